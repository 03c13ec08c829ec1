//! At every branch the two sides differ by no more than their bounds together.

use antipode_geometry::Real;
use antipode_geometry::kernel::horizon::HorizonMap;
use antipode_geometry::kernel::raised::RaisedMap;
use antipode_geometry::kernel::series;

/// A number's neighbours below and above in single precision, several steps each way.
fn around(x: f32) -> Vec<f32> {
    (-6..=6)
        .map(|i| f32::from_bits(x.to_bits().wrapping_add_signed(i)))
        .collect()
}

/// Steps in the last place of 1, or of the value where it is greater.
fn step(a: f32, b: f32) -> f64 {
    let size = a.abs().max(b.abs()).max(1.0);
    (f64::from(a) - f64::from(b)).abs() / f64::from(size * f32::EPSILON)
}

/// Over neighbours of a branch point the function moves by what its slope says and no more than
/// both sides' bounds.
fn smooth(name: &str, at: f32, bound: f64, slope: f64, f: impl Fn(f32) -> f32) {
    let xs = around(at);
    for pair in xs.windows(2) {
        let (a, b) = (f(pair[0]), f(pair[1]));
        let moved = (f64::from(pair[1]) - f64::from(pair[0])).abs() * slope;
        let size = f64::from(a.abs().max(1.0) * f32::EPSILON);
        let jump = step(a, b) - moved / size;
        assert!(jump <= bound, "{name} at {}: {a} {b}, {jump} ulp", pair[0]);
    }
}

#[test]
fn the_series_meet_at_their_ends() {
    smooth("sine over t, obtuse", 3.2, 3.0, 0.2, |s| {
        series::sinc_cos(s)[0]
    });
    smooth("cosine, obtuse", 3.2, 3.0, 0.3, |s| series::sinc_cos(s)[1]);
    smooth("sinh over t, 1", 1.0, 3.2, 0.4, |t| {
        series::sinhc_cosh(t)[0]
    });
    smooth("cosh, 1", 1.0, 3.2, 1.2, |t| series::sinhc_cosh(t)[1]);
    smooth("sine and cosine, -1", 1.0, 3.2, 0.6, |s| {
        series::sine_cosine(-s)[1]
    });
    smooth("bend, 4", 4.0, 3.2, 0.02, |s| series::sinc_bend(s, -1.0));
    smooth("angle, 1/2", 0.5, 3.0, 1.0, |t| series::angle(t, 1.0));
    smooth("angle, 1", 1.0, 3.0, 0.6, |t| series::angle(t, 1.0));
    smooth("angle, 2", 2.0, 3.0, 0.3, |t| series::angle(t, 1.0));
    smooth("asinh, 3/4", 0.75, 3.0, 0.9, series::asinh);
    smooth("asinh, 1e4", 1e4, 3.0, 2e-4, series::asinh);
    // Every power of two that the exponential splits off.
    for n in 1..120 {
        let t = (n as f32 - 0.4) * std::f32::consts::LN_2;
        let grows =
            |t: f32| series::exp(t) / series::exp((n as f32 - 0.4) * std::f32::consts::LN_2);
        smooth("exp", t, 3.0, 1.0, grows);
    }
}

#[test]
fn both_signs_of_curvature_and_none_meet_at_zero() {
    for exponent in -45..-9 {
        let s = 10.0_f64.powi(exponent) as f32;
        for (above, below) in [
            (series::sine_cosine(s)[0], series::sine_cosine(-s)[0]),
            (series::sine_cosine(s)[1], series::sine_cosine(-s)[1]),
        ] {
            assert!(step(above, 1.0) <= 1.0 && step(below, 1.0) <= 1.0, "{s}");
        }
        let bends = series::sinc_bend(s, 1.0) + series::sinc_bend(s, -1.0);
        assert!(bends.abs() < f32::EPSILON, "{s}: {bends}");
    }
    assert_eq!(series::sine_cosine(0.0), [1.0, 1.0]);
    assert_eq!(series::sinc_cos(0.0), [1.0, 1.0]);
}

