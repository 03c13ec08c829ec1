//! Rigid bodies that each have ground of their own, and that meet each other only where they are told to.
//!
//! It is for places where what is near a body is not the same for all, as where a portal leads elsewhere: whoever owns the
//! bodies says, before each step, where each of them is in one common frame, what is solid about it there, and which of them
//! meet. Rapier computes in `f32`. There is no gravity here: who owns the bodies gives them their velocities.

use std::collections::BTreeSet;

use glam::{DQuat, DVec3};
use rapier3d::dynamics::{
    CCDSolver, ImpulseJointSet, IntegrationParameters, IslandManager, MultibodyJointSet, RigidBody,
    RigidBodyBuilder, RigidBodyHandle, RigidBodySet, SoftBodySet,
};
use rapier3d::geometry::{
    BroadPhaseBvh, ColliderBuilder, ColliderHandle, ColliderSet, NarrowPhase, SolverFlags,
};
use rapier3d::math::{Pose, Vector};
use rapier3d::parry::shape::{SharedShape, TriMesh, TriMeshFlags};
use rapier3d::pipeline::{ActiveHooks, PairFilterContext, PhysicsHooks, PhysicsPipeline};

/// Set in the number of a collider that is the ground of a body.
const GROUND: u128 = 1 << 64;

/// The shape of a loose body about its middle, metres of its own size.
#[derive(Clone, Debug, PartialEq)]
pub enum LooseShape {
    /// A block of these half sizes.
    Block(DVec3),
    /// A ball of this radius.
    Ball(f64),
    /// A capsule along y.
    Capsule {
        /// Half its width.
        radius: f64,
        /// Half of the way between the middles of its ends.
        half_height: f64,
    },
    /// A cylinder along y.
    Cylinder {
        /// Half its width.
        radius: f64,
        /// Half its height.
        half_height: f64,
    },
    /// The convex hull of these corners.
    Hull(Vec<DVec3>),
}

/// How a loose body is made.
#[derive(Clone, Debug, PartialEq)]
pub struct LooseBody {
    /// Its shape.
    pub shape: LooseShape,
    /// Its mass at its own size, kilograms; larger it is heavier by the cube.
    pub mass_kg: f64,
    /// Friction, and the share of speed that comes back from a blow, 0 to 1.
    pub friction: f64,
    /// See `friction`.
    pub bounce: f64,
    /// What it loses of its spin, a second.
    pub spin_damping_per_s: f64,
}

/// Where a loose body is and how it moves, in the common frame; metres, seconds and radians.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LooseMotion {
    /// Its middle.
    pub place: DVec3,
    /// How it is turned.
    pub turn: DQuat,
    /// Its velocity.
    pub velocity: DVec3,
    /// Its angular velocity.
    pub spin: DVec3,
}

impl LooseMotion {
    fn is_finite(&self) -> bool {
        let vectors = [self.place, self.velocity, self.spin];
        vectors.iter().all(|it| it.is_finite()) && self.turn.is_finite()
    }
}

/// A blow in the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LooseBlow {
    /// The body.
    pub body: usize,
    /// The other; none for ground.
    pub other: Option<usize>,
    /// N s.
    pub impulse: f64,
}

struct Slot {
    handle: RigidBodyHandle,
    collider: ColliderHandle,
    made: LooseBody,
    scale: f64,
    ground: Vec<ColliderHandle>,
}

/// Loose bodies, by number from 0 in the order in which they were put in.
pub struct LooseBodies {
    slots: Vec<Slot>,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    soft_bodies: SoftBodySet,
    islands: IslandManager,
    joints: ImpulseJointSet,
    multibody_joints: MultibodyJointSet,
    broad_phase: BroadPhaseBvh,
    narrow_phase: NarrowPhase,
    ccd: CCDSolver,
    pipeline: PhysicsPipeline,
}

impl Default for LooseBodies {
    fn default() -> Self {
        Self {
            slots: Vec::new(),
            bodies: RigidBodySet::new(),
            colliders: ColliderSet::new(),
            soft_bodies: SoftBodySet::new(),
            islands: IslandManager::new(),
            joints: ImpulseJointSet::new(),
            multibody_joints: MultibodyJointSet::new(),
            broad_phase: BroadPhaseBvh::new(),
            narrow_phase: NarrowPhase::new(),
            ccd: CCDSolver::new(),
            pipeline: PhysicsPipeline::new(),
        }
    }
}

/// Says who meets whom.
struct Meetings<'a>(&'a BTreeSet<(usize, usize)>);

impl PhysicsHooks for Meetings<'_> {
    fn filter_contact_pair(&self, pair: &PairFilterContext<'_>) -> Option<SolverFlags> {
        let data = [pair.collider1, pair.collider2]
            .map(|it| pair.colliders.get(it).map_or(0, |it| it.user_data));
        let of = |data: u128| (data & !GROUND) as usize;
        let [a, b] = data.map(of);
        let meets = match data.map(|it| it & GROUND != 0) {
            [true, true] => false,
            [false, false] => self.0.contains(&(a.min(b), a.max(b))),
            _ => a == b,
        };
        meets.then_some(SolverFlags::COMPUTE_RIGID_IMPULSES)
    }
}

