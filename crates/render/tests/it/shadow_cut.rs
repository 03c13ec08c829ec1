//! The shadow of a figure that a door cuts.

use antipode_frame::{Cut, Figure, ModelId};
use antipode_geometry::{ChartPoint, Geometry};
use glam::{DVec3, Vec3};

use crate::common::seen_at;
use crate::shadows::{FLOOR_M, SIZE, both, brightness, is_shaded_by, scene};

/// Who stands in a door is there by a part, and that alone throws a shadow: here the half on one side of the way of the light.
#[test]
fn of_a_figure_that_is_cut_the_part_that_is_shown_throws_a_shadow_under_a_sky() {
    for (geometry, side) in [(Geometry::Euclidean, -1.0), (Geometry::Hyperbolic, 1.0)] {
        let mut frame = scene(geometry);
        frame.content_mut().sky.key_direction = Vec3::new(0.5, 0.7, 0.2).normalize().into();
        frame.content_mut().sky.sun_direction = frame.content.sky.key_direction;
        let feet = DVec3::new(13.5, FLOOR_M, 12.0);
        let across = DVec3::new(-0.2, 0.0, 0.5).normalize() * side;
        let mut figure = Figure::standing(ModelId::Astronaut, ChartPoint::a(feet), 0.0);
        figure.cut = Some(Cut {
            heading_rad: across.z.atan2(across.x),
            from_m: 0.0,
        });
        frame.content_mut().figures = vec![figure];
        let Some([on, off]) = both(&frame, SIZE) else {
            return;
        };
        // Of places in the shadow of the kept half, and of the other.
        let (mut dark, mut seen) = ([0; 2], [0; 2]);
        for (i, j) in (-60..60).flat_map(|i| (-60..60).map(move |j| (i, j))) {
            let point = feet + DVec3::new(f64::from(i), 0.0, f64::from(j)) * 0.04;
            let shades = |from_m: f64, to_m: f64| {
                is_shaded_by(&frame, point, |p| {
                    let off = p - feet;
                    let is_trunk = off.x.hypot(off.z) < 0.16 && (0.9..1.5).contains(&off.y);
                    is_trunk && (from_m..to_m).contains(&off.dot(across))
                })
            };
            let is_other = shades(-1.0, -0.05);
            if is_other == shades(0.05, 1.0) || shades(-0.05, 0.05) {
                continue;
            }
            let at = seen_at(&frame, ChartPoint::a(point), SIZE);
            if let (Some(a), Some(b)) = (brightness(&on, at), brightness(&off, at)) {
                let half = usize::from(is_other);
                seen[half] += 1;
                dark[half] += i32::from(b - a > 25);
            }
        }
        assert!(seen[0] > 12 && seen[1] > 12, "{geometry} {side}: {seen:?}");
        assert!(
            dark[0] * 10 > seen[0] * 7 && dark[1] * 5 < seen[1],
            "{geometry} {side}: {dark:?} of {seen:?} are dark"
        );
    }
}
