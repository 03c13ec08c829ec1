//! Heat, humidity and how high land lies, as slow noise, and what these make of a place: its biome and its form.
//!
//! A biome has a place among the climates; the nearest one is that of the land. Others whose squared distance is not greater
//! by more than [`BLEND`] have a share in its form, which goes to nothing smoothly. So between two biomes at a distance `d`
//! of each other the form goes over from one to the other on the way on which the climate changes by `BLEND / d`.
//!
//! In a closed world climates are odd: what is warm here is as cold on the other side. So however small it is, each of its
//! two or three biomes, which the seed chooses, has land.

use std::sync::Arc;

use antipode_geometry::{Atlas, ChartId, ChartPoint, NoiseFrame};
use glam::{DVec3, Vec3, Vec4};

use crate::biome::Biome;
use crate::content::BEND;
use crate::form::Form;
use crate::lattice::{Cell, Lattice, LatticeCoord, SCALE, blend, fade, table_seed};
use crate::tracts::{Spot, Tracts};

/// How far apart the lattice points of the slow noise are in open worlds, metres: of heat, humidity and how high land lies.
const SPREADS_M: [f64; 3] = [520.0, 500.0, 480.0];
/// The same in closed worlds, radii.
const CLOSED_SPREAD: f64 = 1.2;
/// How far apart they were if worlds in tiles had some, radii.
const TILED_SPREAD: f64 = 3.0;
/// Standard deviation of the slow noise in open worlds, which that of worlds in tiles has, too.
const DEVIATION: f32 = 0.305;
/// What the noise is multiplied by, so that climates range about from -0.5 to 0.5.
const GAIN: f32 = 1.1;
/// What high land is colder by, as a share of how high it lies.
const COOLS: f32 = 0.4;
/// How much greater squared distances are of what has no share any more.
const BLEND: f32 = 0.15;
/// The same of colours: their borders are narrower than slopes could be, so that each biome has land of its own.
const COLOUR_BLEND: f32 = 0.03;
/// Closed worlds of this radius have three biomes, smaller ones two.
const OF_THREE_M: f64 = 100.0;
/// How often climates are laid out for a world to begin well, and what the seed grows by from one to the next.
const TRIES: u64 = 64;
const ANEW: u64 = 0x9e37_79b9_7f4a_7c15;
/// Another biome is in reach if it is so near to the start along an axis, metres.
const IN_REACH_M: f64 = 150.0;
/// Where the noise of each is looked for, so that none is that of another or of the ground.
const APART: DVec3 = DVec3::new(37.31, 71.57, 53.93);

/// A biome's place in a world's climates.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Land {
    pub at: Vec4,
    pub form: Form,
    pub biome: &'static Biome,
}

/// The climates of a world.
#[derive(Debug)]
pub(crate) struct Climate {
    lattice: Lattice,
    /// Lattice points per metre.
    frequencies: [f64; 3],
    is_closed: bool,
    /// Of a world in tiles, where the climates are in the spots.
    tracts: Option<Arc<Tracts>>,
    lands: Vec<Land>,
}

impl Climate {
    /// A world begins well where its seed's climates, laid out once or anew, let it: so the first look of a player shows land
    /// that one likes to go on from, and another biome in reach.
    pub(crate) fn new(seed: u64, space: &dyn Atlas) -> Self {
        let start = space.noise_point(ChartPoint::new(ChartId::FIRST, DVec3::ZERO));
        let laid_out =
            |n: u64| Self::laid_out([seed, seed.wrapping_add(n.wrapping_mul(ANEW))], space);
        let mut all = (0..TRIES).map(laid_out);
        let found = all.find(|it| match &it.tracts {
            Some(tracts) => it.begins_well_in(tracts, space),
            None => it.begins_well(start),
        });
        found.unwrap_or_else(|| laid_out(0))
    }

    /// Whether a world may begin at a place of noise space.
    fn begins_well(&self, start: DVec3) -> bool {
        let land = |place: DVec3| self.nearest(self.at(place));
        let first = land(start);
        let is_varied = || {
            let about = [DVec3::X, DVec3::NEG_X, DVec3::Z, DVec3::NEG_Z];
            about
                .iter()
                .any(|way| land(start + *way * IN_REACH_M) != first)
        };
        self.lands[first].biome.begins && (self.is_closed || is_varied())
    }

