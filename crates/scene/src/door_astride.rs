//! Who stands in a door is on both sides of it: shown twice, each time cut at the leaf. Of a car both parts are met, too.
//!
//! A body is on the side where its middle is. What of it has gone through the leaf is shown where it came out, and what has not is
//! not shown there. With n the way through the leaf and s the side of the middle, the one here keeps s n . (p - f) >= 0, and the
//! one there the rest.

use antipode_geometry::doorway::{BELOW_FOOT_M, HALF_WIDTH_M, HEIGHT_M};
use antipode_geometry::{Atlas, ChartPoint, Crossing, Doorway, Leaf, LevelMap, Strategy};
use antipode_physics::{Side, VehicleMotion, VehiclePart, VehiclePhysics};
use glam::DVec3;

use crate::actors::ActorId;
use crate::car::CarView;
use crate::frame::{Cut, Figure};
use crate::moment::Who;
use crate::pick::over;

/// How far from its middle a body may reach, and a car with its driver, metres.
const REACH_M: f64 = 1.2;
const CAR_REACH_M: f64 = 2.6;

/// Shows those that stand in a door on both sides of it.
pub(crate) fn show_astride(
    space: &dyn Strategy,
    doors: &Doorway,
    cars: &[CarView],
    seen: Vec<(Who, Figure)>,
) -> Vec<(Who, Figure)> {
    let car_of = |id: ActorId| cars.iter().find(|car| car.id == id);
    let mut all = Vec::with_capacity(seen.len() + 2);
    for (who, mut figure) in seen {
        let carried = match who {
            Who::Fixture(..) | Who::Foreseen => None,
            Who::Car(id) | Who::Wheel(id, _) => car_of(id).map(|car| (car.middle(), CAR_REACH_M)),
            Who::Player {
                drives: Some(id), ..
            } => car_of(id).map(|car| (car.middle(), CAR_REACH_M)),
            _ => Some((figure.point, REACH_M)),
        };
        let astride =
            carried.and_then(|(middle, reach_m)| stands_in(space, doors, middle, reach_m));
        let there = astride.and_then(|(leaf, side)| {
            let crossing = doors.carry(space, leaf, figure.point)?;
            let mut there = Figure {
                point: crossing.point,
                turn: crossing.rotation() * figure.turn,
                ..figure
            };
            if figure.level != LevelMap::SAME {
                there.level = LevelMap::at(space, crossing.point);
            }
            there.cut = Some(cut(space, &doors.leaves[1 - leaf], -side, there.point));
            figure.cut = Some(cut(space, &doors.leaves[leaf], side, figure.point));
            Some(there)
        });
        all.push((who, figure));
        all.extend(there.map(|it| (who, it)));
    }
    all
}

/// What of a car is where: all of it where it is, or, if it stands in a door, what is on either side of that.
pub(crate) fn car_parts(
    space: &dyn Strategy,
    doors: Option<&Doorway>,
    physics: &VehiclePhysics,
    motion: &VehicleMotion,
) -> Vec<VehiclePart> {
    let parts = doors.and_then(|doors| {
        let middle = ChartPoint::new(motion.chart, motion.middle());
        let (leaf, side) = stands_in(space, doors, middle, CAR_REACH_M)?;
        let crossing = doors.carry(space, leaf, motion.point())?;
        let on_side = |leaf: usize, side: f64, crossing: &Crossing| {
            let kept = cut(space, &doors.leaves[leaf], side, crossing.point);
            physics.part(motion, crossing, side_of(&kept, crossing.point.pos))
        };
        let here = on_side(leaf, side, &Crossing::within(motion.point()));
        let there = on_side(1 - leaf, -side, &crossing);
        Some(here.into_iter().chain(there).collect())
    });
    parts.unwrap_or_else(|| vec![physics.whole(motion)])
}

/// The leaf that a body with its middle there stands in, and the side of it that the middle is on.
fn stands_in(
    space: &dyn Atlas,
    doors: &Doorway,
    middle: ChartPoint,
    reach_m: f64,
) -> Option<(usize, f64)> {
    (0..2).find_map(|leaf| {
        let door = &doors.leaves[leaf];
        let there = over(space, door.foot, middle);
        let at = door.local(there.pos);
        let is_in = there.chart == door.foot.chart
            && at.x.abs() < reach_m
            && at.z.abs() < HALF_WIDTH_M
            && (-BELOW_FOOT_M..HEIGHT_M).contains(&at.y);
        is_in.then_some((leaf, if at.x < 0.0 { -1.0 } else { 1.0 }))
    })
}

/// What is kept of a figure whose origin is there, on a side of a leaf.
fn cut(space: &dyn Strategy, leaf: &Leaf, side: f64, origin: ChartPoint) -> Cut {
    // The leaf as it lies in the chart of the origin.
    let there = space.carry_near(leaf.foot, origin);
    let there = there.unwrap_or(Crossing::within(leaf.foot));
    let foot = there.point.pos;
    let way = leaf.plane(space, &there).0 * side;
    Cut {
        heading_rad: way.z.atan2(way.x),
        from_m: way.dot(foot - origin.pos),
    }
}

/// The same as physics has it.
fn side_of(cut: &Cut, origin: DVec3) -> Side {
    let way = DVec3::new(cut.heading_rad.cos(), 0.0, cut.heading_rad.sin());
    Side {
        at: origin + way * cut.from_m,
        way,
    }
}
