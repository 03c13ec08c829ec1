//! The quantities at their extremes, with the best figures known for each as bars.

use antipode_geometry::kernel::{depth, distance, exponential, frame, linear, translation};
use antipode_geometry::{
    Atlas, ChartId, ChartPoint, ChunkCoord, Eye, Geometry, Real, Spherical, strategy,
};
use glam::{DVec3, Vec3};

use super::golden::{KERNELS, rows};

/// A small generator: the same numbers on every run.
struct Numbers(u64);

impl Numbers {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }

    fn direction(&mut self) -> DVec3 {
        loop {
            let v = DVec3::from_array([0; 3].map(|_| self.between(-1.0, 1.0)));
            if (0.1..1.0).contains(&v.length()) {
                return v.normalize();
            }
        }
    }
}

/// How far the frame's products under the inner product are off those of an orthonormal one.
fn off_orthonormal<T: Real>(sign: f64, frame: [[T; 4]; 4]) -> f64 {
    let frame = frame.map(|axis| axis.map(T::to_f64));
    let mut worst = 0.0_f64;
    for (i, a) in frame.iter().enumerate() {
        for (j, b) in frame.iter().enumerate() {
            let wanted = match (i, j) {
                (3, 3) => sign,
                _ if i == j => 1.0,
                _ => 0.0,
            };
            worst = worst.max((linear::inner(sign, *a, *b) - wanted).abs());
        }
    }
    worst
}

#[test]
fn a_million_metres_out_the_picture_is_the_same_and_seams_are_closed() {
    let mut rng = Numbers(1);
    let space = strategy(Geometry::Hyperbolic, 20.0);
    for far in [0.0, 1e6, 1e8] {
        let offset = DVec3::new(far, 64.0, -far);
        for _ in 0..2000 {
            let eye = Eye {
                point: ChartPoint::a(offset + rng.direction() * 3.0),
                dial: 10.0,
                ..Eye::default()
            };
            let local = (rng.direction() * 20.0).as_vec3();
            let chunk = ChunkCoord::containing(ChartPoint::a(offset));
            let point = ChartPoint::a(chunk.origin() + local.as_dvec3());
            // As a renderer does: subtract in f64, then round once and port in f32.
            let relative = (point.pos - eye.point.pos).as_vec3();
            let map = antipode_geometry::kernel::raised::RaisedMap::new(20.0, 10.0);
            let single = antipode_geometry::kernel::raised::RaisedMap::<f32>::from_uniform(
                [map.k, map.offset, map.sinh, map.cosh].map(|x| x as f32),
                20.0,
            );
            let seen = Vec3::from_slice(&single.port(relative.to_array())[..3]).as_dvec3();
            let view = space.view_point(&eye, point).truncate();
            let exact = eye.to_chart(view);
            let angle = seen.normalize().angle_between(exact.normalize());
            let gap = (seen.normalize() - exact.normalize()).length();
            assert!(gap < 6e-7, "{far}: {gap} {angle}");
            // The same vertex as the next chunk has it, bit for bit.
            let next = chunk.offset(glam::IVec3::X);
            let shared = DVec3::new(32.0, f64::from(local.y), f64::from(local.z));
            let a = chunk.origin() + shared - eye.point.pos;
            let b = next.origin() + shared.with_x(0.0) - eye.point.pos;
            assert_eq!(
                single.port(a.as_vec3().to_array()),
                single.port(b.as_vec3().to_array())
            );
        }
    }
}

#[test]
fn translations_are_orthogonal_up_to_the_antipode() {
    let mut rng = Numbers(2);
    for gap in [3.0, 1.0, 0.1, 1e-3, 1e-4, 1e-6, 0.0] {
        for _ in 0..500 {
            let q = rng.direction() * (std::f64::consts::PI - gap);
            let single = translation::translation(1.0_f32, q.to_array().map(|x| x as f32));
            let off = off_orthonormal(1.0, single);
            assert!(off < 8e-7, "{gap}: {off}");
            let double = translation::translation(1.0_f64, q.to_array());
            assert!(off_orthonormal(1.0, double) < 1.6e-15, "{gap}");
        }
    }
}

