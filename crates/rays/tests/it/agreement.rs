//! Rays on the adapter go where those of `antipode-deformation` go.

use antipode_deformation::{
    Aberration, End, EventKind, Place, Sides, Space, Trace, Traveller, Triangles, Ways, What, trace,
};
use antipode_rays::{Answer, Outcome, ProbeRay, Prober};
use antipode_testing::rooms;
use fastrand::Rng;
use glam::{DQuat, DVec3};

use crate::common::{Gpu, scene_of};

/// Rounds to single numbers, which is what the adapter is given.
fn rounded(space: &Space, rng: &mut Rng) -> ProbeRay {
    let point = rooms::point(rng).as_vec3().as_dvec3();
    let w = rooms::direction(rng);
    ProbeRay {
        start: Place::at(space, point),
        w,
        longest: 60.0,
    }
}

fn outcome(path: &Trace) -> Outcome {
    match path.end {
        End::Spent => Outcome::Spent,
        End::TooManyEvents => Outcome::TooManyEvents,
        End::Hit(hit) => match hit.what {
            What::Object(object, _) => Outcome::Object(object, 0),
            What::Wall(number, axis) => Outcome::Wall(number as u32, axis as u32),
        },
    }
}

fn is_same(answer: &Answer, path: &Trace) -> bool {
    match (answer.outcome, outcome(path)) {
        (Outcome::Object(one, _), Outcome::Object(other, _)) => one == other,
        (one, other) => one == other,
    }
}

#[derive(Debug, Default)]
struct Tally {
    rays: usize,
    other_object: usize,
    few: usize,
    few_off: usize,
    many: usize,
    many_off: usize,
    most_events: usize,
    passed: usize,
    turned: usize,
}

fn compare(
    gpu: &Gpu,
    (seed, depth, pairs): (u64, usize, usize),
    most: f64,
    sides: impl Fn(&mut Rng) -> Sides + Copy,
    tally: &mut Tally,
) {
    let mut rng = Rng::with_seed(seed);
    let boxes = rooms::aberrations(&mut rng, depth, most, sides);
    let portals = rooms::portals(&mut rng, &boxes, pairs, most);
    let space = Space::with_portals(boxes, portals).unwrap();
    compare_in(gpu, &space, &mut rng, tally);
}

fn compare_in(gpu: &Gpu, space: &Space, rng: &mut Rng, tally: &mut Tally) {
    let mut triangles = rooms::solids(rng, 40);
    for triangle in &mut triangles {
        triangle.corners = triangle.corners.map(|corner| corner.as_vec3().as_dvec3());
    }
    let mut scene = scene_of(&triangles);
    scene.aberrations = space.clone();
    let solids = Triangles::new(triangles);
    let rays: Vec<_> = (0..10_000).map(|_| rounded(space, rng)).collect();
    let loaded = gpu.rays.upload(&gpu.device, &gpu.queue, &scene).unwrap();
    let answers = Prober::new(&gpu.device)
        .unwrap()
        .trace(&gpu.device, &gpu.queue, &loaded, &rays)
        .unwrap();
    for (ray, answer) in rays.iter().zip(&answers) {
        let path = trace(
            space,
            &ray.start,
            ray.w,
            ray.longest,
            &solids,
            &Traveller::Body,
        );
        tally.rays += 1;
        tally.most_events = tally.most_events.max(path.events.len());
        let portals = path.events.iter().filter(|it| it.kind == EventKind::Passed);
        tally.passed += portals.count();
        if !is_same(answer, &path) {
            tally.other_object += 1;
            continue;
        }
        let off = (f64::from(answer.length) - path.length).abs() > 1e-4 * path.length.max(1.0);
        if path.events.len() <= 8 {
            tally.few += 1;
            tally.few_off += usize::from(off);
        } else {
            tally.many += 1;
            tally.many_off += usize::from(off);
        }
        let w = path.place.turn * path.w;
        tally.turned += usize::from((answer.w.as_dvec3() - w).length() > 1e-3);
    }
}

#[test]
fn the_adapter_s_rays_end_where_the_reference_s_do() {
    let Some(gpu) = Gpu::shared() else { return };
    let mut tally = Tally::default();
    for round in 0..10 {
        let sides = move |rng: &mut Rng| match round {
            0..7 => Sides::Soft,
            7 => Sides::Snell,
            _ => [Sides::Soft, Sides::Walls][rng.usize(..2)],
        };
        // Boxes alone, portals alone, and both.
        let (depth, pairs) = match round {
            2 | 3 => (0, 12),
            4..6 | 9 => (2, 8),
            _ => (2 + (round as usize) % 5, 0),
        };
        compare(gpu, (100 + round, depth, pairs), 3.0, sides, &mut tally);
    }
    assert_eq!(tally.rays, 100_000);
    assert!(tally.passed > 2_000, "{tally:?}");
    assert!(tally.turned * 1000 <= tally.rays, "{tally:?}");
    assert!(tally.other_object <= 10, "{tally:?}");
    assert!(tally.few_off * 10_000 <= tally.few, "{tally:?}");
    assert!(tally.many_off * 100 <= tally.many, "{tally:?}");
    assert!(tally.many > 1000 && tally.most_events > 20, "{tally:?}");
}

/// Boxes beside one another, some with a face in common, and twelve within one of them: more than are asked one after another.
fn crowd(rng: &mut Rng) -> Space {
    let boxed = |centre: DVec3, half: f64, rng: &mut Rng| Aberration {
        name: "box".to_owned(),
        centre,
        half: DVec3::splat(half),
        turn: DQuat::IDENTITY,
        stretch: DVec3::from_array([(); 3].map(|()| 2.0_f64.powf(rng.f64() * 2.0 - 1.0))),
        sides: Sides::Soft,
        ways: Ways::Both,
    };
    let mut boxes = Vec::new();
    for n in 0..180 {
        let at = DVec3::new(f64::from(n % 6), f64::from(n / 6 % 5), f64::from(n / 30));
        let half = [0.5, 0.375][rng.usize(..2)];
        boxes.push(boxed(2.5 * at - DVec3::new(6.0, 5.0, 6.0), half, rng));
        let beside = boxes[boxes.len() - 1].centre + DVec3::X * 2.0 * half;
        if n % 3 == 0 && n % 6 != 5 && half < 0.45 {
            boxes.push(boxed(beside, half, rng));
        }
    }
    boxes.push(boxed(DVec3::new(0.0, 20.0, 0.0), 8.0, rng));
    for n in 0..12 {
        let at = DVec3::new(f64::from(n % 4) - 1.5, 5.0, f64::from(n / 4) - 1.0);
        boxes.push(boxed(4.0 * at, 1.0, rng));
    }
    Space::new(boxes).unwrap()
}

#[test]
fn of_many_boxes_none_is_missed() {
    let Some(gpu) = Gpu::shared() else { return };
    let mut rng = Rng::with_seed(7);
    let space = crowd(&mut rng);
    assert!(space.placed().len() > 200);
    let mut tally = Tally::default();
    compare_in(gpu, &space, &mut rng, &mut tally);
    assert!(tally.other_object <= 1, "{tally:?}");
    assert!(
        tally.few_off <= 1 && tally.many_off * 100 <= tally.many,
        "{tally:?}"
    );
    assert!(tally.most_events > 8, "{tally:?}");
}
