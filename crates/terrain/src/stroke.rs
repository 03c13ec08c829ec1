//! Strokes: what a pickaxe does in one step of time.

use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

use antipode_geometry::{Atlas, CHUNK_CELLS, ChartId, ChartPoint, ChunkCoord};
use glam::{DVec2, DVec3, IVec3};

use crate::edits::{ChunkEdits, owned_index};
use crate::field::{FIELD_BAND_M, Field, RIM_REACH_M, editable_y_m};
use crate::kind::{Kind, SKIN};
use crate::level::Level;
use crate::samples::Samples;
use crate::shape::Shape;
use crate::strata::Strata;

/// How fast a stroke weakens: `exp(-FALLOFF_PER_M2 d^2)`, as in the reference game.
pub const FALLOFF_PER_M2: f64 = 0.1;
/// Radii are held to this, metres, so that no input can ask for a world's worth of work.
const MAX_RADIUS_M: f64 = 16.0;
/// Samples of a chart this far past its domain are the last that any mesh looks at: the
/// meshed cells' far corners and the border that their normals need.
const EDITED_PAST_RIM_M: f64 = RIM_REACH_M + 4.0;

/// One push of the brush: a Gaussian added to the field's samples within `radius_m`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    /// The brush's middle; distances are measured in this point's chart.
    pub centre: ChartPoint,
    /// Nothing changes farther from the middle than this, metres; 1 to 10 in the game.
    pub radius_m: f64,
    /// Metres of field at the middle: positive digs, negative builds. Strength per second
    /// times the time that the stroke stands for.
    pub amount: f32,
    /// What of the ball is changed.
    pub part: Part,
    /// What is built of; nothing says that what untouched land has there comes back.
    pub kind: Option<Kind>,
    /// The brush's shape and what it does.
    pub shape: Shape,
    /// How hard ground it digs, as [`Kind::hardness`] has it: what is harder stays, and what is just so hard yields slowly.
    /// Without it all ground yields alike.
    pub power: Option<u8>,
}

/// What a chunk's ground is, with all edits before a stroke.
#[derive(Debug, Clone, Copy)]
pub struct Ground<'a> {
    /// Its samples.
    pub samples: &'a Samples,
    /// The untouched land.
    pub field: &'a Field,
}

/// How fast ground yields to what is just hard enough for it.
const HARD_EASE: f32 = 0.4;

/// Where a stroke builds by less than that share of what it does at its middle it leaves ores of other kinds bare.
const LEAST_ON_ORE: f32 = 0.5;
/// What turns at once is so deep in the ground, or so far in the air, metres of field.
const JUST_GROUND: f32 = -0.25;
const WHOLLY_AIR: f32 = FIELD_BAND_M;

/// How a chunk's samples yield to the stroke of somebody who gathers.
struct Ease<'a> {
    samples: &'a Samples,
    strata: Strata<'a>,
    power: u8,
}

