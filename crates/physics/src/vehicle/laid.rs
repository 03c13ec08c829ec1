//! The ground of an arena that has a site: what is near its vehicles, carried vertex by vertex into metres of the space about the site.

use antipode_geometry::{BodyFrame, ChartId, ChartPoint, ChunkCoord};
use glam::{DVec3, Vec3, Vec3Swizzles};
use rapier3d::parry::bounding_volume::Aabb;
use rapier3d::parry::shape::{SharedShape, TriMesh};

use super::doors::Junction;
use super::role::{Earth, JUNCTIONS};
use super::site::Site;
use crate::PhysicsWorld;
use crate::chart_ground::Ground;
use crate::collider::Block;

/// Ground is laid so much farther about a vehicle than it is needed, in metres, that it need not be laid in every step.
const FARTHER_M: DVec3 = DVec3::new(0.8, 1.5, 0.8);
/// And so far ahead: the way of so many seconds, but no less and no more than so many metres.
const AHEAD_S: f64 = 0.8;
const AHEAD_M: (f64, f64) = (1.0, 12.0);
/// A long way is looked at in pieces so long, in metres, as boxes of it are.
const PIECE_M: f64 = 3.0;
/// A box about the site is so many times as wide about its own middle at least, and across the way out by `sinh(x) / x`, with `x` the way
/// there in radii, where space is hyperbolic.
const SLACK: f64 = 1.08;
/// Where ground of several charts is laid, each goes so far past its edge, in metres, that nothing falls between them.
const LAPS_M: f64 = 0.25;

/// Ground that a vehicle needs: a box that goes a way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Want {
    /// Of which side of a door.
    pub earth: Earth,
    /// The vehicle's chart.
    pub chart: ChartId,
    /// The box's middle, from the site.
    pub middle: DVec3,
    /// Half of its width.
    pub half: DVec3,
    /// Where its middle goes from there.
    pub way: DVec3,
}

impl Want {
    /// So much more that the vehicle, which has a velocity, may go on for a while.
    fn grown(self, velocity: DVec3) -> Self {
        let (least_m, most_m) = AHEAD_M;
        let way = velocity * AHEAD_S;
        Self {
            half: self.half + FARTHER_M,
            way: way.normalize_or_zero() * way.length().clamp(least_m, most_m),
            ..self
        }
    }

    /// Whether the box has its middle within `reach` of a place, along each axis, somewhere on its way.
    fn passes(&self, place: DVec3, reach: DVec3) -> bool {
        let (mut first, mut last): (f64, f64) = (0.0, 1.0);
        for axis in 0..3 {
            let (off, way, reach) = ((place - self.middle)[axis], self.way[axis], reach[axis]);
            if reach < 0.0 {
                return false;
            }
            if way.abs() < 1e-9 {
                if off.abs() > reach {
                    return false;
                }
                continue;
            }
            let (a, b) = ((off - reach) / way, (off + reach) / way);
            (first, last) = (first.max(a.min(b)), last.min(a.max(b)));
        }
        first <= last
    }

    fn holds(&self, other: &Self) -> bool {
        self.earth == other.earth && self.passes(other.middle, self.half - other.half)
    }

    fn touches(&self, corners: &[DVec3; 3]) -> bool {
        let [a, b, c] = corners;
        let (low, high) = (a.min(*b).min(*c), a.max(*b).max(*c));
        self.passes(0.5 * (low + high), self.half + 0.5 * (high - low))
    }

    /// Boxes that hold it, piece by piece of its way.
    fn pieces(&self) -> impl Iterator<Item = (DVec3, DVec3)> + '_ {
        let count = (self.way.length() / PIECE_M).ceil().max(1.0);
        (0..count as u32).map(move |nth| {
            let at = |nth: u32| self.middle + self.way * (f64::from(nth) / count);
            let (from, to) = (at(nth), at(nth + 1));
            (from.min(to) - self.half, from.max(to) + self.half)
        })
    }
}

/// A box of a chart in which ground was looked for.
struct Asked {
    earth: Earth,
    chart: ChartId,
    low: DVec3,
    high: DVec3,
}

/// A block that was found there.
type Source = (Earth, ChartId, ChunkCoord, usize, DVec3, Block);