    /// Whether a world in tiles may begin in its first.
    fn begins_well_in(&self, tracts: &Tracts, space: &dyn Atlas) -> bool {
        let Some(tract) = tracts.tract(space, ChartId::FIRST) else {
            return true;
        };
        let lands = || {
            tract
                .middles()
                .map(|broad| self.nearest(Self::tiled(broad)))
        };
        let first = lands().next().unwrap_or(0);
        self.lands[first].biome.begins && lands().any(|land| land != first)
    }

    fn laid_out([first_seed, seed]: [u64; 2], space: &dyn Atlas) -> Self {
        let closed_m = match space.noise_frame(ChartId::FIRST) {
            NoiseFrame::Radial { radius_m } => Some(radius_m),
            NoiseFrame::Square(_) | NoiseFrame::Upright => None,
        };
        // Another lattice than that of the ground.
        let seed = !seed;
        let lands = closed_m.map_or_else(
            || Biome::all().iter().map(Land::new).collect(),
            |radius_m| closed_lands(seed, radius_m),
        );
        let tracts = Tracts::new(first_seed, seed, space).map(Arc::new);
        let tiled_m = tracts.as_ref().map(|it| TILED_SPREAD * it.radius_m());
        let closed_m = closed_m.map(|it| CLOSED_SPREAD * it);
        let spread_m = |n: usize| closed_m.or(tiled_m).unwrap_or(SPREADS_M[n]);
        Self {
            tracts,
            lattice: Lattice::new(seed),
            frequencies: [0, 1, 2].map(|n| spread_m(n).recip()),
            is_closed: closed_m.is_some(),
            lands,
        }
    }

    pub(crate) fn lands(&self) -> &[Land] {
        &self.lands
    }

    /// Distance of the lattice points of the slow noise, metres.
    pub(crate) fn spread_m(&self) -> f64 {
        self.frequencies[0].recip()
    }

    /// The climate at a place of noise space on the ground: heat, humidity, how high land lies, and nothing.
    pub(crate) fn at(&self, place: DVec3) -> Vec4 {
        if self.is_closed {
            let odd = |n: usize| GAIN * (self.noise(n, place) - self.noise(n, -place));
            return Vec4::new(odd(0), odd(1), 0.0, 0.0);
        }
        Self::cooled(self.uncooled(place))
    }

    /// The climate at a spot of a world in tiles.
    #[inline]
    pub(crate) fn at_spot(spot: &Spot) -> Vec4 {
        Self::tiled(spot.climate())
    }

    fn tiled(broad: Vec4) -> Vec4 {
        Self::cooled(broad * (GAIN * DEVIATION))
    }

    fn cooled(climate: Vec4) -> Vec4 {
        climate - Vec4::X * (COOLS * climate.z.max(0.0))
    }

    /// The spots of a world in tiles.
    pub(crate) fn tracts(&self) -> Option<&Arc<Tracts>> {
        self.tracts.as_ref()
    }

    /// The climate of an open world's place, if high land were no colder.
    fn uncooled(&self, place: DVec3) -> Vec4 {
        let place = place.with_y(0.0);
        let [heat, humid, high] = [0, 1, 2].map(|n| GAIN * self.noise(n, place));
        Vec4::new(heat, humid, high, 0.0)
    }

    fn noise(&self, n: usize, place: DVec3) -> f32 {
        let at = place * self.frequencies[n] + APART * (n as f64 + 1.0);
        let [x, y, z] = at.to_array().map(LatticeCoord::new);
        let cell = Cell::new(&self.lattice, [x.low, y.low, z.low]);
        let corners = cell.corners(x.part, y.part, z.part, fade(z.part));
        let (u, v) = (Vec4::splat(fade(x.part)), Vec4::splat(fade(y.part)));
        blend([corners; 4], u, v).x * SCALE
    }

    /// The land of a climate: the place of the nearest in [`Self::lands`].
    #[inline]
    pub(crate) fn nearest(&self, climate: Vec4) -> usize {
        let mut nearest = (f32::INFINITY, 0);
        for (n, land) in self.lands.iter().enumerate() {
            let far = (climate - land.at).length_squared();
            if far < nearest.0 {
                nearest = (far, n);
            }
        }
        nearest.1
    }

    /// Calls `take` with the place in [`Self::lands`] of each that has a share in a climate's colours, and the share; they add
    /// up to one.
    #[inline]
    pub(crate) fn colour_shares(&self, climate: Vec4, take: impl FnMut(usize, f32)) {
        self.shares(climate, COLOUR_BLEND, take);
    }

