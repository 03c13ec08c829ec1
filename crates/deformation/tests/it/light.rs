//! Lamps, the sun and normals.

use antipode_deformation::{
    End, LampPath, Place, Sides, Space, Traveller, Triangles, Void, felt_normal, lamp_paths,
    sun_is_seen, trace,
};
use antipode_testing::rooms;
use fastrand::Rng;
use glam::{DQuat, DVec3};

use crate::common::{boxed, go, space, v};

/// Lamps where paths have ended that passed as many faces: the way there must be among those that are found.
fn found_again(space: &Space, rng: &mut Rng, faces: usize) -> (f64, f64, usize) {
    let (mut off, mut miss, mut count) = (0.0_f64, 0.0_f64, 0);
    for _ in 0..4000 {
        let from = Place::at(space, rooms::point(rng));
        let path = go(space, &from, rooms::direction(rng), 12.0 * rng.f64());
        let crossed: Vec<_> = path.events.iter().map(|event| event.number).collect();
        let is_pair = faces != 2
            || (crossed.len() == 2 && crossed[0] == crossed[1] && is_parallel(space, &path.events));
        if crossed.len() != faces || !is_pair || path.end != End::Spent {
            continue;
        }
        count += 1;
        let ways = lamp_paths(space, &from, &path.place);
        let nearest = |way: &LampPath| (way.w - path.w).length() + (way.length - path.length).abs();
        let best = ways.iter().min_by(|a, b| nearest(a).total_cmp(&nearest(b)));
        off = off.max(best.map_or(f64::INFINITY, nearest));
        let seen = best.is_some_and(|way| way.is_clear(space, &from, &path.place, &Void));
        assert!(seen, "{from:?} {:?} {ways:?}", path.place);
        if let Some(way) = best {
            let end = go(space, &from, way.w, way.length).place.point;
            miss = miss.max((end - path.place.point).length());
        }
    }
    (off, miss, count)
}

/// Whether a box was entered and left across the same axis.
fn is_parallel(space: &Space, events: &[antipode_deformation::Event]) -> bool {
    let axis = |event: &antipode_deformation::Event| {
        let placed = &space.placed()[event.number];
        let room = placed.aberration.half - placed.local(event.point).abs();
        (0..3).min_by(|a, b| room[*a].abs().total_cmp(&room[*b].abs()))
    };
    axis(&events[0]) == axis(&events[1])
}

#[test]
fn lamps_are_seen_where_light_goes_through_no_one_or_two_parallel_faces() {
    let mut rng = Rng::with_seed(11);
    let mut seen = [0; 3];
    for _ in 0..12 {
        let space = space(rooms::aberrations(&mut rng, 3, 4.0, |_| Sides::Soft));
        for (faces, count) in seen.iter_mut().enumerate() {
            let (off, miss, found) = found_again(&space, &mut rng, faces);
            // Numbers up to 12 m are 2e-15 m apart. Short ways tell their direction from the difference of two of them.
            assert!(
                off < 2e-11 && miss < 1e-13,
                "{faces} faces: {off:e} {miss:e}"
            );
            *count += found;
        }
    }
    assert!(seen.iter().all(|count| *count > 100), "{seen:?}");
}

#[test]
fn a_lamp_in_a_box_shines_through_up_to_three_faces_and_adds() {
    let space = space([boxed(
        "box",
        DVec3::ZERO,
        DVec3::splat(1.0),
        v(0.2, 5.0, 1.0),
        Sides::Soft,
    )]);
    let lamp = Place::at(&space, v(0.7, 0.7, 0.1));
    let from = Place::at(&space, v(3.0, 3.0, 0.5));
    let ways = lamp_paths(&space, &from, &lamp);
    let clear = ways
        .iter()
        .filter(|way| way.is_clear(&space, &from, &lamp, &Void))
        .count();
    assert_eq!((ways.len(), clear), (ways.len(), ways.len()));
    assert!(clear >= 1);
}

#[test]
fn the_lamp_s_formula_is_that_of_the_design() {
    let (half, s) = (DVec3::splat(2.0), v(3.0, 0.5, 1.5));
    let space = space([boxed("box", DVec3::ZERO, half, s, Sides::Soft)]);
    let (p, lamp) = (v(-5.0, 0.3, 0.2), v(0.5, -0.4, 0.6));
    let a = (lamp.x - p.x) / (-2.0 - p.x);
    let w = DVec3::from_array([0, 1, 2].map(|j| (lamp - p)[j] / (1.0 + (a - 1.0) * s.x / s[j])))
        .normalize();
    let ways = lamp_paths(&space, &Place::at(&space, p), &Place::at(&space, lamp));
    assert!(
        ways.iter().any(|way| (way.w - w).length() < 1e-14),
        "{ways:?} {w}"
    );
}

#[test]
fn the_sun_is_hidden_by_what_stands_on_the_way_to_it_through_boxes() {
    let space = space([boxed(
        "box",
        v(0.0, 5.0, 0.0),
        v(2.0, 2.0, 2.0),
        v(4.0, 1.0, 1.0),
        Sides::Soft,
    )]);
    let sun = v(1.0, 1.0, 0.0).normalize();
    let place = Place::at(&space, v(-3.0, 0.0, 0.0));
    // Enters the box at (0, 3, 0), goes up in it by 2 m felt as 2 while x gains 0.5, and then on.
    let wall = |x: f64| {
        Triangles::new(rooms::cuboid(
            v(x, 6.9, 0.0),
            DQuat::IDENTITY,
            v(0.1, 0.05, 1.0),
            0,
        ))
    };
    assert!(!sun_is_seen(
        &space,
        &place,
        sun,
        100.0,
        &wall(0.0 + 3.9 / 4.0)
    ));
    assert!(sun_is_seen(&space, &place, sun, 100.0, &wall(3.9)));
}

#[test]
fn normals_are_those_of_felt_tangents() {
    let mut rng = Rng::with_seed(12);
    let mut most: f64 = 0.0;
    for _ in 0..20 {
        let space = space(rooms::aberrations(&mut rng, 3, 8.0, |_| Sides::Soft));
        let scene = Triangles::new(rooms::solids(&mut rng, 200));
        for _ in 0..100 {
            let start = Place::at(&space, rooms::point(&mut rng));
            let path = trace(
                &space,
                &start,
                rooms::direction(&mut rng),
                99.0,
                &scene,
                &Traveller::Body,
            );
            let Some(hit) = path.hit() else { continue };
            let k = space.squeeze(&path.place.stack, path.w, &Traveller::Body);
            let tangents = [
                hit.normal.any_orthonormal_pair().0,
                hit.normal.any_orthonormal_pair().1,
            ];
            for tangent in tangents {
                let felt = (k.inverse() * tangent).normalize();
                assert!(felt.dot(hit.felt_normal).abs() < 1e-12);
            }
            assert!(
                hit.felt_normal.dot(path.w) < 0.0,
                "the felt normal looks against the felt ray"
            );
            assert_eq!(hit.felt_normal, felt_normal(k, hit.normal));
            most = most.max(
                (k * hit.normal)
                    .normalize()
                    .angle_between(hit.felt_normal)
                    .to_degrees(),
            );
        }
    }
    assert!(most > 45.0, "K n would have been {most} degrees off");
}
