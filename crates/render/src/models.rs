//! Loads the game's models for the adapter: vertices and indices in the game's axes, x ahead, y up, z to the right.

use antipode_frame::{ModelId, ModelShape};
use antipode_models::{GAME_FROM_FILE, Material, Mesh, Model, Vertex};
use bytemuck::{Pod, Zeroable};
use glam::{Mat4, Vec3};

use crate::error::RenderError;
use crate::flash;
use crate::rig::Rig;

/// A vertex of a model; the attributes of figure.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct ModelVertex {
    /// Metres, in the bind pose.
    pub position: [f32; 3],
    /// Unit normal, signed normalised; the last is how much it glows, 0 to 1.
    pub normal: [i16; 4],
    /// sRGB, then gloss; of what is clear, its cover.
    pub colour: [u8; 4],
    /// What switches its glow: a [`Switch`].
    pub switch: u32,
}

impl ModelVertex {
    /// Attributes at the locations that figure.wgsl gives them.
    pub const ATTRIBUTES: [wgpu::VertexAttribute; 4] =
        wgpu::vertex_attr_array![0 => Float32x3, 1 => Snorm16x4, 2 => Unorm8x4, 14 => Uint32];
}

/// What ties a vertex to a skeleton.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
pub struct SkinVertex {
    /// Shares of the joints, unsigned normalised; they sum to 1.
    pub weights: [u16; 4],
    /// Joints of the skin.
    pub joints: [u8; 4],
}

impl SkinVertex {
    /// Attributes from location 11 on.
    pub const ATTRIBUTES: [wgpu::VertexAttribute; 2] =
        wgpu::vertex_attr_array![12 => Unorm16x4, 13 => Uint8x4];
}

/// The triangles of a model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shape {
    /// Vertices.
    pub vertices: Vec<ModelVertex>,
    /// One for each vertex; none where nothing bends.
    pub skin: Vec<SkinVertex>,
    /// Three indices for each triangle that hides what is behind it, counter-clockwise seen from outside.
    pub solid: Vec<u16>,
    /// The same of those that let it through.
    pub clear: Vec<u16>,
}

impl Shape {
    /// Lowest and highest corner of its box in the bind pose, metres.
    pub fn limits(&self) -> [Vec3; 2] {
        let places = || self.vertices.iter().map(|v| Vec3::from(v.position));
        [
            places().reduce(Vec3::min).unwrap_or_default(),
            places().reduce(Vec3::max).unwrap_or_default(),
        ]
    }

    /// How far its vertices lie from its origin in the bind pose at most, metres.
    pub fn radius_m(&self) -> f32 {
        let away = self
            .vertices
            .iter()
            .map(|v| Vec3::from(v.position).length());
        away.fold(0.0, f32::max)
    }

    /// Adds a mesh, placed by `place` in the file's axes.
    fn add(&mut self, mesh: &Mesh, materials: &[Material], place: Mat4, look: Look) {
        let skinned = look == Look::Bent;
        for primitive in &mesh.primitives {
            let first = self.vertices.len() as u16;
            let Some(material) = materials.get(primitive.material) else {
                continue;
            };
            // What bends is drawn solid: no astronaut has a part that light goes through.
            let clear = material.clear && !skinned;
            for vertex in &primitive.vertices {
                self.vertices
                    .push(model_vertex(vertex, material, place, look, clear));
                if skinned {
                    self.skin.push(skin_vertex(vertex));
                }
            }
            let indices = primitive.indices.iter().map(|&i| first + i as u16);
            if clear {
                self.clear.extend(indices);
            } else {
                self.solid.extend(indices);
            }
        }
    }
}

/// What a mesh is part of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Look {
    /// A lamp, which shines for others to see by.
    Lamp,
    /// Something with a skeleton.
    Bent,
    /// What has lights that are switched, as a car's body.
    Switched,
    /// Anything else.
    Thing,
}

impl Look {
    /// Share of the brightest glow that a material which shines with full strength has: small lights are to be seen
    /// as lights, and keep their colour.
    fn glow(self) -> f32 {
        match self {
            Self::Lamp => 0.7,
            Self::Bent | Self::Thing | Self::Switched => 0.28,
        }
    }

    /// What switches the glow of a material.
    fn switch(self, material: &str) -> Switch {
        match (self, material) {
            (Self::Switched, "glow.tail") => Switch::LightsAndBrakes,
            (Self::Switched, _) => Switch::Lights,
            (Self::Lamp | Self::Bent | Self::Thing, _) => Switch::Always,
        }
    }
}