/// A uniform's constants, rounded once.
fn horizon(kappa: f64) -> HorizonMap<f32> {
    let map = HorizonMap::new(f64::from(kappa as f32), 1.625);
    HorizonMap::from_uniform(
        [map.kappa, map.lift_m, map.sin, map.cos].map(|x| x as f32),
        map.k as f32,
        map.radius_m as f32,
    )
}

#[test]
fn the_picture_has_no_step_where_curvature_passes_through_zero() {
    let points = [
        [3.0_f32, -1.5, 0.5],
        [60.0, 9.0, 20.0],
        [0.0, 30.0, 0.0],
        [1e-20, -1e-20, 0.0],
    ];
    for u in points {
        let flat = horizon(0.0).port(u);
        assert_eq!(flat, [u[0], u[1], u[2], 1.0]);
        let size = f64::from(u[0].abs() + u[1].abs() + u[2].abs()) + 1e-3;
        for exponent in -30..=-2 {
            for kappa in [10.0_f64.powi(exponent), -(10.0_f64.powi(exponent))] {
                let kappa = kappa.clamp(-0.0625, 4e-4);
                let here = horizon(kappa).port(u);
                let normal = horizon(kappa).normal(u, [0.6, 0.8, 0.0]);
                assert!(
                    here.iter().chain(&normal).all(|x| x.is_finite()),
                    "{kappa} {u:?}"
                );
                // To first order a point moves by kappa r^2 (r + H): what is left is rounding.
                let moved = kappa.abs() * size * size * (size + 2.0) * 3.0;
                let bent = (kappa.abs().sqrt() * (size + 2.0)).exp();
                for (a, b) in here.iter().zip(flat).take(3) {
                    let gap = (f64::from(*a) - f64::from(b)).abs();
                    assert!(gap <= moved * bent + 4e-7 * size, "{kappa} {u:?}: {gap}");
                }
            }
        }
    }
}

#[test]
fn the_raised_maps_branches_meet() {
    let exact = RaisedMap::new(20.0, 10.0);
    let map = RaisedMap::<f32>::from_uniform(
        [exact.k, exact.offset, exact.sinh, exact.cosh].map(|x| x as f32),
        20.0,
    );
    // k delta = 2 straight up and out level, the height of the offset centre, and its plane.
    let level = (50.0_f32 * 50.0 - 100.0).sqrt();
    let starts = [
        [0.0, 40.0, 0.0],
        [level, 0.0, 0.0],
        [7.0, -10.0, 2.0],
        [level, -10.0, 0.0],
    ];
    for start in starts {
        for axis in (0..2).filter(|axis| start[*axis] != 0.0) {
            let mut last: Option<[f32; 4]> = None;
            for x in around(start[axis]) {
                let mut u = start;
                u[axis] = x;
                let here = map.port(u);
                let exact = exact.port(u.map(f64::from));
                let length = (0..3).map(|i| exact[i] * exact[i]).sum::<f64>().sqrt();
                for i in 0..3 {
                    let gap = (here[i].to_f64() - exact[i]).abs();
                    assert!(
                        gap < 12.0 * f64::from(f32::EPSILON) * length,
                        "{u:?}: {gap}"
                    );
                }
                if let Some(last) = last {
                    let jump = (0..3)
                        .map(|i| (here[i] - last[i]).abs())
                        .fold(0.0, f32::max);
                    assert!(f64::from(jump) < 24.0 * f64::from(f32::EPSILON) * length);
                }
                last = Some(here);
            }
        }
    }
}

#[test]
fn the_horizon_maps_one_exponential_meets_the_series() {
    let exact = HorizonMap::new(-0.015_625, 1.625);
    let map = horizon(-0.015_625);
    for sense in [1.0_f32, -1.0] {
        for y in around(8.0) {
            let u = [5.0, sense * y, 1.0];
            let (here, exact) = (map.port(u), exact.port(u.map(f64::from)));
            for (a, b) in here.iter().zip(exact) {
                assert!(
                    (f64::from(*a) - b).abs() < 4e-7 * b.abs().max(1.0),
                    "{u:?}: {a} {b}"
                );
            }
        }
    }
}
