//! Where paths lead that go through portals.

use antipode_deformation::{
    End, EventKind, MAX_EVENTS, Place, Portal, Sides, Space, Trace, Traveller, Triangles, trace,
};
use antipode_testing::rooms;
use fastrand::Rng;
use glam::{DQuat, DVec2, DVec3};

use crate::common::{go, portal, v};

/// By how much a path's rounding may have grown.
fn growth(space: &Space, path: &Trace) -> f64 {
    let of_box = |number: usize| {
        let stretch = space.placed()[number].aberration.stretch;
        stretch.max(stretch.recip()).max_element()
    };
    path.events
        .iter()
        .map(|event| match event.kind {
            EventKind::Passed => {
                let scale = space.portals()[event.number].scale;
                scale.max(scale.recip())
            }
            _ => of_box(event.number),
        })
        .product()
}

/// Whether rounding decides what a path does: it comes near to an edge.
fn grazes(space: &Space, path: &Trace) -> bool {
    path.events.iter().any(|event| {
        if event.kind == EventKind::Passed {
            let portal = &space.portals()[event.number];
            let local = portal.local(event.point);
            let room = |e: &DVec3| e.truncate().dot(local) - e.z;
            return portal.edges.iter().any(|edge| room(edge) < 1e-6);
        }
        let placed = &space.placed()[event.number];
        let room = (placed.aberration.half - placed.local(event.point).abs()).to_array();
        room.iter().filter(|room| room.abs() < 1e-6).count() > 1
    })
}

#[test]
fn every_path_leads_back_through_portals_with_roll_and_size() {
    let mut rng = Rng::with_seed(23);
    let (mut edges, mut passed, mut rays) = (0, 0, 0);
    for round in 0..60 {
        let boxes = if round % 3 == 0 {
            Vec::new()
        } else {
            rooms::aberrations(&mut rng, 3, 3.0, |_| Sides::Soft)
        };
        let mut portals = rooms::portals(&mut rng, &boxes, 6, 3.0);
        for one in &mut portals {
            // From behind one of one side nothing is met, and on the way back it is.
            one.two_sided = true;
        }
        let space = Space::with_portals(boxes, portals).unwrap();
        for _ in 0..200 {
            let start = Place::at(&space, rooms::point(&mut rng));
            let there = go(&space, &start, rooms::direction(&mut rng), 30.0);
            if there.end == End::TooManyEvents {
                continue;
            }
            rays += 1;
            let back = go(&space, &there.place, -there.w, there.length);
            let miss = (back.place.point - start.point).length();
            let gone = there
                .events
                .iter()
                .filter(|it| it.kind == EventKind::Passed);
            passed += gone.count();
            let allowed = 1e-12 * growth(&space, &there).max(30.0);
            let turned = back.place.turn.angle_between(DQuat::IDENTITY);
            let is_back = turned < 1e-7 && (back.place.scale - 1.0).abs() < 1e-12;
            if miss > allowed || !is_back {
                edges += 1;
                assert!(
                    grazes(&space, &there),
                    "{round}: {miss:e} {there:?} {back:?}"
                );
            }
        }
    }
    assert!(
        rays > 11_000 && passed > 600,
        "{rays} rays, {passed} portals"
    );
    assert!(edges < 10, "{edges} of {rays} rays");
}

/// Two portals of 2 x 2 m that look at each other across four metres.
fn facing() -> Space {
    let one = portal("west", v(-2.0, 0.0, 0.0), 0.0, 1);
    let other = portal("east", v(2.0, 0.0, 0.0), 180.0, 0);
    Space::with_portals(Vec::new(), vec![one, other]).unwrap()
}

