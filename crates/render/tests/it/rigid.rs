//! What is rigid in the space, in charts whose metres are others.

use std::f64::consts::PI;

use antipode_frame::{Figure, ModelId};
use antipode_geometry::{BodyFrame, ChartPoint, Geometry, LevelMap};
use glam::DVec3;

use crate::common::{Studio, frame, space};
use crate::figures::changed;

const SIZE: (u32, u32) = (320, 180);
const ASPECT: f64 = 16.0 / 9.0;

/// Six metres beside its middle, a car that is rigid in the space is as long wherever it looks.
#[test]
fn what_is_rigid_in_the_space_is_as_long_whichever_way_it_lies_in_the_chart() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    // Near the equator, and near a corner of a square.
    for (geometry, share) in [
        (Geometry::Spherical, [1.4, 0.2]),
        (Geometry::HyperbolicWorld, [0.5, 0.45]),
    ] {
        let space = space(geometry);
        let [x, z] = share.map(|it| it * space.radius_m());
        let at = ChartPoint::a(DVec3::new(x, 1.0, z));
        let mut long_px = |yaw: f64, level: LevelMap| {
            let aside = DVec3::new(-yaw.sin(), 0.0, yaw.cos());
            let eye = BodyFrame::step(&*space, at, aside * 6.0 + DVec3::Y * 0.8).point;
            let mut frame = frame(&space, eye, ASPECT);
            let way = BodyFrame::way(&*space, eye, at);
            frame.view.eye.yaw = way.z.atan2(way.x);
            let without = studio.picture(&frame);
            frame.content_mut().figures = vec![Figure {
                level,
                ..Figure::standing(ModelId::CarBody, at, yaw)
            }];
            let places = changed(&without, &studio.picture(&frame));
            let columns = || places.iter().map(|(x, _)| *x);
            f64::from(columns().max().unwrap_or(0) - columns().min().unwrap_or(0))
        };
        let mut apart = |level: LevelMap| {
            let lengths = [0.0, 0.25, 0.5, 0.75].map(|turn| long_px(PI * turn, level));
            let most = lengths.into_iter().fold(0.0, f64::max);
            let least = lengths.into_iter().fold(f64::INFINITY, f64::min);
            println!("{geometry}: {lengths:?}");
            most / least
        };
        let (rigid, as_the_chart) = (apart(LevelMap::at(&*space, at)), apart(LevelMap::SAME));
        assert!(rigid < 1.05, "{geometry}: {rigid}");
        assert!(as_the_chart > 1.15, "{geometry}: {as_the_chart}");
    }
}
