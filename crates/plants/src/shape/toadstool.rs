//! Toadstools: mushrooms as high as trees.

use glam::Vec3;

use super::mesh::{Colour, Dice, Mesh, add_turned, rgb, smooth};
use super::plan::Build;
use super::trunk::{Limb, add_limb};
use super::{Material, Shape, Size};

/// The cap at its rim and at its top, its pale edge, and its gills at the stem and at the edge.
const CAP: [Colour; 2] = [rgb(112, 34, 84), rgb(186, 70, 118)];
const EDGE: Colour = rgb(232, 198, 196);
const GILLS: [Colour; 2] = [rgb(112, 74, 96), rgb(206, 164, 158)];

/// The shape of a toadstool.
pub(super) fn grow(build: Build, size: Size) -> Shape {
    let mut mesh = Mesh::default();
    let lean = Vec3::new(0.05, 0.0, 0.02) * build.height * build.by_age(0.5, 1.0, 0.8);
    let cap = Cap {
        foot: lean,
        height: build.height,
        radius: build.radius,
        round: build.by_age(0.95, 0.62, 0.5),
    };
    add_stem(&mut mesh, lean, build, size);
    match size {
        Size::Near => cap.add_near(
            &mut mesh,
            build.by_age(7, 9, 12),
            build.by_age(101, 102, 103),
        ),
        Size::Middle => cap.add(
            &mut mesh,
            9,
            &[
                [0.0, 1.02],
                [0.7, 0.8],
                [1.03, 0.22],
                [0.98, 0.03],
                [0.98, 0.03],
                [0.0, 0.24],
            ],
        ),
        Size::Coarse => cap.add(
            &mut mesh,
            6,
            &[[0.0, 1.04], [0.8, 0.74], [1.06, 0.08], [0.0, 0.24]],
        ),
        Size::Far => cap.add(&mut mesh, 3, &[[0.84, 0.94], [1.2, 0.06]]),
    }
    mesh.finish()
}

/// Adds the stem, with a collar where it is seen.
fn add_stem(mesh: &mut Mesh, lean: Vec3, build: Build, size: Size) {
    let mut stem = Limb::trunk(
        lean + Vec3::Y * build.height * 0.82,
        Vec3::X * build.radius * -0.08,
        build.trunk,
        build.by_age(1.6, 1.4, 1.35),
    );
    let last = stem.rings.len() - 1;
    for ring in stem.rings.iter_mut().take(last).skip(3) {
        ring.1 = ring.1.max(build.trunk * 0.78);
    }
    let flesh = |place: Vec3| {
        let up = place.y / build.height;
        let shade = (0.66 + 0.34 * smooth(-0.02, 0.16, up)) * (1.0 - 0.4 * smooth(0.45, 0.8, up));
        rgb(222, 206, 178).lerp(rgb(206, 178, 176), up) * shade
    };
    let sway = |place: Vec3| 0.2 * (place.y / build.height).clamp(0.0, 1.0).powi(2);
    let fewer = Limb {
        rings: [0, 2, last / 2, last - 1, last]
            .map(|i| stem.rings[i])
            .to_vec(),
        ridges: 0.0,
    };
    match size {
        Size::Near => add_limb(mesh, &stem, 9, &flesh, &sway),
        Size::Middle => add_limb(mesh, &fewer.stouter(4), 4, &flesh, &sway),
        Size::Coarse | Size::Far => add_limb(
            mesh,
            &stem
                .coarse(0)
                .stouter(3)
                .ending(lean + Vec3::Y * build.height * 0.95),
            3,
            &flesh,
            &sway,
        ),
    }
    if size == Size::Near {
        let height = build.height * build.by_age(0.34, 0.5, 0.52);
        let wide = build.trunk;
        let profile = [
            [wide * 0.7, wide * 0.5],
            [wide * 1.5, -wide * 0.35],
            [wide * 1.5, -wide * 0.35],
            [wide * 0.7, -wide * 0.1],
        ];
        add_turned(
            mesh,
            stem.at_height(height) + Vec3::ZERO,
            &profile,
            9,
            Material::Wood,
            &|_, normal| (rgb(214, 190, 172) * (0.78 + 0.22 * normal.y), 0.1),
        );
    }
}

/// A cap: its middle line, its top, how far it reaches and its height as a part of that.
struct Cap {
    foot: Vec3,
    height: f32,
    radius: f32,
    round: f32,
}

impl Cap {
    fn deep(&self) -> f32 {
        self.radius * self.round
    }

    /// Adds a cap turned from a profile of parts of its reach and height.
    fn add(&self, mesh: &mut Mesh, sides: usize, profile: &[[f32; 2]]) {
        let low = self.height - self.deep();
        let scaled: Vec<[f32; 2]> = profile
            .iter()
            .map(|[r, y]| [r * self.radius, low + y * self.deep()])
            .collect();
        add_turned(
            mesh,
            self.foot,
            &scaled,
            sides,
            Material::Leaves,
            &|place, normal| self.look(place, normal),
        );
    }

