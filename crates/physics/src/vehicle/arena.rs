//! The arena in which the vehicles of one chart collide: Rapier's bodies and the few blocks of ground around them.
//!
//! The world's terrain is never stepped. Each step takes the blocks near a moving body into a small set of its own,
//! which shares their meshes, so that a step costs the same however much land is loaded, and what Rapier notes of
//! changes is read by the step that follows.

use std::collections::BTreeMap;

use antipode_geometry::ChartId;
use glam::{DQuat, DVec3};
use rapier3d::control::DynamicRayCastVehicleController;
use rapier3d::dynamics::{
    CCDSolver, ImpulseJointSet, IntegrationParameters, IslandManager, MassProperties,
    MultibodyJointSet, RigidBodyBuilder, RigidBodyHandle, RigidBodySet, RigidBodyType, SoftBodySet,
};
use rapier3d::geometry::{
    BroadPhaseBvh, ColliderBuilder, ColliderHandle, ColliderSet, NarrowPhase,
};
use rapier3d::math::{Pose, Vector};
use rapier3d::parry::shape::SharedShape;
use rapier3d::pipeline::{PhysicsPipeline, QueryFilter};

use super::doors::Junction;
use super::hull::Hull;
use super::laid::{Laid, Want, sill_about};
use super::needed::{BlockName, Lie, Needed};
use super::role::{Earth, JUNCTIONS, Role};
use super::sill::Sill;
use super::site::Site;
use super::{VehicleMotion, VehicleTuning};
use crate::PhysicsWorld;
use crate::collider::Block;

/// The frame moves when a vehicle is farther than this from its origin along an axis, in metres.
const RECENTRE_BEYOND_M: f64 = 512.0;
/// Its origin is a multiple of this, in metres, so that offsets of chunks stay whole numbers.
const ORIGIN_STEP_M: f64 = 32.0;

/// A block that was taken in.
struct Taken {
    lie: Lie,
    block: Block,
    handle: ColliderHandle,
}

/// The ground of both sides of a door, as it was put in.
struct LaidSill {
    sill: Sill,
    handle: Option<ColliderHandle>,
}

/// Bodies, ground and what Rapier needs to step them.
pub(super) struct Arena {
    chart: ChartId,
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
    ground: BTreeMap<BlockName, Taken>,
    sills: [Option<LaidSill>; JUNCTIONS],
    origin: DVec3,
    /// Where it lies if it is not the chart itself, and its ground then.
    site: Option<Site>,
    laid: Option<(Laid, Vec<ColliderHandle>)>,
}

impl Arena {
    /// Without bodies and ground, about the centre of a chart.
    pub fn new(chart: ChartId) -> Self {
        Self {
            chart,
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
            ground: BTreeMap::new(),
            sills: Default::default(),
            origin: DVec3::ZERO,
            site: None,
            laid: None,
        }
    }

    /// Without bodies and ground, about a site.
    pub fn about(site: Site) -> Self {
        let mut arena = Self::new(site.at().chart);
        arena.site = Some(site);
        arena
    }

    /// Where it lies, if that is not the chart.
    pub fn site(&self) -> Option<&Site> {
        self.site.as_ref()
    }

    /// Has it lie elsewhere, without ground. Bodies keep their numbers, which are no longer right.
    pub fn set_site(&mut self, site: Site) {
        for handle in self.laid.take().into_iter().flat_map(|(_, all)| all) {
            self.take_up(handle);
        }
        for at in 0..JUNCTIONS {
            let handle = self.sills[at].take().and_then(|it| it.handle);
            if let Some(handle) = handle {
                self.take_up(handle);
            }
        }
        self.chart = site.at().chart;
        self.site = Some(site);
    }

    /// Whether the ground about the site is all that is wanted, and as the world has it.
    pub fn is_laid(&mut self, world: &PhysicsWorld, needs: &[(Want, DVec3)]) -> bool {
        let laid = self.laid.as_mut();
        laid.is_some_and(|(laid, _)| laid.is_enough(world, needs))
    }

    /// Lays the ground that is wanted about the site.
    pub fn lay_about(
        &mut self,
        world: &PhysicsWorld,
        needs: &[(Want, DVec3)],
        junctions: &[Option<Junction>; JUNCTIONS],
    ) {
        let Some(site) = &self.site else {
            return;
        };
        let (laid, shapes) = Laid::made(world, site, needs, junctions);
        let lie = (DVec3::ZERO, 0.0);
        let handles = shapes.iter().map(|(earth, it)| self.lay(it, lie, *earth));
        let handles = handles.collect();
        self.laid = Some((laid, handles));
    }

    /// Lays the ground of both sides of the junctions that somebody stands in.
    pub fn take_sills(
        &mut self,
        world: &PhysicsWorld,
        junctions: &[Option<Junction>; JUNCTIONS],
        is_stood_in: impl Fn(usize) -> bool,
    ) {
        for (at, junction) in junctions.iter().enumerate() {
            let stood_in = junction.as_ref().filter(|_| is_stood_in(at));
            self.take_sill(world, at, stood_in);
        }
    }

