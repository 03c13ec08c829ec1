//! The world is a function of save, seed and actions: nothing that the player chooses about the picture has a part in it,
//! nor has the machine.
//!
//! `ANTIPODE_TEST_LONG=1` plays ten minutes in place of 45 seconds, and each choice by itself.

mod play;

use antipode_geometry::{Geometry, HyperbolicMap};
use antipode_scene::{Actions, NpcMode, Probe, Scene};

use super::common::figures::beside;
use super::common::{LIMIT, steps};
use play::{How, calm, is_long, opened, played, replayed, sharp, usual, within, worked_by};

/// In short everything is chosen at once, twice.
fn ways() -> Vec<How> {
    let mut ways = vec![
        How {
            name: "calm and near, by four",
            view_distance: 2,
            workers: 4,
            ..calm()
        },
        How {
            name: "sharp and far, by two",
            view_distance: 8,
            workers: 2,
            ..sharp()
        },
    ];
    if is_long() {
        ways.extend([
            calm(),
            sharp(),
            within(2, "near"),
            within(8, "far"),
            worked_by(2, "by two"),
            worked_by(3, "by three"),
            worked_by(4, "by four"),
        ]);
    }
    ways
}

fn assert_same(geometry: Geometry, name: &str, before: &[Probe], now: &[Probe]) {
    assert_eq!(before.len(), now.len());
    for (one, other) in before.iter().zip(now) {
        // The shortest text of a number is of that number alone.
        let (told, tells) = (format!("{one:#?}"), format!("{other:#?}"));
        let mut lines = told.lines().zip(tells.lines());
        let differs = lines.find(|(before, now)| before != now);
        assert_eq!(
            (differs, told.len()),
            (None, tells.len()),
            "{geometry} {name} at {} s",
            one.t
        );
    }
}

fn is_the_same_however_it_is_seen(geometry: Geometry) {
    let before = played(geometry, &usual(), false);
    for how in ways() {
        let now = played(geometry, &how, false);
        assert_same(geometry, how.name, &before.probes, &now.probes);
    }
}

#[test]
fn a_flat_world_is_the_same_however_it_is_seen() {
    is_the_same_however_it_is_seen(Geometry::Euclidean);
}

#[test]
fn a_hyperbolic_world_is_the_same_however_it_is_seen() {
    is_the_same_however_it_is_seen(Geometry::Hyperbolic);
}

#[test]
fn a_world_in_squares_is_the_same_however_it_is_seen() {
    is_the_same_however_it_is_seen(Geometry::HyperbolicWorld);
}

#[test]
fn a_closed_world_is_the_same_however_it_is_seen() {
    is_the_same_however_it_is_seen(Geometry::Spherical);
}

/// Has a scene show its world through another picture, if its space has one.
fn show_otherwise(scene: &mut Scene) {
    match scene.setup().geometry {
        Geometry::Euclidean => assert!(scene.set_bend(12.0)),
        Geometry::Hyperbolic => {
            assert!(scene.set_map(HyperbolicMap::Horizon) && scene.set_curvature(17.0));
        }
        Geometry::Spherical | Geometry::HyperbolicWorld => {}
    }
}

/// Probes without which picture was asked for.
fn unpictured(mut probes: Vec<Probe>) -> Vec<Probe> {
    for probe in &mut probes {
        (probe.map, probe.curvature, probe.bend) = (None, None, None);
    }
    probes
}

/// Actions that tell what they were aimed by, played again where everything is seen otherwise.
fn plays_again(geometry: Geometry) {
    let before = played(geometry, &calm(), true);
    if geometry != Geometry::Spherical {
        assert!(before.hidden > 60, "{geometry}: {} steps", before.hidden);
    }
    let now = replayed(geometry, &sharp(), &before.record, show_otherwise);
    let (before, now) = (unpictured(before.probes), unpictured(now.probes));
    assert_same(geometry, "another picture", &before, &now);
}

#[test]
fn recorded_actions_make_the_same_flat_world_through_whatever_picture_they_are_played_again() {
    plays_again(Geometry::Euclidean);
}

#[test]
fn recorded_actions_make_the_same_hyperbolic_world_through_whatever_picture() {
    plays_again(Geometry::Hyperbolic);
}

#[test]
fn recorded_actions_make_the_same_closed_world_through_whatever_picture() {
    plays_again(Geometry::Spherical);
}

/// More figures than ground is made solid for, far apart: each stands, or waits where it was put, however far the view is.
#[test]
fn nobody_of_a_crowd_falls_through_ground_that_only_a_view_has_made() {
    let places = |view_distance| {
        let mut scene = opened(Geometry::Euclidean, &within(view_distance, ""));
        scene.set_npcs(NpcMode::Still);
        for cell in 0..144 {
            let away_m = |cell: i32| f64::from(cell - 6) * 19.0;
            let at = beside(&scene, away_m(cell % 12), away_m(cell / 12));
            scene.spawn_bot(at, 0.0, false);
        }
        assert!(scene.settle(LIMIT));
        steps(&mut scene, 60, &Actions::default());
        let bots = scene.bots().into_iter().map(|bot| bot.point.pos.to_array());
        bots.collect::<Vec<_>>()
    };
    assert_eq!(places(2), places(8));
}
