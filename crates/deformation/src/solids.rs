//! Solids as forms that stand at places: a form has its triangles in its own axes, and all that look alike share it. A change of one
//! of many makes a hierarchy of their boxes anew, and none of their triangles.
//!
//! A path is taken into the axes of a form to find the triangles that it may meet; these are met where they stand, in the scene, as
//! those of [`crate::Triangles`] are. What is rounded on the way there, 1e-13 of at most 1 km, is far below [`SLACK_M`], by which
//! boxes are widened.

use std::sync::{Arc, OnceLock};

use glam::{DAffine3, DVec3, Vec3};

use crate::bvh::Bvh;
use crate::scene::{SceneHit, SceneQuery};
use crate::triangles::{Slabs, bounds, meet};

/// Triangles in a leaf at most.
const LEAF: u32 = 4;
/// Boxes are asked for with so much about them, metres of the scene.
const SLACK_M: f64 = 1e-7;

/// Triangles in their own axes.
#[derive(Clone, Debug, Default)]
pub struct Form {
    corners: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    bvh: Bvh,
    low: DVec3,
    high: DVec3,
}

impl Form {
    /// Of corners, metres, and the three corners of each triangle, all of which are in the list.
    pub fn new(corners: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Self {
        let of = |it: &[u32; 3]| bounds(&it.map(|one| corners[one as usize]));
        let boxes: Vec<_> = triangles.iter().map(of).collect();
        let low = corners.iter().copied().fold(DVec3::INFINITY, DVec3::min);
        let high = (corners.iter().copied()).fold(DVec3::NEG_INFINITY, DVec3::max);
        Self {
            bvh: Bvh::with_leaves(&boxes, LEAF),
            corners,
            triangles,
            low,
            high,
        }
    }

    /// How low its lowest corner is where it has that pose, metres along `up`; infinite for one without corners.
    pub fn lowest(&self, pose: &DAffine3, up: DVec3) -> f64 {
        // up . (M x + t) = (M^T up) . x + up . t.
        let within = pose.matrix3.transpose() * up;
        let all = self.corners.iter().map(|it| within.dot(*it));
        all.fold(f64::INFINITY, f64::min) + up.dot(pose.translation)
    }

    /// The same of its box, which is no higher.
    fn lowest_of_box(&self, pose: &DAffine3, up: DVec3) -> f64 {
        let within = pose.matrix3.transpose() * up;
        let (middle, half) = ((self.low + self.high) / 2.0, (self.high - self.low) / 2.0);
        within.dot(middle) - within.abs().dot(half) + up.dot(pose.translation)
    }

    /// The box about its own box where it has that pose, rounded outwards.
    fn reach(&self, pose: &DAffine3) -> (Vec3, Vec3) {
        let (middle, half) = ((self.low + self.high) / 2.0, (self.high - self.low) / 2.0);
        let at = pose.transform_point3(middle);
        let out = mul_abs(pose, half);
        bounds(&[at - out, at + out, at])
    }
}

/// Half the edges of the box about a box whose half edges these are, after the linear part of a pose.
fn mul_abs(pose: &DAffine3, half: DVec3) -> DVec3 {
    let it = &pose.matrix3;
    it.x_axis.abs() * half.x + it.y_axis.abs() * half.y + it.z_axis.abs() * half.z
}

/// A form at its place.
#[derive(Clone, Debug)]
pub struct Standing {
    /// What it is.
    pub form: Arc<Form>,
    /// From its own axes to the scene; it can be undone.
    pub pose: DAffine3,
    /// The object that it belongs to.
    pub object: u32,
}

/// Forms that stand in a scene. Copies share all of it.
#[derive(Clone, Debug, Default)]
pub struct Solids {
    all: Arc<Vec<Standing>>,
    sorted: Arc<OnceLock<Sorted>>,
}

/// What paths are followed by. It is made by the first that is: whoever moves 2,000 things does not wait for it, and seldom sees
/// where a path leads before another thread has asked.
#[derive(Debug)]
struct Sorted {
    all: Vec<Stood>,
    bvh: Bvh,
}

#[derive(Debug)]
struct Stood {
    it: Standing,
    /// From the scene to its own axes.
    back: DAffine3,
    /// [`SLACK_M`] along its own axes.
    slack: DVec3,
}

impl Solids {
    /// Of a list; forms without triangles are as though they were not there.
    pub fn new(list: Vec<Standing>) -> Self {
        let has_any = |it: &Standing| !it.form.triangles.is_empty();
        let mut all = list;
        all.retain(has_any);
        Self {
            all: Arc::new(all),
            sorted: Arc::default(),
        }
    }