impl LooseBodies {
    /// Puts a body in, `scale` times as large as its own size; its number.
    pub fn add(&mut self, made: LooseBody, scale: f64, motion: &LooseMotion) -> usize {
        let number = self.slots.len();
        let body = RigidBodyBuilder::dynamic()
            .angular_damping(made.spin_damping_per_s as f32)
            .ccd_enabled(true);
        let handle = self.bodies.insert(body);
        let collider = collider(&made, scale).user_data(number as u128);
        let collider = self
            .colliders
            .insert_with_parent(collider, handle, &mut self.bodies);
        self.slots.push(Slot {
            handle,
            collider,
            made,
            scale,
            ground: Vec::new(),
        });
        self.set_motion(number, motion);
        number
    }

    /// Takes a body out; those after it have the numbers before theirs from now on.
    pub fn remove(&mut self, number: usize) {
        if number >= self.slots.len() {
            return;
        }
        self.set_ground(number, &[], &[]);
        let slot = self.slots.remove(number);
        self.bodies.remove(
            slot.handle,
            &mut self.islands,
            &mut self.colliders,
            &mut self.joints,
            &mut self.multibody_joints,
            &mut self.soft_bodies,
            true,
        );
        for (number, slot) in self.slots.iter().enumerate().skip(number) {
            for (handle, kind) in std::iter::once((slot.collider, 0))
                .chain(slot.ground.iter().map(|it| (*it, GROUND)))
            {
                if let Some(collider) = self.colliders.get_mut(handle) {
                    collider.user_data = number as u128 | kind;
                }
            }
        }
    }

    fn body(&self, number: usize) -> Option<&RigidBody> {
        self.bodies.get(self.slots.get(number)?.handle)
    }

    fn body_mut(&mut self, number: usize) -> Option<&mut RigidBody> {
        self.bodies.get_mut(self.slots.get(number)?.handle)
    }

    /// Puts a body somewhere, and wakes it.
    pub fn set_motion(&mut self, number: usize, motion: &LooseMotion) {
        if let Some(body) = self.body_mut(number) {
            let pose = Pose::from_parts(motion.place.as_vec3(), motion.turn.as_quat());
            body.set_position(pose, true);
            body.set_linvel(motion.velocity.as_vec3(), true);
            body.set_angvel(motion.spin.as_vec3(), true);
        }
    }

    /// Gives a body a velocity, m/s; whether it sleeps stays as it is.
    pub fn set_velocity(&mut self, number: usize, velocity: DVec3) {
        if let Some(body) = self.body_mut(number) {
            body.set_linvel(velocity.as_vec3(), false);
        }
    }

    /// Something weighs on a body at a place, as much as would give it that acceleration, m/s^2, if it were free and struck in its
    /// middle; until it is told otherwise.
    pub fn load(&mut self, number: usize, acceleration: DVec3, at: DVec3) {
        if let Some(body) = self.body_mut(number) {
            body.reset_forces(false);
            body.reset_torques(false);
            if acceleration != DVec3::ZERO {
                let force = acceleration.as_vec3() * body.mass();
                body.add_force_at_point(force, at.as_vec3(), false);
            }
        }
    }

    /// Where a body is and how it moves; nothing where that is no longer a number.
    pub fn motion(&self, number: usize) -> Option<LooseMotion> {
        let body = self.body(number)?;
        let motion = LooseMotion {
            place: body.translation().as_dvec3(),
            turn: body.rotation().as_dquat().normalize(),
            velocity: body.linvel().as_dvec3(),
            spin: body.angvel().as_dvec3(),
        };
        motion.is_finite().then_some(motion)
    }

    /// The energy of its turning, J/kg.
    pub fn turning(&self, number: usize) -> f64 {
        self.body(number).map_or(0.0, |body| {
            let whole = f64::from(body.kinetic_energy() / body.mass());
            (whole - 0.5 * f64::from(body.linvel().length_squared())).max(0.0)
        })
    }

    /// Whether it lies still, and is not computed until something touches or wakes it.
    pub fn sleeps(&self, number: usize) -> bool {
        self.body(number).is_some_and(RigidBody::is_sleeping)
    }

    /// Wakes it.
    pub fn wake(&mut self, number: usize) {
        if let Some(body) = self.body_mut(number) {
            body.wake_up(true);
        }
    }

    /// Makes a body so many times as large as its own size.
    pub fn resize(&mut self, number: usize, scale: f64) {
        let Some(slot) = self.slots.get_mut(number) else {
            return;
        };
        if (slot.scale - scale).abs() <= 1e-9 * scale {
            return;
        }
        slot.scale = scale;
        let like = collider(&slot.made, scale).build();
        if let Some(collider) = self.colliders.get_mut(slot.collider) {
            collider.set_shape(like.shared_shape().clone());
            collider.set_mass(mass(&slot.made, scale));
        }
        self.wake(number);
    }

