//! What goes by the hour of a place, which in a closed world is not everywhere the same.

use crate::common::figures::{SECOND, beside, bot, pass};
use crate::common::{roomy_scene, steps};
use antipode_geometry::{ChartId, ChartPoint, Geometry};
use antipode_scene::tuning::DAY_S;
use antipode_scene::{Actions, Scene, State};
use glam::DVec3;

/// A world with the player at its middle, or at the far one of a closed world, and when its sun sets there, in seconds
/// of the time of day.
fn world(geometry: Geometry) -> (Scene, f64) {
    let mut scene = roomy_scene(geometry);
    let sunset_s = if geometry == Geometry::Spherical {
        let field = scene.field().clone();
        let y = field.surface_height(ChartId::SECOND, 1.0, 0.0) + 0.2;
        scene.teleport(ChartPoint::new(ChartId::SECOND, DVec3::new(1.0, y, 0.0)));
        0.0
    } else {
        300.0
    };
    steps(&mut scene, SECOND / 2, &Actions::default());
    (scene, sunset_s)
}

#[test]
fn a_probe_tells_the_hour_of_the_place() {
    for geometry in Geometry::ALL {
        let (mut scene, sunset_s) = world(geometry);
        for (after_s, hour) in [(0.0, 18.0), (75.0, 21.0), (450.0, 12.0)] {
            scene.set_time_of_day_s(sunset_s + after_s);
            let told = scene.probe().hour.unwrap();
            assert!(
                (told - hour).abs() < 0.2,
                "{geometry:?}: {told}, not {hour}"
            );
            assert_eq!(scene.is_dark(), hour > 20.0, "{geometry:?} at {hour}");
        }
    }
}

#[test]
fn at_dusk_they_sit_down_by_a_lamp_and_get_up_again() {
    for geometry in [Geometry::Euclidean, Geometry::Spherical] {
        let (mut scene, sunset_s) = world(geometry);
        let lamp = beside(&scene, 8.0, 4.0);
        assert!(scene.spawn_lamp(lamp));
        let ids = [(12.0, 0.0), (3.0, 9.0)].map(|(x, z)| {
            let place = beside(&scene, x, z);
            scene.spawn_bot(place, 0.0, false)
        });
        let none_sits = |scene: &Scene| ids.iter().all(|id| bot(scene, *id).state != State::Sit);
        // A third of a day earlier: in a closed world it is dusk on the other side then.
        scene.set_time_of_day_s(sunset_s + DAY_S - 250.0);
        pass(&mut scene, 15.0);
        assert!(none_sits(&scene), "{geometry:?}: not by day");
        scene.set_time_of_day_s(sunset_s);
        pass(&mut scene, 40.0);
        for id in ids {
            let view = bot(&scene, id);
            assert_eq!(view.state, State::Sit, "{geometry:?}: {:?}", view.point);
            assert!((view.point.pos - lamp.pos).length() < 3.5);
        }
        scene.set_time_of_day_s(sunset_s + 150.0);
        pass(&mut scene, 2.0);
        assert!(none_sits(&scene), "{geometry:?}: not by night");
    }
}