#[test]
fn portals_that_face_each_other_give_a_row() {
    let space = facing();
    let start = Place::at(&space, DVec3::ZERO);
    for length in [1.0, 3.0, 9.0, 201.0] {
        let path = go(&space, &start, DVec3::X, length);
        let times = ((length - 2.0) / 4.0 + 1.0).floor().max(0.0);
        assert_eq!(path.events.len(), times as usize, "{length}");
        let expected = length - 4.0 * times;
        assert!((path.place.point.x - expected).abs() < 1e-12, "{path:?}");
        assert!((path.place.turn * path.w - DVec3::X).length() < 1e-12);
    }
    let path = go(&space, &start, DVec3::X, 1000.0);
    assert_eq!(
        (path.end, path.events.len()),
        (End::TooManyEvents, MAX_EVENTS)
    );
}

#[test]
fn in_a_row_what_is_four_metres_on_is_the_same_thing() {
    let space = facing();
    let post = rooms::cuboid(v(0.0, 0.0, 0.5), DQuat::IDENTITY, DVec3::splat(0.02), 7);
    let scene = Triangles::new(post);
    let start = Place::at(&space, DVec3::ZERO);
    for times in 1..10 {
        let aim = v(4.0 * f64::from(times), 0.0, 0.5);
        let w = aim.normalize();
        let path = trace(&space, &start, w, 100.0, &scene, &Traveller::Body);
        assert_eq!(path.events.len(), times as usize);
        assert!(path.hit().is_some());
        assert!((path.length - (aim.length() - 0.02 * aim.length() / aim.x)).abs() < 1e-9);
    }
}

#[test]
fn what_is_behind_a_portal_is_what_is_seen_straight_on_where_g_takes_it() {
    let mut rng = Rng::with_seed(9);
    let mut passed = 0;
    for _ in 0..40 {
        let portals = rooms::portals(&mut rng, &[], 6, 4.0);
        let space = Space::with_portals(Vec::new(), portals).unwrap();
        for _ in 0..200 {
            let start = Place::at(&space, rooms::point(&mut rng));
            let (w, length) = (rooms::direction(&mut rng), 20.0);
            let path = go(&space, &start, w, length);
            let straight = start.point + w * length;
            let unrolled = path.events.iter().fold(straight, |at, event| {
                space.portals()[event.number].map.transform_point3(at)
            });
            passed += path.events.len();
            assert!((path.place.point - unrolled).length() < 1e-10, "{path:?}");
        }
    }
    assert!(passed > 100, "{passed}");
}

#[test]
fn who_stops_on_the_plane_goes_on_through_and_who_turns_there_goes_back() {
    let space = facing();
    let start = Place::at(&space, DVec3::ZERO);
    let step = |place: &Place, w: DVec3, length: f64| go(&space, place, w, length).place;
    let on_plane = step(&start, DVec3::X, 2.0);
    let through = step(&on_plane, DVec3::X, 1.0);
    assert!(
        (through.point - v(-1.0, 0.0, 0.0)).length() < 1e-12,
        "{through:?}"
    );
    // Behind it, on the other's plane to the last digit.
    let tiny = step(&step(&start, DVec3::X, 2.0), DVec3::X, 0.0);
    let just_out = step(&tiny, DVec3::X, 1e-14);
    for place in [tiny, just_out] {
        let on = step(&place, DVec3::X, 1.0);
        assert!((on.point.x - -1.0).abs() < 1e-9, "{on:?}");
        let back = step(&place, DVec3::NEG_X, 1.0);
        assert!((back.point.x - 1.0).abs() < 1e-9, "{back:?}");
    }
}