impl Ease<'_> {
    /// Of a sample by its indices in the block: 1 where it does not resist, 0 where it is too hard. Of air it is that of the
    /// hardest ground beside it, whose surface it moves.
    fn of(&self, [i, j, k]: [usize; 3]) -> f32 {
        if self.samples.get(i, j, k) < 0.0 {
            return self.of_solid([i, j, k]);
        }
        let beside = self.solid_beside([i, j, k]);
        beside.map(|at| self.of_solid(at)).fold(1.0, f32::min)
    }

    /// What is ground of the samples beside one.
    fn solid_beside(&self, [i, j, k]: [usize; 3]) -> impl Iterator<Item = [usize; 3]> {
        let beside = [
            [i - 1, j, k],
            [i + 1, j, k],
            [i, j - 1, k],
            [i, j + 1, k],
            [i, j, k - 1],
            [i, j, k + 1],
        ];
        let is_solid = |[i, j, k]: &[usize; 3]| self.samples.get(*i, *j, *k) < 0.0;
        beside.into_iter().filter(is_solid)
    }

    /// By how much a stroke changes a sample that `now` has that value, in place of `amount`.
    ///
    /// The surface between a sample of ore and one of air is ore, and would grow with the values of both long before the
    /// air is ground of what one builds of. So ores stay as they are, and what lies beside them turns to ground at once, and
    /// later to air at once: nobody pays with ore for what he builds of soil, nor digs ore where he has built soil.
    fn beside_ore(&self, at: [usize; 3], now: f32, stroke: &Stroke, amount: f32) -> f32 {
        let is_ore_beside = |own: Kind| {
            let mut beside = self.solid_beside(at).map(|at| self.kind_of(at));
            beside.any(|kind| kind.is_ore() && kind != own)
        };
        if amount < 0.0 {
            let Some(builds) = stroke.kind else {
                return amount;
            };
            let is_other_ore = |kind: Kind| kind.is_ore() && kind != builds;
            let stays = now < 0.0 && is_other_ore(self.kind_of(at));
            let is_covered = amount <= LEAST_ON_ORE * stroke.amount;
            return match now >= 0.0 && is_ore_beside(builds) {
                _ if stays => 0.0,
                true if is_covered => amount.min(JUST_GROUND - now),
                true => 0.0,
                false => amount,
            };
        }
        let [i, j, k] = at;
        let laid = Kind::of_byte(self.samples.covered(self.samples.index(i, j, k)).laid);
        let turns = now < 0.0 && now + amount >= 0.0;
        if turns && laid.is_some_and(is_ore_beside) {
            return amount.max(WHOLLY_AIR - now);
        }
        amount
    }

    fn of_solid(&self, at: [usize; 3]) -> f32 {
        let hardness = self.kind_of(at).hardness();
        match hardness.cmp(&self.power) {
            Ordering::Less => 1.0,
            Ordering::Equal if hardness == 0 => 1.0,
            Ordering::Equal => HARD_EASE,
            Ordering::Greater => 0.0,
        }
    }

    /// The kind of a sample that is ground.
    fn kind_of(&self, at: [usize; 3]) -> Kind {
        let [i, j, k] = at;
        let land = self.samples.covered(self.samples.index(i, j, k));
        // Strata tell what is within the chunk; beside it the kind is as good as that of the sample next to it.
        let place = at.map(|c| (c as i32 - 1).clamp(0, CHUNK_CELLS));
        let byte = match land.laid {
            0 => self.strata.at(IVec3::from(place), land.depth) & !SKIN,
            laid => laid,
        };
        Kind::of_byte(byte).unwrap_or(Kind::PLAIN)
    }
}

/// The part of a stroke's ball that is changed: all of it, or what is reached from its middle through a gate or not.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub enum Part {
    /// All.
    #[default]
    Whole,
    /// What is not reached through the gate.
    Before(Gate),
    /// What is reached through neither of two.
    BeforeBoth([Gate; 2]),
    /// What is reached through it alone.
    Through(Gate),
}

/// An upright opening in the chart of a stroke's middle, as deep as the ground is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gate {
    /// The middle of its sill.
    pub foot: DVec3,
    /// The heading across it, radians from +x towards +z.
    pub heading_rad: f64,
    /// Half of its width, metres.
    pub half_width_m: f64,
    /// Its height over the foot, metres.
    pub height_m: f64,
}

impl Gate {
    /// Whether the straight way between two places leads through.
    ///
    /// In the gate's axes, x across it, the way from a to b meets it at the share `a.x / (a.x - b.x)`.
    fn is_between(&self, a: DVec3, b: DVec3) -> bool {
        let (sine, cosine) = self.heading_rad.sin_cos();
        let own = |place: DVec3| {
            let off = place - self.foot;
            let aside = off.z * cosine - off.x * sine;
            DVec3::new(off.x * cosine + off.z * sine, off.y, aside)
        };
        let (a, b) = (own(a), own(b));
        if (a.x >= 0.0) == (b.x >= 0.0) {
            return false;
        }
        let at = a.lerp(b, a.x / (a.x - b.x));
        at.z.abs() <= self.half_width_m && at.y <= self.height_m
    }
}

impl Part {
    /// Whether a place belongs to it, of a ball about that middle.
    fn holds(&self, middle: DVec3, place: DVec3) -> bool {
        match self {
            Self::Whole => true,
            Self::Before(gate) => !gate.is_between(middle, place),
            Self::BeforeBoth(gates) => !gates.iter().any(|gate| gate.is_between(middle, place)),
            Self::Through(gate) => gate.is_between(middle, place),
        }
    }
}

/// A square of lattice columns of one chart that holds all that a stroke changes there.
struct Window {
    chart: ChartId,
    x: RangeInclusive<i64>,
    z: RangeInclusive<i64>,
}

/// A column of samples that a stroke reaches.
struct Reached {
    x: i64,
    z: i64,
    /// The way from the stroke's middle, in the chart of that, metres.
    way: DVec2,
    y: RangeInclusive<i64>,
}

/// How far below and above itself, in samples, a sample is seen from chunks.
#[derive(Clone, Copy)]
struct Seen {
    back: i64,
    ahead: i64,
}

