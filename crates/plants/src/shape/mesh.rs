//! What shapes are put together from: corners, bands of triangles, dice and colours.

use glam::Vec3;

use super::{Corner, Material, Shape};

/// A colour, sRGB, each part from 0 to 1.
pub(super) type Colour = Vec3;

/// A colour of bytes.
pub(super) const fn rgb(red: u8, green: u8, blue: u8) -> Colour {
    Vec3::new(
        red as f32 / 255.0,
        green as f32 / 255.0,
        blue as f32 / 255.0,
    )
}

/// Numbers that look thrown, the same on every machine.
pub(super) struct Dice(u64);

impl Dice {
    /// Dice that fall by a seed.
    pub(super) fn new(seed: u64) -> Self {
        Self(
            seed.wrapping_mul(0x9e37_79b9_7f4a_7c15)
                .wrapping_add(0x1234_5678_9abc_def1),
        )
    }

    /// A number from 0 up to 1.
    pub(super) fn unit(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        (bits >> 40) as f32 / (1_u32 << 24) as f32
    }

    /// A number between two.
    pub(super) fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.unit()
    }
}

/// A shape in the making.
#[derive(Default)]
pub(super) struct Mesh {
    corners: Vec<Corner>,
    triangles: Vec<[u16; 3]>,
}

impl Mesh {
    /// Adds a corner and returns its index.
    pub(super) fn corner(
        &mut self,
        place: Vec3,
        normal: Vec3,
        colour: Colour,
        of: Material,
        sway: f32,
    ) -> u16 {
        let colour = (colour.clamp(Vec3::ZERO, Vec3::ONE) * 255.0).round();
        self.corners.push(Corner {
            place,
            normal: normal.try_normalize().unwrap_or(Vec3::Y),
            colour: [colour.x as u8, colour.y as u8, colour.z as u8],
            material: of,
            sway: sway.clamp(0.0, 1.0),
        });
        (self.corners.len() - 1) as u16
    }

    /// Adds a triangle, counter-clockwise seen from outside.
    pub(super) fn triangle(&mut self, a: u16, b: u16, c: u16) {
        self.triangles.push([a, b, c]);
    }

    /// Joins two closed rings of equally many corners that turn from x to z about an upward line. The upper ring may be
    /// turned half a step ahead of the lower one, or else the lower one of the upper.
    pub(super) fn band(&mut self, lower: &[u16], upper: &[u16], upper_ahead: bool) {
        for i in 0..lower.len() {
            let j = (i + 1) % lower.len();
            let (a, b, c, d) = (lower[i], lower[j], upper[i], upper[j]);
            if upper_ahead {
                self.triangle(a, c, b);
                self.triangle(b, c, d);
            } else {
                self.triangle(a, c, d);
                self.triangle(a, d, b);
            }
        }
    }

    /// Closes a ring by a point over it.
    pub(super) fn close_above(&mut self, ring: &[u16], top: u16) {
        for i in 0..ring.len() {
            self.triangle(ring[i], top, ring[(i + 1) % ring.len()]);
        }
    }

    /// Closes a ring by a point below it.
    pub(super) fn close_below(&mut self, ring: &[u16], bottom: u16) {
        for i in 0..ring.len() {
            self.triangle(bottom, ring[i], ring[(i + 1) % ring.len()]);
        }
    }

    /// Takes away those of the triangles from an index on of which a test of their three places says so.
    pub(super) fn thin(&mut self, from: usize, hidden: impl Fn([Vec3; 3]) -> bool) {
        let corners = &self.corners;
        let mut index = 0;
        self.triangles.retain(|triangle| {
            index += 1;
            index <= from || !hidden(triangle.map(|corner| corners[corner as usize].place))
        });
    }

    /// How many triangles there are.
    pub(super) fn count(&self) -> usize {
        self.triangles.len()
    }

    /// The shape, without corners that no triangle uses.
    pub(super) fn finish(self) -> Shape {
        let mut moved = vec![None; self.corners.len()];
        let mut corners = Vec::new();
        let triangles = self.triangles.iter().map(|triangle| {
            triangle.map(|corner| {
                *moved[corner as usize].get_or_insert_with(|| {
                    corners.push(self.corners[corner as usize]);
                    (corners.len() - 1) as u16
                })
            })
        });
        let triangles = triangles.collect();
        Shape { corners, triangles }
    }
}

