//! Walkers in rooms made by chance, with boxes in each other that are turned anyhow.

use antipode_deformation::{Place, Sides, Space, Triangle, Triangles, Walker, WalkerShape};
use antipode_testing::rooms;
use fastrand::Rng;
use glam::DVec3;

use crate::common::v;

const G: DVec3 = DVec3::new(0.0, -9.81, 0.0);
const BODY: WalkerShape = WalkerShape {
    radius_m: 0.35,
    height_m: 1.8,
    eye_m: 1.27,
    step_m: 0.4,
    steepest_rad: 0.87,
};
/// How deep a point is in one of the cuboids, metres; the room itself, number 0, is one that nobody leaves.
fn deepest(solids: &[Triangle], point: DVec3) -> f64 {
    let depths = solids.chunks(12).enumerate().map(|(number, sides)| {
        let depth = sides.iter().fold(f64::MAX, |least, side| {
            let [a, b, c] = side.corners;
            let n = (b - a).cross(c - a).normalize();
            least.min(n.dot(a - point))
        });
        if number == 0 { -depth } else { depth }
    });
    depths.fold(f64::MIN, f64::max)
}

fn free_place(space: &Space, solids: &[Triangle], rng: &mut Rng) -> Place {
    loop {
        let point = rooms::point(rng);
        if deepest(solids, point) < -0.8 {
            return Place::at(space, point);
        }
    }
}

fn room(rng: &mut Rng, round: u32) -> (Space, Vec<Triangle>) {
    let sides = move |rng: &mut Rng| match round % 3 {
        0 => Sides::Soft,
        1 => [Sides::Soft, Sides::Walls][rng.usize(..2)],
        _ => [Sides::Soft, Sides::Snell][rng.usize(..2)],
    };
    let space = Space::new(rooms::aberrations(rng, 3, 2.5, sides)).unwrap();
    (space, rooms::solids(rng, 60))
}

#[test]
fn nobody_gets_into_a_solid_out_of_the_room_or_stuck_in_wild_space() {
    let mut rng = Rng::with_seed(51);
    let (mut went, mut stays, mut most) = (0.0, 0, f64::MIN);
    for round in 0..24 {
        let (space, solids) = room(&mut rng, round);
        let scene = Triangles::new(solids.clone());
        let mut walker = Walker::new(free_place(&space, &solids, &mut rng), BODY);
        let mut wish = DVec3::ZERO;
        let start = walker.body.place.point;
        let mut farthest = 0.0_f64;
        for step in 0..60 * 20 {
            if step % 40 == 0 {
                let way = rooms::direction(&mut rng);
                wish = v(way.x, 0.0, way.z) * 6.0;
                if walker.grounded && rng.bool() {
                    walker.body.velocity.y = 4.8;
                    walker.grounded = false;
                }
            }
            let before = walker.body.place.point;
            walker.step(&space, &scene, wish, G, 1.0 / 60.0);
            let now = walker.body.place.point;
            let eye = walker.eye_place(&space, DVec3::Y).point;
            assert!(now.is_finite() && walker.body.velocity.is_finite());
            let deep = deepest(&solids, now).max(deepest(&solids, eye));
            most = most.max(deep);
            assert!(
                deep < 0.05,
                "round {round}, step {step}: {deep} m at {now}, eye {eye}"
            );
            went += now.distance(before);
            farthest = farthest.max(now.distance(start));
        }
        stays += u32::from(farthest < 1.0);
    }
    println!("{went} m, {stays} stay, {most} m deep");
    assert!(went > 24.0 * 20.0 * 0.8 && stays <= 2, "{went} m, {stays}");
}
