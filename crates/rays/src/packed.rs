//! Aberrations and materials as the shaders have them.

use antipode_deformation::{Exit, MAX_ABERRATIONS, PictureCorners, Placed, Sides, Stack, Ways};
use bytemuck::{Pod, Zeroable};
use glam::{DMat3, DVec3, Vec3, Vec4};

use crate::crowd::Near;
use crate::options::Outlines;
use crate::scene::{Material, Pattern, RayScene, WALL_DEFAULT};
use crate::tree::NOTHING;

/// An aberration, as space.wgsl has it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct PackedAberration {
    centre: Vec3,
    sides: u32,
    axes: [Vec4; 3],
    squeeze_x: Vec3,
    walls: u32,
    squeeze_y: Vec3,
    first: u32,
    squeeze_z: Vec3,
    count: u32,
    legacy: Vec3,
    flags: u32,
    stretch: Vec3,
    rank: u32,
    heading: Vec3,
    is_felt_always: f32,
    near: Near,
    wall_material: u32,
    padding: [u32; 3],
}

/// What a path needs to know of a scene besides its solids, as trace.wgsl has it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct PackedWays {
    pub outermost: u32,
    pub outermost_count: u32,
    /// What the root of all solids is.
    pub root: u32,
    /// The flags of a box whose outline is drawn, any of them.
    pub outlined: u32,
    pub portal_count: u32,
    pub padding: [u32; 3],
    /// The boxes that can be entered from outside of all.
    pub near: Near,
    pub low: Vec4,
    pub high: Vec4,
}

impl PackedWays {
    /// With the corners of a picture.
    pub fn with_corners(self, corners: &PictureCorners) -> Self {
        Self {
            low: corners.low.as_vec3().extend(0.0),
            high: corners.high.as_vec3().extend(0.0),
            ..self
        }
    }

    /// With the outlines that are drawn.
    pub fn with_outlines(self, outlines: Outlines) -> Self {
        Self {
            outlined: match outlines {
                Outlines::Hidden => 0,
                Outlines::Chosen => OUTLINED,
                Outlines::All => OUTLINED | IS_BOX,
            },
            ..self
        }
    }
}

/// Flag of an aberration that has an outline of its own.
const OUTLINED: u32 = 256;
/// Flag of every aberration.
const IS_BOX: u32 = 512;

/// A material, as frame.wgsl has it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct PackedMaterial {
    colour: Vec3,
    layer: f32,
    checker: Vec3,
    square_m: f32,
    glow: Vec3,
    mirror: f32,
    glass_index: f32,
    gloss: f32,
    repeats: f32,
    padding: f32,
}

/// By which rule light goes through aberrations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// That of `antipode-deformation`.
    Exact,
    /// The thesis's, for all of them.
    Thesis,
    /// As if they were not stretched: coordinates of the scene.
    Plain,
}

impl Rule {
    /// All, by number.
    pub const ALL: [Self; 3] = [Self::Exact, Self::Thesis, Self::Plain];

    /// An aberration as it is by this rule.
    pub fn of(self, placed: &Placed) -> Placed {
        let mut placed = placed.clone();
        let it = &mut placed.aberration;
        match (self, it.sides) {
            (Self::Exact, _) | (Self::Thesis, Sides::Legacy(_)) => {}
            // The thesis has no walls that are made by themselves.
            (Self::Thesis, _) => it.sides = Sides::Legacy(Exit::Original),
            (Self::Plain, sides) => {
                placed.squeeze = DMat3::IDENTITY;
                placed.legacy = DVec3::ZERO;
                if sides != Sides::Walls {
                    it.sides = Sides::Soft;
                }
            }
        }
        placed
    }
}

/// All aberrations by a rule.
pub fn aberrations(scene: &RayScene, rule: Rule, near: &[Near]) -> Vec<PackedAberration> {
    let mut first = 0;
    let mut packed: Vec<_> = scene
        .aberrations
        .placed()
        .iter()
        .enumerate()
        .map(|(number, placed)| {
            let own = scene.wall_materials.get(number);
            let wall = own.copied().unwrap_or(WALL_DEFAULT);
            let is_outlined = scene.outlined.get(number).copied().unwrap_or(false);
            let wall = wall.min(scene.materials.len().saturating_sub(1));
            let packed = pack(&rule.of(placed), near[number], first, wall, is_outlined);
            first += packed.count;
            if rule == Rule::Plain {
                // Its walls stay, and are told by how it was stretched.
                return PackedAberration {
                    stretch: Vec3::ONE,
                    ..packed
                };
            }
            packed
        })
        .collect();
    packed.resize(MAX_ABERRATIONS, PackedAberration::zeroed());
    packed
}

