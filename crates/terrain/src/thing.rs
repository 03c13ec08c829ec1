//! Where things can stand on untouched land, and what a chunk's mesh says of those that do.

use antipode_geometry::{ChartId, ChartPoint};
use glam::{DVec3, Vec3};

use crate::field::Field;

/// How far below and above the height that noise asks for land is looked for, metres.
const NEAR_M: f64 = 3.0;
/// Halvings of that: to 6 mm.
const HALVINGS: u32 = 10;
/// How far apart samples for a slope are, metres.
const SLOPE_M: f64 = 0.6;
/// How far below a thing no cave may be, metres: neither the mouth of one nor a hall under a thin roof.
const FIRM_M: [f64; 3] = [0.02, 0.8, 2.0];

/// What grew by itself has slots below this; what somebody planted those from here on.
pub const FIRST_PLANTED: u8 = 128;

/// A thing on a chunk: a plant or a stone, told by numbers that only who draws it understands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thing {
    /// The lowest place of it that shows, metres from the chunk's corner.
    pub root: Vec3,
    /// Its number among all that may stand on the chunk's column, below [`FIRST_PLANTED`]; of what somebody planted among
    /// that on the chunk, from there on.
    pub slot: u8,
    /// The number of its kind.
    pub species: u8,
    /// How old it is, by a number.
    pub age: u8,
    /// How it is turned about the upright, radians.
    pub turn_rad: f32,
    /// How large it is, of its kind and age; about 1.
    pub scale: f32,
}

/// Land that a thing may stand on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Footing {
    /// How high it lies, metres.
    pub height_m: f64,
    /// Its unit normal.
    pub normal: Vec3,
}

impl Field {
    /// The untouched land over a place of the plan, unless it hangs over, is far from where its noise asks for it, or lies
    /// over a cave.
    pub fn footing(&self, chart: ChartId, x: f64, z: f64) -> Option<Footing> {
        let footing = self.untouched_land(chart, x, z)?;
        let below = |below_m: &f64| DVec3::new(x, footing.height_m - below_m, z);
        let is_firm = |below_m| self.sample(ChartPoint::new(chart, below(below_m))) < 0.0;
        FIRM_M.iter().all(is_firm).then_some(footing)
    }

    /// The same of what stands over a cave as well, as long as it is not in its mouth.
    pub fn thin_footing(&self, chart: ChartId, x: f64, z: f64) -> Option<Footing> {
        let footing = self.untouched_land(chart, x, z)?;
        let below = DVec3::new(x, footing.height_m - FIRM_M[0], z);
        (self.sample(ChartPoint::new(chart, below)) < 0.0).then_some(footing)
    }

    /// The land over a place of the plan, caves left out, unless it hangs over or is far from where its noise asks for it.
    fn untouched_land(&self, chart: ChartId, x: f64, z: f64) -> Option<Footing> {
        let land = |x: f64, y: f64, z: f64| self.land(ChartPoint::new(chart, DVec3::new(x, y, z)));
        let about_m = self.land_height_at(chart, x, z);
        let (mut ground_m, mut air_m) = (about_m - NEAR_M, about_m + NEAR_M);
        if land(x, ground_m, z) >= 0.0 || land(x, air_m, z) < 0.0 {
            return None;
        }
        for _ in 0..HALVINGS {
            let middle_m = f64::midpoint(ground_m, air_m);
            if land(x, middle_m, z) < 0.0 {
                ground_m = middle_m;
            } else {
                air_m = middle_m;
            }
        }
        let slope = |by: DVec3| {
            let by = by * SLOPE_M;
            land(x + by.x, ground_m + by.y, z + by.z) - land(x - by.x, ground_m - by.y, z - by.z)
        };
        let normal = Vec3::new(slope(DVec3::X), slope(DVec3::Y), slope(DVec3::Z));
        Some(Footing {
            height_m: ground_m,
            normal: normal.normalize_or(Vec3::Y),
        })
    }
}