#[test]
fn distances_a_thousandth_apart_keep_their_digits() {
    let mut rng = Numbers(3);
    for (sign, bar) in [(-1.0_f64, 1.6e-7), (1.0, 1.6e-7)] {
        let mut worst = 0.0_f64;
        for _ in 0..5000 {
            let u = (rng.direction() * 5e-4).to_array().map(|x| x as f32);
            let v = u.map(|x| -x);
            let [a, b] = [u, v].map(|p| exponential::point(sign as f32, p));
            let ours = if sign > 0.0 {
                distance::spherical(a, b)
            } else {
                distance::hyperbolic(a, b)
            };
            // Opposite points on a geodesic through the centre; their coordinates are the input.
            let out = linear::length([a[0], a[1], a[2]].map(f64::from));
            let exact = 2.0 * if sign > 0.0 { out.asin() } else { out.asinh() };
            worst = worst.max((ours.to_f64() / exact - 1.0).abs());
        }
        assert!(worst < bar, "{sign}: {worst}");
    }
}

#[test]
fn distances_of_any_size_keep_their_digits() {
    for row in rows(KERNELS, "chords") {
        let (sign, exact) = (row[0], row[7]);
        let points = |p: &[f64]| [p[0] as f32, p[1] as f32, p[2] as f32];
        let [a, b] =
            [points(&row[1..]), points(&row[4..])].map(|p| exponential::point(sign as f32, p));
        let ours = if sign > 0.0 {
            distance::spherical(a, b)
        } else {
            distance::hyperbolic(a, b)
        };
        // Points a radius from the centre have an absolute rounding, and so has what is between.
        let size = points(&row[1..])
            .iter()
            .chain(&points(&row[4..]))
            .fold(0.0_f32, |m, x| m.max(x.abs()));
        let rounding = f64::from(f32::EPSILON) * f64::from(size) * 2.0;
        let error = (ours.to_f64() - exact).abs();
        assert!(error <= 1.6e-7 * exact + rounding, "{row:?}: {ours}");
    }
}

#[test]
fn directions_to_a_light_are_unit_tangents_at_any_separation() {
    let mut rng = Numbers(4);
    for sign in [-1.0_f32, 1.0] {
        for exponent in -38..=-4 {
            for _ in 0..200 {
                let size = 10.0_f64.powi(exponent);
                let [u, v] = [0; 2].map(|_| (rng.direction() * size).to_array().map(|x| x as f32));
                let [a, b] = [u, v].map(|p| exponential::point(sign, p));
                let up = [0.0, 1.0, 0.0, 0.0];
                let ours = distance::direction(sign, a, b, up).map(f64::from);
                let s = f64::from(sign);
                let norm = linear::inner(s, ours, ours).sqrt();
                assert!((norm - 1.0).abs() < 2e-7, "{u:?} {v:?}: {norm}");
                let along = linear::inner(s, ours, a.map(f64::from));
                assert!(along.abs() < 2e-7, "{u:?} {v:?}: {along}");
            }
        }
        // At one point and at the antipode every direction leads there: the normal is taken.
        let (here, up) = ([0.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 0.0]);
        assert_eq!(distance::direction(sign, here, here, up), up);
        if sign > 0.0 {
            assert_eq!(
                distance::direction(sign, here, [0.0, 0.0, 0.0, -1.0], up),
                up
            );
        }
    }
}

