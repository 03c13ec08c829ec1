//! Trees of a trunk, branches and a crown of lumps.

use glam::Vec3;

use super::crown::Crown;
use super::mesh::{Colour, Dice, Mesh, add_turned, smooth};
use super::trunk::{Limb, add_limb};
use super::{Material, Shape, Size};

/// The most triangles of a shape close by.
const NEAR: usize = 600;

/// How bark looks.
#[derive(Clone)]
pub(super) struct Bark {
    /// Low down, and high up.
    pub colours: [Colour; 2],
    /// Colour and heights of dark bands.
    pub bands: (Colour, Vec<f32>),
}

impl Bark {
    /// Bark without bands.
    pub(super) fn plain(low: Colour, high: Colour) -> Self {
        Self {
            colours: [low, high],
            bands: (low, Vec::new()),
        }
    }

    /// The colour at a place of a trunk under a crown that begins at a height.
    fn colour(&self, place: Vec3, crown: [Vec3; 2]) -> Colour {
        let up = smooth(0.0, crown[0].y.max(1.0) * 1.3, place.y);
        let angle = place.z.atan2(place.x);
        let streak = 1.0 + 0.06 * (angle * 3.0 + place.y * 1.7).sin();
        let under = 1.0
            - 0.38
                * smooth(
                    crown[0].y - 0.6,
                    crown[0].y * 0.65 + crown[1].y * 0.35,
                    place.y,
                );
        let foot = 0.72 + 0.28 * smooth(-0.1, 0.6, place.y);
        let colour = self.colours[0].lerp(self.colours[1], up) * streak * foot * under;
        let dark = self.bands.1.iter().enumerate().any(|(i, &band)| {
            (place.y - band).abs() < 0.03 && (angle + i as f32 * 2.1).sin() > -0.45
        });
        if dark { self.bands.0 } else { colour }
    }
}

/// A plan of a tree, from which it is made in any size.
pub(super) struct Tree {
    /// The trunk, if it has one.
    pub trunk: Option<Limb>,
    /// Limbs that start at the trunk.
    pub branches: Vec<Limb>,
    /// How many of the branches are seen from farther off.
    pub bold: usize,
    /// What the trunk and the branches are covered with.
    pub bark: Bark,
    /// The leaves.
    pub crown: Crown,
    /// Hulls about groups of lumps from farther off: sides and rings of each.
    pub hulls: Vec<[usize; 2]>,
    /// How much higher hulls are than the lumps, so that they hide as much.
    pub deep: f32,
    /// The crown from farther off, where hulls don't show it well: sides, and a profile like that from far off.
    pub turned: Option<(usize, Vec<[f32; 2]>)>,
    /// The crown from far off: its sides, and distances from its middle line as parts of the reach with heights as
    /// parts of the height, from the top down.
    pub far: (usize, Vec<[f32; 2]>),
    /// What its dice fall by.
    pub seed: u64,
}

impl Tree {
    /// The shape in a size.
    pub(super) fn shape(&self, size: Size) -> Shape {
        match size {
            Size::Near => self.near(),
            Size::Middle => self.middle(),
            Size::Coarse => self.coarse(),
            Size::Far => self.far(),
        }
    }

    fn add_wood(&self, mesh: &mut Mesh, limb: &Limb, sides: usize) {
        let limits = self.crown.limits();
        let colour = |place: Vec3| self.bark.colour(place, limits);
        let sway = |place: Vec3| 0.3 * (place.y / limits[1].y).clamp(0.0, 1.0).powi(2);
        add_limb(mesh, limb, sides, &colour, &sway);
    }

    fn near(&self) -> Shape {
        let details = [
            [12, 5],
            [11, 4],
            [10, 4],
            [9, 4],
            [8, 4],
            [9, 3],
            [8, 3],
            [7, 3],
            [6, 3],
            [5, 3],
            [5, 2],
            [4, 2],
        ];
        let mut best = Mesh::default();
        for [sides, rings] in details {
            let mut mesh = Mesh::default();
            if let Some(trunk) = &self.trunk {
                self.add_wood(
                    &mut mesh,
                    trunk,
                    if self.bark.bands.1.is_empty() { 6 } else { 5 },
                );
            }
            for branch in &self.branches {
                self.add_wood(&mut mesh, branch, 4);
            }
            self.crown
                .add_clumps(&mut mesh, sides, rings, &mut Dice::new(self.seed));
            best = mesh;
            if best.count() <= NEAR {
                break;
            }
        }
        best.finish()
    }

    fn middle(&self) -> Shape {
        let mut mesh = Mesh::default();
        if let Some(trunk) = &self.trunk {
            self.add_wood(&mut mesh, &trunk.coarse(1).stouter(4), 4);
        }
        for branch in self.branches.iter().take(self.bold) {
            self.add_wood(&mut mesh, &branch.coarse(0).stouter(3), 3);
        }
        if let Some((sides, profile)) = &self.turned {
            self.add_turned(&mut mesh, *sides, profile);
            return mesh.finish();
        }
        for (group, &[sides, rings]) in self.hulls.iter().enumerate() {
            self.crown.add_hull(
                &mut mesh,
                Some(group as u8),
                sides,
                rings,
                Vec3::new(1.08, self.deep, 1.08),
            );
        }
        mesh.finish()
    }

    fn coarse(&self) -> Shape {
        let mut mesh = Mesh::default();
        self.add_spike(&mut mesh);
        if let Some((_, profile)) = &self.turned {
            self.add_turned(&mut mesh, 5, profile);
            return mesh.finish();
        }
        let [sides, rings] = if self.hulls.len() > 1 { [5, 1] } else { [6, 2] };
        for group in 0..self.hulls.len() {
            let wider = Vec3::new(1.12, self.deep, 1.12);
            self.crown
                .add_hull(&mut mesh, Some(group as u8), sides, rings, wider);
        }
        mesh.finish()
    }

    fn far(&self) -> Shape {
        let mut mesh = Mesh::default();
        let (sides, profile) = &self.far;
        self.add_turned(&mut mesh, *sides, profile);
        if mesh.count() < 10 {
            self.add_spike(&mut mesh);
        }
        mesh.finish()
    }

    /// Adds the trunk as one that tapers to its end within the crown.
    fn add_spike(&self, mesh: &mut Mesh) {
        let middle = self.crown.centre();
        let end = middle.midpoint(middle.with_y(self.crown.limits()[1].y));
        if let Some(trunk) = &self.trunk {
            self.add_wood(mesh, &trunk.coarse(0).stouter(3).ending(end), 3);
        }
    }

    /// Adds a crown that is turned about its middle line.
    fn add_turned(&self, mesh: &mut Mesh, sides: usize, profile: &[[f32; 2]]) {
        let [low, high] = self.crown.limits();
        let reach = (high.x - low.x + high.z - low.z) / 4.0;
        let foot = (low + high) / 2.0 * Vec3::new(1.0, 0.0, 1.0);
        let profile: Vec<_> = profile
            .iter()
            .map(|[r, y]| [r * reach, y * high.y])
            .collect();
        let paint = |place: Vec3, normal: Vec3| self.crown.far_look(place, normal);
        add_turned(mesh, foot, &profile, sides, Material::Leaves, &paint);
    }
}