/// Lists of neighbours, trees of them where they are many, the neighbours of each box, and what the outermost ones are.
pub fn neighbours(scene: &RayScene) -> (Vec<u32>, Vec<Near>, PackedWays) {
    let space = &scene.aberrations;
    let of_each = space.placed().iter().flat_map(|placed| &placed.neighbours);
    let mut neighbours: Vec<_> = of_each.map(|number| u32::from(*number)).collect();
    let outermost = space.entrances(&Stack::default());
    let outermost_at = neighbours.len();
    neighbours.extend(outermost.iter().map(|number| u32::from(*number)));
    let of_box = |it: &Placed| Near::new(&mut neighbours, space.placed(), &it.neighbours);
    let near_each = space.placed().iter().map(of_box).collect();
    let near = Near::new(&mut neighbours, space.placed(), outermost);
    let ways = PackedWays {
        outermost: outermost_at as u32,
        outermost_count: outermost.len() as u32,
        root: NOTHING,
        outlined: OUTLINED,
        portal_count: space.portals().len() as u32,
        padding: [0; 3],
        near,
        low: Vec4::ZERO,
        high: Vec4::ZERO,
    };
    // A buffer may not be empty.
    neighbours.push(0);
    (neighbours, near_each, ways)
}

fn pack(
    placed: &Placed,
    near: Near,
    first: u32,
    wall: usize,
    is_outlined: bool,
) -> PackedAberration {
    let aberration = &placed.aberration;
    let axis = |i: usize| {
        placed
            .axes
            .col(i)
            .as_vec3()
            .extend(aberration.half[i] as f32)
    };
    let (sides, exit) = match aberration.sides {
        Sides::Walls | Sides::Soft => (0, 0),
        Sides::Snell => (1, 0),
        Sides::Legacy(exit) => (
            2,
            match exit {
                Exit::Original => 0,
                Exit::Inverse => 1,
                Exit::None => 2,
            },
        ),
    };
    let (heading, is_felt_always) = match aberration.ways {
        Ways::Both => (Vec3::ZERO, 1.0),
        Ways::Along(axis) => (axis_of(placed, axis), 0.0),
    };
    let row = |k: &DMat3, i: usize| k.row(i).as_vec3();
    PackedAberration {
        centre: aberration.centre.as_vec3(),
        sides,
        axes: [axis(0), axis(1), axis(2)],
        squeeze_x: row(&placed.squeeze, 0),
        walls: (0..3).map(|i| u32::from(aberration.is_wall(i)) << i).sum(),
        squeeze_y: row(&placed.squeeze, 1),
        first,
        squeeze_z: row(&placed.squeeze, 2),
        count: placed.neighbours.len() as u32,
        legacy: placed.legacy.as_vec3(),
        flags: exit | IS_BOX | if is_outlined { OUTLINED } else { 0 },
        stretch: aberration.stretch.as_vec3(),
        rank: placed.rank as u32,
        heading,
        is_felt_always,
        near,
        wall_material: wall as u32,
        padding: [0; 3],
    }
}

fn axis_of(placed: &Placed, axis: u8) -> Vec3 {
    placed.axes.col(usize::from(axis)).as_vec3()
}

/// A stack as the shaders have it: a byte for each box.
pub fn stack(stack: &Stack) -> [u32; 4] {
    let mut packed = [0; 4];
    for (at, number) in stack.as_bytes().iter().enumerate() {
        packed[at / 4] |= u32::from(*number) << (8 * (at % 4));
    }
    packed
}

/// A material; one that names a picture that there is not is plain.
pub fn material(material: &Material, textures: usize) -> PackedMaterial {
    let mut packed = PackedMaterial {
        colour: material.colour,
        layer: -1.0,
        checker: Vec3::ZERO,
        square_m: 0.0,
        glow: material.glow,
        mirror: material.mirror.clamp(0.0, 1.0),
        glass_index: material.glass.map_or(0.0, |index| index.max(1.0)),
        gloss: material.gloss,
        repeats: 1.0,
        padding: 0.0,
    };
    match material.pattern {
        Pattern::Checker { other, edge_m } => {
            packed.checker = other;
            packed.square_m = edge_m.max(0.0);
        }
        Pattern::Texture { number, repeats } if number < textures => {
            packed.layer = number as f32;
            packed.repeats = repeats;
        }
        _ => {}
    }
    packed
}
