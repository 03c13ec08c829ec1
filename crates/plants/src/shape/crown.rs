//! Crowns: lumps of leaves that merge, and simpler hulls about them.

use std::f32::consts::{PI, TAU};

use glam::Vec3;

use super::Material;
use super::mesh::{Colour, Dice, Mesh, smooth};

/// A lump of leaves: an ellipsoid.
#[derive(Clone, Copy)]
pub(super) struct Clump {
    /// Its middle, metres.
    pub centre: Vec3,
    /// Its half axes, metres.
    pub radii: Vec3,
    /// Which hull it belongs to from farther off.
    pub group: u8,
    /// How far it narrows towards its lower end, from 0 to 1.
    pub taper: f32,
}

impl Clump {
    /// How many rings it takes that no edge is much longer than a metre and a half upward.
    fn rings(&self, least: usize) -> usize {
        let fits =
            |rings: usize| self.radii.y * 2.0 * (PI / (2.0 * (rings as f32 + 1.0))).sin() < 1.78;
        (least..9).find(|&rings| fits(rings)).unwrap_or(9)
    }

    /// The distance of a place from the middle, where 1 is the surface.
    fn depth(&self, place: Vec3) -> f32 {
        ((place - self.centre) / self.radii).length()
    }

    /// How far a ray from a place goes until it leaves the clump for good, if it meets it.
    fn exit(&self, from: Vec3, direction: Vec3) -> Option<f32> {
        let (o, d) = ((from - self.centre) / self.radii, direction / self.radii);
        let (a, b, c) = (d.dot(d), o.dot(d), o.dot(o) - 1.0);
        let under = b * b - a * c;
        (under >= 0.0)
            .then(|| (-b + under.sqrt()) / a)
            .filter(|&far| far > 0.0)
    }
}

/// How much lighter or darker a hull is in a direction, where lumps would be.
fn mottle(direction: Vec3) -> f32 {
    1.0 + 0.1 * (direction.x * 5.0 + 1.0).sin() * (direction.z * 5.0 + 2.0).sin()
        + 0.06 * (direction.y * 9.0).sin()
}

/// Lumps that make up one crown, with the colours from its shaded inside to its lit top.
pub(super) struct Crown {
    /// The lumps.
    pub clumps: Vec<Clump>,
    /// Colours: in the shade, between and in the light.
    pub palette: [Colour; 3],
    /// How uneven each lump is, as a part of its radius.
    pub uneven: f32,
    /// How far wind moves the lower ends.
    pub hanging: bool,
}

impl Crown {
    /// The smallest and the largest of each coordinate.
    pub(super) fn limits(&self) -> [Vec3; 2] {
        let start = [Vec3::INFINITY, Vec3::NEG_INFINITY];
        self.clumps.iter().fold(start, |[low, high], clump| {
            [
                low.min(clump.centre - clump.radii),
                high.max(clump.centre + clump.radii),
            ]
        })
    }

    /// The middle of the whole.
    pub(super) fn centre(&self) -> Vec3 {
        let [low, high] = self.limits();
        (low + high) / 2.0
    }

    /// The colour of a place that faces a way: lighter at the top and outside, darker where other lumps are close.
    fn colour(&self, place: Vec3, normal: Vec3, radius: f32, own: Option<usize>) -> Colour {
        let [low, high] = self.limits();
        let height = (place.y - low.y) / (high.y - low.y);
        let outside = ((place - self.centre()) / ((high - low) / 2.0))
            .length()
            .min(1.0);
        let before = place + normal * radius * 0.25;
        let others = self
            .clumps
            .iter()
            .enumerate()
            .filter(|&(i, _)| Some(i) != own);
        let shade: f32 = others
            .map(|(_, clump)| smooth(1.3, 0.75, clump.depth(before)))
            .sum();
        let light =
            0.42 * height + 0.2 * outside + 0.38 * (normal.y * 0.5 + 0.5) - 0.3 * shade.min(1.4);
        let light = (light * 1.15).clamp(0.0, 1.0);
        let [dark, middle, bright] = self.palette;
        if light < 0.5 {
            dark.lerp(middle, light * 2.0)
        } else {
            middle.lerp(bright, light * 2.0 - 1.0)
        }
    }

    /// The look of a place of the crown as one whole.
    pub(super) fn far_look(&self, place: Vec3, normal: Vec3) -> (Colour, f32) {
        (self.colour(place, normal, 0.5, None), self.sway(place))
    }

    /// How far wind moves a place.
    fn sway(&self, place: Vec3) -> f32 {
        let [low, high] = self.limits();
        let height = (place.y / high.y).clamp(0.0, 1.0);
        let middle = self.centre();
        let out = Vec3::new(place.x - middle.x, 0.0, place.z - middle.z).length()
            / (high.x - low.x).max(0.01);
        if self.hanging {
            0.25 + 0.6 * out
        } else {
            height * (0.3 + 0.5 * out)
        }
    }

    /// Stretches all lumps to a height and a reach from the upright line through the root, metres.
    pub(super) fn fit(&mut self, height: f32, radius: f32) {
        let reach =
            |clump: &Clump| clump.centre.x.hypot(clump.centre.z) + clump.radii.x.max(clump.radii.z);
        let wide = self.clumps.iter().map(reach).fold(0.01, f32::max);
        let factor = Vec3::new(radius / wide, height / self.limits()[1].y, radius / wide);
        for clump in &mut self.clumps {
            clump.centre *= factor;
            clump.radii *= factor;
        }
    }

