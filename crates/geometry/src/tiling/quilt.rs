//! What noise that knows no centre goes by: the tiles about a place, each with coordinates of its own there and a weight.
//!
//! A tile's *patch* is the disc about its centre in which it has a weight. With P = (X, Z, W) as its frame has a point, the
//! weight is `t^3 / (t + SOFT)` of `t = 1 - (W - 1)/(PATCH_COSH - 1)`, twice differentiable where it comes to nothing, and the
//! coordinates are `(X, Z) 3/(2 + W)`, which is the way out from the centre to 1.4 %: `r/sinh(r) = 1 - (W - 1)/3 + ...`,
//! and so is `3/(2 + W)`. In a patch a metre of them is 1 m outwards and 1 to 1.32 m across. Nothing in that but the chart's own
//! tangents is more than a root away from whole numbers, so that all machines find the same.
//!
//! A place on an edge or a corner belongs to two or five tiles. It is told in the least of them, where it lies exactly, so
//! that whoever asks in another chart is told the same to the bit.

use glam::{DMat3, DVec2, DVec3};

use super::{EDGE_TANH, Frame, Golden, Isometry, Side, TilingError, rings};

/// Tiles whose patches reach into a tile: itself, four over its edges and eight over its corners.
pub const PATCHES: usize = 13;
/// The most patches that a place lies in; on average they are 5.
pub const MOST_PATCHES: usize = 8;
/// W where a patch ends, 1.317 radii from its centre. That is as wide as it can be for no other tiles to reach into one, and so
/// wide that noise is hardly steeper at a corner, where weights change fastest.
pub const PATCH_COSH: f64 = 2.0;
/// How a weight comes to nothing: as a cube where t is less than this.
const SOFT: f64 = 0.1;
/// Centres nearer than this to a tile's, in W, are those of the patches that reach into it: over a corner it is phi^2.
const NEAR_COSH: f64 = 3.0;
/// What lies so near to an edge, in X/W, lies on it.
const ON_EDGE: f64 = 1e-12;

/// A tile's patch, as another tile near it has it.
#[derive(Debug, Clone)]
pub struct Patch {
    frame: Frame,
    key: u64,
    // From (X, Z, W) in the asking tile's frame to that in the patch's.
    way: DMat3,
}

impl Patch {
    /// A number of the patch's tile, from its exact centre: tiles do not share one but by chance.
    pub fn key(&self) -> u64 {
        self.key
    }

    /// The patch's tile.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// The place in the patch, radii, of one by X/W and Z/W of it in the asking tile's frame.
    pub fn place(&self, at: DVec2) -> DVec2 {
        let there = self.way * on_sheet(at);
        there.truncate() * (3.0 / (2.0 + there.z))
    }

    /// [`Self::key`] of the tiles whose centres, in the patch's frame, are those of a [`Surroundings`], in their order. What
    /// lies past the end of the world has 0.
    pub fn keys_around(&self, surroundings: &Surroundings) -> impl Iterator<Item = u64> {
        let centres = surroundings.exact.iter();
        centres.map(|centre| {
            let moved = self.frame.to_root().moved(*centre);
            moved.map_or(0, key_of)
        })
    }
}

/// Where tiles lie about any tile, in its frame.
#[derive(Debug, Clone, Default)]
pub struct Surroundings {
    exact: Vec<[Golden; 3]>,
    centres: Vec<DVec3>,
}

impl Surroundings {
    /// Those to so many steps whose centres have a W of at most this, nearest steps first.
    ///
    /// # Errors
    /// [`TilingError::TooMany`] where there would be more than `most` within so many steps.
    pub fn new(steps: usize, most_cosh: f64, most: usize) -> Result<Self, TilingError> {
        let mut exact = Vec::new();
        let mut centres = Vec::new();
        for frame in rings(&Frame::ROOT, steps, most)?.iter().flatten() {
            let lorentz = frame.to_root().lorentz();
            let centre = lorentz.w_axis;
            if centre.w <= most_cosh {
                exact.push(frame.tile().centre());
                centres.push(DVec3::new(centre.x, centre.z, centre.w));
            }
        }
        Ok(Self { exact, centres })
    }

    /// (X, Z, W) of each centre.
    pub fn centres(&self) -> &[DVec3] {
        &self.centres
    }
}

/// A tile that an edge or a corner is shared with: its place in [`Quilt::around`], and which of its sides or corners that is.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Shared {
    over: usize,
    back: u8,
}