/// What switches the glow of a vertex, by its number in figure.wgsl.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Switch {
    /// Nothing does.
    Always = 0,
    /// The lights of the instance.
    Lights = 1,
    /// These, and more strongly its brake lights.
    LightsAndBrakes = 2,
}

/// The number of a model in the buffers.
pub fn number(model: ModelId) -> usize {
    ModelId::ALL.iter().position(|it| *it == model).unwrap_or(0)
}

/// A shape, and the skeleton that bends it if there is one.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// Triangles.
    pub shape: Shape,
    /// What bends it.
    pub rig: Option<Rig>,
}

/// Reads every model of the game, in the order of [`ModelId::ALL`].
///
/// # Errors
/// When one of the embedded files cannot be read or outgrows what is drawn; a test reads them all.
pub fn load_all() -> Result<Vec<Loaded>, RenderError> {
    ModelId::ALL.into_iter().map(load).collect()
}

/// Reads one model.
///
/// # Errors
/// When its file cannot be read.
pub fn load(model: ModelId) -> Result<Loaded, RenderError> {
    let look = if model.shines() {
        Look::Lamp
    } else if model.is_switched() {
        Look::Switched
    } else {
        Look::Thing
    };
    match model.shape() {
        ModelShape::Whole(file) => Ok(whole(&read(file)?, look)),
        ModelShape::Part(file, node) => part(&read(file)?, node, look),
        ModelShape::Bent(file) => bent(&read(file)?),
        ModelShape::Made => Ok(Loaded {
            shape: flash::shape(),
            rig: None,
        }),
    }
}

fn read(bytes: &[u8]) -> Result<Model, RenderError> {
    Model::from_glb(bytes).map_err(|e| RenderError::Model(e.to_string()))
}

/// The whole of a model that does not move.
fn whole(model: &Model, look: Look) -> Loaded {
    let places = antipode_models::Pose::rest(&model.skeleton).model_matrices(&model.skeleton);
    let mut shape = Shape::default();
    for part in &model.parts {
        shape.add(
            &model.meshes[part.mesh],
            &model.materials,
            places[part.node],
            look,
        );
    }
    Loaded { shape, rig: None }
}

/// What hangs from one node, about that node.
fn part(model: &Model, name: &str, look: Look) -> Result<Loaded, RenderError> {
    let missing = || RenderError::Model(format!("there is no part {name}"));
    let node = model.skeleton.find(name).ok_or_else(missing)?;
    let part = model.parts.iter().find(|part| part.node == node);
    let mut shape = Shape::default();
    let mesh = &model.meshes[part.ok_or_else(missing)?.mesh];
    shape.add(mesh, &model.materials, Mat4::IDENTITY, look);
    Ok(Loaded { shape, rig: None })
}

/// A model that is bent by its skeleton.
fn bent(model: &Model) -> Result<Loaded, RenderError> {
    let mut shape = Shape::default();
    for part in &model.parts {
        shape.add(
            &model.meshes[part.mesh],
            &model.materials,
            Mat4::IDENTITY,
            Look::Bent,
        );
    }
    Ok(Loaded {
        shape,
        rig: Some(Rig::new(model)?),
    })
}

fn model_vertex(
    vertex: &Vertex,
    material: &Material,
    place: Mat4,
    look: Look,
    clear: bool,
) -> ModelVertex {
    let position = GAME_FROM_FILE * place.transform_point3(vertex.position);
    let normal = (GAME_FROM_FILE * place.transform_vector3(vertex.normal)).normalize_or(Vec3::Y);
    let colour = vertex.colour * material.colour;
    // A mirror's shine is all of it, chalk's none; in between it falls quickly.
    let gloss = (1.0 - material.roughness).powi(2);
    let fourth = if clear { colour.w } else { gloss };
    let snorm = |x: f32| (x * f32::from(i16::MAX)).round() as i16;
    let unorm = |x: f32| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
    ModelVertex {
        position: position.into(),
        normal: [
            snorm(normal.x),
            snorm(normal.y),
            snorm(normal.z),
            snorm(look.glow() * material.emission.max_element().min(1.0)),
        ],
        colour: [
            unorm(srgb(colour.x)),
            unorm(srgb(colour.y)),
            unorm(srgb(colour.z)),
            unorm(fourth),
        ],
        switch: look.switch(&material.name) as u32,
    }
}

/// The sRGB curve (IEC 61966-2-1) from linear light.
fn srgb(light: f32) -> f32 {
    if light <= 0.003_130_8 {
        12.92 * light
    } else {
        1.055 * light.powf(1.0 / 2.4) - 0.055
    }
}