    fn look(&self, place: Vec3, normal: Vec3) -> (Colour, f32) {
        let away =
            Vec3::new(place.x - self.foot.x, 0.0, place.z - self.foot.z).length() / self.radius;
        let up = (place.y - self.height + self.deep()) / self.deep();
        let colour = if normal.y < -0.3 {
            GILLS[0].lerp(GILLS[1], smooth(0.15, 1.0, away))
        } else {
            CAP[0]
                .lerp(CAP[1], smooth(0.15, 1.0, up))
                .lerp(EDGE, 0.85 * smooth(0.2, 0.06, up))
        };
        (colour, 0.15 + 0.15 * away)
    }

    /// The distance of the outside from the middle line at a part of the cap's height.
    fn outside(up: f32) -> f32 {
        (1.0 - ((up - 0.12) / 0.88).max(0.0).powf(1.7))
            .max(0.0)
            .powf(0.62)
    }

    /// Adds the cap with gills and warts.
    fn add_near(&self, mesh: &mut Mesh, warts: usize, seed: u64) {
        let mut profile = vec![[0.0, 1.0]];
        profile.extend([0.95, 0.8, 0.58, 0.32, 0.14].map(|up| [Self::outside(up), up]));
        profile.push([0.985, 0.05]);
        self.add(mesh, 18, &profile);
        self.add_gills(mesh, 18);
        let mut dice = Dice::new(seed);
        for i in 0..warts {
            let up = if i == 0 {
                0.97
            } else {
                0.93 - 0.6 * i as f32 / warts as f32 + dice.between(-0.04, 0.04)
            };
            self.add_wart(
                mesh,
                up,
                i as f32 * 2.4 + dice.between(-0.3, 0.3),
                self.radius * dice.between(0.08, 0.14),
            );
        }
    }

    /// Adds the underside: gills that go up and down about the stem.
    fn add_gills(&self, mesh: &mut Mesh, sides: usize) {
        let low = self.height - self.deep();
        let mut rings = Vec::new();
        for (reach, rise, wave) in [(0.985, 0.05, 0.0), (0.6, 0.1, 0.035), (0.02, 0.22, 0.0)] {
            let ring = (0..2 * sides).map(|i| {
                let angle = (i as f32 / 2.0 + 0.0) / sides as f32 * std::f32::consts::TAU;
                let out = Vec3::new(angle.cos(), 0.0, angle.sin());
                let ridge = if i % 2 == 0 { -1.0 } else { 1.0 };
                let place = self.foot
                    + out * reach * self.radius
                    + Vec3::Y * (low + (rise + wave * ridge) * self.deep());
                let (colour, sway) = self.look(place, Vec3::NEG_Y);
                let tone = if wave > 0.0 { 1.0 - 0.22 * ridge } else { 1.0 };
                mesh.corner(
                    place,
                    out * 0.15 - Vec3::Y,
                    colour * tone,
                    Material::Leaves,
                    sway,
                )
            });
            rings.push(ring.collect::<Vec<u16>>());
        }
        mesh.band(&rings[1], &rings[0], true);
        mesh.band(&rings[2], &rings[1], true);
    }

    /// Adds a pale wart on the outside.
    fn add_wart(&self, mesh: &mut Mesh, up: f32, angle: f32, size: f32) {
        let reach = if up > 0.96 { 0.1 } else { Self::outside(up) };
        let out = Vec3::new(angle.cos(), 0.0, angle.sin());
        let middle = self.foot
            + out * reach * self.radius
            + Vec3::Y * (self.height - self.deep() * (1.0 - up));
        let steep = (Self::outside(up + 0.03) - Self::outside(up - 0.03)) * self.radius
            / (0.06 * self.deep());
        let normal = (out - Vec3::Y * steep).normalize_or(Vec3::Y);
        let (across, along) = normal.any_orthonormal_pair();
        let ring = (0..6).map(|i| {
            let turn = i as f32 / 6.0 * std::f32::consts::TAU;
            let side = across * turn.cos() + along * turn.sin();
            mesh.corner(
                middle + side * size - normal * size * 0.25,
                side * 0.7 + normal,
                EDGE * 0.88,
                Material::Leaves,
                0.2,
            )
        });
        let ring: Vec<u16> = ring.collect();
        let top = mesh.corner(
            middle + normal * size * 0.42,
            normal,
            EDGE,
            Material::Leaves,
            0.2,
        );
        for i in 0..ring.len() {
            mesh.triangle(ring[i], ring[(i + 1) % ring.len()], top);
        }
    }
}