    fn sorted(&self) -> &Sorted {
        self.sorted.get_or_init(|| {
            let of = |it: &Standing| {
                let back = it.pose.inverse();
                let slack = mul_abs(&back, DVec3::splat(SLACK_M));
                let it = it.clone();
                Stood { it, back, slack }
            };
            let boxes: Vec<_> = self.all.iter().map(|it| it.form.reach(&it.pose)).collect();
            Sorted {
                bvh: Bvh::with_leaves(&boxes, 1),
                all: self.all.iter().map(of).collect(),
            }
        })
    }

    /// How low the lowest corner of all is, metres along `up`; infinite where there is none.
    pub fn lowest(&self, up: DVec3) -> f64 {
        self.all.iter().fold(f64::INFINITY, |lowest, one| {
            let (form, pose) = (&one.form, &one.pose);
            if form.lowest_of_box(pose, up) >= lowest {
                return lowest;
            }
            lowest.min(form.lowest(pose, up))
        })
    }

    /// What a path x + v t meets first up to a time, as [`SceneQuery::first`], of those objects that `takes` takes.
    pub fn first_of(
        &self,
        x: DVec3,
        v: DVec3,
        longest: f64,
        takes: impl Fn(u32) -> bool,
    ) -> Option<SceneHit> {
        let path = Slabs::new(x, v);
        let nearest = std::cell::Cell::new(longest);
        let mut found = None;
        let enter = |low: DVec3, high: DVec3| {
            let slack = DVec3::splat(SLACK_M);
            path.enters(low - slack, high + slack, nearest.get())
        };
        let Sorted { all, bvh } = self.sorted();
        bvh.visit(enter, |number| {
            let one = &all[number as usize];
            if !takes(one.it.object) {
                return;
            }
            if let Some(hit) = one.first(x, v, nearest.get()) {
                nearest.set(hit.time);
                found = Some(hit);
            }
        });
        found
    }
}

impl Stood {
    /// The corners of a triangle in the scene.
    fn corners(&self, part: u32) -> [DVec3; 3] {
        let form = &self.it.form;
        let corner = |it: u32| self.it.pose.transform_point3(form.corners[it as usize]);
        form.triangles[part as usize].map(corner)
    }

    fn first(&self, x: DVec3, v: DVec3, longest: f64) -> Option<SceneHit> {
        let own = Slabs::new(
            self.back.transform_point3(x),
            self.back.transform_vector3(v),
        );
        let nearest = std::cell::Cell::new(longest);
        let mut found = None;
        let enter = |low: DVec3, high: DVec3| {
            own.enters(low - self.slack, high + self.slack, nearest.get())
        };
        self.it.form.bvh.visit(enter, |part| {
            if let Some((time, normal)) = meet(&self.corners(part), x, v, nearest.get()) {
                nearest.set(time);
                let object = self.it.object;
                found = Some(SceneHit {
                    time,
                    object,
                    part,
                    normal,
                });
            }
        });
        found
    }

    fn near(&self, low: DVec3, high: DVec3, show: &mut dyn FnMut([DVec3; 3])) {
        let (middle, half) = ((low + high) / 2.0, (high - low) / 2.0);
        let at = self.back.transform_point3(middle);
        let out = mul_abs(&self.back, half) + self.slack;
        let (own_low, own_high) = (at - out, at + out);
        let enter = |from: DVec3, to: DVec3| from.cmple(own_high).all() && to.cmpge(own_low).all();
        self.it.form.bvh.visit(enter, |part| {
            let corners = self.corners(part);
            let [a, b, c] = corners;
            let reaches = a.min(b).min(c).cmple(high).all() && a.max(b).max(c).cmpge(low).all();
            if reaches {
                show(corners);
            }
        });
    }
}

impl SceneQuery for Solids {
    fn first(&self, x: DVec3, v: DVec3, longest: f64) -> Option<SceneHit> {
        self.first_of(x, v, longest, |_| true)
    }

    fn near(&self, low: DVec3, high: DVec3, show: &mut dyn FnMut([DVec3; 3])) {
        let (from, to) = (low - SLACK_M, high + SLACK_M);
        let enter = |low: DVec3, high: DVec3| low.cmple(to).all() && high.cmpge(from).all();
        let Sorted { all, bvh } = self.sorted();
        bvh.visit(enter, |number| {
            all[number as usize].near(low, high, show);
        });
    }
}
