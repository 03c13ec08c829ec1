//! Solids made of triangles, and the few of them that a path may meet.
//!
//! The boxes of the hierarchy are `f32`, rounded outwards; triangles are met in `f64` (T. Möller and B. Trumbore, 1997).

use glam::{DVec3, Vec3};

use crate::bvh::Bvh;
use crate::scene::{SceneHit, SceneQuery};

/// Triangles in a leaf at most.
const LEAF: u32 = 4;

/// A triangle of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// Its corners, metres of the scene.
    pub corners: [DVec3; 3],
    /// The object that it belongs to.
    pub object: u32,
}

/// Solids made of triangles.
#[derive(Clone, Debug, Default)]
pub struct Triangles {
    triangles: Vec<Triangle>,
    bvh: Bvh,
}

impl Triangles {
    /// Of a list. Numbers of parts in hits are those of this list.
    pub fn new(triangles: Vec<Triangle>) -> Self {
        let boxes: Vec<_> = triangles
            .iter()
            .map(|triangle| bounds(&triangle.corners))
            .collect();
        Self {
            bvh: Bvh::with_leaves(&boxes, LEAF),
            triangles,
        }
    }

    /// The triangles.
    pub fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    /// As [`SceneQuery::first`], by asking every triangle: what tests compare with.
    pub fn first_of_all(&self, x: DVec3, v: DVec3, longest: f64) -> Option<SceneHit> {
        let hits =
            (0..self.triangles.len() as u32).filter_map(|part| self.meet(part, x, v, longest));
        hits.min_by(|a, b| a.time.total_cmp(&b.time))
    }

    fn meet(&self, part: u32, x: DVec3, v: DVec3, longest: f64) -> Option<SceneHit> {
        let triangle = &self.triangles[part as usize];
        let (time, normal) = meet(&triangle.corners, x, v, longest)?;
        Some(SceneHit {
            time,
            object: triangle.object,
            part,
            normal,
        })
    }
}

/// When the path x + t v meets a triangle, 0 <= t <= `longest`, and the triangle's normal.
pub(crate) fn meet(
    [a, b, c]: &[DVec3; 3],
    x: DVec3,
    v: DVec3,
    longest: f64,
) -> Option<(f64, DVec3)> {
    let (ab, ac) = (b - a, c - a);
    let across = v.cross(ac);
    let volume = ab.dot(across);
    if volume == 0.0 {
        return None;
    }
    let from = x - a;
    let along_b = from.dot(across) / volume;
    let turned = from.cross(ab);
    let along_c = v.dot(turned) / volume;
    let time = ac.dot(turned) / volume;
    let is_met = along_b >= 0.0 && along_c >= 0.0 && along_b + along_c <= 1.0;
    (is_met && (0.0..=longest).contains(&time)).then(|| (time, ab.cross(ac).normalize()))
}

/// A path, and what it takes to tell which boxes it goes through.
pub(crate) struct Slabs {
    x: DVec3,
    inverse: DVec3,
}

impl Slabs {
    /// Of the path x + t v.
    pub fn new(x: DVec3, v: DVec3) -> Self {
        let pace = v.to_array().map(|one| one.signum() / one.abs().max(1e-200));
        Self {
            x,
            inverse: DVec3::from_array(pace),
        }
    }

    /// Whether it is in a box at any 0 <= t <= `longest`.
    pub fn enters(&self, low: DVec3, high: DVec3, longest: f64) -> bool {
        let (a, b) = (
            (low - self.x) * self.inverse,
            (high - self.x) * self.inverse,
        );
        let (enters, leaves) = (a.min(b).max_element(), a.max(b).min_element());
        enters <= leaves && leaves >= 0.0 && enters <= longest
    }
}

impl SceneQuery for Triangles {
    fn first(&self, x: DVec3, v: DVec3, longest: f64) -> Option<SceneHit> {
        let path = Slabs::new(x, v);
        let nearest = std::cell::Cell::new(longest);
        let mut found = None;
        let enter = |low: DVec3, high: DVec3| path.enters(low, high, nearest.get());
        self.bvh.visit(enter, |part| {
            if let Some(hit) = self.meet(part, x, v, nearest.get()) {
                nearest.set(hit.time);
                found = Some(hit);
            }
        });
        found
    }

    fn near(&self, low: DVec3, high: DVec3, show: &mut dyn FnMut([DVec3; 3])) {
        let enter = |from: DVec3, to: DVec3| from.cmple(high).all() && to.cmpge(low).all();
        self.bvh
            .visit(enter, |part| show(self.triangles[part as usize].corners));
    }
}

/// The corners of a triangle's box in `f32`, rounded outwards.
pub(crate) fn bounds(corners: &[DVec3; 3]) -> (Vec3, Vec3) {
    let [a, b, c] = corners;
    let (low, high) = (a.min(*b).min(*c), a.max(*b).max(*c));
    let down = |value: f64| (value as f32).next_down();
    let up = |value: f64| (value as f32).next_up();
    (
        Vec3::new(down(low.x), down(low.y), down(low.z)),
        Vec3::new(up(high.x), up(high.y), up(high.z)),
    )
}