    /// Whether no vehicle has a body there.
    pub fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }

    /// Puts a body in.
    pub fn put_in(
        &mut self,
        hull: &Hull,
        tuning: &VehicleTuning,
        motion: &VehicleMotion,
    ) -> RigidBodyHandle {
        let size = tuning.inertia_box_m;
        let about = |a: f64, b: f64| tuning.mass_kg / 12.0 * (a * a + b * b);
        let inertia = DVec3::new(
            about(size.y, size.z),
            about(size.x, size.z),
            about(size.x, size.y),
        );
        let mass = MassProperties::new(
            tuning.mass_centre.as_vec3(),
            tuning.mass_kg as f32,
            inertia.as_vec3(),
        );
        let body = RigidBodyBuilder::dynamic()
            .additional_mass_properties(mass)
            .angular_damping(tuning.spin_damping_per_s as f32)
            .can_sleep(false)
            .ccd_enabled(true);
        let handle = self.bodies.insert(body);
        let collider = ColliderBuilder::new(hull.shape.clone())
            .density(0.0)
            .collision_groups(Role::Free.groups())
            .friction(tuning.body_friction as f32);
        self.colliders
            .insert_with_parent(collider, handle, &mut self.bodies);
        self.set_motion(handle, motion);
        handle
    }

    /// Removes a body with its hull.
    pub fn take_out(&mut self, body: RigidBodyHandle) {
        self.bodies.remove(
            body,
            &mut self.islands,
            &mut self.colliders,
            &mut self.joints,
            &mut self.multibody_joints,
            &mut self.soft_bodies,
            true,
        );
    }

    /// Puts a body somewhere in the chart, and lets it move as it is told.
    pub fn set_motion(&mut self, body: RigidBodyHandle, motion: &VehicleMotion) {
        let at = (motion.place - self.origin).as_vec3();
        if let Some(body) = self.bodies.get_mut(body) {
            body.set_position(Pose::from_parts(at, motion.turn.as_quat()), true);
            body.set_linvel(motion.velocity.as_vec3(), true);
            body.set_angvel(motion.spin.as_vec3(), true);
        }
    }

    /// Where a body is and how it moves; nothing where that is no longer a number.
    pub fn motion(&self, body: RigidBodyHandle) -> Option<VehicleMotion> {
        let body = self.bodies.get(body)?;
        let place = body.translation().as_dvec3() + self.origin;
        let motion = VehicleMotion {
            chart: self.chart,
            place,
            turn: body.rotation().as_dquat().normalize(),
            velocity: body.linvel().as_dvec3(),
            spin: body.angvel().as_dvec3(),
        };
        motion.is_finite().then_some(motion)
    }

    /// Whether a body stands still whatever runs into it.
    pub fn set_still(&mut self, body: RigidBodyHandle, still: bool) {
        let kind = if still {
            RigidBodyType::Fixed
        } else {
            RigidBodyType::Dynamic
        };
        if let Some(body) = self.bodies.get_mut(body)
            && body.body_type() != kind
        {
            body.set_body_type(kind, true);
        }
    }

    /// Says what a body meets.
    pub fn set_role(&mut self, body: RigidBodyHandle, role: Role) {
        let colliders = self.bodies.get(body).map(|it| it.colliders().to_vec());
        for handle in colliders.into_iter().flatten() {
            let groups = role.groups();
            let collider = self.colliders.get(handle);
            if collider.is_some_and(|it| it.collision_groups() != groups)
                && let Some(collider) = self.colliders.get_mut(handle)
            {
                collider.set_collision_groups(groups);
            }
        }
    }

    /// Strikes a body at a place of the chart with an impulse in N s.
    pub fn push(&mut self, body: RigidBodyHandle, at: DVec3, impulse: DVec3) {
        let at = (at - self.origin).as_vec3();
        if let Some(body) = self.bodies.get_mut(body) {
            body.apply_impulse_at_point(impulse.as_vec3(), at, true);
        }
    }

    /// Keeps the numbers small that Rapier computes with: its `f32` positions are near `focus`.
    pub fn recentre(&mut self, focus: DVec3) {
        if !focus.is_finite() || (focus - self.origin).abs().max_element() <= RECENTRE_BEYOND_M {
            return;
        }
        let before = self.origin;
        self.origin = (focus / ORIGIN_STEP_M).round() * ORIGIN_STEP_M;
        let shift = (before - self.origin).as_vec3();
        for (_, body) in self.bodies.iter_mut() {
            let moved = body.translation() + shift;
            body.set_translation(moved, false);
        }
        for taken in self.ground.values() {
            if let Some(collider) = self.colliders.get_mut(taken.handle) {
                collider.set_translation((taken.lie.0 - self.origin).as_vec3());
            }
        }
        for handle in self.sills.iter().flatten().filter_map(|it| it.handle) {
            if let Some(collider) = self.colliders.get_mut(handle) {
                let moved = collider.translation() + shift;
                collider.set_translation(moved);
            }
        }
    }

    /// Takes in the ground that is needed, and lets go of the rest.
    pub fn take_ground(&mut self, world: &PhysicsWorld, needed: &Needed) {
        let wanted = needed.blocks(world, self.chart);
        let gone: Vec<BlockName> = self
            .ground
            .iter()
            .filter(|(name, taken)| {
                !wanted
                    .get(name)
                    .is_some_and(|(lie, block)| *lie == taken.lie && taken.block.is_like(block))
            })
            .map(|(name, _)| *name)
            .collect();
        for name in gone {
            if let Some(taken) = self.ground.remove(&name) {
                self.take_up(taken.handle);
            }
        }
        for (name, (lie, block)) in wanted {
            if self.ground.contains_key(&name) {
                continue;
            }
            let handle = self.lay(&block.shape, lie, name.0);
            let block = block.clone();
            self.ground.insert(name, Taken { lie, block, handle });
        }
        for (at, junction) in needed.junctions.iter().enumerate() {
            let stood_in = junction.as_ref().filter(|it| it.is_stood_in);
            self.take_sill(world, at, stood_in.map(|it| &it.junction));
        }
    }

    /// Lays the ground of both sides of a junction, or takes it up.
    fn take_sill(&mut self, world: &PhysicsWorld, at: usize, junction: Option<&Junction>) {
        let before = self.sills[at].take();
        let (before, handle) = before.map_or((None, None), |it| (Some(it.sill), it.handle));
        let made = junction.map(|junction| (Sill::made(before, world, junction), junction));
        if let Some(((sill, false), _)) = made {
            self.sills[at] = Some(LaidSill { sill, handle });
            return;
        }
        if let Some(handle) = handle {
            self.take_up(handle);
        }
        let Some(((sill, _), junction)) = made else {
            return;
        };
        // The leaf's own x lies along its heading, which is measured from x to z.
        let (shape, lie) = match &self.site {
            None => {
                let lie = (junction.host.foot.pos, -junction.host.yaw);
                (sill.shape.clone(), lie)
            }
            Some(site) => {
                let shape = sill.shape.as_ref();
                let about = shape.and_then(|it| sill_about(site, junction, it));
                (about, (DVec3::ZERO, 0.0))
            }
        };
        let handle = shape.map(|shape| self.lay(&shape, lie, Earth::Sill(at)));
        self.sills[at] = Some(LaidSill { sill, handle });
    }

    fn lay(
        &mut self,
        shape: &SharedShape,
        (corner, turn_rad): Lie,
        earth: Earth,
    ) -> ColliderHandle {
        let at = (corner - self.origin).as_vec3();
        let turn = DQuat::from_rotation_y(turn_rad).as_quat();
        let collider = ColliderBuilder::new(shape.clone())
            .position(Pose::from_parts(at, turn))
            .collision_groups(earth.groups());
        self.colliders.insert(collider)
    }

    fn take_up(&mut self, handle: ColliderHandle) {
        self.colliders.remove(
            handle,
            &mut self.islands,
            &mut self.bodies,
            &mut self.soft_bodies,
            true,
        );
    }

    /// Advances all bodies by one step.
    pub fn step(&mut self, gravity_m_s2: f64, dt_s: f64) {
        let parameters = IntegrationParameters {
            dt: dt_s as f32,
            ..IntegrationParameters::default()
        };
        self.pipeline.step(
            Vector::new(0.0, -gravity_m_s2 as f32, 0.0),
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
            &(),
            &(),
        );
    }

    /// Adds to a body's angular velocity, rad/s.
    pub fn spin_by(&mut self, body: RigidBodyHandle, by: DVec3) {
        if let Some(body) = self.bodies.get_mut(body) {
            let spin = body.angvel() + by.as_vec3();
            body.set_angvel(spin, true);
        }
    }

    /// Lets a vehicle's springs and tyres act on it. After a step, so that the ground that was taken in is found. Tyres
    /// meet the ground as if it moved by the opposite of `pull`, in m/s.
    pub fn roll(
        &mut self,
        controller: &mut DynamicRayCastVehicleController,
        role: Role,
        pull: DVec3,
        dt_s: f64,
    ) {
        let chassis = controller.chassis;
        self.drift(chassis, pull);
        let filter = QueryFilter::default()
            .exclude_rigid_body(controller.chassis)
            .groups(role.groups());
        let queries = self.broad_phase.as_query_pipeline_mut(
            self.narrow_phase.query_dispatcher(),
            &mut self.bodies,
            &mut self.colliders,
            filter,
        );
        controller.update_vehicle(dt_s as f32, queries);
        self.drift(chassis, -pull);
    }

    /// Adds to a body's velocity, m/s.
    fn drift(&mut self, body: RigidBodyHandle, by: DVec3) {
        if by != DVec3::ZERO
            && let Some(body) = self.bodies.get_mut(body)
        {
            let velocity = body.linvel() + by.as_vec3();
            body.set_linvel(velocity, true);
        }
    }
}
