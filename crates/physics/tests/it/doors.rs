//! A vehicle that stands in a door collides on both sides of it at once.

use std::sync::Arc;

use crate::common::{STEP_S, Soup};
use antipode_geometry::{
    ChartId, ChartPoint, ChunkCoord, Doorway, Geometry, Leaf, Strategy, strategy,
};
use antipode_physics::{
    PhysicsWorld, Vehicle, VehicleDoors, VehicleInput, VehicleMotion, VehiclePhysics,
};
use glam::{DQuat, DVec3, IVec3, Vec3};

/// The leaves lie about these places of their charts, at these heights and with these headings.
const FEET_M: [DVec3; 2] = [DVec3::new(6.0, 4.0, 3.0), DVec3::new(-9.0, 7.0, -5.0)];
const YAWS_RAD: [f64; 2] = [0.4, -2.1];
/// Walls are so wide and so high to either side, metres.
const WALL_M: f64 = 3.0;

/// Level ground about a leaf, and walls so far from it along its front.
fn land(leaf: &Leaf, walls_m: &[f64]) -> Soup {
    let mut soup = Soup::default();
    let at = |x: f64, y: f64, z: f64| leaf.place(DVec3::new(x, y, z)).pos.as_vec3();
    let square = |a: f64, b: f64| [at(a, 0.0, a), at(b, 0.0, a), at(b, 0.0, b), at(a, 0.0, b)];
    soup.quad(square(-14.0, 14.0), Vec3::Y);
    for wall_m in walls_m {
        let corners = [
            at(*wall_m, 0.0, -WALL_M),
            at(*wall_m, WALL_M, -WALL_M),
            at(*wall_m, WALL_M, WALL_M),
            at(*wall_m, 0.0, WALL_M),
        ];
        soup.quad(corners, -leaf.through().as_vec3());
    }
    soup
}

/// A pair, whose second leaf is in the same chart or in another one, with walls so far from each.
struct Site {
    space: Arc<dyn Strategy>,
    pair: Doorway,
    world: PhysicsWorld,
    physics: VehiclePhysics,
}

impl Site {
    fn new(geometry: Geometry, walls_m: [&[f64]; 2]) -> Self {
        let has_second = matches!(geometry, Geometry::Spherical | Geometry::HyperbolicWorld);
        let other = if has_second {
            ChartId::SECOND
        } else {
            ChartId::FIRST
        };
        // In one chart they lie apart.
        let apart = if has_second {
            DVec3::ZERO
        } else {
            DVec3::X * 64.0
        };
        let space = strategy(geometry, 64.0);
        let leaf = |at: usize, chart, apart: DVec3| {
            let foot = ChartPoint::new(chart, FEET_M[at] + apart);
            Leaf::at(&*space, foot, YAWS_RAD[at])
        };
        let leaves = [leaf(0, ChartId::FIRST, DVec3::ZERO), leaf(1, other, apart)];
        let mut world = PhysicsWorld::new();
        for (number, (leaf, walls_m)) in leaves.iter().zip(walls_m).enumerate() {
            let chart = leaf.foot.chart;
            let coord = ChunkCoord::new(chart, IVec3::new(number as i32, 0, 0));
            let soup = land(leaf, walls_m);
            let ground = world.chart_mut(chart);
            ground.set_terrain(coord, DVec3::ZERO, Some(soup.build()));
        }
        Self {
            space,
            pair: Doorway { leaves },
            world,
            physics: VehiclePhysics::default(),
        }
    }

    /// A vehicle at a place of a leaf's own axes, turned so against its front.
    fn vehicle(&self, leaf: usize, local: DVec3, turn_rad: f64) -> Vehicle {
        let leaf = &self.pair.leaves[leaf];
        let turn = DQuat::from_rotation_y(-leaf.yaw - turn_rad);
        self.physics
            .vehicle(VehicleMotion::at(leaf.place(local), turn))
    }

    fn step(&mut self, all: &mut [(&mut Vehicle, Option<VehicleInput>)]) {
        let doors = VehicleDoors {
            atlas: &*self.space,
            pair: &self.pair,
        };
        let before: Vec<_> = all.iter().map(|(it, _)| it.motion().point()).collect();
        self.physics.step(&self.world, Some(&doors), all, STEP_S);
        for ((vehicle, _), before) in all.iter_mut().zip(before) {
            let now = vehicle.motion().point();
            if let Some(by) = self.pair.met(&*self.space, before, now) {
                let crossing = self.pair.pass(&*self.space, by, now).unwrap();
                self.physics.carry(vehicle, &crossing);
            }
        }
    }

    /// Where a vehicle is in the axes of the first leaf if it is there, and of the second else.
    fn local(&self, vehicle: &Vehicle) -> (usize, DVec3) {
        let of = |leaf: usize| {
            let door = &self.pair.leaves[leaf];
            let near = self.space.carry_near(vehicle.motion().point(), door.foot)?;
            Some((leaf, door.local(near.point.pos)))
        };
        // In a world of squares not both may be written where it is.
        let both = (0..2).filter_map(of);
        let near = both.min_by(|a, b| a.1.length().total_cmp(&b.1.length()));
        near.expect("it is near one of them")
    }
}