#[test]
fn through_portals_too_one_comes_to_one_place_at_any_rate() {
    let mut rng = Rng::with_seed(5);
    let mut passed = 0;
    for round in 0..30 {
        let boxes = rooms::aberrations(&mut rng, 2 * usize::from(round % 2 == 0), 3.0, |_| {
            Sides::Soft
        });
        let portals = rooms::portals(&mut rng, &boxes, 6, 2.0);
        let space = Space::with_portals(boxes, portals).unwrap();
        for _ in 0..30 {
            let start = Place::at(&space, rooms::point(&mut rng));
            let w = rooms::direction(&mut rng);
            let whole = go(&space, &start, w, 12.0);
            passed += whole.place.passage.count;
            for rate in [30, 60, 144, 1000] {
                let mut place = start;
                for _ in 0..3 * rate {
                    place = go(&space, &place, w, 4.0 / f64::from(rate)).place;
                }
                let off = (place.point - whole.place.point).length();
                assert!(off < 1e-6 || grazes(&space, &whole), "{rate}: {off:e}");
            }
        }
    }
    assert!(passed > 30, "{passed}");
}

#[test]
fn from_behind_a_portal_of_one_side_is_nothing_and_of_two_leads_on() {
    let pair = |two_sided: bool| {
        let mut both = [
            portal("one", DVec3::ZERO, 0.0, 1),
            portal("other", v(50.0, 0.0, 0.0), 0.0, 0),
        ];
        for one in &mut both {
            one.two_sided = two_sided;
        }
        Space::with_portals(Vec::new(), both.to_vec()).unwrap()
    };
    let from_behind = |space: &Space| {
        let start = Place::at(space, v(-1.0, 0.2, 0.3));
        go(space, &start, DVec3::X, 3.0).place.point
    };
    assert!((from_behind(&pair(false)) - v(2.0, 0.2, 0.3)).length() < 1e-12);
    // It comes out of the other's back.
    let out = from_behind(&pair(true));
    assert!((out - v(48.0, 0.2, -0.3)).length() < 1e-12, "{out}");
}

#[test]
fn who_goes_into_a_portal_twice_as_large_comes_out_twice_as_large() {
    let mut large = portal("large", v(50.0, 0.0, 0.0), 0.0, 0);
    large.polygon = Portal::rectangle(DVec2::splat(4.0));
    let small = portal("small", DVec3::ZERO, 0.0, 1);
    let space = Space::with_portals(Vec::new(), vec![small, large]).unwrap();
    let start = Place::at(&space, v(1.0, 0.5, 0.25));
    let path = go(&space, &start, DVec3::NEG_X, 4.0);
    assert!((path.place.scale - 2.0).abs() < 1e-12);
    // A metre before it, and three of its own behind it.
    assert!(
        (path.place.point - v(56.0, 1.0, -0.5)).length() < 1e-12,
        "{path:?}"
    );
    assert_eq!(path.length, 4.0);
}

#[test]
fn a_portal_may_be_its_own_partner_and_shows_who_looks_into_it() {
    let own = portal("own", DVec3::ZERO, 0.0, 0);
    let space = Space::with_portals(Vec::new(), vec![own]).unwrap();
    let start = Place::at(&space, v(3.0, 0.0, 0.4));
    let path = go(&space, &start, DVec3::NEG_X, 6.0);
    assert!((path.place.point - v(3.0, 0.0, -0.4)).length() < 1e-12);
    // A mirror would leave what is to the right there.
    assert!((path.place.turn * DVec3::Z - DVec3::NEG_Z).length() < 1e-12);
}

#[test]
fn a_portal_on_a_wall_is_a_hole_in_it() {
    let space = facing();
    let wall = |x: f64| rooms::cuboid(v(x, 0.0, 0.0), DQuat::IDENTITY, v(0.5, 3.0, 3.0), 1);
    let scene = Triangles::new([wall(-2.5), wall(2.5)].concat());
    let mut rng = Rng::with_seed(8);
    for _ in 0..2000 {
        let w = (DVec3::X + 0.5 * rooms::direction(&mut rng)).normalize();
        let start = Place::at(&space, DVec3::ZERO);
        let path = trace(&space, &start, w, 3.9, &scene, &Traveller::Body);
        let at = w * (2.0 / w.x);
        let is_through = at.y.abs() < 1.0 && at.z.abs() < 1.0;
        assert_eq!(path.hit().is_none(), is_through, "{w} {path:?}");
    }
}
