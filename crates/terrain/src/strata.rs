//! Which kind of ground a sample of untouched land is: a pure function of seed, place and depth.
//!
//! The depth is the field's own value there, so that it costs nothing: metres below the surface where the ground is
//! level, and held to the field's band. Near the surface height and two slow waves decide among the biome's kinds;
//! below lie a bed of what is under them, stone, slate, and in those the ores. The waves are worked out at the corners
//! of a lattice of 16 m that all chunks and levels have in common, and drawn between them: a sample has the same kind
//! whichever chunk and level asks. How steep land is, the shader sees by pixel.

use std::cell::RefCell;

use antipode_geometry::{CHUNK_CELLS, ChartPoint, ChunkCoord};
use glam::{DVec3, IVec3, Vec4};

use crate::biome::{Biome, Kinds};
use crate::climate::Climate;
use crate::field::{FIELD_BAND_M, Field};
use crate::kind::{Kind, SKIN};
use crate::memo::{Places, Waves};
use crate::sites::Sites;

/// Depths told apart, of the field's band.
const DEPTH_STEPS: f32 = 255.0;
/// Metres from corner to corner of the lattice of waves.
const SPACING_M: i32 = 16;
/// The lattice's cells along an edge of a chunk.
const ACROSS: i32 = CHUNK_CELLS / SPACING_M;
const CELLS: usize = ACROSS.pow(3) as usize;
/// Frequency of the wave that moves the borders between heights.
const WANDER_FREQUENCY: f64 = 0.37;
/// How far it moves them, metres.
const WANDER_M: f32 = 2.0;
/// Frequency of the wave that makes patches: 25 to 40 m.
const PATCH_FREQUENCY: f64 = 0.25;
/// Frequencies of the waves in which veins lie, and what heights are multiplied by there: veins stand steep, so that what
/// lies at the surface tells of them.
const VEIN_FREQUENCIES: [f64; 2] = [0.7, 0.45];
const VEIN_RISE: f64 = 0.15;
/// Patches lie where that is more than this: an eighth of the land.
const PATCH: f32 = 0.30;
/// What caps the heights begins so far over the high ground, metres.
const CAP_OVER_M: f32 = 4.5;
/// By how much of a climate the waves move the borders between biomes.
const RAGGED: f32 = 0.04;
/// Thickness of what is at the surface, and depths where stone and slate begin, metres; patches move the latter.
const SKIN_M: f32 = 1.1;
const STONE_M: f32 = 2.8;
const SLATE_M: f32 = 6.2;
/// Depths where ores begin, metres.
const COAL_M: f32 = 2.0;
const COPPER_M: f32 = 4.2;
const CRYSTAL_M: f32 = 6.8;

/// The depth of a sample by the field's untouched value there: 0 at the surface and in the air, 255 at the band's end.
pub(crate) fn depth_of(value: f32) -> u8 {
    // The cast saturates, and takes NaN to zero.
    (-value * (DEPTH_STEPS / FIELD_BAND_M)) as u8
}

/// Such a depth in metres.
#[inline]
pub(crate) fn depth_m(depth: u8) -> f32 {
    f32::from(depth) * (FIELD_BAND_M / DEPTH_STEPS)
}

/// The waves at a place: wandering, patches, and the two of the veins.
type Node = Vec4;

/// The kinds of one chunk's samples.
#[derive(Debug)]
pub(crate) struct Strata<'a> {
    field: &'a Field,
    climate: Option<&'a Climate>,
    /// Of the biomes that there are, as [`Climate::lands`] has them, or of the one.
    grounds: Vec<Ground>,
    coord: ChunkCoord,
    offset_m: f64,
    scale: f64,
    memo: RefCell<Memo>,
}

/// What a biome's ground is made of.
#[derive(Debug)]
struct Ground {
    kinds: Kinds,
    /// What is at the surface: by height in the two lowest bits, then in patches, over copper and over crystal.
    skins: [Kind; 32],
    /// Heights where middle ground, high ground and the cap begin, metres in flat worlds.
    borders_m: [f32; 3],
}

impl Ground {
    fn new(kinds: Kinds, [middle, top]: [f32; 2]) -> Self {
        Self {
            kinds,
            skins: skins_of(kinds),
            borders_m: [middle, top, top + CAP_OVER_M],
        }
    }