/// Ground that was laid.
pub(super) struct Laid {
    wants: Vec<Want>,
    charts: Vec<ChartId>,
    asked: Vec<Asked>,
    sources: Vec<Source>,
    /// The world's count of changes when the sources were last found to be as they are.
    changes: u64,
}

impl Laid {
    /// What is to be laid about a site for vehicles of such velocities (m/s), and the shapes of it, which lie as the site does.
    pub fn made(
        world: &PhysicsWorld,
        site: &Site,
        needs: &[(Want, DVec3)],
        junctions: &[Option<Junction>; JUNCTIONS],
    ) -> (Self, Vec<(Earth, SharedShape)>) {
        let wants = needs.iter().map(|(it, velocity)| it.grown(*velocity));
        let wants: Vec<Want> = wants.collect();
        let mut charts: Vec<ChartId> = wants.iter().map(|it| it.chart).collect();
        charts.sort_unstable();
        charts.dedup();
        let asked = asked(site, &wants, &charts, junctions);
        let found = found(world, &asked);
        let mut earths: Vec<Earth> = wants.iter().map(|it| it.earth).collect();
        earths.sort_unstable();
        earths.dedup();
        let shape = |earth: Earth| {
            let mut mesh = Mesh::default();
            for (_, chart, ground) in found.iter().filter(|it| it.0 == earth) {
                let carried = Carried {
                    site,
                    chart: *chart,
                    earth,
                    junctions,
                    is_cut: earth == Earth::Own && charts.len() > 1,
                };
                mesh.take(&carried, ground, &asked, &wants);
            }
            mesh.shape().map(|shape| (earth, shape))
        };
        let shapes = earths.into_iter().filter_map(shape).collect();
        let sources = found.iter().map(|(earth, chart, it)| {
            let block = it.block.clone();
            (*earth, *chart, it.coord, it.number(), it.origin, block)
        });
        let sources = sources.collect();
        let laid = Self {
            wants,
            charts,
            asked,
            sources,
            changes: world.changes(),
        };
        (laid, shapes)
    }

    /// Whether it is all that is wanted, and as the world has it.
    pub fn is_enough(&mut self, world: &PhysicsWorld, needs: &[(Want, DVec3)]) -> bool {
        let has = |(want, _): &(Want, DVec3)| {
            self.charts.contains(&want.chart) && self.wants.iter().any(|it| it.holds(want))
        };
        if !needs.iter().all(has) {
            return false;
        }
        let is_same = self.changes == world.changes() || self.is_as_found(world);
        if is_same {
            self.changes = world.changes();
        }
        is_same
    }

    fn is_as_found(&self, world: &PhysicsWorld) -> bool {
        let found = found(world, &self.asked);
        let is_same = |(source, (earth, chart, it)): (&Source, &(Earth, ChartId, &Ground))| {
            (source.0, source.1, source.2, source.3, source.4)
                == (*earth, *chart, it.coord, it.number(), it.origin)
                && source.5.is_like(&it.block)
        };
        found.len() == self.sources.len() && self.sources.iter().zip(&found).all(is_same)
    }
}

/// The boxes of charts in which the ground is that is wanted.
fn asked(
    site: &Site,
    wants: &[Want],
    charts: &[ChartId],
    junctions: &[Option<Junction>; JUNCTIONS],
) -> Vec<Asked> {
    let mut asked = Vec::new();
    for want in wants {
        for (low, high) in want.pieces() {
            match want.earth {
                Earth::Own => asked.extend(charts.iter().filter_map(|&chart| {
                    let (low, high) = chart_box(site, low, high, chart)?;
                    Some(Asked {
                        earth: want.earth,
                        chart,
                        low,
                        high,
                    })
                })),
                Earth::Far(at) => asked.extend(junctions[at].as_ref().and_then(|junction| {
                    let (low, high) = chart_box(site, low, high, junction.host.foot.chart)?;
                    let middle = junction.taken_back(0.5 * (low + high));
                    // However the box is turned there.
                    let half = DVec3::splat(0.5 * (high - low).length());
                    Some(Asked {
                        earth: want.earth,
                        chart: junction.far.foot.chart,
                        low: middle - half,
                        high: middle + half,
                    })
                })),
                Earth::Sill(_) => {}
            }
        }
    }
    asked
}

