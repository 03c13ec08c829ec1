//! Doors for tests: level ground, a pair put up on it, and who stands before one.

use antipode_geometry::{ChartId, ChartPoint, Doorway, Geometry, Leaf};
use antipode_items::Item;
use antipode_scene::{Actions, NpcMode, Scene};
use glam::DVec3;

use super::{LIMIT, roomy_scene, steps};

/// Nothing is done.
pub fn still() -> Actions {
    Actions::default()
}

/// Walks ahead.
pub fn ahead() -> Actions {
    Actions {
        forward: 1.0,
        ..still()
    }
}

/// Presses a button for a step.
pub fn press(scene: &mut Scene, primary: bool) {
    let click = Actions {
        primary,
        secondary: !primary,
        ..still()
    };
    steps(scene, 1, &click);
    steps(scene, 1, &still());
}

/// The ground of a column.
pub fn ground(scene: &Scene, chart: ChartId, x: f64, z: f64) -> ChartPoint {
    let field = scene.field().clone();
    let at = |y: f64| ChartPoint::new(chart, DVec3::new(x, y, z));
    let limits = scene.strategy().limits();
    let highest_m = limits.map_or(100.0, |limits| limits.ceiling_m);
    let heights = (0..4000).map(|step| highest_m - 0.05 * f64::from(step));
    let solid = heights.into_iter().find(|y| field.sample(at(*y)) < 0.0);
    at(solid.unwrap())
}

/// Where land is nearly level for so many metres to either side along a heading: near a place of the chart, and which heading
/// that is. The flattest of some.
pub fn level_strip(
    scene: &Scene,
    about: ChartPoint,
    within_m: f64,
    half_m: f64,
) -> (ChartPoint, f64) {
    level_field(scene, about, within_m, half_m, &[])
}

/// The same of land that is level at some places beside the strip, too: metres along the heading and to the right of it.
fn level_field(
    scene: &Scene,
    about: ChartPoint,
    within_m: f64,
    half_m: f64,
    beside: &[(f64, f64)],
) -> (ChartPoint, f64) {
    let mut best = (f64::INFINITY, about, 0.0);
    for at in 0..49 {
        let (x, z) = (f64::from(at % 7) - 3.0, f64::from(at / 7) - 3.0);
        let (x, z) = (
            about.pos.x + x / 3.0 * within_m,
            about.pos.z + z / 3.0 * within_m,
        );
        let middle = ground(scene, about.chart, x, z);
        for turn in 0..8 {
            let yaw = 0.3 + std::f64::consts::FRAC_PI_4 * f64::from(turn);
            let (cos, sin) = (yaw.cos(), yaw.sin());
            let rise = |m: f64, aside_m: f64| {
                let (x, z) = (x + m * cos - aside_m * sin, z + m * sin + aside_m * cos);
                (ground(scene, about.chart, x, z).pos.y - middle.pos.y).abs()
            };
            let along = [-1.0, -0.6, -0.3, 0.3, 0.6, 1.0].map(|share| rise(share * half_m, 0.0));
            let most = along.into_iter().fold(0.0, f64::max);
            if most >= best.0 {
                continue;
            }
            let most = beside
                .iter()
                .fold(most, |most, it| most.max(rise(it.0, it.1)));
            if most < best.0 {
                best = (most, middle, yaw);
            }
        }
    }
    (best.1, best.2)
}

/// A leaf that stands at a place.
pub fn standing(scene: &Scene, foot: ChartPoint, yaw: f64) -> Leaf {
    Leaf::at(&**scene.strategy(), foot, yaw)
}

/// A leaf that stands on the ground of a column.
pub fn leaf(scene: &Scene, chart: ChartId, x: f64, z: f64, yaw: f64) -> Leaf {
    standing(scene, ground(scene, chart, x, z), yaw)
}