/// A tile's own patch and all that reach into it.
#[derive(Debug, Clone)]
pub struct Quilt {
    /// First those that reach into it, so many; then those two steps straight on.
    around: Vec<Patch>,
    near: usize,
    /// Over each side the tile there, and the way there.
    over: [Option<(Shared, DMat3)>; 4],
    /// Where an edge belongs to the tile over it.
    edges: [Option<Shared>; 4],
    /// Of each corner, between a side and the next: the tile that it belongs to, if that is another, and which of its corners
    /// it is.
    corners: [Option<Shared>; 4],
}

/// Whose a place is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Owner {
    /// The tile's that was asked; X/W and Z/W of it there.
    This(DVec2),
    /// Another's: its place in [`Quilt::around`], and X/W and Z/W in its frame.
    Other(usize, DVec2),
}

impl Quilt {
    /// That of a tile.
    ///
    /// # Errors
    /// As [`Frame::neighbour`], but for what lies past the end of the world, which is left out.
    pub fn new(own: &Frame) -> Result<Self, TilingError> {
        let mut patches = Vec::with_capacity(PATCHES);
        let mut beyond = Vec::new();
        for frame in rings(own, 2, 1 + 4 + 12)?.into_iter().flatten() {
            let way = frame.between(own)?;
            let way = plane(&way);
            let patch = Patch {
                frame,
                key: key_of(frame.tile().centre()),
                way,
            };
            // Where the own centre lies.
            if way.z_axis.z < NEAR_COSH {
                patches.push(patch);
            } else {
                beyond.push(patch);
            }
        }
        let near = patches.len();
        patches.append(&mut beyond);
        let mut quilt = Self {
            around: patches,
            near,
            over: [None; 4],
            edges: [None; 4],
            corners: [None; 4],
        };
        for side in Side::ALL {
            quilt.share(own, side)?;
        }
        Ok(quilt)
    }

    /// Finds whose the edge at a side is, and the corner between it and the next.
    fn share(&mut self, own: &Frame, side: Side) -> Result<(), TilingError> {
        let n = usize::from(side.number());
        if let Ok(over) = own.neighbour(side) {
            let way = plane(&Isometry::crossing(over.back, side)?);
            let shared = self.shared(&over.frame, over.back);
            self.over[n] = shared.map(|shared| (shared, way));
            self.edges[n] = shared.filter(|_| over.frame.tile() < own.tile());
        }
        // Round the corner: over the side that it begins, it lies between the side one comes by and the one before.
        let (mut frame, mut corner) = (*own, side);
        let mut least = (*own, side);
        for _ in 0..4 {
            let Ok(next) = frame.neighbour(corner) else {
                return Ok(());
            };
            (frame, corner) = (next.frame, next.back.turned(3));
            if frame.tile() < least.0.tile() {
                least = (frame, corner);
            }
        }
        if least.0 != *own {
            self.corners[n] = self.shared(&least.0, least.1);
        }
        Ok(())
    }

    fn shared(&self, frame: &Frame, back: Side) -> Option<Shared> {
        let over = self.around.iter().position(|other| other.frame == *frame)?;
        let back = back.number();
        Some(Shared { over, back })
    }

    /// The tiles over the sides, as places in [`Self::around`]; none past the end of the world.
    pub fn over_sides(&self) -> [Option<usize>; 4] {
        self.over.map(|over| over.map(|(shared, _)| shared.over))
    }

    /// The patches that reach into the tile, at most [`PATCHES`], its own first.
    pub fn patches(&self) -> &[Patch] {
        &self.around[..self.near]
    }

    /// All tiles to two steps over edges: [`Self::patches`] and the four straight on behind those over the edges. No tile that
    /// shares a corner with this one is missing.
    pub fn around(&self) -> &[Patch] {
        &self.around
    }

