//! The sentences of peaceful figures: facts about the space that hold at the place where one stands.

use std::fmt;

use antipode_geometry::{ChartPoint, Eye, Strategy, equilateral_angle_sum_rad, square_gap_m};
use glam::DVec3;
use hecs::Entity;

use super::bearing::{Way, ahead, apart_m, way};
use super::dice::Dice;
use super::mind::{Mind, State};
use super::speech::Said;
use super::tuning::{HAILS_M, TALKS_M};
use crate::actors::Actors;
use crate::crosshair::Crosshair;
use crate::lens::own_view;
use crate::notice::Hint;
use crate::outbox::Outbox;
use crate::player::Player;
use crate::situation::Situation;
use crate::world::World;

/// Sides of the triangle whose angles are told, in metres: the way home if it lies between.
const SIDE_M: (f64, f64) = (5.0, 20.0);
/// How far off the ground is looked for that shows where the horizon lies, in metres.
const HORIZON_M: f64 = 20.0;
/// A player cannot mean a figure that is farther than this, in metres.
const CALLS_M: f64 = 60.0;
/// Nearer than this one is at home, in metres.
const AT_HOME_M: f64 = 6.0;
/// Within what distance land is counted, and how long the sides are that do not close, in metres.
const LAND_M: f64 = 250.0;
const SQUARE_M: f64 = 30.0;
/// A step by which it is measured how long ways are at a height, in metres.
const PACE_M: f64 = 0.1;

/// A line about the space, with its figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {
    /// The angles between three lamps, each as far from the others, as sighted from one to another. In open worlds the
    /// land is flat, whatever the picture makes of it: every map keeps azimuths.
    Triangle {
        /// Length of each line of sight, in metres.
        side_m: u32,
        /// Sum of the angles, in tenths of a degree.
        sum_decidegrees: i32,
        /// Whether only the picture of the land is bent.
        pictured: bool,
    },
    /// How much lower the ground is seen than flat space would show it; higher where negative.
    Horizon {
        /// How far off that ground is, in metres.
        away_m: u32,
        /// By how much lower, in tenths of a degree.
        lower_decidegrees: i32,
    },
    /// The way to where a new player stands.
    Home {
        /// The short way, in metres.
        there_m: u32,
        /// The other way round, in metres, in a closed world.
        round_m: Option<u32>,
        /// How many squares away it is, in a world in squares.
        squares: Option<u32>,
    },
    /// How much land there is, in a world in squares.
    Land {
        /// Within how many metres.
        within_m: u32,
        /// Of how many tenths of the land that is within as much of a place of a flat world.
        tenths: u32,
    },
    /// How far one who walks four equal sides with right angles ends from where he began, in a world in squares.
    Square {
        /// Length of a side, in metres.
        side_m: u32,
        /// How far that is, in tenths of a metre.
        gap_decimetres: u32,
    },
}

/// Talks to the peaceful one ahead, if there is one close by; one that is farther off waits.
pub(crate) fn talk(world: &World, actors: &mut Actors, player: &Player, outbox: &mut Outbox) {
    let now = Situation::of(world, actors, player);
    let head = now.head().point;
    let crosshair = Crosshair::aimed(now);
    let Some((entity, id)) = crosshair.listener(TALKS_M) else {
        let hint = if let Some((entity, _)) = crosshair.listener(HAILS_M) {
            heed(actors, entity, head);
            Hint::WaitsToTalk
        } else if crosshair.listener(CALLS_M).is_some() {
            Hint::TooFarToTalk
        } else {
            Hint::NobodyToTalkTo
        };
        outbox.hints.push(hint);
        return;
    };
    let Some(mind) = heed(actors, entity, head) else {
        return;
    };
    let told = mind.told;
    mind.told += 1;
    let greets = told == 0;
    let now = Situation::of(world, actors, player);
    let line = line_of(now, id, told);
    actors.npcs.said = Some(Said {
        speaker: id,
        greets,
        line,
        at_s: world.simulated_s,
    });
    outbox.hints.push(Hint::Said { greets, line });
}

/// Has somebody heed the player whose head is there, sitting where he sits.
fn heed(actors: &mut Actors, entity: Entity, head: ChartPoint) -> Option<&mut Mind> {
    let mind = actors.ecs.query_one_mut::<&mut Mind>(entity).ok()?;
    if mind.state != State::Sit {
        mind.listen(head);
    }
    Some(mind)
}

/// One line after another, of those that are true here.
fn line_of(now: Situation<'_>, id: u32, told: u32) -> Line {
    let strategy = &*now.world.strategy;
    let home = way(strategy, now.feet(), now.start());
    let first = Dice::new(&[now.world.setup.seed, u64::from(id)]).whole([0, 2]);
    let count = if strategy.tiled().is_some() { 5 } else { 3 };
    match (first + told) % count {
        0 => triangle(now, home.level_m),
        1 => horizon(now),
        // A player at home need not be told the way.
        2 if home.level_m < AT_HOME_M && strategy.globe().is_none() => horizon(now),
        2 => way_home(strategy, now.feet(), home),
        3 => land(strategy, now.feet()),
        _ => square(strategy, now.feet()),
    }
}

