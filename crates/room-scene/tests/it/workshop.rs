//! Seeing is touching: what the pointer drags stays under it, through aberrations and portals, in every room of the game.

use antipode_room_scene::RoomScene;
use antipode_room_scene::workshop::{
    Change, Drag, FreeCamera, Handle, Handles, Held, Snap, Tool, Viewpoint,
};
use antipode_rooms::shipped;
use fastrand::Rng;
use glam::{DMat3, DVec2, DVec3};

use crate::{empty, eyes, room};

/// Half the height of a picture, pixels.
const HALF_PX: f64 = 360.0;
const FREE: Snap = Snap {
    grid_m: 0.0,
    turn_deg: 0.0,
};

fn views(scene: &RoomScene) -> Vec<Viewpoint> {
    let aspect = 16.0 / 9.0;
    let all = eyes::of(scene).into_iter();
    all.map(|eye| Viewpoint { eye, aspect }).collect()
}

fn somewhere(rng: &mut Rng) -> DVec2 {
    DVec2::new(rng.f64() * 2.0 - 1.0, rng.f64() * 2.0 - 1.0)
}

fn held(origin: DVec3) -> Held {
    Held {
        origin,
        axes: DMat3::IDENTITY,
        half: DVec3::ONE,
        stays_m: DVec3::ONE,
        felt: None,
    }
}

#[test]
fn what_is_dragged_stays_under_the_pointer_within_a_pixel_through_all_that_is_seen_through() {
    let mut rng = Rng::with_seed(24);
    let (mut drags, mut bent, mut portals) = (0, 0, 0);
    for id in shipped::ROOMS.iter().map(|it| it.id) {
        let scene = room(id);
        for view in views(&scene) {
            for _ in 0..40 {
                let at = somewhere(&mut rng);
                let Some(seen) = scene.seen(&view, at) else {
                    continue;
                };
                let through = scene.through(&view, seen.chain.clone());
                let grabbed = seen.place.point;
                let Some(drag) = Drag::begin_body(&through, held(grabbed), grabbed, at) else {
                    continue;
                };
                let to = at + 0.1 * somewhere(&mut rng);
                let Some(Change::Move(way)) = drag.change(&through, to, &FREE) else {
                    continue;
                };
                // Places that come up to the horizon of their plane are hardly anywhere.
                if way.length() > 200.0 {
                    continue;
                }
                let there = through.seen_at(grabbed + way, to).unwrap();
                let off_px = view.apart(there, to) * HALF_PX;
                assert!(off_px < 1.0, "{id}: {off_px} px at {to}");
                drags += 1;
                bent += usize::from(!seen.chain.is_empty());
                portals += usize::from(seen.chain.has_portal());
            }
        }
    }
    assert!(
        drags > 1500 && bent > 300 && portals > 100,
        "{drags} {bent} {portals}"
    );
}

#[test]
fn handles_are_taken_hold_of_where_they_are_seen_and_follow_the_pointer_along_their_axes() {
    let mut rng = Rng::with_seed(25);
    let mut drags = [0; 3];
    for id in ["long-house", "big-house", "two-portals", "nested-boxes"] {
        let scene = room(id);
        for view in views(&scene) {
            for _ in 0..12 {
                let at = somewhere(&mut rng);
                let Some(seen) = scene.seen(&view, at) else {
                    continue;
                };
                let through = scene.through(&view, seen.chain.clone());
                for (number, tool) in [Tool::Move, Tool::Turn, Tool::Scale]
                    .into_iter()
                    .enumerate()
                {
                    let origin = seen.place.point;
                    let Some(handles) = Handles::of(&through, at, held(origin), tool) else {
                        continue;
                    };
                    drags[number] += pull(&through, &handles, id);
                }
            }
        }
    }
    assert!(drags.iter().all(|count| *count > 100), "{drags:?}");
}