    fn alone(biome: &'static Biome) -> Self {
        Self::new(biome.kinds_alone(), biome.levels_alone_m())
    }
}

#[derive(Debug)]
struct Memo {
    sites: Option<Sites<Vec4>>,
    places: Places,
    waves: Waves,
    veins: Waves,
    /// The corners of each cell, x the slowest and z the next; not numbers where nobody has asked yet.
    cells: Box<[[Node; 8]; CELLS]>,
}

impl<'a> Strata<'a> {
    pub(crate) fn new(field: &'a Field, coord: ChunkCoord) -> Self {
        let climate = field.climate().map(|it| &**it);
        let grounds = climate.map_or_else(
            || vec![Ground::alone(field.alone())],
            |climate| {
                let biomes = climate.lands().iter().map(|land| land.biome);
                biomes
                    .map(|it| Ground::new(it.kinds, it.levels_m))
                    .collect()
            },
        );
        let (offset_m, scale) = field.own_heights();
        Self {
            field,
            climate,
            grounds,
            coord,
            offset_m,
            scale,
            memo: RefCell::new(Memo {
                sites: climate.map(Sites::new),
                places: Places::new(),
                waves: Waves::new([WANDER_FREQUENCY, PATCH_FREQUENCY]),
                veins: Waves::new(VEIN_FREQUENCIES),
                cells: Box::new([[Vec4::NAN; 8]; CELLS]),
            }),
        }
    }

    /// The kind of the sample at whole metres from the chunk's origin, each 0 to 32, at a depth as [`depth_of`] tells it: the
    /// number of a kind, and [`SKIN`] where it is that.
    #[expect(clippy::inline_always, reason = "compiled for several processors")]
    #[inline(always)]
    pub(crate) fn at(&self, sample: IVec3, depth: u8) -> u8 {
        let waves = self.waves(sample);
        let y = f64::from(self.coord.index.y) * f64::from(CHUNK_CELLS) + f64::from(sample.y);
        let height = ((y - self.offset_m) * self.scale) as f32;
        let depth_m = depth_m(depth);
        let ground = self.ground(sample, waves);
        if depth_m < SKIN_M {
            ground.skin(height, waves).byte() | SKIN
        } else {
            ground.below(depth_m, height, waves).byte()
        }
    }

    /// What the biome of a sample has. Borders between biomes are ragged.
    #[inline]
    fn ground(&self, sample: IVec3, waves: Node) -> &Ground {
        let Some(climate) = self.climate else {
            return &self.grounds[0];
        };
        let pos = self.coord.origin() + sample.as_dvec3();
        let point = ChartPoint::new(self.coord.chart, pos);
        let here = match &mut self.memo.borrow_mut().sites {
            Some(sites) => sites.at(self.field, climate, point),
            None => Vec4::ZERO,
        };
        let ragged = Vec4::new(waves.y, waves.x, 0.0, 0.0) * RAGGED;
        &self.grounds[climate.nearest(here + ragged)]
    }

    /// The waves between the lattice's corners.
    #[expect(clippy::inline_always, reason = "compiled for several processors")]
    #[inline(always)]
    fn waves(&self, sample: IVec3) -> Node {
        // What is drawn between two corners is exact at both, so that chunks agree where they meet.
        let cell = (sample >> SPACING_M.trailing_zeros()).min(IVec3::splat(ACROSS - 1));
        let part = (sample - cell * SPACING_M).as_vec3() * (1.0 / SPACING_M as f32);
        let at = ((cell.x * ACROSS + cell.z) * ACROSS + cell.y) as usize % CELLS;
        let memo = &mut *self.memo.borrow_mut();
        if memo.cells[at][0].x.is_nan() {
            memo.cells[at] = self.corners(memo, cell);
        }
        let [a, b, c, d, e, f, g, h] = memo.cells[at];
        let lower = a.lerp(e, part.x).lerp(c.lerp(g, part.x), part.z);
        let upper = b.lerp(f, part.x).lerp(d.lerp(h, part.x), part.z);
        lower.lerp(upper, part.y)
    }

