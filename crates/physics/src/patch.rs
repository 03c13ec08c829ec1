//! The few triangles around a character, in a frame of its own, and its contacts with them.
//!
//! Coordinates are metres from an anchor near the character, in `f64`: neither the place in the
//! world nor the floating origin changes a bit of what a move computes.

use antipode_geometry::BodyFrame;
use glam::{DVec3, Vec3Swizzles as _};
use rapier3d::parry::bounding_volume::Aabb;

use crate::ChartGround;
use crate::triangle::{Touch, Triangle};

/// Distances (m) below this are touching, where a direction can no longer be taken from them.
const NO_DISTANCE_M: f64 = 1e-9;

/// Boxes asked of a mesh are grown by this against the rounding to its `f32`.
const BOX_SKIN_M: f64 = 1e-3;

/// The upright capsule of a character.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Capsule {
    pub height_m: f64,
    pub radius_m: f64,
}

impl Capsule {
    /// A capsule; one lower than it is wide becomes a ball.
    pub fn new(height_m: f64, radius_m: f64) -> Self {
        let radius_m = radius_m.max(0.01);
        Self {
            height_m: height_m.max(2.0 * radius_m),
            radius_m,
        }
    }

    /// The ends of the axis for feet at `feet`.
    pub fn axis(&self, feet: DVec3) -> (DVec3, DVec3) {
        (
            feet + DVec3::Y * self.radius_m,
            feet + DVec3::Y * (self.height_m - self.radius_m),
        )
    }

    /// The box around the capsule with its feet at `feet`.
    pub fn bounds(&self, feet: DVec3) -> (DVec3, DVec3) {
        let r = self.radius_m;
        (
            feet - DVec3::new(r, 0.0, r),
            feet + DVec3::new(r, self.height_m, r),
        )
    }
}

/// One triangle cutting into the capsule from its air side.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Contact {
    /// Unit direction from the triangle towards the axis, along which the capsule must leave.
    pub normal: DVec3,
    /// Unit normal of the triangle.
    pub face: DVec3,
    /// How far the capsule must leave (m).
    pub depth: f64,
}

/// Vertices of a mesh that were carried into a body's frame of late: each is a corner of about six triangles.
struct Carried([Option<(u32, DVec3)>; CARRIED]);

/// So many of them are kept, each at a place that its number gives.
const CARRIED: usize = 64;

impl Carried {
    const NONE: Self = Self([None; CARRIED]);

    fn of(&mut self, index: u32, carry: impl FnOnce() -> DVec3) -> DVec3 {
        let kept = &mut self.0[index as usize % CARRIED];
        match *kept {
            Some((known, at)) if known == index => at,
            _ => kept.insert((index, carry())).1,
        }
    }
}

/// Triangles near a character, relative to `anchor`.
pub(crate) struct Patch {
    triangles: Vec<Triangle>,
}

impl Patch {
    /// Takes the triangles that touch a box about a place of the chart, where a body is: the box is metres of the space from
    /// there, and told as if they were the chart's.
    pub fn gather(
        world: &ChartGround,
        frame: Option<&BodyFrame<'_>>,
        anchor: DVec3,
        min: DVec3,
        max: DVec3,
    ) -> Self {
        let (min, max) = frame.map_or((min, max), |it| it.chart_box(min - anchor, max - anchor));
        let offsets = frame.map(BodyFrame::offsets);
        let skin = DVec3::splat(BOX_SKIN_M);
        let mut triangles = Vec::new();
        let mut found: Vec<u32> = Vec::new();
        for ground in world.grounds_in(min - skin, max + skin) {
            let Some(mesh) = ground.block.mesh() else {
                continue;
            };
            let (low, high) = (min - skin - ground.origin, max + skin - ground.origin);
            found.clear();
            found.extend(
                mesh.bvh()
                    .intersect_aabb(&Aabb::new(low.as_vec3(), high.as_vec3())),
            );
            found.sort_unstable();
            let (vertices, indices, offset) =
                (mesh.vertices(), mesh.indices(), ground.origin - anchor);
            let mut carried = Carried::NONE;
            triangles.extend(found.iter().filter_map(|&id| {
                let corners = indices.get(id as usize)?.map(|index| {
                    let vertex = vertices[index as usize].as_dvec3();
                    match &offsets {
                        Some(offsets) => carried.of(index, || offsets(vertex + ground.origin)),
                        None => vertex + offset,
                    }
                });
                Triangle::new(corners)
            }));
        }
        let solid = world.obstacles_in(min - skin, max + skin);
        triangles.extend(solid.filter_map(|corners| {
            Triangle::new(corners.map(|corner| match &offsets {
                Some(offsets) => offsets(corner),
                None => corner - anchor,
            }))
        }));
        Self { triangles }
    }