/// Pulls each handle from its middle to another place of the line that it moves on, and sees whether it comes there.
fn pull(
    through: &antipode_room_scene::workshop::Through<'_>,
    handles: &Handles,
    id: &str,
) -> usize {
    let mut count = 0;
    for line in &handles.lines {
        let from = line.points[line.points.len() / 2];
        let found = handles.under(&through.view, from, 0.03);
        assert!(found.is_some(), "{id}: {:?} is not found", line.handle);
        let Some(drag) = Drag::begin(through, handles, line.handle, from) else {
            continue;
        };
        let nothing = drag.change(through, from, &FREE);
        let is_rest = match nothing {
            Some(Change::Move(way)) => way.length() < 1e-6 * (1.0 + handles.reach_m),
            Some(Change::Turn(_, rad)) => rad.abs() < 1e-6,
            Some(Change::Scale(times)) => (times - 1.0).abs().max_element() < 1e-6,
            Some(Change::Feel(times)) => (times - 1.0).abs() < 1e-6,
            None => true,
        };
        assert!(is_rest, "{id}: {:?} {nothing:?}", line.handle);
        if let (Handle::Size(axis), 9) = (line.handle, line.points.len())
            && let Some(Change::Scale(times)) = drag.change(through, line.points[8], &FREE)
        {
            // From 0.55 to 1 of the reach, with a side that stays a metre behind the middle.
            let reach = |share: f64| share * handles.reach_m + 1.0;
            let wanted = reach(1.0) / reach(0.55);
            assert!(
                (times[axis] - wanted).abs() < 0.02 * wanted,
                "{id}: {times} {wanted}"
            );
        }
        let (Handle::Along(axis), 9) = (line.handle, line.points.len()) else {
            count += 1;
            continue;
        };
        let to = line.points[line.points.len() - 1];
        let Some(Change::Move(way)) = drag.change(through, to, &FREE) else {
            continue;
        };
        let along = handles.held.axes.col(axis);
        // Arrows begin at a quarter of the reach.
        let wanted = handles.reach_m * (1.0 - 0.625);
        assert!(
            (way - along * wanted).length() < 0.02 * handles.reach_m,
            "{id}: {:?} {way} {wanted}",
            line.handle
        );
        count += 1;
    }
    count
}

#[test]
fn what_is_chosen_in_the_list_is_found_in_the_picture_where_it_is_seen() {
    let (mut found, mut all, mut bent) = (0, 0, 0);
    let mut rng = Rng::with_seed(26);
    for id in ["long-house", "big-house", "nested-boxes", "four-tunnels"] {
        let scene = room(id);
        for view in views(&scene) {
            for _ in 0..30 {
                let at = 0.9 * somewhere(&mut rng);
                let Some(seen) = scene.seen(&view, at).filter(|it| !it.chain.has_portal()) else {
                    continue;
                };
                // A point on a face of a box is in neither.
                let point = seen.place.point + 1e-6 * seen.normal;
                if scene.space().stack_at(point) != seen.place.stack {
                    continue;
                }
                all += 1;
                let Some((through, there)) = scene.way_to(&view, point, &[]) else {
                    continue;
                };
                // It may be seen by more ways than one; each leads to it.
                let leg = through.leg(there).unwrap();
                let off = (point - leg.place.point).reject_from(leg.velocity).length();
                assert!(off < 1e-5 * (1.0 + seen.felt_m), "{id}: {off}");
                found += 1;
                bent += usize::from(!through.chain.is_empty());
            }
        }
    }
    assert!(all > 300 && bent > 60, "{all} {bent}");
    assert!(found * 10 > all * 9, "{found} of {all}");
}

