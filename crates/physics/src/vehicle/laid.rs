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

/// Ground is laid so much farther than it is needed, in metres, that it need not be laid in every step.
const FARTHER_M: DVec3 = DVec3::new(4.0, 2.0, 4.0);
/// Boxes of charts are grown by this, in metres, for what axes bend by within them.
const BENDS_M: f64 = 1.0;
/// A box that is told in the chart of another may be so many times as wide there.
const STRETCHED: f64 = 2.0;
/// Where ground of several charts is laid, each goes so far past its edge, in metres, that nothing falls between them.
const LAPS_M: f64 = 0.25;

/// Ground that a vehicle needs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Want {
    /// Of which side of a door.
    pub earth: Earth,
    /// The vehicle's chart.
    pub chart: ChartId,
    /// A box about the site.
    pub low: DVec3,
    /// Its other corner.
    pub high: DVec3,
}

impl Want {
    fn grown(self) -> Self {
        Self {
            low: self.low - FARTHER_M,
            high: self.high + FARTHER_M,
            ..self
        }
    }

    fn holds(&self, other: &Self) -> bool {
        self.earth == other.earth
            && self.low.cmple(other.low).all()
            && self.high.cmpge(other.high).all()
    }

    fn touches(&self, corners: &[DVec3; 3]) -> bool {
        let [a, b, c] = corners;
        a.min(*b).min(*c).cmple(self.high).all() && a.max(*b).max(*c).cmpge(self.low).all()
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
}

impl Laid {
    /// What is to be laid about a site, and the shapes of it, which lie as the site does.
    pub fn made(
        world: &PhysicsWorld,
        site: &Site,
        wants: &[Want],
        junctions: &[Option<Junction>; JUNCTIONS],
    ) -> (Self, Vec<(Earth, SharedShape)>) {
        let wants: Vec<Want> = wants.iter().map(|it| it.grown()).collect();
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
        };
        (laid, shapes)
    }

    /// Whether it is all that is wanted, and as the world has it.
    pub fn is_enough(&self, world: &PhysicsWorld, wants: &[Want]) -> bool {
        let has = |want: &Want| {
            self.charts.contains(&want.chart) && self.wants.iter().any(|it| it.holds(want))
        };
        wants.iter().all(has) && {
            let found = found(world, &self.asked);
            let is_same = |(source, (earth, chart, it)): (&Source, &(Earth, ChartId, &Ground))| {
                (source.0, source.1, source.2, source.3, source.4)
                    == (*earth, *chart, it.coord, it.number(), it.origin)
                    && source.5.is_like(&it.block)
            };
            found.len() == self.sources.len() && self.sources.iter().zip(&found).all(is_same)
        }
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
        match want.earth {
            Earth::Own => {
                let boxes = charts.iter().filter_map(|&chart| {
                    let (low, high) = chart_box(site, want, chart)?;
                    Some(Asked {
                        earth: want.earth,
                        chart,
                        low,
                        high,
                    })
                });
                asked.extend(boxes);
            }
            Earth::Far(at) => {
                let Some(junction) = &junctions[at] else {
                    continue;
                };
                let Some((low, high)) = chart_box(site, want, junction.host.foot.chart) else {
                    continue;
                };
                let middle = junction.taken_back(0.5 * (low + high));
                // However the box is turned there.
                let half = DVec3::splat(0.5 * (high - low).length());
                asked.push(Asked {
                    earth: want.earth,
                    chart: junction.far.foot.chart,
                    low: middle - half,
                    high: middle + half,
                });
            }
            Earth::Sill(_) => {}
        }
    }
    asked
}

/// A box of a chart that holds one about the site.
fn chart_box(site: &Site, want: &Want, chart: ChartId) -> Option<(DVec3, DVec3)> {
    let frame = site.frame()?;
    let (low, high) = frame.chart_box(want.low, want.high);
    let bends = DVec3::new(BENDS_M, 0.0, BENDS_M);
    let (low, high) = (low - bends, high + bends);
    if chart == site.at().chart {
        return Some((low, high));
    }
    let middle = ChartPoint::new(site.at().chart, 0.5 * (low + high));
    let there = site.space().carry(middle, chart)?.point.pos;
    let half_m = STRETCHED * 0.5 * (high - low).xz().length();
    let half = DVec3::new(half_m, 0.5 * (high.y - low.y), half_m);
    Some((there - half, there + half))
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
        let place = |index: u32| vertices[index as usize].as_dvec3() + ground.origin;
        let named = ids.iter().filter_map(|&id| indices.get(id as usize));
        let named: Vec<[u32; 3]> = named.copied().collect();
        let mut used: Vec<u32> = named.iter().flatten().copied().collect();
        used.sort_unstable();
        used.dedup();
        let frame = carried.site.frame();
        let places = carried.places(frame.as_ref());
        let moved: Vec<Option<DVec3>> = used.iter().map(|&it| places(place(it))).collect();
        let moved_at = |index: u32| moved[used.binary_search(&index).ok()?];
        let first = self.vertices.len() as u32;
        let is_wanted = |corners: &[DVec3; 3]| {
            let own = wants.iter().filter(|it| it.earth == carried.earth);
            own.into_iter().any(|it| it.touches(corners))
        };
        for corners in named {
            let [Some(a), Some(b), Some(c)] = corners.map(moved_at) else {
                continue;
            };
            if is_wanted(&[a, b, c]) && carried.is_own(&corners.map(place)) {
                let at = |index: u32| first + used.binary_search(&index).unwrap_or(0) as u32;
                self.triangles.push(corners.map(at));
            }
        }
        let none = DVec3::ZERO;
        self.vertices
            .extend(moved.iter().map(|it| it.unwrap_or(none).as_vec3()));
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
        places(place.pos).map(|it| it.as_vec3())
    });
    let moved: Option<Vec<Vec3>> = moved.collect();
    let mesh = TriMesh::new(moved?, mesh.indices().to_vec()).ok()?;
    Some(SharedShape::new(mesh))
}