/// Goes from 0 at one number to 1 at another, softly at both ends.
pub(super) fn smooth(from: f32, to: f32, at: f32) -> f32 {
    let t = ((at - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// What a place that faces a way looks like: its colour and its sway.
pub(super) type Paint<'a> = &'a dyn Fn(Vec3, Vec3) -> (Colour, f32);

/// Adds a solid turned about an upright line: distances from the line and heights from the top down. A distance of 0 is
/// a point; a place told twice is an edge; three sides are closed at their ends.
pub(super) fn add_turned(
    mesh: &mut Mesh,
    foot: Vec3,
    profile: &[[f32; 2]],
    sides: usize,
    of: Material,
    paint: Paint<'_>,
) {
    let mut above: Vec<u16> = Vec::new();
    let mut turned = false;
    for (i, &[reach, height]) in profile.iter().enumerate() {
        let (before, after) = (
            profile[i.saturating_sub(1)],
            profile[(i + 1).min(profile.len() - 1)],
        );
        let again = i > 0 && before == [reach, height];
        turned ^= !again;
        let slope = [before[1] - after[1], after[0] - before[0]];
        let count = if reach > 0.0 { sides } else { 1 };
        let ring = (0..count).map(|side| {
            let ahead = if turned { 0.5 } else { 0.0 };
            let angle = (side as f32 + ahead) / sides as f32 * std::f32::consts::TAU;
            let out = Vec3::new(angle.cos(), 0.0, angle.sin());
            let upright = if i == 0 { Vec3::Y } else { Vec3::NEG_Y };
            let normal = if count == 1 {
                upright
            } else {
                (out * slope[0] + Vec3::Y * slope[1]).normalize_or(out)
            };
            let closed = sides == 3 && (i == 0 || i + 1 == profile.len());
            let normal = if closed {
                normal + upright * 0.9
            } else {
                normal
            };
            let place = foot + out * reach + Vec3::Y * height;
            let (colour, sway) = paint(place, normal);
            mesh.corner(place, normal, colour, of, sway)
        });
        let ring: Vec<u16> = ring.collect();
        match (above.as_slice(), ring.as_slice()) {
            ([], [a, b, c]) => mesh.triangle(*a, *c, *b),
            ([], _) => {}
            ([point], _) => mesh.close_above(&ring, *point),
            (_, [point]) => mesh.close_below(&above, *point),
            _ if again => {}
            _ => mesh.band(&ring, &above, !turned),
        }
        if let ([a, b, c], true) = (ring.as_slice(), i + 1 == profile.len()) {
            mesh.triangle(*a, *b, *c);
        }
        above = ring;
    }
}

/// The mean colour of a material over the area of a shape, bytes, if it has any.
fn tone(shape: &Shape, of: Material) -> Option<Vec3> {
    let mut sum = Vec3::ZERO;
    let mut area = 0.0;
    for triangle in &shape.triangles {
        let [a, b, c] = triangle.map(|corner| shape.corners[corner as usize]);
        if a.material == of {
            let part = (b.place - a.place).cross(c.place - a.place).length();
            let colour = |corner: Corner| Vec3::from(corner.colour.map(f32::from));
            sum += (colour(a) + colour(b) + colour(c)) / 3.0 * part;
            area += part;
        }
    }
    (area > 0.0).then(|| sum / area)
}

/// Gives each material of a simpler shape the mean colour that it has in a finer one.
pub(super) fn match_tones(fine: &Shape, simple: &mut Shape) {
    for material in [Material::Wood, Material::Leaves, Material::Stone] {
        if let (Some(wanted), Some(is)) = (tone(fine, material), tone(simple, material)) {
            let factor = wanted / is.max(Vec3::ONE);
            for corner in simple
                .corners
                .iter_mut()
                .filter(|corner| corner.material == material)
            {
                let colour = Vec3::from(corner.colour.map(f32::from)) * factor;
                corner.colour =
                    [colour.x, colour.y, colour.z].map(|part| part.round().clamp(0.0, 255.0) as u8);
            }
        }
    }
}