fn parked() -> VehicleInput {
    VehicleInput {
        parked: true,
        ..VehicleInput::default()
    }
}

/// Driven at about so many metres a second.
fn at_speed(vehicle: &Vehicle, m_s: f64) -> VehicleInput {
    let is_slow = vehicle.motion().speed_m_s() < m_s;
    VehicleInput {
        throttle: if is_slow { 0.7 } else { 0.0 },
        ..VehicleInput::default()
    }
}

#[test]
fn a_wall_beyond_a_door_stops_the_nose_that_is_through_and_one_behind_the_leaf_does_not() {
    for geometry in Geometry::ALL {
        // Right behind the near leaf there is one, too: whoever goes in is not there.
        let mut site = Site::new(geometry, [&[1.1], &[1.0]]);
        let mut car = site.vehicle(0, DVec3::new(-6.0, 0.1, 0.0), 0.0);
        let mut farthest = f64::MIN;
        for _ in 0..360 {
            let input = at_speed(&car, 4.0);
            site.step(&mut [(&mut car, Some(input))]);
            let (leaf, at) = site.local(&car);
            assert_eq!(leaf, 0, "{geometry}: {at}");
            farthest = farthest.max(at.x);
        }
        // Its nose is 1.52 m before its middle.
        assert!((-0.62..-0.45).contains(&farthest), "{geometry}: {farthest}");
    }
}

#[test]
fn one_that_goes_through_onto_open_land_feels_nothing_of_the_leaf() {
    for geometry in Geometry::ALL {
        let mut site = Site::new(geometry, [&[1.1], &[]]);
        let mut car = site.vehicle(0, DVec3::new(-8.0, 0.1, 0.1), 0.0);
        let (mut jolt, mut rise) = (0.0f64, 0.0f64);
        let mut through = false;
        for step in 0..300 {
            let input = at_speed(&car, 6.0);
            site.step(&mut [(&mut car, Some(input))]);
            let (leaf, at) = site.local(&car);
            through |= leaf == 1 && at.x > 3.0;
            if step > 60 && !through {
                jolt = jolt.max(car.jolt_m_s());
                rise = rise.max((car.motion().up().y - 1.0).abs());
            }
        }
        assert!(through, "{geometry}: {:?}", site.local(&car));
        assert!(jolt < 0.1 && rise < 1e-3, "{geometry}: {jolt} {rise}");
    }
}

#[test]
fn one_that_stands_beyond_a_door_is_run_into_and_what_one_loses_the_other_gets() {
    for geometry in Geometry::ALL {
        let mut site = Site::new(geometry, [&[], &[]]);
        let mut car = site.vehicle(0, DVec3::new(-6.0, 0.1, 0.0), 0.0);
        // Its tail is 1.1 m behind the far leaf.
        let mut other = site.vehicle(1, DVec3::new(2.65, 0.1, 0.0), 0.0);
        let coast = VehicleInput::default();
        let mut pushed_from = None;
        for _ in 0..240 {
            let is_met = other.motion().speed_m_s() > 0.5;
            let input = if is_met { coast } else { at_speed(&car, 4.0) };
            site.step(&mut [(&mut car, Some(input)), (&mut other, Some(coast))]);
            if is_met && pushed_from.is_none() {
                let (leaf, at) = site.local(&car);
                let [a, b] = [&car, &other].map(|it| it.motion().speed_m_s());
                assert!(a + b > 3.2 && a + b < 4.6, "{geometry}: {a} {b}");
                pushed_from = Some((leaf, at.x));
            }
        }
        let (leaf, x) = pushed_from.unwrap();
        assert!(
            leaf == 0 && (-0.6..-0.2).contains(&x),
            "{geometry}: {leaf} {x}"
        );
        let (leaf, at) = site.local(&other);
        assert!(
            leaf == 1 && at.x > 3.2 && at.z.abs() < 0.2,
            "{geometry}: {leaf} {at}"
        );
    }
}

#[test]
fn one_that_is_parked_beyond_stays_where_it_is_to_the_bit_while_another_stands_in_the_door() {
    for geometry in Geometry::ALL {
        let mut site = Site::new(geometry, [&[], &[]]);
        let mut other = site.vehicle(1, DVec3::new(6.5, 0.02, 0.0), 0.3);
        for _ in 0..200 {
            site.step(&mut [(&mut other, Some(parked()))]);
        }
        assert!(other.is_asleep(), "{geometry}");
        let rests = other.motion();
        let mut car = site.vehicle(0, DVec3::new(-0.8, 0.02, 0.0), 0.0);
        for _ in 0..60 {
            let held = VehicleInput {
                brake: true,
                ..VehicleInput::default()
            };
            site.step(&mut [(&mut car, Some(held)), (&mut other, Some(parked()))]);
        }
        assert!(other.is_asleep() && other.motion() == rests, "{geometry}");
    }
}