    /// Calls `take` as [`Self::colour_shares`] does, where nothing has a share whose squared distance is greater by so much.
    #[inline]
    fn shares(&self, climate: Vec4, blend: f32, mut take: impl FnMut(usize, f32)) {
        let mut far = [f32::INFINITY; MOST_LANDS];
        let mut least = f32::INFINITY;
        for (far, land) in far.iter_mut().zip(&self.lands) {
            *far = (climate - land.at).length_squared();
            least = least.min(*far);
        }
        let share = |far: f32| {
            let near = (1.0 - (far - least) * blend.recip()).max(0.0);
            near * near
        };
        let whole: f32 = far
            .iter()
            .take(self.lands.len())
            .map(|far| share(*far))
            .sum();
        for (n, far) in far.iter().take(self.lands.len()).enumerate() {
            let share = share(*far);
            if share > 0.0 {
                take(n, share / whole);
            }
        }
    }

    /// The form of the ground of a climate.
    pub(crate) fn form(&self, climate: Vec4) -> Form {
        let mut form = Form {
            waves: Vec4::ZERO,
            fall_m: 0.0,
            terraces: 0.0,
        };
        self.shares(climate, BLEND, |n, share| {
            let land = self.lands[n].form;
            form.waves += land.waves * share;
            form.fall_m += land.fall_m * share;
            form.terraces += land.terraces * share;
        });
        form
    }
}

/// Room for the rounding of climates.
const ROUNDING: f32 = 1e-4;

impl Climate {
    /// Forms between which those of all columns are, in whatever they say: of an open world's columns in a square of noise
    /// space with this least corner and edge.
    ///
    /// A climate strays from what the corners enclose by no more than `h^2 / 8` times its second derivative along each
    /// axis, and a biome has no share anywhere where it has none at its best corner of what they enclose.
    pub(crate) fn forms(&self, corner: DVec3, edge_m: f64) -> [Form; 2] {
        let (mut least, mut most) = (Vec4::INFINITY, Vec4::NEG_INFINITY);
        for [x, z] in [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]] {
            let climate = self.uncooled(corner + DVec3::new(x, 0.0, z) * edge_m);
            (least, most) = (least.min(climate), most.max(climate));
        }
        let strays = Vec3::from(self.frequencies.map(|it| Self::strays(it * edge_m)));
        let strays = strays.extend(0.0) + ROUNDING;
        (least, most) = (least - strays, most + strays);
        // Heat falls with height, whatever it is.
        let cold = COOLS * most.z.max(0.0);
        let warm = COOLS * least.z.max(0.0);
        self.forms_within(least - Vec4::X * cold, most - Vec4::X * warm)
    }

    /// How far a climate strays between nodes so many lattice points apart.
    fn strays(steps: f64) -> f32 {
        GAIN * (BEND / 8.0 * 2.0 * steps * steps) as f32
    }

    /// [`Self::forms`] of climates between two.
    ///
    /// The nearest land has a share of `1 / (1 + sum n^2)`, where each other has `n^2` times as much: so one that is nowhere
    /// the nearest has no more than `n^2 / (1 + n^2)`, and moves the form by no more than that of its distance.
    fn forms_within(&self, least: Vec4, most: Vec4) -> [Form; 2] {
        let mut most_shares = [0.0; MOST_LANDS];
        for (share, land) in most_shares.iter_mut().zip(&self.lands) {
            let near = |other: &Land| {
                // By how much the other is nearer is linear in the climate.
                let slope = 2.0 * (other.at - land.at);
                let farthest = Vec4::select(slope.cmplt(Vec4::ZERO), most, least);
                let fixed = land.at.length_squared() - other.at.length_squared();
                1.0 - (slope.dot(farthest) + fixed - ROUNDING) * BLEND.recip()
            };
            let near = self.lands.iter().map(near).fold(f32::INFINITY, f32::min);
            let square = near.max(0.0).powi(2);
            // With itself it is 1 and a little.
            *share = if near >= 1.0 {
                1.0
            } else {
                square / (1.0 + square)
            };
        }
        let lands = || self.lands.iter().zip(most_shares);
        let mut nearest = lands().filter(|(_, share)| *share >= 1.0);
        let first = nearest.next().map_or(Form::PLAIN, |(land, _)| land.form);
        let [low, high] = nearest.fold([first; 2], |[low, high], (land, _)| {
            [
                low.pick(&land.form, f32::min),
                high.pick(&land.form, f32::max),
            ]
        });
        let moved = |from: Form, pick: fn(f32, f32) -> f32| {
            lands().fold(from, |form, (land, share)| {
                let by = |form: f32, (from, to): (f32, f32)| form + share * (pick(from, to) - from);
                form.moved(&from, &land.form, by)
            })
        };
        [moved(low, f32::min), moved(high, f32::max)]
    }
}