    /// Says what is solid about a body and only to it, in place of what was said before: triangles of the common frame that
    /// are solid from the side from which they run anticlockwise, and such that are from both.
    pub fn set_ground(&mut self, number: usize, solids: &[[DVec3; 3]], walls: &[[DVec3; 3]]) {
        let Some(slot) = self.slots.get_mut(number) else {
            return;
        };
        for handle in slot.ground.drain(..) {
            self.colliders.remove(
                handle,
                &mut self.islands,
                &mut self.bodies,
                &mut self.soft_bodies,
                false,
            );
        }
        let kinds = [
            (solids, TriMeshFlags::FIX_INTERNAL_EDGES),
            (walls, TriMeshFlags::FIX_INTERNAL_EDGES_TWO_SIDED),
        ];
        for (triangles, flags) in kinds {
            let Some(mesh) = mesh(triangles, flags) else {
                continue;
            };
            let ground = ColliderBuilder::new(SharedShape::new(mesh))
                .active_hooks(ActiveHooks::FILTER_CONTACT_PAIRS)
                .friction(slot.made.friction as f32)
                .restitution(slot.made.bounce as f32)
                .user_data(number as u128 | GROUND);
            slot.ground.push(self.colliders.insert(ground));
        }
    }

    /// Advances all bodies by `time` seconds; of two only those meet whose numbers, the lower first, are in the list.
    pub fn step(&mut self, time: f64, meetings: &BTreeSet<(usize, usize)>) {
        let parameters = IntegrationParameters {
            dt: time as f32,
            ..IntegrationParameters::default()
        };
        self.pipeline.step(
            Vector::ZERO,
            &parameters,
            &mut self.islands,
            &mut self.broad_phase,
            &mut self.narrow_phase,
            &mut self.bodies,
            &mut self.colliders,
            &mut self.joints,
            &mut self.multibody_joints,
            &mut self.soft_bodies,
            &mut self.ccd,
            &Meetings(meetings),
            &(),
        );
    }

    /// What struck what in the last step; also what lies on something presses on it.
    pub fn blows(&self) -> Vec<LooseBlow> {
        let number = |it: ColliderHandle| self.colliders.get(it).map_or(GROUND, |it| it.user_data);
        let pairs = self.narrow_phase.contact_pairs();
        let touching = pairs.filter(|it| it.has_any_active_contact());
        let blow = |pair: &rapier3d::geometry::ContactPair| {
            let (a, b) = (number(pair.collider1), number(pair.collider2));
            let (body, other) = if a & GROUND == 0 { (a, b) } else { (b, a) };
            LooseBlow {
                body: body as usize,
                other: (other & GROUND == 0).then_some(other as usize),
                impulse: f64::from(pair.total_impulse_magnitude()),
            }
        };
        touching.map(blow).collect()
    }
}

fn mass(made: &LooseBody, scale: f64) -> f32 {
    (made.mass_kg * scale.powi(3)).clamp(1e-6, 1e12) as f32
}

fn collider(made: &LooseBody, scale: f64) -> ColliderBuilder {
    let long = |length: f64| (length * scale) as f32;
    let builder = match &made.shape {
        LooseShape::Block(half) => {
            ColliderBuilder::cuboid(long(half.x), long(half.y), long(half.z))
        }
        LooseShape::Ball(radius) => ColliderBuilder::ball(long(*radius)),
        LooseShape::Capsule {
            radius,
            half_height,
        } => ColliderBuilder::capsule_y(long(*half_height), long(*radius)),
        LooseShape::Cylinder {
            radius,
            half_height,
        } => ColliderBuilder::cylinder(long(*half_height), long(*radius)),
        LooseShape::Hull(corners) => {
            let corners: Vec<Vector> = corners.iter().map(|it| (*it * scale).as_vec3()).collect();
            ColliderBuilder::convex_hull(&corners)
                .unwrap_or_else(|| ColliderBuilder::ball(long(0.1)))
        }
    };
    builder
        .active_hooks(ActiveHooks::FILTER_CONTACT_PAIRS)
        .friction(made.friction as f32)
        .restitution(made.bounce as f32)
        .mass(mass(made, scale))
}

/// Triangles that have an area, as Rapier takes them.
fn mesh(triangles: &[[DVec3; 3]], flags: TriMeshFlags) -> Option<TriMesh> {
    let is_whole = |it: &&[DVec3; 3]| (it[1] - it[0]).cross(it[2] - it[0]).length() > 1e-12;
    let corners: Vec<Vector> = triangles
        .iter()
        .filter(is_whole)
        .flatten()
        .copied()
        .map(DVec3::as_vec3)
        .collect();
    let numbers = (0..corners.len() as u32 / 3).map(|it| [3 * it, 3 * it + 1, 3 * it + 2]);
    let flags = flags | TriMeshFlags::DELETE_DEGENERATE_TRIANGLES;
    TriMesh::with_flags(corners, numbers.collect(), flags).ok()
}