#[test]
fn steps_of_the_grid_and_of_turns_hold_places_and_angles() {
    let scene = empty();
    let view = scene.viewpoint(&FreeCamera::of(&scene.eye()), 1.5);
    let origin = DVec3::new(0.1, 0.6, -5.0);
    let (through, at) = scene.way_to(&view, origin, &[]).unwrap();
    let snap = Snap {
        grid_m: 0.25,
        turn_deg: 15.0,
    };
    let handles = Handles::of(&through, at, held(origin), Tool::Move).unwrap();
    let line = &handles.lines[0];
    let drag = Drag::begin(&through, &handles, line.handle, line.points[4]).unwrap();
    let Some(Change::Move(way)) = drag.change(&through, line.points[8], &snap) else {
        panic!("it is not moved")
    };
    let x = origin.x + way.x;
    assert!((x / 0.25 - (x / 0.25).round()).abs() < 1e-9, "{x}");
    assert!(x > 0.3 && way.y == 0.0 && way.z == 0.0, "{way}");
    let handles = Handles::of(&through, at, held(origin), Tool::Turn).unwrap();
    // About z, which points to the eye.
    let ring = handles.lines.last().unwrap();
    let drag = Drag::begin(&through, &handles, ring.handle, ring.points[0]).unwrap();
    let Some(Change::Turn(axis, rad)) = drag.change(&through, ring.points[6], &snap) else {
        panic!("it is not turned")
    };
    assert_eq!(axis, DVec3::Z);
    assert!(
        (rad.to_degrees() - 45.0).abs() < 1e-9,
        "{}",
        rad.to_degrees()
    );
}

#[test]
fn what_lies_off_the_grid_is_dragged_to_the_side_along_no_other_axis() {
    let scene = empty();
    let view = scene.viewpoint(&FreeCamera::of(&scene.eye()), 1.5);
    let origin = DVec3::new(0.1, 0.6, -5.07);
    let (through, at) = scene.way_to(&view, origin, &[]).unwrap();
    let handles = Handles::of(&through, at, held(origin), Tool::Move).unwrap();
    let is_plane = |it: &&antipode_room_scene::workshop::HandleLine| it.handle == Handle::Across(1);
    let line = handles.lines.iter().find(is_plane).unwrap();
    let from = line.points[0];
    let drag = Drag::begin(&through, &handles, line.handle, from).unwrap();
    let snap = Snap {
        grid_m: 0.25,
        turn_deg: 15.0,
    };
    // A hand is not level to the pixel.
    let to = from + DVec2::new(0.3, 0.002);
    let Some(Change::Move(way)) = drag.change(&through, to, &snap) else {
        panic!("it is not moved")
    };
    assert!(way.x > 0.3 && way.y == 0.0 && way.z == 0.0, "{way}");
}

#[test]
fn a_free_camera_goes_round_what_it_looks_at_and_through_portals() {
    let scene = room("two-portals");
    let mut camera = FreeCamera::of(&scene.eye());
    let target = DVec3::new(0.0, 1.0, -4.0);
    camera.focus(scene.space(), target, 1.0, 1.3);
    for _ in 0..8 {
        camera.orbit(scene.space(), 0.4, -0.05);
        let view = scene.viewpoint(&camera, 1.0);
        if let Some((through, at)) = scene.way_to(&view, target, &[])
            && through.chain.is_empty()
        {
            assert!(view.apart(at, DVec2::ZERO) < 1e-6, "{at}");
        }
    }
    let before = camera;
    camera.fly(scene.space(), DVec3::new(3.0, 1.0, -0.5));
    camera.fly(scene.space(), DVec3::new(-3.0, -1.0, 0.5));
    assert!(camera.point.distance(before.point) < 1e-9);
}

#[test]
fn an_aberration_is_held_from_outside_whatever_is_seen_in_it() {
    let scene = room("long-house");
    let objects = &scene.room().objects;
    let is_box =
        |it: &antipode_rooms::Object| matches!(it.what, antipode_rooms::What::Aberration(_));
    let index = objects.iter().position(|it| is_box(it)).unwrap();
    let point = antipode_rooms::poses(scene.room())[index].translation;
    let mut found = 0;
    for view in views(&scene) {
        if !view.eye.place.stack.is_empty() {
            continue;
        }
        let straight = point - view.eye.place.point;
        let Some(wanted) = view.place_of(straight) else {
            continue;
        };
        let (through, at) = scene.way_to(&view, point, &[index]).unwrap();
        assert!(through.chain.is_empty());
        assert!(view.apart(at, wanted) < 1e-6, "{at} {wanted}");
        found += 1;
    }
    assert!(found > 1, "{found}");
}