/// More than biomes there are.
const MOST_LANDS: usize = 16;

impl Land {
    fn new(biome: &'static Biome) -> Self {
        Self {
            at: Vec4::from((Vec3::from(biome.climate), 0.0)),
            form: biome.form(),
            biome,
        }
    }
}

/// The biomes of a closed world, at equal distances round the middle of its climates.
fn closed_lands(seed: u64, radius_m: f64) -> Vec<Land> {
    const PLACES: [&[[f32; 2]]; 2] = [
        &[[0.25, 0.0], [-0.25, 0.0]],
        &[[0.29, 0.0], [-0.145, 0.25], [-0.145, -0.25]],
    ];
    let places = PLACES[usize::from(radius_m >= OF_THREE_M)];
    let mut left: Vec<_> = Biome::all().iter().collect();
    let mut random = u64::from(table_seed(seed));
    let mut lands = Vec::with_capacity(places.len());
    for &[heat, humid] in places {
        let count = left.len() as u64;
        let biome = left.swap_remove((random % count) as usize);
        random /= count;
        lands.push(Land {
            at: Vec4::new(heat, humid, 0.0, 0.0),
            ..Land::new(biome)
        });
    }
    lands
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{Geometry, strategy};
    use glam::DVec2;

    use super::*;

    /// On how many metres of a way of places so far apart a biome's share of the form goes over from a tenth to nine tenths, or
    /// back.
    fn widths_m(climate: &Climate, way: impl Iterator<Item = DVec3>, step_m: f64) -> Vec<f64> {
        let mut widths = Vec::new();
        // Where each share was last low and last high.
        let mut last = [[None::<usize>; 2]; MOST_LANDS];
        for (step, at) in way.enumerate() {
            let mut shares = [0.0; MOST_LANDS];
            climate.shares(climate.at(at), BLEND, |n, share| shares[n] = share);
            for (last, share) in last.iter_mut().zip(shares) {
                let is = [share <= 0.1, share >= 0.9];
                for (now, other) in [(0, 1), (1, 0)] {
                    if is[now] {
                        let before = last[other].take();
                        widths.extend(before.map(|before| (step - before) as f64 * step_m));
                        last[now] = Some(step);
                    }
                }
            }
        }
        widths
    }

    #[test]
    fn forms_of_open_worlds_go_over_on_24_metres_and_more() {
        let space = strategy(Geometry::Euclidean, 0.0);
        let mut all = Vec::new();
        for seed in 300..320 {
            let climate = Climate::new(seed, &*space);
            for n in 0..8 {
                let along = DVec2::from_angle(f64::from(n) * 0.7);
                let from = DVec3::new(f64::from(n) * 430.0, 0.0, -900.0);
                let along = DVec3::new(along.x, 0.0, along.y);
                let way = (0..3000).map(|step| from + along * f64::from(step));
                all.extend(widths_m(&climate, way, 1.0));
            }
        }
        all.sort_by(f64::total_cmp);
        println!(
            "{} borders, from {} m, median {} m",
            all.len(),
            all[0],
            all[all.len() / 2]
        );
        assert!(all.len() > 300 && all[0] >= 24.0, "{:?}", &all[..8]);
    }

    #[test]
    fn forms_of_small_closed_worlds_go_over_on_a_fifth_of_the_spread() {
        let mut shares = Vec::new();
        for seed in 300..320 {
            let space = strategy(Geometry::Spherical, 16.0);
            let climate = Climate::new(seed, &*space);
            let mut widths = Vec::new();
            for n in 0..8 {
                // A great circle, by its axis.
                let axis = DVec3::new(f64::from(n) - 3.5, 1.3, 0.4 * f64::from(n)).normalize();
                let start = axis.any_orthonormal_vector();
                let place = |step: u32| {
                    let (sin, cos) = (f64::from(step) * 0.05 / 16.0).sin_cos();
                    16.0 * (start * cos + axis.cross(start) * sin)
                };
                widths.extend(widths_m(&climate, (0..2000).map(place), 0.05));
            }
            shares.extend(widths.into_iter().map(|width| width / climate.spread_m()));
        }
        shares.sort_by(f64::total_cmp);
        let middle = shares[shares.len() / 2];
        println!("{} borders, median {middle:.3} of the spread", shares.len());
        assert!(middle <= 0.2, "{middle}");
    }
}