/// A box of a chart that holds one about the site. It is told about its own middle: what a chart's axes bend by grows with the square of
/// the way from where it is told.
fn chart_box(site: &Site, low: DVec3, high: DVec3, chart: ChartId) -> Option<(DVec3, DVec3)> {
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    let mut there = site.frame()?.arrival(middle.with_y(0.0));
    let mut turn_rad = there.turn_rad;
    if chart != there.point.chart {
        there = site.space().carry(there.point, chart)?;
        turn_rad += there.turn_rad;
    }
    let away_rad = middle.xz().length() / site.space().radius_m();
    let slack = SLACK.max(away_rad.sinh() / away_rad);
    let (sin, cos) = turn_rad.sin_cos();
    let (sin, cos) = (slack * sin.abs(), slack * cos.abs());
    let (x, z) = (cos * half.x + sin * half.z, sin * half.x + cos * half.z);
    let frame = BodyFrame::of(site.space(), there.point)?;
    Some(frame.chart_box(DVec3::new(-x, low.y, -z), DVec3::new(x, high.y, z)))
}

fn found<'a>(world: &'a PhysicsWorld, asked: &[Asked]) -> Vec<(Earth, ChartId, &'a Ground)> {
    let mut all: Vec<_> = asked
        .iter()
        .flat_map(|it| {
            let here = world.chart(it.chart).grounds_in(it.low, it.high);
            here.into_iter().map(|ground| (it.earth, it.chart, ground))
        })
        .collect();
    let name = |it: &(Earth, ChartId, &Ground)| (it.0, it.1, it.2.coord, it.2.number());
    all.sort_by_key(name);
    all.dedup_by_key(|it| name(it));
    all
}

/// How ground of a chart comes to lie about the site.
struct Carried<'a> {
    site: &'a Site,
    chart: ChartId,
    earth: Earth,
    junctions: &'a [Option<Junction>; JUNCTIONS],
    /// Whether only what is the chart's own is laid, as the rest is another's.
    is_cut: bool,
}

impl Carried<'_> {
    fn places<'a>(
        &'a self,
        frame: Option<&'a BodyFrame<'_>>,
    ) -> impl Fn(DVec3) -> Option<DVec3> + 'a {
        let offsets = frame.map(BodyFrame::offsets);
        let junction = match self.earth {
            Earth::Far(at) => self.junctions[at].as_ref(),
            Earth::Own | Earth::Sill(_) => None,
        };
        move |pos| {
            let (chart, pos) = junction.map_or((self.chart, pos), |junction| {
                (junction.host.foot.chart, junction.brought(pos))
            });
            let at = self.site.at();
            let pos = if chart == at.chart {
                pos
            } else {
                let over = self
                    .site
                    .space()
                    .carry_near(ChartPoint::new(chart, pos), at);
                over?.point.pos
            };
            offsets.as_ref().map(|offsets| offsets(pos))
        }
    }

    fn is_own(&self, corners: &[DVec3; 3]) -> bool {
        let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        let domain = self.site.space().domain(self.chart);
        !self.is_cut || domain.outside_m(middle.xz()) <= LAPS_M
    }
}

/// Triangles about the site.
#[derive(Default)]
struct Mesh {
    vertices: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
}

impl Mesh {
    fn take(&mut self, carried: &Carried<'_>, ground: &Ground, asked: &[Asked], wants: &[Want]) {
        let Some(mesh) = ground.block.mesh() else {
            return;
        };
        let mut ids: Vec<u32> = Vec::new();
        let here = |it: &&Asked| it.earth == carried.earth && it.chart == carried.chart;
        for it in asked.iter().filter(here) {
            let (low, high) = (it.low - ground.origin, it.high - ground.origin);
            let near = Aabb::new(low.as_vec3(), high.as_vec3());
            ids.extend(mesh.bvh().intersect_aabb(&near));
        }
        ids.sort_unstable();
        ids.dedup();
        let (vertices, indices) = (mesh.vertices(), mesh.indices());
        let named = ids.iter().filter_map(|&id| indices.get(id as usize));
        let named: Vec<[u32; 3]> = named.copied().collect();
        let place = |index: u32| vertices[index as usize].as_dvec3() + ground.origin;
        // Each vertex is carried once: those of a number follow each other in its order.
        let all = named.iter().flatten().zip(0_u32..);
        let mut all: Vec<(u32, u32)> = all.map(|(&index, slot)| (index, slot)).collect();
        all.sort_unstable();
        let mut slots = vec![0; all.len()];
        let frame = carried.site.frame();
        let places = carried.places(frame.as_ref());
        let mut moved: Vec<Option<DVec3>> = Vec::new();
        let mut last = None;
        for (index, slot) in all {
            if last != Some(index) {
                moved.push(places(place(index)));
                last = Some(index);
            }
            slots[slot as usize] = moved.len() as u32 - 1;
        }
        let first = self.vertices.len() as u32;
        let is_wanted = |corners: &[DVec3; 3]| {
            let mut own = wants.iter().filter(|it| it.earth == carried.earth);
            own.any(|it| it.touches(corners))
        };
        for (corners, slots) in named.iter().zip(slots.chunks_exact(3)) {
            let at = |nth: usize| moved[slots[nth] as usize];
            let (Some(a), Some(b), Some(c)) = (at(0), at(1), at(2)) else {
                continue;
            };
            if is_wanted(&[a, b, c]) && carried.is_own(&corners.map(place)) {
                let own = [slots[0], slots[1], slots[2]];
                self.triangles.push(own.map(|slot| first + slot));
            }
        }
        let moved = moved.iter().map(|it| it.unwrap_or_default().as_vec3());
        self.vertices.extend(moved);
    }

