//! Light that goes through doors: what shines before a leaf shines out of the other one.
//!
//! A lamp is seen through the pair where its place is taken to, behind the other leaf; from there its light goes as far as the opening
//! lets it. That is a beam whose axis leads through the middle of the opening and whose cone holds its corners, and which lights
//! nothing before the leaf. Beams go through as they are, in a cone no wider than that.

use antipode_geometry::doorway::HEIGHT_M;
use antipode_geometry::{Atlas, ChartPoint, Doorway, Leaf};
use glam::DVec3;

use crate::frame::BeamLight;
use crate::moment::Lit;
use crate::pick::over;

/// Beams that come out of doors at most.
const MOST: usize = 8;
/// A leaf is looked for so far ahead on a beam's way, metres.
const LOOKS_M: f64 = 8.0;
/// Nearer to a leaf than this a light fills its opening, metres.
const LEAST_M: f64 = 0.25;
/// Radii of the discs about the middle of an opening that are lit in full, and at all, metres.
const FULL_M: f64 = 0.85;
const DARK_M: f64 = 1.35;

/// The beams that lamps and beams send through a pair.
pub(crate) fn light_through(space: &dyn Atlas, doors: &Doorway, lit: &Lit) -> Vec<BeamLight> {
    let lamps = lit.lamps.iter().flat_map(|(_, lamp)| {
        let out = move |leaf| {
            let (point, behind, way) = taken(space, doors, leaf, lamp.point, lamp.range_m)?;
            Some(BeamLight {
                point,
                direction: way.normalize_or(DVec3::X),
                colour: lamp.colour,
                range_m: lamp.range_m,
                cone_rad: opening_cone_rad(way.length()),
                behind: Some(behind),
            })
        };
        (0..2).filter_map(out)
    });
    let beams = lit.beams.iter().filter_map(|(_, beam)| {
        // As far as a way is looked at near a leaf.
        let end = beam.point.moved(beam.direction * beam.range_m.min(LOOKS_M));
        let leaf = doors.met(space, beam.point, end)?.leaf;
        let (point, behind, way) = taken(space, doors, leaf, beam.point, beam.range_m)?;
        let crossing = doors.carry(space, leaf, beam.point)?;
        let (full, dark) = opening_cone_rad(way.length());
        Some(BeamLight {
            point,
            direction: crossing.turn_vector(beam.direction),
            cone_rad: (beam.cone_rad.0.min(full), beam.cone_rad.1.min(dark)),
            behind: Some(behind),
            ..*beam
        })
    });
    lamps.chain(beams).take(MOST).collect()
}

/// A light's place as taken through a leaf that it reaches; the other leaf and its side that is lit; and the way from there to the
/// middle of the opening.
fn taken(
    space: &dyn Atlas,
    doors: &Doorway,
    leaf: usize,
    light: ChartPoint,
    range_m: f64,
) -> Option<(ChartPoint, (Leaf, bool), DVec3)> {
    let (own, far) = (&doors.leaves[leaf], doors.leaves[1 - leaf]);
    let near = over(space, own.foot, light);
    let at = own.local(near.pos);
    let middle = DVec3::Y * (0.5 * HEIGHT_M);
    if near.chart != own.foot.chart || at.distance(middle) > range_m {
        return None;
    }
    let point = doors.carry(space, leaf, light)?.point;
    let way = over(space, point, far.place(middle)).pos - point.pos;
    Some((point, (far, at.x < 0.0), way))
}

/// The cone about the middle of an opening that far off.
fn opening_cone_rad(away_m: f64) -> (f64, f64) {
    let away_m = away_m.max(LEAST_M);
    (FULL_M.atan2(away_m), DARK_M.atan2(away_m))
}
