//! Views are where rays go.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use antipode_deformation::{Aberration, Place, Void, trace};
use glam::DQuat;

use super::*;
use crate::raster::tidy;

const LIMITS: Limits = Limits {
    levels: 5,
    views: 40,
};

/// A turned tunnel along z about the origin, and one more in it.
fn nested() -> Space {
    let turn = DQuat::from_rotation_y(0.2);
    let outer = Aberration::tunnel(DVec3::ZERO, turn, DVec3::new(2.0, 2.0, 6.0), 2, 30.0);
    let turn = DQuat::from_rotation_y(0.5);
    let inner = Aberration::tunnel(0.5 * DVec3::Z, turn, DVec3::new(0.7, 0.8, 1.5), 2, 1.0);
    Space::new(vec![outer, inner]).unwrap()
}

fn plan(space: &Space, eye: &Eye, limits: Limits) -> Plan {
    Plan::doors(space, &tidy(space), eye, 1.6, limits)
}

fn looking(space: &Space, from: DVec3, to: DVec3) -> Eye {
    Eye::looking(Place::at(space, from), to - from, DVec3::Y, 1.2)
}

#[test]
fn rays_go_where_the_views_say() {
    let space = nested();
    let far = DVec3::new(3.2, 0.3, 14.0);
    let places = [far, DVec3::new(0.9, 0.1, 4.4), DVec3::new(0.1, 0.0, 0.4)];
    for (from, least) in places.into_iter().zip([4, 3, 3]) {
        let eye = looking(&space, from, DVec3::ZERO);
        let plan = plan(&space, &eye, LIMITS);
        let mut seen = 0;
        for view in &plan.views {
            // The middle of its door.
            let middle = 0.5 * (view.extent.0 + view.extent.1);
            let w = eye.direction(middle.x, middle.y, 1.6);
            let felt_m = just_behind(view, w);
            let path = trace(&space, &eye.place, w, felt_m, &Void, &Traveller::Body);
            let is_whole = (path.length - felt_m).abs() < 1e-9;
            let is_there = path.place.stack == view.stack && path.events.len() == view.level;
            if !(is_whole && is_there) {
                continue;
            }
            let there = view.origin + felt_m * (view.carry * w);
            assert!(there.distance(path.place.point) < 1e-9, "{view:?}");
            let [x, y, depth] = view.rows.map(|row| row.dot(there - view.origin));
            assert!((x / depth - middle.x).abs() < 1e-9 && (y / depth - middle.y).abs() < 1e-9);
            seen += 1;
        }
        assert!(seen >= least, "{seen} of {}", plan.views.len());
    }
}

/// Felt metres to just behind the door of a view.
fn just_behind(view: &View, w: DVec3) -> f64 {
    view.cut.map_or(1e-3, |(n, d)| {
        (d - n.dot(view.origin)) / n.dot(view.carry * w) + 1e-3
    })
}

#[test]
fn what_is_behind_the_last_level_is_for_rays() {
    let space = nested();
    let eye = looking(&space, 14.0 * DVec3::Z, DVec3::ZERO);
    let kinds = |levels| {
        let limits = Limits { levels, ..LIMITS };
        let plan = plan(&space, &eye, limits);
        assert_eq!(plan.levels(), levels);
        let count =
            |wanted: fn(&Kind) -> bool| plan.faces.iter().filter(|face| wanted(&face.kind)).count();
        (
            count(|kind| matches!(kind, Kind::Door(_))),
            count(|kind| *kind == Kind::Rays),
        )
    };
    assert_eq!(kinds(1), (0, 1));
    assert_eq!(kinds(2).0, 1);
    assert!(kinds(2).1 >= 2);
}

#[test]
fn a_door_behind_the_eye_opens_no_view() {
    let space = nested();
    let eye = looking(&space, 14.0 * DVec3::Z, 20.0 * DVec3::Z);
    assert_eq!(plan(&space, &eye, LIMITS).views.len(), 1);
}

#[test]
fn in_coordinates_of_the_scene_there_are_walls_only() {
    let space = nested();
    let eye = looking(&space, 14.0 * DVec3::Z, DVec3::ZERO);
    let plan = Plan::plain(&space, &eye, 1.6);
    assert_eq!(plan.faces.len(), 8);
    assert!(
        plan.faces
            .iter()
            .all(|face| matches!(face.kind, Kind::Wall(..)))
    );
}
