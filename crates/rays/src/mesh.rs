//! Meshes, and how their triangles lie in the adapter's memory.

use glam::{Vec2, Vec3};

use crate::error::RaysError;

/// Texels of a triangle, and of what is drawn on it.
pub const TRIANGLE_TEXELS: usize = 3;
/// Marks the last triangle of a leaf.
const LAST: u32 = 1;

/// Triangles with what is drawn on them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corners, in metres of the mesh.
    pub positions: Vec<Vec3>,
    /// Triangles, by numbers of corners.
    pub triangles: Vec<[u32; 3]>,
    /// Normals of the corners; empty for faces that are flat.
    pub normals: Vec<Vec3>,
    /// Where in a texture the corners lie; empty where there is none.
    pub uvs: Vec<Vec2>,
    /// What each triangle's material is multiplied by, linear light from 0 to 1; empty for 1.
    pub colours: Vec<Vec3>,
    /// Number of each triangle's material; empty for 0.
    pub materials: Vec<u32>,
}

impl Mesh {
    /// Refuses what has numbers that are none, or lists that do not fit each other. `number` is what errors call it.
    ///
    /// # Errors
    /// Says what of it is faulty.
    pub fn check(&self, number: usize) -> Result<(), RaysError> {
        let corners = self.positions.len();
        let lengths = |what| Err(RaysError::Lengths { mesh: number, what });
        let fits = |found: usize, wanted: usize| found == 0 || found == wanted;
        if !fits(self.normals.len(), corners) {
            return lengths("normals");
        }
        if !fits(self.uvs.len(), corners) {
            return lengths("places in a texture");
        }
        if !fits(self.materials.len(), self.triangles.len()) {
            return lengths("materials");
        }
        if !fits(self.colours.len(), self.triangles.len()) {
            return lengths("colours");
        }
        if !self.positions.iter().all(|place| place.is_finite()) {
            return Err(RaysError::Place { mesh: number });
        }
        let lacks = |triangle: &[u32; 3]| triangle.iter().any(|corner| *corner as usize >= corners);
        match self.triangles.iter().position(lacks) {
            Some(triangle) => Err(RaysError::Corner {
                mesh: number,
                triangle,
            }),
            None => Ok(()),
        }
    }

    /// The greatest number of a material; none without triangles.
    pub fn most_material(&self) -> Option<usize> {
        let most = self.materials.iter().copied().max().unwrap_or(0);
        (!self.triangles.is_empty()).then_some(most as usize)
    }

    /// The corners of a triangle, of a list of places.
    pub fn corners(&self, triangle: u32, places: &[Vec3]) -> [Vec3; 3] {
        self.triangles[triangle as usize].map(|corner| places[corner as usize])
    }

    /// What is drawn on a triangle: its normals and material, and its uv and colour. `places` and `normals` are those of
    /// the corners.
    pub fn attributes(&self, number: u32, places: &[Vec3], normals: &[Vec3]) -> [[u32; 4]; 3] {
        let triangle = self.triangles[number as usize].map(|corner| corner as usize);
        let [a, b, c] = triangle.map(|corner| places[corner]);
        let flat = (b - a).cross(c - a);
        let normals = triangle.map(|corner| {
            let own = normals.get(corner).copied().unwrap_or(flat);
            octahedral(own.try_normalize().unwrap_or(Vec3::Y))
        });
        let uvs = triangle.map(|corner| self.uvs.get(corner).copied().unwrap_or(Vec2::ZERO));
        let [u, v] = [uvs[1] - uvs[0], uvs[2] - uvs[0]];
        let uv_for_metre = (u.perp_dot(v).abs() / flat.length().max(1e-12)).sqrt();
        let material = self.materials.get(number as usize).copied().unwrap_or(0);
        let colour = self.colours.get(number as usize).copied();
        [
            [normals[0], normals[1], normals[2], material],
            [uvs[0].x, uvs[0].y, uvs[1].x, uvs[1].y].map(f32::to_bits),
            [
                uvs[2].x.to_bits(),
                uvs[2].y.to_bits(),
                uv_for_metre.to_bits(),
                bytes(colour.unwrap_or(Vec3::ONE)),
            ],
        ]
    }
}

/// The box of a triangle.
pub fn bounds([a, b, c]: [Vec3; 3]) -> (Vec3, Vec3) {
    (a.min(b).min(c), a.max(b).max(c))
}

/// A triangle as scene.wgsl has it: a corner with the triangle's number in its mesh, and two edges with whether a leaf ends
/// here and with the number of its instance.
pub fn triangle([a, b, c]: [Vec3; 3], number: u32, ends: bool, instance: u32) -> [[u32; 4]; 3] {
    let texel = |v: Vec3, word: u32| [v.x.to_bits(), v.y.to_bits(), v.z.to_bits(), word];
    [
        texel(a, number),
        texel(b - a, if ends { LAST } else { 0 }),
        texel(c - a, instance),
    ]
}

/// Linear light in bytes of its root, so that dark colours keep their shades.
fn bytes(colour: Vec3) -> u32 {
    let byte = |light: f32| (255.0 * light.clamp(0.0, 1.0).sqrt()).round() as u32;
    byte(colour.x) | (byte(colour.y) << 8) | (byte(colour.z) << 16)
}

/// A direction folded onto a square, each coordinate in 16 bits (Q. Meyer and others, 2010).
fn octahedral(n: Vec3) -> u32 {
    let n = n / (n.x.abs() + n.y.abs() + n.z.abs());
    let sign = |v: f32| if v >= 0.0 { 1.0 } else { -1.0 };
    let folded = if n.z < 0.0 {
        Vec2::new((1.0 - n.y.abs()) * sign(n.x), (1.0 - n.x.abs()) * sign(n.y))
    } else {
        Vec2::new(n.x, n.y)
    };
    let pack = |v: f32| u32::from(((v.clamp(-1.0, 1.0) * 32767.0).round() as i16) as u16);
    pack(folded.x) | (pack(folded.y) << 16)
}
