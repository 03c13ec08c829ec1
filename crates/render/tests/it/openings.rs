//! What is seen through doors.

use std::sync::Arc;

use crate::common::{GEOMETRIES, Studio, difference, frame, land, space, standing};

use antipode_frame::{Figure, Frame, ModelId, Opening};
use antipode_geometry::{ChartId, ChartPoint, Doorway, Geometry, Leaf};
use antipode_render::ShadowQuality;
use glam::DVec3;

const SIZE: (u32, u32) = (160, 90);
const ASPECT: f64 = 16.0 / 9.0;

/// Land, an eye that looks along +x, and an astronaut four metres before it.
fn before_an_astronaut(geometry: Geometry) -> Frame {
    let space = space(geometry);
    let point = standing(&space, ChartId::FIRST, 5.0, 3.0);
    let feet = point.moved(DVec3::new(4.0, -1.6, 0.3));
    frame(&space, point, ASPECT).with_content(|it| {
        it.land = land(&space, point, 1);
        it.figures = vec![Figure::standing(ModelId::Astronaut, feet, 0.4)];
    })
}

fn leaf(frame: &Frame, ahead_m: f64, yaw: f64) -> Leaf {
    let eye = frame.view.eye;
    Leaf {
        foot: eye.point.moved(DVec3::new(ahead_m, -1.6, 0.0)),
        yaw: eye.yaw + yaw,
    }
}

fn with_doors(frame: &Frame, leaves: [Leaf; 2]) -> Frame {
    let mut frame = frame.clone();
    frame.openings = Opening::all(&frame.view, &Doorway { leaves }).to_vec();
    frame
}

/// Through a door that turns nothing the sky is as without it, and so is who stands as far behind the other one. The light on
/// them is that of their place, which on a globe is another.
#[test]
fn who_stands_behind_the_far_door_is_seen_as_if_standing_behind_the_near_one() {
    for geometry in [Geometry::Euclidean, Geometry::Hyperbolic] {
        for (samples, near_m) in [(1, 2.0), (4, 2.0), (1, 0.05), (1, 0.01)] {
            let Some(mut studio) = Studio::sampled(SIZE, ShadowQuality::Low, samples) else {
                return;
            };
            let mut frame = before_an_astronaut(geometry);
            frame.content_mut().land = Arc::default();
            let plain = studio.picture(&frame);
            let near = leaf(&frame, near_m, 0.0);
            let far = Leaf {
                foot: near.foot.moved(DVec3::new(31.0, 3.0, -12.0)),
                ..near
            };
            let doors = Doorway {
                leaves: [near, far],
            };
            let feet = frame.content.figures[0].point;
            let there = doors.carry(&*frame.view.strategy, 0, feet).unwrap();
            frame.content_mut().figures[0].point = there.point;
            let seen = studio.picture(&with_doors(&frame, doors.leaves));
            let (most, mean) = difference(&seen, &plain);
            assert!(
                mean < 0.5,
                "{geometry} {samples} {near_m}: {mean}, at most {most}"
            );
        }
    }
}

#[test]
fn what_stands_behind_the_far_door_is_seen_in_the_near_one_and_what_stands_behind_that_is_not() {
    for geometry in GEOMETRIES {
        let Some(mut studio) = Studio::new(SIZE) else {
            return;
        };
        let mut frame = before_an_astronaut(geometry);
        // Land there might hide who stands behind the door.
        frame.content_mut().land = Arc::default();
        // The far one stands aside and behind the eye, and looks across.
        let far = Leaf {
            foot: frame.view.eye.point.moved(DVec3::new(-6.0, -1.6, 9.0)),
            yaw: 2.0,
        };
        let leaves = [leaf(&frame, 2.0, 0.0), far];
        let doors = Doorway { leaves };
        let without = |frame: &Frame| frame.clone().with_content(|it| it.figures.clear());
        let shown = |frame: &Frame, studio: &mut Studio| {
            let bare = studio.picture(&with_doors(&without(frame), leaves));
            let full = studio.picture(&with_doors(frame, leaves));
            difference(&full, &bare).1
        };
        let hidden = shown(&frame, &mut studio);
        assert!(hidden < 0.02, "{geometry}: behind the near one {hidden}");
        let feet: ChartPoint = frame.content.figures[0].point;
        let there = doors.carry(&*frame.view.strategy, 0, feet);
        let there = there.unwrap().point;
        frame.content_mut().figures[0].point = there;
        let seen = shown(&frame, &mut studio);
        assert!(seen > 0.1, "{geometry}: behind the far one {seen}");
        // Before the far leaf it is cut off.
        let before = far.place(DVec3::new(-1.0, 0.0, 0.0));
        frame.content_mut().figures[0].point = before;
        let cut = shown(&frame, &mut studio);
        assert!(cut < 0.02, "{geometry}: before the far one {cut}");
    }
}

#[test]
fn a_picture_without_doors_is_the_same_after_one_with_doors() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let frame = before_an_astronaut(Geometry::Hyperbolic);
    let alone = studio.picture(&frame);
    let leaves = [leaf(&frame, 2.0, 0.0), leaf(&frame, -3.0, 1.0)];
    let with = studio.picture(&with_doors(&frame, leaves));
    assert!(with != alone);
    assert!(studio.picture(&frame) == alone);
}