    fn near<'a>(&'a self, capsule: &Capsule, feet: DVec3) -> impl Iterator<Item = &'a Triangle> {
        let (min, max) = capsule.bounds(feet);
        self.triangles
            .iter()
            .filter(move |triangle| triangle.min.cmple(max).all() && triangle.max.cmpge(min).all())
    }

    /// The deepest contact, if one is deeper than `tolerance` (m).
    pub fn deepest(&self, capsule: &Capsule, feet: DVec3, tolerance: f64) -> Option<Contact> {
        let mut deepest: Option<Contact> = None;
        for triangle in self.near(capsule, feet) {
            let least = deepest.map_or(tolerance, |contact| contact.depth);
            if let Some(contact) = contact(triangle, capsule, feet)
                && contact.depth > least
            {
                deepest = Some(contact);
            }
        }
        deepest
    }

    /// How deep any triangle reaches into the capsule, from whichever side; at most its radius.
    pub fn depth_any_side(&self, capsule: &Capsule, feet: DVec3) -> f64 {
        let (foot, top) = capsule.axis(feet);
        self.near(capsule, feet)
            .fold(0.0, |deepest: f64, triangle| {
                let nearest = triangle.nearest_to_upright(foot, top);
                deepest.max(capsule.radius_m - nearest.on_axis.distance(nearest.on_triangle))
            })
    }

    /// The highest place of a falling ball's touches over `at` that `wanted` picks.
    pub fn highest_touch(
        &self,
        at: DVec3,
        radius_m: f64,
        wanted: impl Fn(&Touch, &Triangle) -> bool,
    ) -> Option<Touch> {
        let mut highest: Option<Touch> = None;
        for triangle in &self.triangles {
            let apart = triangle.min.x > at.x + radius_m
                || triangle.max.x < at.x - radius_m
                || triangle.min.z > at.z + radius_m
                || triangle.max.z < at.z - radius_m;
            if !apart
                && let Some(touch) = triangle.catch_ball(at.xz(), radius_m)
                && highest
                    .as_ref()
                    .is_none_or(|best| touch.centre_y > best.centre_y)
                && wanted(&touch, triangle)
            {
                highest = Some(touch);
            }
        }
        highest
    }
}

/// The contact of a capsule with one triangle; ground is solid from its air side only, so that
/// someone below a floor or behind a wall is never dragged through it.
fn contact(triangle: &Triangle, capsule: &Capsule, feet: DVec3) -> Option<Contact> {
    let (foot, top) = capsule.axis(feet);
    let nearest = triangle.nearest_to_upright(foot, top);
    let face = triangle.normal;
    if nearest.pierced {
        let behind = (foot - nearest.on_axis)
            .dot(face)
            .min((top - nearest.on_axis).dot(face));
        return Some(Contact {
            normal: face,
            face,
            depth: capsule.radius_m - behind,
        });
    }
    let away = nearest.on_axis - nearest.on_triangle;
    let distance = away.length();
    if distance >= capsule.radius_m || away.dot(face) < -NO_DISTANCE_M {
        return None;
    }
    let normal = if distance > NO_DISTANCE_M {
        away / distance
    } else {
        face
    };
    Some(Contact {
        normal,
        face,
        depth: capsule.radius_m - distance,
    })
}
