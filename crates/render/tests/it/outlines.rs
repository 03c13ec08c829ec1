//! Outlines of hit shapes: where the shapes are, in every space, green awake and red asleep, and seen through land.

use crate::common::{GEOMETRIES, Studio, frame, plates, seen_at, space, standing};
use antipode_frame::{ChunkChange, Frame, HitForm, HitShape};
use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Geometry};
use glam::{DQuat, DVec3, Vec3};
use image::RgbaImage;

const SIZE: (u32, u32) = (640, 360);
const ASPECT: f64 = 16.0 / 9.0;
const BODY: HitForm = HitForm::Capsule {
    height_m: 1.8,
    radius_m: 0.35,
};

fn shape(form: HitForm, point: ChartPoint, awake: bool) -> HitShape {
    HitShape {
        form,
        point,
        turn: DQuat::from_rotation_y(0.4),
        awake,
    }
}

fn is_green([r, g, b]: [u8; 3]) -> bool {
    g > 90 && g.saturating_sub(r) > 45 && g.saturating_sub(b) > 45
}

fn is_red([r, g, b]: [u8; 3]) -> bool {
    r > 90 && r.saturating_sub(g) > 45 && r.saturating_sub(b) > 45
}

fn count(picture: &RgbaImage, like: impl Fn([u8; 3]) -> bool) -> usize {
    picture
        .pixels()
        .filter(|p| like([p.0[0], p.0[1], p.0[2]]))
        .count()
}

/// Whether a pixel like that is within two of a place.
fn is_there(picture: &RgbaImage, (x, y): (f64, f64), like: impl Fn([u8; 3]) -> bool) -> bool {
    let near = |at: f64, most: u32| {
        let at = at.round() as i64;
        (at - 2..=at + 2)
            .filter(move |at| (0..i64::from(most)).contains(at))
            .map(|at| at as u32)
    };
    near(y, SIZE.1).any(|y| {
        near(x, SIZE.0).any(|x| {
            let p = picture.get_pixel(x, y).0;
            like([p[0], p[1], p[2]])
        })
    })
}

/// Empty frames of every space and hemisphere, seen from 1.7 m over where land would be.
fn places() -> Vec<(Frame, String)> {
    let mut places = Vec::new();
    for geometry in GEOMETRIES {
        let space = space(geometry);
        for chart in [ChartId::FIRST, ChartId::SECOND] {
            if chart == ChartId::FIRST || geometry == Geometry::Spherical {
                let stand = standing(&space, chart, 4.0, 4.0);
                let name = format!("{geometry} {chart:?}");
                places.push((frame(&space, stand, ASPECT), name));
            }
        }
    }
    places
}

#[test]
fn a_capsule_reaches_from_the_feet_to_the_head_wherever_it_stands() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    for (mut frame, place) in places() {
        let empty = studio.picture(&frame);
        assert_eq!(
            count(&empty, is_green) + count(&empty, is_red),
            0,
            "{place}"
        );
        for (away, aside) in [(3.0, 0.4), (9.0, -3.0)] {
            let feet = frame.view.eye.point.moved(DVec3::new(away, -1.6, aside));
            frame.content_mut().hit_shapes = vec![shape(BODY, feet, true)];
            let picture = studio.picture(&frame);
            for height in [0.0, 0.35, 1.45, 1.8] {
                // The lowest and highest points are on the axis, the others on the rings about it.
                let off = if (0.1..1.7).contains(&height) {
                    0.35
                } else {
                    0.0
                };
                let way = frame.view.eye.point.pos - feet.pos;
                let out = way.with_y(0.0).normalize() * off;
                let at = seen_at(&frame, feet.moved(out + DVec3::Y * height), SIZE);
                assert!(
                    is_there(&picture, at, is_green),
                    "{place}: nothing at {height} m of a capsule {away} m away"
                );
            }
            assert_eq!(count(&picture, is_red), 0, "{place}");
            let head = seen_at(&frame, feet.moved(DVec3::Y * 2.1), SIZE);
            assert!(
                !is_there(&picture, head, is_green),
                "{place}: above the head"
            );
        }
    }
}

#[test]
fn balls_and_boxes_are_where_they_should_be_and_red_at_rest() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    for (mut frame, place) in places() {
        let eye = frame.view.eye.point;
        let ball = eye.moved(DVec3::new(4.0, -0.2, -1.5));
        let cuboid = eye.moved(DVec3::new(5.0, -0.5, 1.6));
        let half_m = DVec3::new(1.0, 0.4, 0.6);
        frame.content_mut().hit_shapes = vec![
            shape(HitForm::Box { half_m }, cuboid, false),
            shape(HitForm::Ball { radius_m: 0.35 }, ball, true),
        ];
        let picture = studio.picture(&frame);
        let turn = frame.content.hit_shapes[0].turn;
        for corner in 0..8u8 {
            let sign = |bit: u8| if corner >> bit & 1 == 1 { 1.0 } else { -1.0 };
            let corner = turn * (half_m * DVec3::new(sign(0), sign(1), sign(2)));
            let at = seen_at(&frame, cuboid.moved(corner), SIZE);
            assert!(is_there(&picture, at, is_red), "{place}: corner {corner}");
        }
        for pole in [0.35, -0.35] {
            let at = seen_at(&frame, ball.moved(DVec3::Y * pole), SIZE);
            assert!(is_there(&picture, at, is_green), "{place}: pole {pole}");
        }
        let middle = seen_at(&frame, cuboid, SIZE);
        assert!(!is_there(&picture, middle, is_red), "{place}: filled");
    }
}

#[test]
fn behind_a_wall_an_outline_is_faint_but_there() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let space = space(Geometry::Euclidean);
    let eye = ChartPoint::a(DVec3::new(4.0, 16.0, 16.0));
    let mut frame = frame(&space, eye, ASPECT);
    frame.content_mut().hit_shapes = vec![shape(BODY, eye.moved(DVec3::new(6.0, -0.9, 0.0)), true)];
    let open = count(&studio.picture(&frame), is_green);
    let wall = [(12.0, 10.0), (20.0, 10.0), (20.0, 22.0), (12.0, 22.0)];
    let corners = wall.map(|(z, y)| Vec3::new(7.0, y, z));
    let coord = ChunkCoord::containing(eye);
    frame.change_land([ChunkChange::Put(coord, plates(&[corners]))]);
    let walled = studio.picture(&frame);
    frame.content_mut().hit_shapes.clear();
    let bare = studio.picture(&frame);
    let differs = walled.pixels().zip(bare.pixels()).filter(|(a, b)| a != b);
    let (faint, strong) = (differs.count(), count(&walled, is_green));
    assert!(
        open > 200 && faint > 200 && strong < open / 4,
        "{open} {faint} {strong}"
    );
}

#[test]
fn a_shape_around_and_behind_the_eye_hurts_nobody() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    for (mut frame, place) in places() {
        let eye = frame.view.eye.point;
        frame.content_mut().hit_shapes = vec![
            shape(BODY, eye.moved(DVec3::Y * -1.62), true),
            shape(BODY, eye.moved(DVec3::X * -4.0), true),
        ];
        let picture = studio.picture(&frame);
        // Lines that went the wrong way round would cover much of the picture.
        let covered = count(&picture, is_green);
        assert!(
            covered < (SIZE.0 * SIZE.1 / 20) as usize,
            "{place}: {covered}"
        );
    }
}
