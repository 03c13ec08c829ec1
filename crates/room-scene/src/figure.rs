//! The figure of who walks, and things that come and go: how they are held, and where and how large they are in the scene.

use antipode_deformation::{Place, Traveller};
use antipode_frame::motion::Doing;
use antipode_frame::{ModelId, Posture};
use antipode_items::Item;
use antipode_rays::{Material, Mesh, Mover};
use antipode_rooms::direction;
use antipode_rooms::mesh::SolidMesh;
use glam::{Affine3A, DAffine3, DMat3, DQuat, DVec2, DVec3, Vec3};

use crate::bodies::{Owner, Solid};
use crate::scene::RoomScene;
use crate::things::{Thing, ThingKind};
use crate::tuning::{DAYLIGHT, STEP_S, THROWN};

/// The number of the mesh of a ball among the meshes that may move.
const BALL: usize = 0;
/// Materials of things, in the order of [`ThingKind`], from this number on.
pub const THINGS_FROM: usize = 1;
/// Materials of what is loose, in its order, from this number on.
pub const LOOSE_FROM: usize = THINGS_FROM + THING_MATERIALS;
const THING_MATERIALS: usize = 4;
/// Rows of the mesh of a ball, and columns.
const ROWS: (u32, u32) = (12, 24);
/// How thick a mark is to its width.
const MARK_THICKNESS: f64 = 0.15;

/// The figure of who walks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoomFigure {
    /// How it is held.
    pub posture: Posture,
    /// What is in its hand.
    pub held: Option<ModelId>,
    /// Whether that flashes.
    pub flashes: bool,
    /// From its own axes (x ahead, y up, z to the right; metres from between its feet) to the scene. It keeps its felt size, so
    /// that it is squeezed by the aberrations that it is in.
    pub pose: Affine3A,
    /// What it is called where it is seen: the number after those of the room's objects.
    pub object: u32,
    /// Whether the eye is in its head, or too near to see it as a whole.
    pub unseen_by_eye: bool,
}

impl RoomScene {
    /// The figure of who walks, at a share of the way of the last step.
    pub fn figure_between(&self, share: f64) -> RoomFigure {
        let (feet, look_deg) = self.feet_between(share);
        let up = self.felt_up(&feet);
        let ahead = direction(DVec2::new(look_deg.x, 0.0)).reject_from_normalized(up);
        let ahead = ahead.normalize_or(up.any_orthonormal_vector());
        let turn = DMat3::from_cols(ahead, up, ahead.cross(up));
        let mut posture = self.motion.posture();
        self.hand.move_arm(&mut posture);
        RoomFigure {
            posture,
            held: Some(Item::Gun.into()),
            flashes: self.hand.flashes(),
            pose: self.felt_pose(&feet, turn),
            object: self.room().objects.len() as u32,
            unseen_by_eye: !self.sees_who_walks(share),
        }
    }

    /// Bullets, marks, balls and lamps that were put down as balls of their felt size, at a share of the way of the last step.
    /// Their numbers as objects come after that of who walks.
    pub fn movers_between(&self, share: f64) -> Vec<Mover> {
        let of = |thing: &Thing| Mover {
            mesh: BALL,
            pose: self.felt_pose(&thing.place, shape_of(thing)),
            object: self.number_of(thing.id),
            materials: THINGS_FROM + thing.kind as usize,
            unseen_by_eye: false,
            held: false,
            cut: None,
        };
        let loose = self.bodies.shown(&self.space, share);
        let loose = loose.iter().filter_map(|it| self.loose_mover(it));
        let all = self.things.shown(&self.space, share);
        all.iter().map(of).chain(loose).collect()
    }

    fn loose_mover(&self, solid: &Solid) -> Option<Mover> {
        let cut = solid
            .cut
            .map(|(n, least)| n.as_vec3().extend(-least as f32));
        let mover = |mesh: usize, pose: DAffine3, object: u32, materials: usize| Mover {
            mesh,
            pose: pose.as_affine3a(),
            object,
            materials,
            unseen_by_eye: false,
            held: false,
            cut,
        };
        match solid.owner {
            Owner::Object(object) => {
                let of_object = |it: &SolidMesh| it.object == object;
                let mesh = self.loose_meshes.iter().position(of_object)?;
                let (pose, number) = (solid.pose, object as u32);
                Some(mover(BALL + 1 + mesh, pose, number, LOOSE_FROM + mesh))
            }
            Owner::Thrown(id) => {
                let radius = DAffine3::from_scale(DVec3::splat(THROWN.radius_m));
                let kind = THINGS_FROM + ThingKind::Ball as usize;
                Some(mover(BALL, solid.pose * radius, self.number_of(id), kind))
            }
            Owner::Walker => None,
        }
    }