    /// Whose a place is, by X/W and Z/W of it in this tile's frame; of one outside of the tile it may be yet another's, which
    /// that other is to be asked.
    pub fn owner(&self, at: DVec2) -> Owner {
        let turns = [at, turned(at, 3), turned(at, 2), turned(at, 1)];
        let farthest = (0..4).fold(
            0,
            |most, n| if turns[n].x > turns[most].x { n } else { most },
        );
        if turns[farthest].x > EDGE_TANH + ON_EDGE {
            return self.past(farthest, at);
        }
        let is_on = |n: usize| turns[n % 4].x > EDGE_TANH - ON_EDGE;
        let Some(n) = (0..4).find(|n| is_on(*n)) else {
            return Owner::This(at);
        };
        let corner = if is_on(n + 1) {
            Some(n)
        } else {
            is_on(n + 3).then_some((n + 3) % 4)
        };
        if let Some(corner) = corner {
            let own = turned(DVec2::splat(EDGE_TANH), corner);
            return self.corners[corner].map_or(Owner::This(own), |shared| {
                let there = turned(DVec2::splat(EDGE_TANH), shared.back.into());
                Owner::Other(shared.over, there)
            });
        }
        let along = turns[n].y;
        let own = turned(DVec2::new(EDGE_TANH, along), n);
        self.edges[n].map_or(Owner::This(own), |shared| {
            let there = turned(DVec2::new(EDGE_TANH, -along), shared.back.into());
            Owner::Other(shared.over, there)
        })
    }

    /// A place past a side, in the tile over it.
    fn past(&self, side: usize, at: DVec2) -> Owner {
        self.over[side].map_or(Owner::This(at), |(shared, way)| {
            let there = way * at.extend(1.0);
            Owner::Other(shared.over, there.truncate() / there.z)
        })
    }

    /// Calls `take` with each patch that a place of the tile lies in, by X/W and Z/W: its number among [`Self::patches`], the
    /// place there in radii, and its weight, more than 0 and at most 0.91.
    pub fn each(&self, at: DVec2, mut take: impl FnMut(usize, DVec2, f64)) {
        const PER_COSH: f64 = 1.0 / (PATCH_COSH - 1.0);
        let point = on_sheet(at);
        for (n, patch) in self.patches().iter().enumerate() {
            let way = &patch.way;
            let cosh = way.x_axis.z * point.x + way.y_axis.z * point.y + way.z_axis.z * point.z;
            let t = 1.0 - (cosh - 1.0) * PER_COSH;
            if t > 0.0 {
                let there = *way * point;
                let place = there.truncate() * (3.0 / (2.0 + cosh));
                take(n, place, t * t * t / (t + SOFT));
            }
        }
    }
}

/// (X, Z, W) by X/W and Z/W.
fn on_sheet(at: DVec2) -> DVec3 {
    let w = (1.0 - at.length_squared()).max(f64::MIN_POSITIVE).sqrt();
    at.extend(1.0) / w
}

/// X/W and Z/W in a patch's own frame of a place in the patch, radii: the inverse of `(X, Z) 3/(2 + W)`. With its length u and
/// `s = |(X, Z)|`, `u (2 + sqrt(1 + s^2)) = 3 s` is `(9 - u^2) s^2 - 12 u s + 3 u^2 = 0`.
pub fn tangents_in_patch(place: DVec2) -> DVec2 {
    /// Where that has no root any more s is infinite.
    const FARTHEST: f64 = 8.5;
    let square = place.length_squared().min(FARTHEST);
    let stretch = (12.0 + (36.0 + 12.0 * square).sqrt()) / (2.0 * (9.0 - square));
    let level = place * stretch;
    level / (1.0 + level.length_squared()).sqrt()
}

/// A place turned by so many quarter turns from x to z, exactly.
fn turned(at: DVec2, quarters: usize) -> DVec2 {
    match quarters % 4 {
        0 => at,
        1 => DVec2::new(-at.y, at.x),
        2 => -at,
        _ => DVec2::new(at.y, -at.x),
    }
}

/// A move on (X, Z, W), in radii.
fn plane(way: &Isometry) -> DMat3 {
    let way = way.lorentz();
    let column = |v: glam::DVec4| DVec3::new(v.x, v.z, v.w);
    DMat3::from_cols(column(way.x_axis), column(way.z_axis), column(way.w_axis))
}

/// A number of a centre: all of its bits, stirred (the finaliser of splitmix64).
fn key_of(centre: [Golden; 3]) -> u64 {
    let stirred = |n: u64| {
        let n = n.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let n = (n ^ (n >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let n = (n ^ (n >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        n ^ (n >> 31)
    };
    // The third number follows from the two.
    let parts = [centre[0], centre[1]].map(Golden::parts);
    parts.into_iter().flatten().fold(0, |key, part| {
        let part = part.cast_unsigned();
        stirred(stirred(key ^ part as u64) ^ (part >> 64) as u64)
    })
}
