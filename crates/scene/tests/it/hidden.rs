//! The display points to a foe who sees the player and whom the picture hides, before he fires.

use antipode_geometry::Geometry;
use antipode_scene::{Actions, Scene};

use super::common::figures::{SECOND, beside, world};
use super::common::steps;

/// How long a mark points to one who is hidden before he fires, in steps, but for a rounding.
const MARKED: usize = 2 * SECOND - 1;

/// What is seen of a fight: steps with somebody hidden, shots of one who was marked long enough, and who was not.
#[derive(Debug, Default)]
struct Fight {
    hidden: usize,
    late: usize,
    early: usize,
}

/// A fight with somebody so far off, some seconds of it seen as the world is and then through another picture.
fn fight(mut scene: Scene, (dx, dz): (f64, f64), bend: &dyn Fn(&mut Scene)) -> Fight {
    let at = beside(&scene, dx, dz);
    let facing = (-dz).atan2(-dx);
    scene.spawn_bot(at, facing, true);
    let (mut fight, mut marked, mut newest) = (Fight::default(), 0, None);
    for step in 0..12 * SECOND {
        if step == 5 * SECOND {
            bend(&mut scene);
        }
        scene.set_health(20.0);
        steps(&mut scene, 1, &Actions::default());
        marked = if scene.hidden_foes().is_empty() {
            0
        } else {
            marked + 1
        };
        fight.hidden += usize::from(marked > 0);
        let last = scene.projectiles().iter().map(|(id, _)| *id).max();
        if last > newest && marked > 0 {
            newest = last;
            *(if marked < MARKED {
                &mut fight.early
            } else {
                &mut fight.late
            }) += 1;
        }
        newest = newest.max(last);
    }
    fight
}

#[test]
fn whom_the_picture_hides_fires_only_after_the_mark_has_pointed_to_him() {
    let mut all = Fight::default();
    for (dx, dz) in [
        (10.0, 0.0),
        (-9.0, 4.0),
        (3.0, -12.0),
        (0.0, 14.0),
        (-8.0, -9.0),
    ] {
        for bend in [-20.0, 20.0] {
            let of = fight(world(Geometry::Euclidean), (dx, dz), &|scene| {
                assert!(scene.set_bend(bend));
            });
            assert_eq!(of.early, 0, "{dx} {dz} {bend}: {of:?}");
            all.hidden += of.hidden;
            all.late += of.late;
        }
        let unbent = fight(world(Geometry::Euclidean), (dx, dz), &|_| {});
        assert_eq!(
            unbent.hidden, 0,
            "nobody is hidden in the world's own picture"
        );
    }
    assert!(all.hidden > 2 * MARKED && all.late > 0, "{all:?}");
}

/// Others see by the world, whatever the player looks through: who is hidden by a picture knows of the player as soon.
#[test]
fn through_whatever_picture_the_player_aims_others_see_him_alike() {
    let watched = |(dx, dz): (f64, f64), bend: Option<f64>| {
        let mut scene = world(Geometry::Euclidean);
        if let Some(bend) = bend {
            assert!(scene.set_bend(bend));
        }
        steps(&mut scene, 2 * SECOND, &Actions::default());
        let at = beside(&scene, dx, dz);
        let id = scene.spawn_bot(at, (-dz).atan2(-dx), true);
        let (mut told, mut hidden) = (Vec::new(), 0);
        for _ in 0..3 * SECOND / 2 {
            steps(&mut scene, 1, &Actions::default());
            hidden += scene.hidden_foes().len();
            let bots = scene.bots();
            let view = bots.iter().find(|view| view.bot.id == id).unwrap();
            told.push(view.state.name());
        }
        (told, hidden)
    };
    let (mut hidden, mut seen) = (0, 0);
    for place in [
        (10.0, 0.0),
        (-9.0, 4.0),
        (3.0, -12.0),
        (0.0, 14.0),
        (-8.0, -9.0),
    ] {
        let (own, _) = watched(place, None);
        seen += own.iter().filter(|state| **state == "fight").count();
        for bend in [-20.0, 20.0] {
            let (told, of) = watched(place, Some(bend));
            assert_eq!(told, own, "{place:?} {bend}");
            hidden += of;
        }
    }
    assert!(hidden > 60 && seen > 60, "{hidden} {seen}");
}