/// By its owner only.
const OWNED: Seen = Seen { back: 0, ahead: 0 };

impl Seen {
    /// By every chunk whose block at a level holds it: samples -step..=32 + step of chunk 0.
    const fn padded(level: Level) -> Self {
        let step = level.step_m() as i64;
        Self {
            back: step + 1,
            ahead: step,
        }
    }

    fn chunks(self, samples: &RangeInclusive<i64>) -> RangeInclusive<i32> {
        let first = (samples.start() - self.back).div_euclid(32);
        let last = (samples.end() + self.ahead).div_euclid(32);
        first as i32..=last as i32
    }
}

fn whole(low: f64, high: f64) -> RangeInclusive<i64> {
    low.ceil() as i64..=high.floor() as i64
}

fn common(a: &RangeInclusive<i64>, b: &RangeInclusive<i64>) -> RangeInclusive<i64> {
    *a.start().max(b.start())..=*a.end().min(b.end())
}

impl Stroke {
    /// Chunks that own a sample within the stroke, of every chart whose edge it nears, in
    /// ascending order. The chunks to [`Self::apply`] it to.
    pub fn touched(&self, strategy: &dyn Atlas) -> Vec<ChunkCoord> {
        self.chunks(strategy, OWNED)
    }

    /// Chunks whose block of samples, border included, holds a sample within the stroke:
    /// [`Self::touched`] and the neighbours that see it. The chunks to mesh again.
    pub fn remeshed(&self, strategy: &dyn Atlas) -> Vec<ChunkCoord> {
        self.remeshed_at(strategy, Level::FULL)
    }

    /// As [`Self::remeshed`], of chunks that are meshed at a level: the coarser, the farther
    /// their border reaches.
    pub fn remeshed_at(&self, strategy: &dyn Atlas, level: Level) -> Vec<ChunkCoord> {
        self.chunks(strategy, Seen::padded(level))
    }

    /// Whether the stroke goes by what the ground is: [`Self::apply_to`] needs samples then.
    pub fn needs_samples(&self, edits: &ChunkEdits) -> bool {
        let lays = self.amount < 0.0 && (self.kind.is_some() || !edits.kind_bytes().is_empty());
        self.shape != Shape::Ball || lays || self.power.is_some()
    }

    /// Adds the stroke to the edits of the chunk at `coord`, as far as that needs no samples; says whether any edit's
    /// stored value changed. Edits must be kept either way: what is less than a stored unit adds up.
    pub fn apply(&self, coord: ChunkCoord, edits: &mut ChunkEdits, strategy: &dyn Atlas) -> bool {
        self.apply_to(coord, edits, strategy, None)
    }

    /// As [`Self::apply`], by what the chunk's ground is with all edits before. What turns from air to ground is laid of
    /// the stroke's kind.
    pub fn apply_to(
        &self,
        coord: ChunkCoord,
        edits: &mut ChunkEdits,
        strategy: &dyn Atlas,
        now: Option<Ground<'_>>,
    ) -> bool {
        let ease = now.zip(self.power).map(|(now, power)| Ease {
            samples: now.samples,
            strata: Strata::new(now.field, coord),
            power,
        });
        let now = now.map(|now| (now.samples, ease.as_ref()));
        let [x0, y0, z0] = coord.index.to_array().map(|c| i64::from(c) * 32);
        let mut changed = false;
        for mut window in self.windows(strategy) {
            if window.chart != coord.chart {
                continue;
            }
            window.x = common(&window.x, &(x0..=x0 + 31));
            window.z = common(&window.z, &(z0..=z0 + 31));
            for column in self.columns(strategy, &window) {
                for y in common(&column.y, &(y0..=y0 + 31)) {
                    let dy = y as f64 - self.centre.pos.y;
                    let off = DVec3::new(column.way.x, dy, column.way.y);
                    if !self.part.holds(self.centre.pos, self.centre.pos + off) {
                        continue;
                    }
                    let local = [column.x - x0, y - y0, column.z - z0].map(|c| c as usize);
                    changed |= self.apply_at(local, off, edits, now);
                }
            }
        }
        changed
    }

