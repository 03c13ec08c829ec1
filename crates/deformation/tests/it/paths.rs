//! Where paths lead.

use antipode_deformation::{
    Aberration, End, EventKind, Place, Sides, Space, Trace, Traveller, Triangles, What, trace,
};
use antipode_testing::rooms;
use fastrand::Rng;
use glam::{DQuat, DVec3};

use crate::common::{boxed, go, space, v};

/// By how much a path's rounding may have grown.
fn growth(space: &Space, path: &Trace) -> f64 {
    let of = |number: usize| {
        let stretch = space.placed()[number].aberration.stretch;
        stretch.max(stretch.recip()).max_element()
    };
    path.events.iter().map(|event| of(event.number)).product()
}

#[test]
fn every_path_leads_back() {
    let mut rng = Rng::with_seed(22);
    let (mut edges, mut events) = (0, 0);
    for round in 0..60 {
        let soft = |_: &mut Rng| Sides::Soft;
        let mixed = |rng: &mut Rng| {
            if rng.bool() {
                Sides::Soft
            } else {
                Sides::Snell
            }
        };
        let boxes = if round % 2 == 0 {
            rooms::aberrations(&mut rng, 4, 5.0, soft)
        } else {
            rooms::aberrations(&mut rng, 3, 3.0, mixed)
        };
        let space = space(boxes);
        for _ in 0..200 {
            let start = Place::at(&space, rooms::point(&mut rng));
            let there = go(&space, &start, rooms::direction(&mut rng), 30.0);
            if there.end == End::TooManyEvents {
                continue;
            }
            let back = go(&space, &there.place, -there.w, there.length);
            let miss = (back.place.point - start.point).length();
            events += there.events.len();
            // What grazes a face, or an edge, goes another way back: rounding decides there.
            if miss > 1e-12 * growth(&space, &there).max(30.0) {
                edges += 1;
                assert!(grazes(&space, &there), "{round}: {miss:e} {there:?}");
            }
        }
    }
    assert!(events > 15_000, "{events}");
    assert!(edges < 30, "{edges} of 12,000 rays");
}

/// Whether a path comes so near to an edge, or so flat to a face, that rounding decides what it does.
fn grazes(space: &Space, path: &Trace) -> bool {
    path.events.iter().any(|event| {
        let placed = &space.placed()[event.number];
        let room = (placed.aberration.half - placed.local(event.point).abs()).to_array();
        room.iter().filter(|room| room.abs() < 1e-6).count() > 1
    })
}

#[test]
fn a_tunnel_unrolled_is_straight() {
    let (half, felt) = (v(3.0, 2.0, 5.0), 50.0);
    let tunnel = Aberration::tunnel(DVec3::ZERO, DQuat::IDENTITY, half, 2, felt);
    let space = space([tunnel]);
    let mut rng = Rng::with_seed(1);
    let mut passed = 0;
    while passed < 5000 {
        let from = v(
            2.9 * (rng.f64() - 0.5),
            1.9 * (rng.f64() - 0.5),
            -5.0 - 3.0 * rng.f64(),
        );
        let w = v(rng.f64() * 0.1 - 0.05, rng.f64() * 0.1 - 0.05, 1.0).normalize();
        let length = 70.0 * rng.f64();
        let path = go(&space, &Place::at(&space, from), w, length);
        if path.hit().is_some() {
            continue;
        }
        passed += 1;
        // Along the axis the doors are 50 m apart when one walks, and 10 m in the scene.
        let mut expected = from + w * length;
        expected.z = match expected.z {
            z if z <= -5.0 => z,
            z if z <= 45.0 => -5.0 + (z + 5.0) / 5.0,
            z => z - 40.0,
        };
        assert!(
            (path.place.point - expected).length() < 2e-13,
            "{path:?} {expected}"
        );
        assert_eq!(path.w, w);
    }
}

#[test]
fn a_stretch_of_one_is_no_box() {
    let mut rng = Rng::with_seed(3);
    let mut boxes = rooms::aberrations(&mut rng, 4, 5.0, |_| Sides::Soft);
    for one in &mut boxes {
        one.stretch = DVec3::ONE;
        one.sides = [Sides::Soft, Sides::Snell, Sides::Walls][rng.usize(..3)];
    }
    let (with, without) = (space(boxes), Space::default());
    let scene = Triangles::new(rooms::solids(&mut rng, 100));
    for _ in 0..3000 {
        let (point, w) = (rooms::point(&mut rng), rooms::direction(&mut rng));
        let see = |space: &Space| {
            trace(
                space,
                &Place::at(space, point),
                w,
                99.0,
                &scene,
                &Traveller::Body,
            )
        };
        let (one, other) = (see(&with), see(&without));
        assert_eq!(
            one.hit().map(|hit| hit.what),
            other.hit().map(|hit| hit.what)
        );
        assert!((one.length - other.length).abs() < 1e-11);
        assert!((one.place.point - other.place.point).length() < 1e-11);
    }
}

