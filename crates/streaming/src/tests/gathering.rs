//! In gathering worlds what is dug can be built with, and no more than that.

use antipode_geometry::{Geometry, strategy};
use antipode_storage::EarthRecord;
use antipode_terrain::{Kind, Stock, Stroke};
use glam::DVec3;

use super::{Game, stroke};
use crate::api::{NotUndone, Until};

fn gathering(geometry: Geometry) -> (Game, DVec3) {
    let mut game = Game::in_space(strategy(geometry, 32.0), 2, None, None);
    let at = game.ground(3.0, -7.0);
    game.wish(at, 1);
    game.wait(Until::Idle);
    game.streamer.gather(None);
    (game, at)
}

fn works(game: &mut Game, press: u64, at: DVec3, amount: f32, kind: Option<Kind>) -> f64 {
    let one = Stroke {
        kind,
        ..stroke(at, amount)
    };
    game.streamer.edit_in(Some(press), one);
    game.wait(Until::Edits).earth.gained_m3()
}

fn all_m3(game: &Game) -> f64 {
    let stock = game.streamer.stock().copied().unwrap_or_default();
    stock.kept().map(|(_, m3)| m3).sum()
}

fn undone(game: &mut Game) -> Result<(), NotUndone> {
    game.streamer.undo();
    let ends = game.wait(Until::Edits).undone;
    ends.last().expect("an end").map(|_| ())
}

#[test]
fn what_is_dug_is_built_until_nothing_is_left() {
    for geometry in [
        Geometry::Euclidean,
        Geometry::Hyperbolic,
        Geometry::Spherical,
    ] {
        let (mut game, at) = gathering(geometry);
        let dug = works(&mut game, 1, at, 2.0, None);
        assert!((all_m3(&game) - dug).abs() < 1e-6 && dug > 20.0, "{dug}");
        let kind = game.streamer.stock().and_then(Stock::most);
        let most = kind.map(|kind| game.streamer.stock().expect("a stock").of(kind));
        // Far more than there is; all of it beside the pit, so that the same ground does not come back.
        let beside = game.ground(-8.0, 8.0);
        let mut built = 0.0;
        for press in 2..9 {
            built -= works(&mut game, press, beside, -3.0, kind);
        }
        let most = most.expect("something");
        assert!(built <= most + 1e-3, "{geometry}: {built} of {most}");
        assert!(built > 0.97 * most, "{geometry}: {built} of {most}");
        let stock = game.streamer.stock().expect("a stock");
        assert!(Kind::ALL.into_iter().all(|kind| stock.of(kind) >= 0.0));
        assert!((all_m3(&game) - (dug - built)).abs() < 1e-6);
        // What the pit gave has been built with; what was built can be taken back, and then the pit filled.
        assert_eq!(undone(&mut game), Ok(()), "{geometry}");
    }
}

#[test]
fn ground_that_has_been_used_cannot_be_given_back() {
    let (mut game, at) = gathering(Geometry::Euclidean);
    works(&mut game, 1, at, 2.0, None);
    let before = game.streamer.stock().copied().expect("a stock");
    assert!(game.streamer.spend(&before));
    assert_eq!(undone(&mut game), Err(NotUndone::Spent));
    assert!(game.streamer.spend(&before.negative()), "it is given back");
    assert_eq!(undone(&mut game), Ok(()));
    assert!(all_m3(&game).abs() < 1e-6);
    assert_eq!(undone(&mut game), Err(NotUndone::NoneLeft));
}

/// What there is of a kind as it is kept, cubic metres: of ores it may be less than zero.
fn stock(game: &Game, kind: Kind) -> f64 {
    let stock = game.streamer.stock().expect("a stock");
    let of_kind = stock.kept().find(|(it, _)| *it == kind);
    of_kind.map_or(0.0, |(_, m3)| m3)
}

#[test]
fn copper_is_not_grown_with_soil() {
    let (mut game, at) = gathering(Geometry::Euclidean);
    let all = |kind: Kind| EarthRecord {
        kinds: vec![(kind.byte(), 1e4)],
    };
    game.streamer.gather(Some(&all(Kind::Copper)));
    works(&mut game, 1, at, -6.0, Some(Kind::Copper));
    game.streamer.gather(Some(&all(Kind::Soil)));
    for round in 0..6 {
        works(&mut game, 2 + 2 * round, at, -1.0, Some(Kind::Soil));
        works(&mut game, 3 + 2 * round, at, 1.0, None);
    }
    let grown = stock(&game, Kind::Copper);
    assert!(grown.abs() < 2.0, "{grown} m3 of copper came of soil");
}

/// As the game's brush does it, a little at a time: over a vein that is laid bare one builds of soil, and digs that again
/// with wood.
#[test]
fn who_builds_of_soil_beside_copper_neither_pays_nor_wins_copper() {
    for geometry in Geometry::ALL {
        let (mut game, at) = gathering(geometry);
        let all = |kind: Kind| EarthRecord {
            kinds: vec![(kind.byte(), 1e4)],
        };
        game.streamer.gather(Some(&all(Kind::Copper)));
        works(&mut game, 1, at, -6.0, Some(Kind::Copper));
        game.streamer.gather(Some(&all(Kind::Soil)));
        let top = at + DVec3::Y * 3.0;
        for round in 0..4 {
            let before = stock(&game, Kind::Soil);
            for (press, amount, kind) in [
                (2 + 2 * round, -0.1, Some(Kind::Soil)),
                (3 + 2 * round, 0.1, None),
            ] {
                for _ in 0..40 {
                    let little = Stroke {
                        amount,
                        kind,
                        power: Some(1),
                        ..stroke(top, 4.0)
                    };
                    game.streamer.edit_in(Some(press), little);
                    game.wait(Until::Edits);
                }
                let copper = stock(&game, Kind::Copper);
                assert!(
                    copper.abs() < 0.3,
                    "{geometry}, round {round}: {copper} m3 of copper"
                );
                if amount < 0.0 {
                    let paid = before - stock(&game, Kind::Soil);
                    assert!(paid > 5.0, "{geometry}, round {round}: {paid} m3 of soil");
                }
            }
        }
    }
}

/// A pickaxe that is too weak leaves the surface of hard ground where it is.
#[test]
fn ground_that_is_too_hard_stays() {
    let (mut game, at) = gathering(Geometry::Euclidean);
    let laid = |kind| EarthRecord {
        kinds: vec![(Kind::byte(kind), 1e4)],
    };
    game.streamer.gather(Some(&laid(Kind::Crystal)));
    let top = at + DVec3::Y * 4.0;
    works(&mut game, 1, top, -8.0, Some(Kind::Crystal));
    let dig = |game: &mut Game, press: u64, power: Option<u8>| {
        let one = Stroke {
            power,
            ..stroke(top + DVec3::Y * 4.0, 2.0)
        };
        game.streamer.edit_in(Some(press), one);
        game.wait(Until::Edits).earth.dug_m3(Kind::Crystal)
    };
    assert!(dig(&mut game, 2, Some(2)) < 1e-3);
    let slowly = dig(&mut game, 3, Some(3));
    let fast = dig(&mut game, 4, Some(4));
    assert!(slowly > 1.0 && fast > 1.5 * slowly, "{slowly} {fast}");
}