    /// What a thing is called where it is seen: the numbers after that of who walks.
    fn number_of(&self, id: u64) -> u32 {
        self.room().objects.len() as u32 + 1 + (id & 0x00ff_ffff) as u32
    }

    /// From the axes of what is at a place to the scene; `felt` takes them to felt metres about it.
    fn felt_pose(&self, place: &Place, felt: DMat3) -> Affine3A {
        let heading = self.walker.body.velocity;
        let k = self.space.carry(place, heading, &Traveller::Body);
        let pose = DAffine3 {
            matrix3: k * felt,
            translation: place.point,
        };
        pose.as_affine3a()
    }

    /// Lets a step pass for how the figure is held; `falls_m_s` is how fast it fell before.
    pub(crate) fn hold_figure(&mut self, falls_m_s: f64) {
        let up = self.up();
        let (ahead, right) = self.look.level(up);
        let velocity = self.walker.body.velocity;
        let grounded = self.walker.grounded;
        let doing = Doing {
            way: DVec2::new(velocity.dot(ahead), velocity.dot(right)),
            rise_m_s: velocity.dot(up),
            grounded,
            impact_m_s: if grounded { falls_m_s.max(0.0) } else { 0.0 },
            holds: true,
            pitch_rad: self.look.pitch_rad,
            ..Doing::default()
        };
        let foot_down = self.motion.pass(&doing, STEP_S);
        self.move_hand();
        self.hear_body(foot_down, falls_m_s, up);
    }
}

/// From a ball of radius 1 to a thing, in felt metres about its middle.
fn shape_of(thing: &Thing) -> DMat3 {
    let turn = match thing.kind {
        ThingKind::Mark => DQuat::from_rotation_arc(DVec3::Y, thing.normal.normalize_or(DVec3::Y)),
        _ => thing.turn,
    };
    let thickness = match thing.kind {
        ThingKind::Mark => MARK_THICKNESS,
        _ => 1.0,
    };
    let size = thing.radius_m * DVec3::new(1.0, thickness, 1.0);
    DMat3::from_quat(turn) * DMat3::from_diagonal(size)
}

/// Materials of things, in the order of [`ThingKind`].
pub fn materials() -> [Material; THING_MATERIALS] {
    let plain = |red: f32, green: f32, blue: f32, gloss: f32| Material {
        colour: Vec3::new(red, green, blue),
        gloss,
        ..Material::default()
    };
    [
        plain(0.55, 0.36, 0.12, 0.8),
        plain(0.03, 0.03, 0.03, 0.0),
        plain(0.75, 0.16, 0.08, 0.3),
        Material {
            glow: Vec3::new(2.2, 1.8, 1.2) * DAYLIGHT,
            ..plain(0.9, 0.85, 0.7, 0.0)
        },
    ]
}

/// A ball of radius 1, half of it in another shade, so that one sees it roll.
pub fn ball() -> Mesh {
    let (rows, columns) = ROWS;
    let mut mesh = Mesh::default();
    for row in 0..=rows {
        let polar = std::f32::consts::PI * row as f32 / rows as f32;
        for column in 0..=columns {
            let around = std::f32::consts::TAU * column as f32 / columns as f32;
            let ring = Vec3::new(around.cos(), 0.0, around.sin()) * polar.sin();
            mesh.positions.push(ring + Vec3::Y * polar.cos());
        }
    }
    mesh.normals.clone_from(&mesh.positions);
    for row in 0..rows {
        for column in 0..columns {
            let a = row * (columns + 1) + column;
            let b = a + columns + 1;
            mesh.triangles.extend([[a, a + 1, b], [b, a + 1, b + 1]]);
            let shade = if (column * 4 / columns).is_multiple_of(2) {
                1.0
            } else {
                0.55
            };
            mesh.colours.extend([Vec3::splat(shade); 2]);
        }
    }
    mesh
}