#[test]
fn however_often_a_second_is_parted_one_walks_to_one_place() {
    let mut rng = Rng::with_seed(4);
    for _ in 0..20 {
        let space = space(rooms::aberrations(&mut rng, 5, 5.0, |_| Sides::Soft));
        for _ in 0..5 {
            let start = Place::at(&space, rooms::point(&mut rng));
            let (w, speed) = (rooms::direction(&mut rng), 4.0);
            let whole = go(&space, &start, w, speed * 3.0).place;
            for rate in [30, 60, 144, 1000] {
                let mut place = start;
                for _ in 0..3 * rate {
                    place = go(&space, &place, w, speed / f64::from(rate)).place;
                }
                let off = (place.point - whole.point).length();
                assert!(off < 1e-6, "{rate} steps a second end {off:e} m off");
                assert_eq!(place.stack, whole.stack);
            }
        }
    }
}

#[test]
fn one_walks_to_what_the_crosshair_shows() {
    let mut rng = Rng::with_seed(5);
    let space = space(rooms::aberrations(&mut rng, 4, 6.0, |_| Sides::Soft));
    let scene = Triangles::new(rooms::solids(&mut rng, 60));
    for _ in 0..200 {
        let start = Place::at(&space, rooms::point(&mut rng));
        let w = rooms::direction(&mut rng);
        let seen = trace(&space, &start, w, 200.0, &scene, &Traveller::Body);
        let Some(aim) = seen.hit() else { continue };
        let (mut place, mut steps) = (start, 0);
        let reached = loop {
            let step = trace(
                &space,
                &place,
                w,
                0.01 + 0.1 * rng.f64(),
                &scene,
                &Traveller::Body,
            );
            place = step.place;
            steps += 1;
            assert!(steps < 10_000);
            if let Some(hit) = step.hit() {
                break hit.what;
            }
        };
        assert_eq!(reached, aim.what);
        assert!((place.point - seen.place.point).length() < 1e-9);
    }
}

#[test]
fn nothing_jumps_where_the_eye_enters_a_box() {
    let mut rng = Rng::with_seed(6);
    let space = space([boxed(
        "soft",
        DVec3::ZERO,
        v(4.0, 3.0, 5.0),
        v(0.4, 2.0, 5.0),
        Sides::Soft,
    )]);
    let scene = Triangles::new(rooms::solids(&mut rng, 60));
    let see = |point: DVec3, w| {
        trace(
            &space,
            &Place::at(&space, point),
            w,
            200.0,
            &scene,
            &Traveller::Body,
        )
    };
    let mut differ = 0;
    for _ in 0..2000 {
        let on_face = v(6.0 * rng.f64() - 3.0, 4.0 * rng.f64() - 2.0, -5.0);
        let w = rooms::direction(&mut rng);
        let (before, after) = (
            see(on_face - v(0.0, 0.0, 1e-9), w),
            see(on_face + v(0.0, 0.0, 1e-9), w),
        );
        let jump = (before.place.point - after.place.point).length();
        differ += usize::from(jump > 1e-5);
    }
    assert!(
        differ <= 2,
        "{differ} of 2000 rays jump, which is more than edges of solids"
    );
}

#[test]
fn rays_at_edges_and_corners_end_and_know_where_they_are() {
    // Boxes that share faces, edges and corners, and one that fills another.
    let cube = |name: &str, x: f64, y: f64, z: f64, s: f64| {
        boxed(
            name,
            v(x, y, z),
            DVec3::ONE,
            v(s, 1.0, 1.0 / s),
            Sides::Soft,
        )
    };
    let mut boxes = vec![
        cube("a", -1.0, -1.0, -1.0, 3.0),
        cube("b", 1.0, -1.0, -1.0, 0.4),
        cube("c", -1.0, 1.0, 1.0, 2.0),
        cube("d", 1.0, 1.0, 1.0, 5.0),
        cube("filled", 1.0, -1.0, -1.0, 2.0),
    ];
    boxes.push(boxed(
        "half",
        v(1.5, 1.0, 1.0),
        v(0.5, 1.0, 1.0),
        v(1.0, 3.0, 1.0),
        Sides::Soft,
    ));
    let space = space(boxes);
    let mut most = 0;
    for from in lattice(5) {
        for to in lattice(2) {
            let Some(w) = (to - from).try_normalize() else {
                continue;
            };
            let path = go(&space, &Place::at(&space, from), w, 40.0);
            most = most.max(path.events.len());
            assert_eq!(path.end, End::Spent, "{from} {to}");
            let there = path.place.point;
            let is_outside = there.abs().max_element() > 2.0 + 1e-9;
            assert!(
                !is_outside || path.place.stack.is_empty(),
                "{from} to {to}: {path:?}"
            );
        }
    }
    assert!((4..=12).contains(&most), "{most}");
}

