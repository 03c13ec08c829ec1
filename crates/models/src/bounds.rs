//! A sphere that holds a model in whatever pose its clips, or any mixture of them, can bring it.
//!
//! Whatever turns there are, a node is no farther from its parent than its longest offset, and what hangs from a node
//! no farther than its reach:
//!
//! ```text
//! reach(n) = size(n) max( own vertices' distance, max over children c of ( |offset(c)| + reach(c) ) )
//! ```
//!
//! Offsets and sizes are the largest of the rest pose and of all keys; mixtures are convex, so they stay below. A
//! skinned vertex is a convex combination of the places its joints would carry it to, each within that joint's reach.
//! Down from a root, nodes that no clip turns are followed exactly, so the sphere is about the first that moves.

use glam::{Mat4, Vec3};

use crate::clip::Channel;
use crate::load::Model;

/// A sphere in the model's axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its middle, metres.
    pub centre: Vec3,
    /// Its radius, metres.
    pub radius: f32,
}

impl Sphere {
    /// The sphere round the box of some points.
    fn round(points: &[Vec3]) -> Self {
        let low = points.iter().copied().reduce(Vec3::min).unwrap_or_default();
        let high = points.iter().copied().reduce(Vec3::max).unwrap_or_default();
        let centre = low.midpoint(high);
        Self {
            centre,
            radius: points
                .iter()
                .map(|p| p.distance(centre))
                .fold(0.0, f32::max),
        }
    }

    /// A sphere that holds several.
    fn over(spheres: &[Self]) -> Self {
        let centre = Self::round(&spheres.iter().map(|s| s.centre).collect::<Vec<_>>()).centre;
        let radius = spheres
            .iter()
            .map(|s| s.centre.distance(centre) + s.radius)
            .fold(0.0, f32::max);
        Self { centre, radius }
    }
}

/// What the clips can do to one node.
struct Range {
    offsets: Vec<Vec3>,
    most_scale: f32,
    turns: bool,
    /// Farthest vertex that the node carries, in its own axes.
    own_m: f32,
}

/// The sphere about a whole model.
pub fn bounds(model: &Model) -> Sphere {
    let ranges = ranges(model);
    let reach = reaches(model, &ranges);
    let mut spheres = Vec::new();
    let mut exact: Vec<Option<Mat4>> = Vec::new();
    for (j, joint) in model.skeleton.joints.iter().enumerate() {
        let above = joint.parent.map_or(Some(Mat4::IDENTITY), |p| exact[p]);
        let fixed = !ranges[j].turns && ranges[j].offsets.len() == 1;
        exact.push(if fixed {
            above.map(|m| m * joint.rest.matrix())
        } else {
            None
        });
        let (Some(above), None) = (above, exact[j]) else {
            continue;
        };
        // The first node on this branch that moves: its places, and its reach about them.
        let places: Vec<Vec3> = ranges[j]
            .offsets
            .iter()
            .map(|o| above.transform_point3(*o))
            .collect();
        let about = Sphere::round(&places);
        spheres.push(Sphere {
            radius: about.radius + reach[j] * stretch(above),
            ..about
        });
    }
    spheres.extend(still(model, &exact));
    Sphere::over(&spheres)
}

/// Spheres round the vertices that hang from nodes which never move.
fn still(model: &Model, exact: &[Option<Mat4>]) -> Vec<Sphere> {
    let mut out = Vec::new();
    for part in &model.parts {
        let mut points = Vec::new();
        for vertex in model.meshes[part.mesh]
            .primitives
            .iter()
            .flat_map(|p| &p.vertices)
        {
            match part.skin.map(|s| &model.skins[s]) {
                None => {
                    points.extend(exact[part.node].map(|m| m.transform_point3(vertex.position)));
                }
                Some(skin) => {
                    for (joint, weight) in vertex.joints.iter().zip(vertex.weights) {
                        let Some(matrix) =
                            exact[skin.joints[*joint as usize]].filter(|_| weight > 0.0)
                        else {
                            continue;
                        };
                        points.push(
                            (matrix * skin.inverse_bind[*joint as usize])
                                .transform_point3(vertex.position),
                        );
                    }
                }
            }
        }
        if !points.is_empty() {
            out.push(Sphere::round(&points));
        }
    }
    out
}

fn ranges(model: &Model) -> Vec<Range> {
    let rest = |joint: &crate::Joint| Range {
        offsets: vec![joint.rest.translation],
        most_scale: joint.rest.scale.abs().max_element(),
        turns: false,
        own_m: 0.0,
    };
    let mut out: Vec<Range> = model.skeleton.joints.iter().map(rest).collect();
    for channel in model.clips.iter().flat_map(|clip| &clip.channels) {
        let range = &mut out[channel.joint()];
        match channel {
            Channel::Translation(_, curve) => range.offsets.extend(curve.hull()),
            Channel::Rotation(..) => range.turns = true,
            Channel::Scale(_, curve) => {
                range.turns = true;
                let most = curve
                    .hull()
                    .iter()
                    .map(|s| s.abs().max_element())
                    .fold(0.0, f32::max);
                range.most_scale = range.most_scale.max(most);
            }
        }
    }
    for part in &model.parts {
        for vertex in model.meshes[part.mesh]
            .primitives
            .iter()
            .flat_map(|p| &p.vertices)
        {
            let Some(skin) = part.skin.map(|s| &model.skins[s]) else {
                out[part.node].own_m = out[part.node].own_m.max(vertex.position.length());
                continue;
            };
            for (joint, weight) in vertex.joints.iter().zip(vertex.weights) {
                if weight > 0.0 {
                    let at = skin.inverse_bind[*joint as usize].transform_point3(vertex.position);
                    let range = &mut out[skin.joints[*joint as usize]];
                    range.own_m = range.own_m.max(at.length());
                }
            }
        }
    }
    out
}

fn reaches(model: &Model, ranges: &[Range]) -> Vec<f32> {
    let mut out: Vec<f32> = ranges.iter().map(|r| r.own_m).collect();
    // Children come after their parents, so from the end each is complete before it is passed up.
    for j in (0..out.len()).rev() {
        out[j] *= ranges[j].most_scale;
        if let Some(parent) = model.skeleton.joints[j].parent {
            let offset = ranges[j]
                .offsets
                .iter()
                .map(|o| o.length())
                .fold(0.0, f32::max);
            out[parent] = out[parent].max(offset + out[j]);
        }
    }
    out
}

/// By how much a matrix lengthens at the most: never more than the root of the sum of its columns' squares.
fn stretch(m: Mat4) -> f32 {
    let columns = [m.x_axis, m.y_axis, m.z_axis].map(glam::Vec4::truncate);
    let lengths = columns.map(Vec3::length);
    // Of a turn times a size along the axes the columns are at right angles, and the longest is exact.
    let square = columns[0].dot(columns[1]).abs()
        + columns[1].dot(columns[2]).abs()
        + columns[2].dot(columns[0]).abs();
    if square < 1.0e-4 {
        lengths[0].max(lengths[1]).max(lengths[2])
    } else {
        Vec3::from(lengths).length()
    }
}
