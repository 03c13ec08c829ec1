//! The hierarchy finds what every triangle asked one by one finds.

use antipode_deformation::{SceneQuery, Triangles};
use antipode_testing::rooms;
use fastrand::Rng;
use glam::DVec3;

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