/// The area of a disc of r is `2 pi R^2 (cosh(r/R) - 1)`, and `pi r^2` on flat ground. It is told of the height where one
/// stands, where lengths and R are as many times longer.
fn land(strategy: &dyn Strategy, feet: ChartPoint) -> Line {
    let radii = LAND_M / (strategy.radius_m() * length_at_feet(strategy, feet));
    let times = 2.0 * (radii.cosh() - 1.0) / (radii * radii);
    Line::Land {
        within_m: LAND_M as u32,
        tenths: (10.0 * times).round() as u32,
    }
}

/// Told of the height where one stands, too.
fn square(strategy: &dyn Strategy, feet: ChartPoint) -> Line {
    let share = length_at_feet(strategy, feet);
    let gap_m = share * square_gap_m(strategy.curvature().per_m2(), SQUARE_M / share);
    Line::Square {
        side_m: SQUARE_M as u32,
        gap_decimetres: (10.0 * gap_m).round() as u32,
    }
}

/// The triangle whose sides are as long as the way home. Straight lines between three points of a closed space lie
/// in one sphere of its radius, however high above the level they begin.
fn triangle(now: Situation<'_>, home_m: f64) -> Line {
    let side_m = home_m.clamp(SIDE_M.0, SIDE_M.1).round();
    let strategy = &*now.world.strategy;
    // Where a dial bends the picture the land itself is flat.
    let curvature_per_m2 = match own_view(strategy).dial() {
        Some(_) => 0.0,
        None => strategy.curvature().per_m2(),
    };
    let sum_rad = equilateral_angle_sum_rad(curvature_per_m2, side_m);
    Line::Triangle {
        side_m: side_m as u32,
        sum_decidegrees: (sum_rad.to_degrees() * 10.0).round() as i32,
        pictured: now.aiming().dial != 0.0,
    }
}

/// Where ground as high as one's own is seen some way off, beside where a flat space shows it.
fn horizon(now: Situation<'_>) -> Line {
    let level = Eye {
        pitch: 0.0,
        ..now.head()
    };
    let place = ahead(&*now.world.strategy, now.feet(), level.front(), HORIZON_M);
    let seen = now.aiming().strategy.view_point(&level, place).truncate();
    let rise_rad = seen.y.atan2(seen.x.hypot(seen.z));
    let flat_rad = (now.feet().pos.y - level.point.pos.y).atan2(HORIZON_M);
    Line::Horizon {
        away_m: HORIZON_M as u32,
        lower_decidegrees: ((flat_rad - rise_rad).to_degrees() * 10.0).round() as i32,
    }
}

/// The way home, as far as it is where one stands: high above the level that ways are told by they are shorter in a
/// closed world.
fn way_home(strategy: &dyn Strategy, feet: ChartPoint, home: Way) -> Line {
    let share = length_at_feet(strategy, feet);
    let there_m = home.level_m * share;
    Line::Home {
        there_m: there_m.round() as u32,
        round_m: strategy
            .globe()
            .map(|globe| (globe.round_m() * share - there_m).round() as u32),
        squares: strategy
            .tiled()
            .and_then(|tiled| tiled.edges_from_first(feet.chart))
            .map(|squares| squares as u32),
    }
}

/// How long a way is at the height of one's feet whose foot on the level is 1 m long, in metres. It is the same whichever way
/// one goes.
fn length_at_feet(strategy: &dyn Strategy, feet: ChartPoint) -> f64 {
    let pace = ahead(strategy, feet, DVec3::X, PACE_M);
    apart_m(strategy, feet, pace) / PACE_M
}

/// English, for logs and scripts.
impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Triangle {
                side_m,
                sum_decidegrees,
                pictured,
            } => {
                let degrees = f64::from(sum_decidegrees) / 10.0;
                write!(
                    f,
                    "Three lamps, each {side_m} m from the others, make angles of {degrees:.1} degrees together here."
                )?;
                if pictured {
                    write!(f, " The land is flat; only its picture is bent.")?;
                }
                Ok(())
            }
            Self::Horizon {
                away_m,
                lower_decidegrees,
            } => {
                let degrees = f64::from(lower_decidegrees) / 10.0;
                write!(
                    f,
                    "Level ground {away_m} m off is seen {degrees:.1} degrees lower here than in flat space."
                )
            }
            Self::Home {
                there_m,
                squares: Some(squares),
                ..
            } => write!(
                f,
                "Home is {there_m} m from here, {squares} squares on; no other way is as short."
            ),
            Self::Land { within_m, tenths } => write!(
                f,
                "At this height there is {:.1} times as much land within {within_m} m as on flat ground.",
                f64::from(tenths) / 10.0
            ),
            Self::Square {
                side_m,
                gap_decimetres,
            } => write!(
                f,
                "Walk {side_m} m and turn right, four times: you end {:.1} m from where you began.",
                f64::from(gap_decimetres) / 10.0
            ),
            Self::Home {
                there_m,
                round_m: Some(round_m),
                ..
            } => write!(
                f,
                "Home is {there_m} m from here, or {round_m} m the other way round the world."
            ),
            Self::Home {
                there_m,
                round_m: None,
                squares: None,
            } => write!(
                f,
                "Home is {there_m} m from here; this land has no end, so no way leads round."
            ),
        }
    }
}
