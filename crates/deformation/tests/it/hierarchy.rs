//! The hierarchy finds what every triangle asked one by one finds.

use std::sync::Arc;

use antipode_deformation::{Form, SceneHit, SceneQuery, Solids, Standing, Triangle, Triangles};
use antipode_testing::rooms;
use fastrand::Rng;
use glam::{DAffine3, DQuat, DVec3};

#[test]
fn what_is_met_first_is_what_asking_every_triangle_finds() {
    let mut rng = Rng::with_seed(9);
    let scene = Triangles::new(rooms::solids(&mut rng, 300));
    let mut hits = 0;
    for _ in 0..5000 {
        let (x, mut v) = (
            rooms::point(&mut rng),
            rooms::direction(&mut rng) * (0.1 + rng.f64()),
        );
        if rng.f64() < 0.1 {
            v[rng.usize(..3)] = 0.0;
        }
        let longest = 30.0 * rng.f64();
        let (found, all) = (
            scene.first(x, v, longest),
            scene.first_of_all(x, v, longest),
        );
        assert_eq!(found.map(|hit| hit.time), all.map(|hit| hit.time));
        hits += usize::from(found.is_some());
    }
    assert!(hits > 1000 && hits < 5000, "{hits}");
}

#[test]
fn triangles_near_a_place_are_all_shown() {
    let mut rng = Rng::with_seed(10);
    let scene = Triangles::new(rooms::solids(&mut rng, 100));
    for _ in 0..200 {
        let at = rooms::point(&mut rng);
        let (low, high) = (at - DVec3::splat(1.0), at + DVec3::splat(1.0));
        let mut shown = Vec::new();
        scene.near(low, high, &mut |corners| shown.push(corners));
        for triangle in scene.triangles() {
            let [a, b, c] = triangle.corners;
            let touches = a.min(b).min(c).cmple(high).all() && a.max(b).max(c).cmpge(low).all();
            assert!(!touches || shown.contains(&triangle.corners));
        }
    }
}

#[test]
fn an_empty_scene_is_met_nowhere() {
    let scene = Triangles::default();
    assert_eq!(scene.first(DVec3::ZERO, DVec3::X, 9.0), None);
}

/// Forms that stand about, and the same triangles one by one.
fn standing(rng: &mut Rng, count: usize) -> (Solids, Triangles) {
    let forms: Vec<_> = (0..5).map(|_| form(rng)).collect();
    let mut all = Vec::new();
    let mut list = Vec::new();
    for object in 0..count as u32 {
        let (form, triangles) = &forms[rng.usize(..forms.len())];
        let turn = DQuat::from_axis_angle(rooms::direction(rng), 6.0 * rng.f64());
        let turn = if object % 3 == 0 {
            DQuat::IDENTITY
        } else {
            turn
        };
        let scale = DVec3::splat(0.1 + 2.0 * rng.f64());
        let pose = DAffine3::from_scale_rotation_translation(scale, turn, rooms::point(rng));
        all.extend(triangles.iter().map(|it| Triangle {
            corners: it.map(|corner| pose.transform_point3(corner)),
            object,
        }));
        let form = form.clone();
        list.push(Standing { form, pose, object });
    }
    (Solids::new(list), Triangles::new(all))
}

/// A few triangles, some of them in a plane of the axes.
fn form(rng: &mut Rng) -> (Arc<Form>, Vec<[DVec3; 3]>) {
    let corners: Vec<_> = (0..30)
        .map(|number| {
            let mut corner = rooms::direction(rng) * rng.f64();
            if number < 12 {
                corner.y = 0.0;
            }
            corner
        })
        .collect();
    let triangles: Vec<[u32; 3]> = (0..10).map(|it| [3 * it, 3 * it + 1, 3 * it + 2]).collect();
    let of = |it: &[u32; 3]| it.map(|one| corners[one as usize]);
    let listed = triangles.iter().map(of).collect();
    (Arc::new(Form::new(corners, triangles)), listed)
}

#[test]
fn forms_are_met_where_their_triangles_are_and_shown_near_a_place() {
    let mut rng = Rng::with_seed(12);
    let (solids, triangles) = standing(&mut rng, 400);
    let mut hits = 0;
    for _ in 0..5000 {
        let (x, mut v) = (rooms::point(&mut rng), rooms::direction(&mut rng));
        if rng.f64() < 0.1 {
            v[rng.usize(..3)] = 0.0;
        }
        let longest = 30.0 * rng.f64();
        let (found, all) = (
            solids.first(x, v, longest),
            triangles.first_of_all(x, v, longest),
        );
        // Triangles of a form that lie in one plane are met at once, from either side.
        let told = |hit: SceneHit| (hit.time, hit.object);
        assert_eq!(found.map(told), all.map(told));
        hits += usize::from(found.is_some());
    }
    assert!(hits > 500, "{hits}");
    for _ in 0..200 {
        let at = rooms::point(&mut rng);
        let (low, high) = (at - DVec3::splat(1.0), at + DVec3::splat(1.0));
        let mut shown = Vec::new();
        solids.near(low, high, &mut |corners| shown.push(corners));
        for triangle in triangles.triangles() {
            let [a, b, c] = triangle.corners;
            let touches = a.min(b).min(c).cmple(high).all() && a.max(b).max(c).cmpge(low).all();
            // Boxes along other axes may part what boxes along these do not.
            let places = (0..=10).flat_map(|n| (0..=10 - n).map(move |m| (n, m)));
            let mut places = places
                .map(|(n, m)| a + (b - a) * f64::from(n) / 10.0 + (c - a) * f64::from(m) / 10.0);
            let reaches = places.any(|it| it.cmpge(low).all() && it.cmple(high).all());
            let is_shown = shown.contains(&triangle.corners);
            assert!(is_shown || !reaches, "{:?}", triangle.corners);
            assert!(touches || !is_shown, "{:?}", triangle.corners);
        }
    }
    for up in [DVec3::Y, rooms::direction(&mut rng)] {
        let all = triangles.triangles().iter().flat_map(|it| it.corners);
        let lowest = all.map(|it| it.dot(up)).fold(f64::INFINITY, f64::min);
        assert!((solids.lowest(up) - lowest).abs() < 1e-12);
    }
}