#[test]
fn a_hundred_thousand_composed_moves_stay_orthogonal() {
    for sign in [-1.0_f32, 1.0] {
        let mut rng = Numbers(5);
        let mut camera = translation::translation(sign, [0.0; 3]);
        let mut worst = 0.0_f64;
        for i in 0..100_000 {
            // Out and back, with a turn in between: the camera stays near where it began.
            let out = rng.direction() * 0.05;
            let home = exponential::point(sign, [0.0; 3]);
            let back = linear::inner(sign, camera[3], home).abs() > 1.02;
            let step = if back {
                DVec3::from(
                    camera[3]
                        .map(f64::from)
                        .first_chunk::<3>()
                        .copied()
                        .unwrap(),
                ) * -0.1
            } else {
                out
            };
            let step = translation::translation(sign, step.to_array().map(|x| x as f32));
            let sin = (f64::from(i) * 0.01).sin();
            let (sin, cos) = ((sin * 0.01) as f32, (1.0 - 5e-5 * sin * sin) as f32);
            let turn = [
                [cos, sin, 0.0, 0.0],
                [-sin, cos, 0.0, 0.0],
                [0.0, 0.0, 1.0, 0.0],
                [0.0, 0.0, 0.0, 1.0],
            ];
            let moved = if back {
                frame::product(step, camera)
            } else {
                frame::product(camera, step)
            };
            camera = frame::orthonormalized(sign, frame::product(moved, turn));
            let size: f64 = camera
                .iter()
                .flatten()
                .map(|x| f64::from(*x).powi(2))
                .sum::<f64>()
                / 4.0;
            worst = worst.max(off_orthonormal(f64::from(sign), camera) / size);
        }
        assert!(worst < 2e-7, "{sign}: {worst}");
    }
}

#[test]
fn crossing_the_equator_moves_the_picture_by_less_than_the_eye_can_tell() {
    let mut rng = Numbers(6);
    let space = Spherical::new(32.0);
    let rim = space.domain(ChartId::FIRST).radius_m().unwrap();
    for _ in 0..5000 {
        let angle = rng.between(-3.2, 3.2);
        let spot = |r: f64, y: f64| DVec3::new(r * angle.cos(), y, r * angle.sin());
        let here = ChartPoint::a(spot(rim + rng.between(-0.3, 0.3), rng.between(3.0, 30.0)));
        let there = space.images(here, f64::INFINITY)[0].point;
        let single = |point: ChartPoint| {
            let b = point.chart == ChartId::SECOND;
            let p = point.pos.as_vec3().to_array();
            antipode_geometry::kernel::sphere::port(1.0 / 32.0_f32, b, p)
        };
        let (a, b) = (single(here), single(there));
        let gap = (0..3)
            .map(|i| f64::from(a[i] - b[i]).powi(2))
            .sum::<f64>()
            .sqrt()
            / 32.0;
        assert!(gap <= 5.6e-7, "{here:?}: {gap}");
    }
}

#[test]
fn a_depth_step_is_a_ten_millionth_of_the_distance_to_twenty_radii() {
    // n exp(-d) falls by its own part in every step, so one f32 step is that part of a radius.
    let (near, k) = (0.05_f32, 0.05_f32);
    for i in 1..=2000 {
        let d = f64::from(i) * 0.01;
        let view = [0.0, 0.0, -(20.0 * d.sinh()) as f32, d.cosh() as f32];
        let here = depth::exponential(near, k, view) / -view[2];
        let next = f32::from_bits(here.to_bits() - 1);
        // The stored value is n e^-d over R sinh d; its logarithm falls by 1 + coth d.
        let step = (f64::from(here) / f64::from(next) - 1.0) / (1.0 + 1.0 / d.tanh());
        assert!(step > 0.0 && step <= 7e-8, "{d}: {step}");
        let exact = f64::from(near) * (-d).exp() / (20.0 * d.sinh());
        assert!((f64::from(here) / exact - 1.0).abs() < 4e-7, "{d}");
    }
}

