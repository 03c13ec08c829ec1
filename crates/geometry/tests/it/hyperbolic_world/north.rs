//! The axes in which the light from the sky is told.

use antipode_geometry::{Atlas, ChartId, ChartPoint, HyperbolicWorld, Map, Metric, Optics};
use glam::{DVec2, DVec3, DVec4};
use proptest::prelude::{prop_assert, proptest};

use super::common::{charts, looking, place, worlds};
use crate::space::common::{cases, vector};

#[test]
fn in_the_middle_of_the_world_the_sky_has_the_axes_of_the_chart() {
    let world = HyperbolicWorld::new(60.305);
    let middle = ChartPoint::a(DVec3::Y * 12.0);
    for axis in DVec3::AXES {
        assert!(world.in_sky_axes(middle, axis).distance(axis) < 1e-15);
    }
}

/// A null vector goes from chart to chart by the way that points do.
#[test]
fn all_charts_see_one_ideal_point() {
    let world = HyperbolicWorld::new(60.305);
    for number in 1..2000 {
        let chart = ChartId::new(number);
        let way = world.between(ChartId::FIRST, chart);
        let north = way * DVec4::new(-world.radius_m(), 0.0, 0.0, 1.0);
        let seen = DVec2::new(north.x, north.z) / (north.w * world.radius_m());
        let lost = 1e-15 * (way.w_axis.w / north.w).powi(2).max(1.0);
        assert!(
            seen.distance(world.ideal_north(chart)) < 100.0 * lost,
            "{number} {seen}"
        );
    }
}

proptest! {
    #![proptest_config(cases(300))]

    /// At one place the sky is the same however that is told: at edges, and at corners, where five charts meet.
    #[test]
    fn the_sky_knows_no_edges(from in charts(), share in vector(1.0), corner in 0..3_u8, v in vector(1.0)) {
        for world in worlds() {
            let mut share = share;
            if corner > 0 {
                share.x = share.x.signum();
            }
            if corner > 1 {
                share.z = share.z.signum();
            }
            let point = place(&world, from, share);
            let sky = world.in_sky_axes(point, v);
            prop_assert!((sky.length() - v.length()).abs() < 1e-14);
            prop_assert!(sky.y == v.y);
            for image in world.images(point, 0.5) {
                let turned = image.turn_vector(v);
                let same = world.in_sky_axes(image.point, turned);
                prop_assert!(same.distance(sky) < 1e-9, "{sky} {same}");
            }
        }
    }

    /// Who walks north keeps north ahead, and comes nearer to all others who do.
    #[test]
    fn north_lies_straight_ahead(from in charts(), share in vector(0.9)) {
        for world in worlds() {
            let mut point = place(&world, from, share);
            point.pos.y = 0.0;
            let eye = looking(point, [0.0; 3]);
            let axes = DVec3::AXES.map(|axis| world.in_sky_axes(point, axis));
            // The way that the sky calls -x.
            let north = -DVec3::from(axes.map(|axis| axis.x));
            let ahead = world.along(&eye, eye.to_view(north), 80.0);
            let back = world.view_point(&looking(ahead, [0.0; 3]), point).truncate();
            let back = looking(ahead, [0.0; 3]).to_chart(back.normalize());
            let told = world.in_sky_axes(ahead, back);
            prop_assert!(told.distance(DVec3::X) < 1e-9, "{told}");
        }
    }
}