    /// The corners of a cell of the lattice.
    #[cold]
    #[inline(never)]
    fn corners(&self, memo: &mut Memo, cell: IVec3) -> [Node; 8] {
        std::array::from_fn(|n| {
            let n = n as i32;
            let node = cell + IVec3::new(n >> 2, n & 1, n >> 1 & 1);
            self.wave(memo, self.coord.origin() + (node * SPACING_M).as_dvec3())
        })
    }

    fn wave(&self, memo: &mut Memo, pos: DVec3) -> Node {
        if let Some(spot) = self.field.spot(self.coord.chart, pos.x, pos.z) {
            let lattice = self.field.lattice();
            let [wander, patch] = memo.waves.over(lattice, &spot, pos.y);
            let [a, b] = memo.veins.over(lattice, &spot, pos.y * VEIN_RISE);
            return Vec4::new(wander, patch, a, b);
        }
        let mut place = |y: f64| {
            let pos = DVec3::new(pos.x, y, pos.z);
            memo.places
                .at(self.field, ChartPoint::new(self.coord.chart, pos))
        };
        let (here, risen) = (place(pos.y), place(pos.y * VEIN_RISE));
        let lattice = self.field.lattice();
        let [wander, patch] = memo.waves.at(lattice, here);
        let [a, b] = memo.veins.at(lattice, risen);
        Vec4::new(wander, patch, a, b)
    }
}

impl Ground {
    /// The kind at the surface.
    #[inline]
    fn skin(&self, height: f32, waves: Node) -> Kind {
        let level = height + WANDER_M * waves.x;
        // Without branches, which processors would foresee badly.
        let over = self.borders_m.map(|border| usize::from(level > border));
        let by_height = over[0] + over[1] + over[2];
        let is_patch = usize::from(waves.y > PATCH) & (over[2] ^ 1);
        let is_copper = usize::from(COPPER.holds(waves));
        let is_crystal = usize::from(CRYSTAL.holds(waves));
        self.skins[by_height | is_patch << 2 | is_copper << 3 | is_crystal << 4]
    }

    fn below(&self, depth_m: f32, height: f32, waves: Node) -> Kind {
        if let Some(ore) = ore_of(depth_m, height, waves) {
            ore
        } else if depth_m > SLATE_M + waves.x {
            Kind::Slate
        } else if depth_m > STONE_M + waves.y {
            self.kinds.stone
        } else {
            self.kinds.under
        }
    }
}

/// As [`Ground::skins`].
fn skins_of(kinds: Kinds) -> [Kind; 32] {
    let by_height = [kinds.low, kinds.middle, kinds.high, kinds.cap];
    std::array::from_fn(|n| {
        if n & 0b1000 != 0 {
            Kind::Clay
        } else if n & 0b1_0000 != 0 {
            Kind::Gravel
        } else if n & 0b100 != 0 {
            kinds.patch
        } else {
            by_height[n & 3]
        }
    })
}

/// Where the two waves of the veins are near a value each: tubes, which two surfaces have in common.
struct Vein {
    at: [f32; 2],
    width: f32,
}

impl Vein {
    #[inline]
    fn holds(&self, waves: Node) -> bool {
        ((waves.z - self.at[0]).abs() < self.width) & ((waves.w - self.at[1]).abs() < self.width)
    }
}

/// Over copper lies clay and over crystal gravel.
const COPPER: Vein = Vein {
    at: [0.12, 0.06],
    width: 0.085,
};
const CRYSTAL: Vein = Vein {
    at: [-0.16, -0.10],
    width: 0.06,
};
/// Coal lies in beds so far apart, metres of height, of this share of it, where the patches' wave is more than this.
const COAL_BED_M: f32 = 5.0;
const COAL_SHARE: f32 = 0.26;
const COAL_PATCH: f32 = 0.02;

/// The ore at a depth and height, metres, if there is any: the deeper, the rarer.
fn ore_of(depth_m: f32, height: f32, waves: Node) -> Option<Kind> {
    if depth_m > CRYSTAL_M && CRYSTAL.holds(waves) {
        return Some(Kind::Crystal);
    }
    if depth_m > COPPER_M && COPPER.holds(waves) {
        return Some(Kind::Copper);
    }
    let bed = (height + WANDER_M * waves.x) / COAL_BED_M;
    let is_coal = depth_m > COAL_M && waves.y > COAL_PATCH && bed - bed.floor() < COAL_SHARE;
    is_coal.then_some(Kind::Coal)
}