    /// Changes one sample of a chunk, which is so far off the stroke's middle.
    fn apply_at(
        &self,
        local: [usize; 3],
        off: DVec3,
        edits: &mut ChunkEdits,
        now: Option<(&Samples, Option<&Ease<'_>>)>,
    ) -> bool {
        let [i, j, k] = local;
        let at = owned_index(i, j, k);
        let amount = match (self.shape, now) {
            (Shape::Ball, _) | (_, None) => {
                f64::from(self.amount) * (-FALLOFF_PER_M2 * off.length_squared()).exp()
            }
            (shape, Some((now, _))) => {
                let place = (off, self.centre.pos.y + off.y);
                let change = shape.change(now, local, place, (self.radius_m(), self.amount > 0.0));
                f64::from(change.clamp(-self.amount.abs(), self.amount.abs()))
            }
        };
        let Some((now, ease)) = now else {
            return edits.add_at(at, amount as f32);
        };
        let yields = |ease: &Ease<'_>| f64::from(ease.of([i + 1, j + 1, k + 1]));
        let amount = amount * ease.filter(|_| amount > 0.0).map_or(1.0, yields);
        let before = now.get(i + 1, j + 1, k + 1);
        let mut amount = amount as f32;
        if let Some(ease) = ease {
            amount = ease.beside_ore([i + 1, j + 1, k + 1], before, self, amount);
        }
        let changed = edits.add_at(at, amount);
        let turns = before >= 0.0 && before + amount < 0.0;
        let laid = self.kind.map_or(0, Kind::byte);
        (turns && edits.lay_at(at, laid)) || changed
    }

    fn radius_m(&self) -> f64 {
        self.radius_m.clamp(0.0, MAX_RADIUS_M)
    }

    /// How far from its middle the stroke changes anything.
    fn reach_m(&self) -> f64 {
        self.shape.reach_m(self.radius_m())
    }

    fn chunks(&self, strategy: &dyn Atlas, seen: Seen) -> Vec<ChunkCoord> {
        let mut found = BTreeSet::new();
        for window in self.windows(strategy) {
            for column in self.columns(strategy, &window) {
                for x in seen.chunks(&(column.x..=column.x)) {
                    for z in seen.chunks(&(column.z..=column.z)) {
                        for y in seen.chunks(&column.y) {
                            found.insert(ChunkCoord {
                                chart: window.chart,
                                index: IVec3::new(x, y, z),
                            });
                        }
                    }
                }
            }
        }
        found.into_iter().collect()
    }

    /// Where columns may be reached: around the middle, and around the same point in each chart whose domain is near.
    fn windows(&self, strategy: &dyn Atlas) -> Vec<Window> {
        if !self.centre.pos.is_finite() || !self.radius_m.is_finite() {
            return Vec::new();
        }
        let around = |point: ChartPoint, half: f64| Window {
            chart: point.chart,
            x: whole(point.pos.x - half, point.pos.x + half),
            z: whole(point.pos.z - half, point.pos.z + half),
        };
        let radius = self.reach_m();
        let images = strategy.images(self.centre, radius + EDITED_PAST_RIM_M);
        let spread = strategy.spread_m(self.centre, radius, EDITED_PAST_RIM_M);
        // What is near by way of another chart need not be near in its own.
        let own = if images.is_empty() { radius } else { spread };
        let mut windows = vec![around(self.centre, own)];
        windows.extend(images.into_iter().map(|image| around(image.point, spread)));
        windows
    }

    fn columns(&self, strategy: &dyn Atlas, window: &Window) -> Vec<Reached> {
        let (low, high) = editable_y_m(strategy);
        let editable = whole(low, high);
        let domain = strategy.domain(window.chart);
        let radius2 = self.reach_m().powi(2);
        let mut reached = Vec::new();
        for x in window.x.clone() {
            for z in window.z.clone() {
                let here = DVec2::new(x as f64, z as f64);
                if domain.outside_m(here) > EDITED_PAST_RIM_M {
                    continue;
                }
                let Some(way) = self.way_to(strategy, window.chart, here) else {
                    continue;
                };
                let distance2_m2 = way.length_squared();
                if distance2_m2 > radius2 {
                    continue;
                }
                let half = (radius2 - distance2_m2).sqrt();
                let centre_y = self.centre.pos.y;
                let y = common(&whole(centre_y - half, centre_y + half), &editable);
                if !y.is_empty() {
                    reached.push(Reached { x, z, way, y });
                }
            }
        }
        reached
    }

    /// The horizontal way from the middle to a column, in the middle's chart. Carrying
    /// moves columns as wholes: it keeps heights and does not look at them.
    fn way_to(&self, strategy: &dyn Atlas, chart: ChartId, column: DVec2) -> Option<DVec2> {
        let point = ChartPoint::new(chart, DVec3::new(column.x, 0.0, column.y));
        let point = strategy.carry_near(point, self.centre)?.point;
        let offset = point.pos - self.centre.pos;
        Some(DVec2::new(offset.x, offset.z))
    }
}