/// Weights in 16 bits that still sum to one: what rounding leaves over goes to the greatest.
fn skin_vertex(vertex: &Vertex) -> SkinVertex {
    let one = u32::from(u16::MAX);
    let mut weights = vertex.weights.map(|w| (w * one as f32) as u32);
    let left = one.saturating_sub(weights.iter().sum());
    if let Some(most) = weights.iter_mut().max() {
        *most = (*most + left).min(one);
    }
    SkinVertex {
        weights: weights.map(|w| w as u16),
        joints: vertex.joints.map(|j| j as u8),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;

    #[test]
    fn every_model_is_read_and_fits_the_buffers() {
        for (id, Loaded { shape, rig }) in ModelId::ALL.into_iter().zip(load_all().unwrap()) {
            assert!(shape.vertices.len() < usize::from(u16::MAX), "{id:?}");
            assert!(
                shape.solid.len() >= 12 && shape.solid.len().is_multiple_of(3),
                "{id:?}"
            );
            assert_eq!(rig.is_some(), !shape.skin.is_empty(), "{id:?}");
            let used = || shape.solid.iter().chain(&shape.clear);
            assert!(
                used().all(|&i| usize::from(i) < shape.vertices.len()),
                "{id:?}"
            );
            for skin in &shape.skin {
                let sum: u32 = skin.weights.iter().map(|w| u32::from(*w)).sum();
                assert_eq!(sum, u32::from(u16::MAX));
            }
        }
    }

    #[test]
    fn they_look_along_x_with_their_feet_on_the_ground() {
        let all = load_all().unwrap();
        let of = |id: ModelId| &all[ModelId::ALL.iter().position(|it| *it == id).unwrap()].shape;
        let [low, high] = of(ModelId::Astronaut).limits();
        assert!(
            low.y.abs() < 0.01 && (high.y - 1.8).abs() < 0.02,
            "{low} {high}"
        );
        // The visor is the glossiest, and in front.
        let visor = || {
            of(ModelId::Astronaut)
                .vertices
                .iter()
                .filter(|v| v.colour[3] > 200)
        };
        assert!(visor().count() > 20 && visor().all(|v| v.position[0] > 0.0));
        let [low, high] = of(ModelId::Item(antipode_items::Item::Gun)).limits();
        assert!(
            high.x > 0.25 && low.x > -0.1,
            "the barrel is ahead: {low} {high}"
        );
        let [low, high] = of(ModelId::CarWheelLeft).limits();
        assert!(
            (low + high).truncate().length() < 0.01,
            "about its hub: {low} {high}"
        );
        // The hub caps show outwards: of the left side at -z.
        assert!(low.z < -0.13 && high.z < 0.13, "{low} {high}");
        let [low, high] = of(ModelId::CarBody).limits();
        assert!(high.x - low.x > 3.0 && high.z - low.z < 1.6, "{low} {high}");
        assert!(
            !of(ModelId::Item(antipode_items::Item::Lamp))
                .clear
                .is_empty()
                && !of(ModelId::CarBody).clear.is_empty()
        );
    }

    #[test]
    fn the_lamps_of_a_car_have_switches() {
        let all = load_all().unwrap();
        let vertices = |id: ModelId| all[number(id)].shape.vertices.iter();
        let glowing = || vertices(ModelId::CarBody).filter(|it| it.normal[3] > 0);
        let has = |ahead: bool, switch: Switch| {
            glowing().any(|it| (it.position[0] > 0.0) == ahead && it.switch == switch as u32)
        };
        assert!(has(true, Switch::Lights) && has(false, Switch::LightsAndBrakes));
        assert!(!has(true, Switch::LightsAndBrakes));
        assert!(glowing().all(|it| it.switch != Switch::Always as u32));
        let mut lamp = vertices(ModelId::Item(antipode_items::Item::Lamp));
        assert!(lamp.any(|it| it.normal[3] > 0 && it.switch == 0));
    }

    /// What the scene says of how things lie must fit the models: their lowest corner touches the ground.
    #[test]
    fn things_that_lie_touch_the_ground_and_do_not_sink_into_it() {
        let all = load_all().unwrap();
        for item in antipode_items::Item::ALL {
            let id = ModelId::from(item);
            let place = ModelId::ALL.iter().position(|it| *it == id).unwrap();
            let (turn, height_m) = antipode_scene::drops::lying(item);
            let heights = all[place].shape.vertices.iter().map(|vertex| {
                let at = Vec3::from(vertex.position).as_dvec3();
                (turn * at).y + height_m
            });
            let lowest = heights.fold(f64::INFINITY, f64::min);
            assert!(lowest.abs() < 0.003, "{item:?}: {lowest} m over the ground");
        }
    }
}