/// Puts both leaves up, and makes their ground.
pub fn put_up(scene: &mut Scene, leaves: [Leaf; 2]) -> Doorway {
    for leaf in leaves {
        assert!(scene.put_up(Item::Door, leaf.foot, leaf.yaw, ""));
    }
    steps(scene, 2, &still());
    Doorway { leaves }
}

/// A leaf in the chart that it stands in, as who puts one up has it.
fn at_home(scene: &Scene, leaf: Leaf) -> Leaf {
    let home = scene.strategy().cross(leaf.foot);
    home.map_or(leaf, |home| {
        standing(scene, home.point, leaf.yaw - home.turn_rad)
    })
}

/// A pair on level ground: one leaf near the start and the other elsewhere, on a globe beyond the equator and higher or lower.
pub fn level_pair(scene: &mut Scene, half_m: f64) -> Doorway {
    pair_on(scene, half_m, &[])
}

/// The same where land is level beside the leaves, too: from there bullets fly and people walk up.
pub fn open_pair(scene: &mut Scene, half_m: f64) -> Doorway {
    pair_on(scene, half_m, &[(-1.2, -2.0), (0.6, -2.0), (0.0, 2.0)])
}

fn pair_on(scene: &mut Scene, half_m: f64, beside: &[(f64, f64)]) -> Doorway {
    let (foot, yaw) = level_field(scene, scene.feet(), 14.0, half_m, beside);
    let closed = scene.setup().geometry == Geometry::Spherical;
    let elsewhere = if closed {
        ChartPoint::new(ChartId::SECOND, DVec3::new(32.0, 0.0, -14.0))
    } else {
        foot.moved(DVec3::new(-34.0, 0.0, 19.0))
    };
    let (there, looks) = level_field(scene, elsewhere, 12.0, 4.0, beside);
    let near = standing(scene, foot, yaw);
    let far = standing(scene, there, looks);
    let leaves = [near, far].map(|leaf| at_home(scene, leaf));
    put_up(scene, leaves)
}

/// Puts a car on the ground at a place of a leaf's axes, and lets it come to rest.
pub fn car_at(scene: &mut Scene, leaf: &Leaf, x: f64, turn_rad: f64) {
    let at = leaf.place(DVec3::X * x);
    let at = ground(scene, at.chart, at.pos.x, at.pos.z);
    assert!(scene.spawn_car(at, leaf.yaw + turn_rad));
    steps(scene, 150, &still());
}

/// One leaf two metres before the player, who looks along its front and through it; the other elsewhere, on a globe beyond the
/// equator, and higher or lower.
pub fn before_the_player(geometry: Geometry) -> (Scene, Doorway) {
    let mut scene = roomy_scene(geometry);
    scene.set_npcs(NpcMode::Still);
    let (at, yaw) = level_strip(&scene, scene.feet(), 8.0, 2.5);
    let near = standing(&scene, at, yaw);
    let from = near.place(DVec3::X * -2.0).pos;
    scene.teleport(ground(&scene, at.chart, from.x, from.z).moved(DVec3::Y * 0.1));
    assert!(scene.wait_for_step(LIMIT));
    steps(&mut scene, 20, &still());
    scene.aim(yaw, 0.0);
    let elsewhere = if geometry == Geometry::Spherical {
        ChartPoint::new(ChartId::SECOND, DVec3::new(32.0, 0.0, -14.0))
    } else {
        at.moved(DVec3::new(-24.0, 0.0, 9.0))
    };
    let (there, looks) = level_strip(&scene, elsewhere, 8.0, 2.5);
    let far = standing(&scene, there, looks);
    let far = at_home(&scene, far);
    let pair = put_up(&mut scene, [near, far]);
    (scene, pair)
}

/// A place in a leaf's own axes.
pub fn local(scene: &Scene, leaf: &Leaf, point: ChartPoint) -> DVec3 {
    let there = scene.strategy().carry_near(point, leaf.foot).unwrap();
    leaf.local(there.point.pos)
}
