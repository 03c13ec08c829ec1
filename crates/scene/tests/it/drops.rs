//! Things that lie about: on the ground, along its slope, in every space.

use crate::common::{scene, steps};
use antipode_geometry::Geometry;
use antipode_scene::drops::lying;
use antipode_scene::frame::{Figure, ModelId};
use antipode_scene::{Actions, Item, Scene, Stack};
use glam::DVec3;

fn shown(scene: &mut Scene, item: Item) -> Figure {
    let content = scene.frame(1.3, 1.7, 1).content;
    let mut like = content
        .figures
        .iter()
        .filter(|figure| figure.model == ModelId::from(item));
    *like.next().expect("it is shown")
}

#[test]
fn whatever_is_thrown_away_comes_to_lie_on_the_ground_and_lies_still() {
    for geometry in Geometry::ALL {
        let mut scene = scene(geometry);
        steps(&mut scene, 30, &Actions::default());
        let field = scene.field().clone();
        // What rolls lies on any side.
        let lie = Item::ALL.into_iter().filter(|it| it.rolls_m().is_none());
        for (turn, item) in (0..).zip(lie) {
            // No farther round: up the slope at the sphere's start, from where things roll back to the player.
            scene.aim(f64::from(turn % 6), 0.3);
            scene.throw_away(Stack { item, count: 1 });
            steps(&mut scene, 300, &Actions::default());
            let figure = shown(&mut scene, item);
            let (own, height_m) = lying(item);
            // The slope's normal: what was up before the thing's own turn.
            let up = figure.turn * (own.inverse() * DVec3::Y);
            let foot = figure.point.moved(up * -height_m);
            let rises = |axis: DVec3| {
                let at = |way: DVec3| f64::from(field.sample(foot.moved(way)));
                at(axis * 0.3) - at(axis * -0.3)
            };
            let slope = DVec3::new(rises(DVec3::X), rises(DVec3::Y), rises(DVec3::Z));
            let along = slope.normalize().dot(up);
            assert!(along > 0.95, "{geometry} {item:?} stands off: {along}");
            let off = f64::from(field.sample(foot));
            assert!(
                off.abs() < 0.12,
                "{geometry} {item:?}: {off} m over the ground"
            );
            steps(&mut scene, 30, &Actions::default());
            assert_eq!(shown(&mut scene, item).turn, figure.turn, "{item:?} turns");
        }
    }
}