fn lattice(reach: i32) -> impl Iterator<Item = DVec3> {
    let side = -reach..=reach;
    side.clone().flat_map(move |x| {
        let side = side.clone();
        side.clone()
            .flat_map(move |y| side.clone().map(move |z| v(x.into(), y.into(), z.into())))
    })
}

#[test]
fn the_stack_agrees_with_the_place_in_nested_boxes() {
    let mut rng = Rng::with_seed(8);
    let mut deepest = 0;
    for _ in 0..20 {
        let space = space(rooms::aberrations(&mut rng, 7, 3.0, |_| Sides::Soft));
        for _ in 0..200 {
            let start = Place::at(&space, rooms::point(&mut rng));
            deepest = deepest.max(start.stack.len());
            let path = go(&space, &start, rooms::direction(&mut rng), 5.0 * rng.f64());
            if path.end == End::Spent {
                assert_eq!(
                    path.place.stack,
                    space.stack_at(path.place.point),
                    "{path:?}"
                );
            }
        }
    }
    assert!(deepest >= 4, "{deepest}");
}

#[test]
fn a_path_through_nested_boxes_has_the_product_of_their_stretches() {
    let outer = boxed(
        "outer",
        DVec3::ZERO,
        DVec3::splat(4.0),
        v(2.0, 1.0, 1.0),
        Sides::Soft,
    );
    let inner = boxed(
        "inner",
        DVec3::ZERO,
        DVec3::splat(1.0),
        v(3.0, 1.0, 1.0),
        Sides::Soft,
    );
    let space = space([inner, outer]);
    let path = go(
        &space,
        &Place::at(&space, v(-6.0, 0.1, 0.2)),
        DVec3::X,
        27.0,
    );
    // 2 m before, 3 m felt as 6, 2 m felt as 12, 3 m felt as 6, and 1 m behind.
    assert!((path.place.point.x - 5.0).abs() < 1e-12, "{path:?}");
    let kinds: Vec<_> = path
        .events
        .iter()
        .map(|event| (event.kind, event.number))
        .collect();
    let (entered, left) = (EventKind::Entered, EventKind::Left);
    assert_eq!(kinds, [(entered, 1), (entered, 0), (left, 0), (left, 1)]);
    let lengths: Vec<_> = path
        .events
        .iter()
        .map(|event| event.length.round())
        .collect();
    assert_eq!(lengths, [2.0, 8.0, 20.0, 26.0]);
}

#[test]
fn a_path_that_never_ends_is_cut_after_64_events() {
    let slab = |n: i32| {
        boxed(
            "slab",
            v(2.0 * f64::from(n), 0.0, 0.0),
            v(0.5, 9.0, 9.0),
            v(2.0, 1.0, 1.0),
            Sides::Soft,
        )
    };
    let space = space((0..40).map(slab).collect::<Vec<_>>());
    let path = go(&space, &Place::at(&space, v(-3.0, 0.0, 0.0)), DVec3::X, 1e3);
    assert_eq!((path.end, path.events.len()), (End::TooManyEvents, 64));
}

#[test]
fn a_box_of_one_way_is_felt_one_way() {
    let mut one_way = boxed(
        "way",
        DVec3::ZERO,
        v(2.0, 2.0, 5.0),
        v(1.0, 1.0, 4.0),
        Sides::Soft,
    );
    one_way.ways = antipode_deformation::Ways::Along(2);
    let space = space([one_way]);
    let felt = |from: f64, w: DVec3| {
        let path = go(&space, &Place::at(&space, v(0.0, 0.0, from)), w, 45.0);
        path.events.last().unwrap().length
    };
    assert!((felt(-6.0, DVec3::Z) - 41.0).abs() < 1e-12);
    assert!((felt(6.0, -DVec3::Z) - 11.0).abs() < 1e-12);
}

#[test]
fn walls_are_hit_from_both_sides_and_doors_are_open() {
    let tunnel = Aberration::tunnel(DVec3::ZERO, DQuat::IDENTITY, v(1.0, 1.0, 5.0), 2, 50.0);
    let space = space([tunnel]);
    let hit = |from: DVec3, w: DVec3| {
        go(&space, &Place::at(&space, from), w, 99.0)
            .hit()
            .map(|hit| (hit.what, hit.normal))
    };
    assert_eq!(
        hit(v(-3.0, 0.0, 0.0), DVec3::X),
        Some((What::Wall(0, 0), -DVec3::X))
    );
    assert_eq!(
        hit(v(0.0, 0.0, 1.0), DVec3::Y),
        Some((What::Wall(0, 1), -DVec3::Y))
    );
    assert_eq!(hit(v(0.0, 0.0, -9.0), DVec3::Z), None);
}
