//! How the key light sees the world, on boxes and axes of all kinds.

use antipode_geometry::{Geometry, strategy};

use super::*;

#[test]
fn axes_are_orthonormal_wherever_the_light_comes_from() {
    for i in 0..200 {
        let t = f64::from(i) * 0.37;
        let toward = DVec3::new(t.sin(), (1.7 * t).cos(), (0.6 * t).sin()).normalize();
        if let Light::Far { across, anchor, .. } = far(toward, ChartPoint::a(DVec3::splat(100.0))) {
            let [a, b] = across;
            assert!(a.dot(b).abs() < 1e-14 && a.dot(toward).abs() < 1e-14);
            assert!(
                (a.cross(b) - toward).length() < 1e-14 || (b.cross(a) - toward).length() < 1e-14
            );
            assert_eq!(anchor, ChartPoint::a(DVec3::splat(128.0)));
        }
        let at = DVec4::new(t.sin(), t.cos(), (2.0 * t).sin(), (0.3 * t).cos()).normalize();
        if let Light::Star { axes, .. } = star(at, 32.0) {
            let all = [at, axes[0], axes[1], axes[2]];
            for (i, a) in all.iter().enumerate() {
                for (j, b) in all.iter().enumerate() {
                    let due = if i == j { 1.0 } else { 0.0 };
                    assert!((a.dot(*b) - due).abs() < 1e-14);
                }
            }
        }
    }
}

/// Every point of every box must be counted where the map shows it.
#[test]
fn a_box_is_left_out_only_where_no_point_of_it_is_on_the_map() {
    let sphere = strategy(Geometry::Spherical, 32.0);
    let flat = strategy(Geometry::Euclidean, 0.0);
    let mut found = [0; 2];
    for i in 0..400_u32 {
        let t = f64::from(i);
        let wave = |f: f64| (t * f).sin();
        let min = DVec3::new(36.0 * wave(1.3), 5.0 + 4.0 * wave(0.7), 36.0 * wave(2.1));
        let of = Caster {
            chart: if i % 3 == 0 {
                ChartId::SECOND
            } else {
                ChartId::FIRST
            },
            min,
            max: min + DVec3::new(3.0, 5.0, 8.0),
        };
        let at = DVec4::new(wave(0.11), 0.3, wave(0.17), wave(0.23)).normalize();
        let toward = DVec3::new(wave(0.3), 0.4, wave(0.4)).normalize();
        for (case, (space, light)) in [
            (&flat, far(toward, ChartPoint::default())),
            (&sphere, star(at, 32.0)),
        ]
        .into_iter()
        .enumerate()
        {
            let face = if case == 1 { i as usize % FACES } else { 0 };
            let scale = if case == 1 { 1.0 } else { 20.0 };
            let crop = Crop {
                face,
                centre: DVec2::new(wave(0.9), wave(1.9)) * scale,
                half: 0.3 * scale,
            };
            let heights = light.heights(&**space, &crop, &of);
            let clip = light.clip(&crop, heights.unwrap_or([0.0, 1.0]));
            for corner in 0..27_u32 {
                let share = |n: u32| f64::from(corner / n % 3) * 0.5;
                let inside = DVec3::new(share(1), share(3), share(9)) * (of.max - of.min);
                let base = light.base(&**space, ChartPoint::new(of.chart, min + inside));
                let c = clip * base;
                if c.w > 1e-9 && (c.x / c.w).abs() < 1.0 && (c.y / c.w).abs() < 1.0 {
                    found[case] += 1;
                    assert!(heights.is_some(), "{i} {case}");
                    assert!(
                        (0.0..=1.0).contains(&(c.z / c.w)) || c.w < 1.0,
                        "{i} {case} {c}"
                    );
                }
            }
        }
    }
    assert!(found[0] > 100 && found[1] > 50, "{found:?}");
}