#[test]
fn nothing_is_nan_at_any_magnitude() {
    let mut rng = Numbers(7);
    let raised = antipode_geometry::kernel::raised::RaisedMap::new(20.0, 10.0);
    for dial in [0.0, 10.0] {
        let map = antipode_geometry::kernel::raised::RaisedMap::new(20.0, dial);
        let single = antipode_geometry::kernel::raised::RaisedMap::<f32>::from_uniform(
            [map.k, map.offset, map.sinh, map.cosh].map(|x| x as f32),
            20.0,
        );
        for exponent in -45..=38 {
            for _ in 0..100 {
                let p = rng.direction() * 10.0_f64.powi(exponent);
                let u = p.to_array().map(|x| x as f32);
                let values = [single.port(u), {
                    let n = single.normal(u, [0.6, 0.8, 0.0]);
                    [n[0], n[1], n[2], 0.0]
                }];
                assert!(values.iter().flatten().all(|x| x.is_finite()), "{u:?}");
                let drawn = linear::length(single.within_range(u));
                assert!(drawn <= 79.1 * 20.0, "{u:?}: {drawn}");
                let far = (p * 1e100).to_array();
                assert!(raised.port(far).iter().all(|x| x.is_finite()), "{far:?}");
            }
        }
    }
}

#[test]
fn tiny_points_keep_their_directions() {
    // At no offset the map is the identity near the eye, down to the least normal numbers.
    let map = antipode_geometry::kernel::raised::RaisedMap::<f32>::from_uniform(
        [0.05, 0.0, 0.0, 1.0],
        20.0,
    );
    let mut rng = Numbers(8);
    for exponent in -36..=-2 {
        for _ in 0..100 {
            let p = rng.direction() * 10.0_f64.powi(exponent);
            let u = p.to_array().map(|x| x as f32);
            let x = map.port(u);
            for i in 0..3 {
                let gap = (f64::from(x[i]) - f64::from(u[i])).abs();
                let flat = f64::from(u[i]).abs().max(p.length()) * 3e-7 + p.length().powi(3);
                assert!(gap <= flat, "{u:?} {x:?}");
            }
        }
    }
}

#[test]
fn what_rounding_took_from_a_length_is_known_to_nine_digits() {
    let mut rng = Numbers(9);
    for i in 0..100_000 {
        let size = 10.0_f64.powf(rng.between(-15.0, 18.0));
        let mut q = (rng.direction() * size).to_array().map(|x| x as f32);
        if i % 3 == 0 {
            // On an axis nothing is rounded.
            q[1] = 0.0;
            q[2] = 0.0;
        }
        let exact = q.iter().map(|x| f64::from(*x).powi(2)).sum::<f64>().sqrt();
        let [t, rest] = f32::length_rest(q).map(f64::from);
        assert!(
            (t + rest - exact).abs() <= exact * 2.0_f64.powi(-32),
            "{q:?}"
        );
        assert!(rest.abs() <= exact * 2.0_f64.powi(-22), "{q:?}");
        if i % 3 == 0 {
            assert_eq!(rest, 0.0, "{q:?}");
        }
    }
    assert_eq!(f64::length_rest([3.0, 0.0, 4.0]), [5.0, 0.0]);
}

#[test]
fn what_a_unit_vector_lacks_is_known_to_nine_digits() {
    let mut rng = Numbers(10);
    for sign in [-1.0, 1.0] {
        for _ in 0..50_000 {
            let q = rng.direction() * rng.between(0.0, 0.5);
            let v = exponential::direction(sign, q.to_array(), rng.direction().to_array());
            let off = rng.between(-1e-6, 1e-6);
            let v = v.map(|x| (x * (1.0 + off)) as f32);
            let exact = 1.0 - linear::inner(sign, v.map(f64::from), v.map(f64::from));
            let single = f64::from(linear::lacks(sign as f32, v));
            assert!((single - exact).abs() < 1e-9, "{v:?}: {single} {exact}");
            let double = linear::lacks(sign, v.map(f64::from));
            assert!((double - exact).abs() < 1e-15, "{v:?}");
        }
    }
}