    fn shape(self) -> Option<SharedShape> {
        let mesh = TriMesh::new(self.vertices, self.triangles).ok()?;
        Some(SharedShape::new(mesh))
    }
}

/// A sill, which is written in the own axes of a leaf, about a site.
pub(super) fn sill_about(
    site: &Site,
    junction: &Junction,
    sill: &SharedShape,
) -> Option<SharedShape> {
    let mesh = sill.as_trimesh()?;
    let carried = Carried {
        site,
        chart: junction.host.foot.chart,
        earth: Earth::Own,
        junctions: &[None; JUNCTIONS],
        is_cut: false,
    };
    let frame = site.frame();
    let places = carried.places(frame.as_ref());
    let moved = mesh.vertices().iter().map(|it| {
        let place = junction.host.place(it.as_dvec3());
        places(place.pos).map(DVec3::as_vec3)
    });
    let moved: Option<Vec<Vec3>> = moved.collect();
    let mesh = TriMesh::new(moved?, mesh.indices().to_vec()).ok()?;
    Some(SharedShape::new(mesh))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests fail by panicking")]
mod tests {
    use std::sync::Arc;

    use antipode_geometry::{Geometry, Strategy, strategy};

    use super::*;

    #[test]
    fn the_box_of_a_chart_holds_all_of_one_about_a_site_however_far_off_that_lies() {
        let spaces = [
            (Geometry::HyperbolicWorld, 30.152),
            (Geometry::HyperbolicWorld, 60.305),
            (Geometry::Spherical, 32.0),
            (Geometry::Spherical, 256.0),
        ];
        let mut held = 0;
        for (geometry, radius_m) in spaces {
            let space: Arc<dyn Strategy> = strategy(geometry, radius_m);
            for (at, away_m) in [([0.0, 0.0], 4.0), ([9.0, -6.0], 16.0), ([-3.0, 12.0], 40.0)] {
                let at = ChartPoint::a(DVec3::new(at[0], 3.0, at[1]));
                let site = Site::about(&space, at);
                let frame = site.frame().unwrap();
                for heading in 0..8 {
                    let way = DVec3::X * f64::min(away_m, 0.75 * radius_m);
                    let middle = glam::DQuat::from_rotation_y(f64::from(heading)) * way;
                    let half = DVec3::new(4.0, 2.0, 3.0);
                    let (low, high) = (middle - half, middle + half);
                    // Past where the chart is written there is no ground of it.
                    let Some((least, most)) = chart_box(&site, low, high, at.chart) else {
                        continue;
                    };
                    held += 1;
                    for n in 0..27 {
                        let share = DVec3::new((n % 3).into(), (n / 3 % 3).into(), (n / 9).into());
                        let place = low + (high - low) * 0.5 * share;
                        let there = frame.arrival(place).point;
                        let is_held = there.chart != at.chart
                            || (there.pos.cmpge(least).all() && there.pos.cmple(most).all());
                        assert!(
                            is_held,
                            "{geometry:?} {radius_m} {away_m} {heading}: {there:?} in {least} {most}"
                        );
                    }
                }
            }
        }
        assert!(held > 80, "{held} of 96");
    }
}