    /// Adds each lump as a solid of so many sides and at least so many rings, without what lies inside other lumps.
    pub(super) fn add_clumps(&self, mesh: &mut Mesh, sides: usize, rings: usize, dice: &mut Dice) {
        for (own, clump) in self.clumps.iter().enumerate() {
            let from = mesh.count();
            let sides = if clump.taper > 0.0 {
                sides.clamp(5, 6)
            } else {
                sides
            };
            self.add_clump(mesh, own, sides, clump.rings(rings), dice);
            let inside = |other: &Clump, place: Vec3| {
                other.taper == 0.0 && other.depth(place) < 0.86 - self.uneven * 0.5
            };
            mesh.thin(from, |places| {
                let mut others = self.clumps.iter().enumerate().filter(|&(i, _)| i != own);
                others.any(|(_, other)| places.iter().all(|&place| inside(other, place)))
            });
        }
    }

    fn add_clump(&self, mesh: &mut Mesh, own: usize, sides: usize, rings: usize, dice: &mut Dice) {
        let clump = self.clumps[own];
        let hue = Vec3::new(
            dice.between(-0.022, 0.028),
            dice.between(-0.02, 0.022),
            dice.between(-0.02, 0.012),
        );
        let turn = dice.between(0.0, TAU);
        let middle = self.centre();
        let put = |mesh: &mut Mesh, polar: f32, angle: f32, dice: &mut Dice| {
            let unit = Vec3::new(
                polar.sin() * angle.cos(),
                polar.cos(),
                polar.sin() * angle.sin(),
            );
            let lump = 1.0 + self.uneven * dice.between(-1.0, 1.0);
            let narrow = 1.0 - clump.taper * (-unit.y).max(0.0);
            let place = clump.centre + unit * clump.radii * lump * Vec3::new(narrow, 1.0, narrow);
            let own_normal = (unit / clump.radii).normalize_or(unit);
            let normal = own_normal * 0.62 + (place - middle).normalize_or(Vec3::Y) * 0.38;
            let colour = self.colour(place, own_normal, clump.radii.min_element(), Some(own)) + hue;
            mesh.corner(place, normal, colour, Material::Leaves, self.sway(place))
        };
        let top = put(mesh, 0.0, 0.0, dice);
        let mut above: Vec<u16> = Vec::new();
        for ring in 0..rings {
            let polar = (ring as f32 + 1.0) / (rings as f32 + 1.0) * PI;
            let ahead = if ring % 2 == 1 { 0.5 } else { 0.0 };
            let angle = |side: usize| turn + (side as f32 + ahead) / sides as f32 * TAU;
            let corners: Vec<u16> = (0..sides)
                .map(|side| put(mesh, polar, angle(side), dice))
                .collect();
            if ring == 0 {
                mesh.close_above(&corners, top);
            } else {
                mesh.band(&corners, &above, ring % 2 == 0);
            }
            above = corners;
        }
        let bottom = put(mesh, PI, 0.0, dice);
        mesh.close_below(&above, bottom);
    }

    /// How far it is from the middle to where a ray leaves the lumps for good, softened by its neighbours.
    fn reach(&self, middle: Vec3, unit: Vec3, half: Vec3) -> f32 {
        let (across, along) = unit.any_orthonormal_pair();
        let asides = [
            Vec3::ZERO,
            across,
            -across,
            along,
            -along,
            across + along,
            -across - along,
        ];
        let reaches = asides.map(|aside| {
            let direction = ((unit + aside * 0.22) * half).normalize_or(unit);
            self.clumps
                .iter()
                .filter_map(|clump| clump.exit(middle, direction))
                .fold(0.0, f32::max)
        });
        let met = reaches.into_iter().filter(|&reach| reach > 0.0);
        let (sum, count) = met.fold((0.0, 0.0), |(sum, count), reach| (sum + reach, count + 1.0));
        if count > 0.0 {
            sum / count
        } else {
            half.min_element() * 0.5
        }
    }

    /// Adds one hull about the lumps of a group, or about all: so many sides and rings, each corner where a ray from
    /// the middle leaves the lumps for good, and so much farther out.
    pub(super) fn add_hull(
        &self,
        mesh: &mut Mesh,
        group: Option<u8>,
        sides: usize,
        rings: usize,
        wider: Vec3,
    ) {
        let clumps = self
            .clumps
            .iter()
            .filter(|clump| group.is_none_or(|group| clump.group == group));
        let part = Self {
            clumps: clumps.copied().collect(),
            palette: self.palette,
            uneven: 0.0,
            hanging: self.hanging,
        };
        let (middle, [low, high]) = (part.centre(), part.limits());
        let half = (high - low) / 2.0;
        let put = |mesh: &mut Mesh, polar: f32, angle: f32| {
            let unit = Vec3::new(
                polar.sin() * angle.cos(),
                polar.cos(),
                polar.sin() * angle.sin(),
            );
            let direction = (unit * half).normalize_or(unit);
            let reach = part.reach(middle, unit, half);
            let place = middle + direction * reach * wider;
            let normal = (unit / half).normalize_or(unit);
            let colour = self.colour(place, normal, half.min_element(), None) * mottle(direction);
            mesh.corner(place, normal, colour, Material::Leaves, self.sway(place))
        };
        let top = put(mesh, 0.0, 0.0);
        let mut above: Vec<u16> = Vec::new();
        for ring in 0..rings {
            let polar = (ring as f32 + 1.0) / (rings as f32 + 1.0) * PI;
            let ahead = if ring % 2 == 1 { 0.5 } else { 0.0 };
            let corners =
                (0..sides).map(|side| put(mesh, polar, (side as f32 + ahead) / sides as f32 * TAU));
            let corners: Vec<u16> = corners.collect();
            if ring == 0 {
                mesh.close_above(&corners, top);
            } else {
                mesh.band(&corners, &above, ring % 2 == 0);
            }
            above = corners;
        }
        let bottom = put(mesh, PI, 0.0);
        mesh.close_below(&above, bottom);
    }
}
