//! Models of the game as triangles that are bent on the processor, for whoever traces rays: a ray may meet any of them, so
//! that a vertex shader cannot.

use antipode_frame::{ModelId, Posture};
use glam::{Vec3, Vec4};

use crate::error::RenderError;
use crate::models::{self, Loaded, ModelVertex};
use crate::rig::HandPose;

/// How a triangle looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BentSurface {
    /// Share of light that it throws back, linear.
    pub colour: Vec3,
    /// How much it glows, 0 to 1.
    pub glow: f32,
    /// How much it shines, 0 to 1.
    pub gloss: f32,
}

/// The triangles of a model, in the game's axes: x ahead, y up, z to the right; metres.
#[derive(Clone, Debug)]
pub struct BentMesh {
    loaded: Loaded,
    triangles: Vec<[u32; 3]>,
}

/// Where the corners of a bent mesh are.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BentCorners {
    /// Metres.
    pub places: Vec<Vec3>,
    /// Of length 1.
    pub normals: Vec<Vec3>,
}

impl BentMesh {
    /// Reads a model of the game.
    ///
    /// # Errors
    /// When the embedded file cannot be read; a test reads them all.
    pub fn new(model: ModelId) -> Result<Self, RenderError> {
        let loaded = models::load(model)?;
        let shape = &loaded.shape;
        let corners: Vec<u32> = shape
            .solid
            .iter()
            .chain(&shape.clear)
            .map(|it| u32::from(*it))
            .collect();
        let triangles = corners.as_chunks::<3>().0.to_vec();
        Ok(Self { loaded, triangles })
    }

    /// Its triangles, by numbers of corners.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// How each triangle looks: as its first corner does.
    pub fn surfaces(&self) -> Vec<BentSurface> {
        let of = |[corner, ..]: &[u32; 3]| surface(&self.loaded.shape.vertices[*corner as usize]);
        self.triangles.iter().map(of).collect()
    }

    /// Where the right hand of a model with a skeleton is in a posture.
    pub fn hand(&self, posture: &Posture) -> Option<HandPose> {
        self.loaded.rig.as_ref().map(|rig| rig.pose(posture).hand)
    }

    /// Where its corners are in a posture; a model without a skeleton has only one.
    pub fn corners(&self, posture: &Posture) -> BentCorners {
        let shape = &self.loaded.shape;
        let places = shape.vertices.iter().map(|it| Vec3::from(it.position));
        let normals = shape.vertices.iter().map(normal_of);
        let Some(rig) = &self.loaded.rig else {
            let (places, normals) = (places.collect(), normals.collect());
            return BentCorners { places, normals };
        };
        let joints = rig.pose(posture).joints;
        let mut corners = BentCorners::default();
        for ((place, normal), skin) in places.zip(normals).zip(&shape.skin) {
            let mut rows = [Vec4::ZERO; 3];
            for (joint, weight) in skin.joints.iter().zip(skin.weights) {
                let share = f32::from(weight) / f32::from(u16::MAX);
                for (sum, row) in rows.iter_mut().zip(&joints[usize::from(*joint)]) {
                    *sum += share * Vec4::from(*row);
                }
            }
            let by = |v: Vec4| Vec3::from_array(rows.map(|row| row.dot(v)));
            corners.places.push(by(place.extend(1.0)));
            corners
                .normals
                .push(by(normal.extend(0.0)).normalize_or(Vec3::Y));
        }
        corners
    }
}

fn normal_of(vertex: &ModelVertex) -> Vec3 {
    let [x, y, z, _] = vertex.normal.map(|it| f32::from(it) / f32::from(i16::MAX));
    Vec3::new(x, y, z)
}

fn surface(vertex: &ModelVertex) -> BentSurface {
    let [red, green, blue, gloss] = vertex.colour.map(|byte| f32::from(byte) / 255.0);
    BentSurface {
        colour: Vec3::new(red, green, blue).map(linear),
        glow: f32::from(vertex.normal[3]) / f32::from(i16::MAX),
        gloss,
    }
}

/// Linear light of a share in sRGB (IEC 61966-2-1).
fn linear(share: f32) -> f32 {
    if share <= 0.040_45 {
        share / 12.92
    } else {
        ((share + 0.055) / 1.055).powf(2.4)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use antipode_frame::Clip;

    use super::*;

    fn limits(corners: &BentCorners) -> (Vec3, Vec3) {
        let places = || corners.places.iter().copied();
        let low = places().reduce(Vec3::min).unwrap();
        (low, places().reduce(Vec3::max).unwrap())
    }

    #[test]
    fn the_astronaut_stands_runs_and_lies_on_the_ground() {
        let mesh = BentMesh::new(ModelId::Astronaut).unwrap();
        let (low, high) = limits(&mesh.corners(&Posture::of(Clip::Idle, 0.0)));
        assert!(
            low.y.abs() < 0.03 && (high.y - 1.8).abs() < 0.05,
            "{low} {high}"
        );
        let wide = high - low;
        let (low, high) = limits(&mesh.corners(&Posture::of(Clip::Run, 0.25)));
        assert!(
            high.x - low.x > 1.3 * wide.x,
            "legs and arms apart: {low} {high}, standing {wide}"
        );
        let lies = limits(&mesh.corners(&Posture::of(Clip::Die, 9.0)));
        assert!(lies.1.y < 0.9, "{lies:?}");
        let corners = mesh.corners(&Posture::default());
        assert!(
            corners
                .normals
                .iter()
                .all(|it| (it.length() - 1.0).abs() < 1e-4)
        );
    }

    #[test]
    fn every_model_has_triangles_that_look_like_something() {
        for model in ModelId::ALL {
            let mesh = BentMesh::new(model).unwrap();
            let corners = mesh.corners(&Posture::default());
            let most = mesh.triangles().iter().flatten().max().unwrap();
            assert!((*most as usize) < corners.places.len(), "{model:?}");
            let surfaces = mesh.surfaces();
            assert_eq!(surfaces.len(), mesh.triangles().len());
            assert!(
                surfaces.iter().any(|it| it.colour.max_element() > 0.05),
                "{model:?}"
            );
        }
        let lamp = BentMesh::new(ModelId::Item(antipode_items::Item::Lamp)).unwrap();
        assert!(lamp.surfaces().iter().any(|it| it.glow > 0.3));
    }
}
