//! What the player is made of: the components that all figures share, how they are carried over the edges of charts, and what he
//! alone has.

use antipode_geometry::{Atlas, ChartPoint, Eye};
use antipode_physics::Character;
use glam::{DVec2, DVec3};

use crate::actions::Actions;
use crate::aimed::Gaze;
use crate::biome::InBiome;
use crate::brush::{Brush, Choice};
use crate::circumnavigation::Circumnavigation;
use crate::damage::Condition;
use crate::earthworks::Earthworks;
use crate::felling::Chop;
use crate::frame::ModelId;
use crate::inventory::Inventory;
use crate::lens::Lens;
use crate::tool::ToolMark;
use crate::tuning::{BRUSH_RADIUS_M, FULL_HEALTH, PITCH_LIMIT_RAD};
use antipode_frame::motion::{Doing, Motion};

/// What the player alone has and does, besides the components of a figure.
pub(crate) struct Player {
    pub inventory: Inventory,
    pub gaze: Gaze,
    /// Where the tool in hand works.
    pub tool: Option<ToolMark>,
    /// What it is felling.
    pub chop: Option<Chop>,
    /// Whether it has felled something by the press that goes on.
    pub has_felled: bool,
    pub brush_radius_m: f64,
    pub brush: Brush,
    /// What of it was chosen last, and when, simulated seconds.
    pub chosen: Option<(Choice, f64)>,
    /// Presses of the brush in this visit.
    pub presses: u64,
    pub earthworks: Earthworks,
    pub flying: bool,
    pub condition: Condition,
    /// Until the gun can be fired again, seconds.
    pub gun_rests_s: f64,
    /// Whether each button was down in the step before.
    pub primary_before: bool,
    pub secondary_before: bool,
    pub flashlight: bool,
    /// Where the player stands up again, unless the land alone decides.
    pub start: Option<ChartPoint>,
    pub circumnavigation: Circumnavigation,
    /// The biome of the land that the player is in.
    pub biome: InBiome,
    /// Whether the body was put where it is and may be stuck there.
    pub body_unchecked: bool,
    /// Whether the player was put back to the start, and it was not seen yet whether the ground there has been dug away.
    pub stands_up: bool,
}

impl Player {
    /// Somebody who has just come with what he carries, and sees through that lens.
    pub fn new(lens: Lens, inventory: Inventory) -> Self {
        Self {
            inventory,
            gaze: Gaze::through(lens),
            tool: None,
            chop: None,
            has_felled: false,
            brush_radius_m: BRUSH_RADIUS_M.2,
            brush: Brush::default(),
            chosen: None,
            presses: 0,
            earthworks: Earthworks::default(),
            flying: false,
            condition: Condition::default(),
            gun_rests_s: 0.0,
            primary_before: false,
            secondary_before: false,
            flashlight: false,
            start: None,
            circumnavigation: Circumnavigation::default(),
            biome: InBiome::default(),
            body_unchecked: true,
            stands_up: false,
        }
    }

    /// Whether he lies dead.
    pub fn is_dead(&self) -> bool {
        self.condition.dead_left_s.is_some()
    }

    /// Whether things that lie about are picked up by coming near.
    pub fn picks_up(&self) -> bool {
        !self.flying && !self.is_dead()
    }
}

/// Where an entity's feet are, in the chart that it is in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Position(pub ChartPoint);

/// The way an entity looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// Heading in radians, 0 along +x, a quarter turn along +z; kept within (-pi, pi].
    pub yaw: f64,
    /// Elevation in radians, up positive.
    pub pitch: f64,
}

impl Look {
    /// Along +x.
    pub const LEVEL: Self = Self {
        yaw: 0.0,
        pitch: 0.0,
    };

    /// Turns by the angles given in radians, keeping short of the vertical.
    pub fn turn(&mut self, yaw: f64, pitch: f64) {
        self.yaw = wrap_angle(self.yaw + yaw);
        self.pitch = (self.pitch + pitch).clamp(-PITCH_LIMIT_RAD, PITCH_LIMIT_RAD);
    }

    /// Turns with a way or into another chart, as every direction does, by the turn of a [`antipode_geometry::Crossing`].
    pub fn follow(&mut self, turn_rad: f64) {
        if turn_rad != 0.0 {
            self.yaw = wrap_angle(self.yaw - turn_rad);
        }
    }

    /// The unit ground direction of the heading.
    pub fn heading(&self) -> DVec3 {
        DVec3::new(self.yaw.cos(), 0.0, self.yaw.sin())
    }
}

/// An entity's capsule.
#[derive(Clone, Debug)]
pub struct Body(pub Character);

/// How much damage an entity can take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Health(pub f64);

/// What an entity is drawn as, how it moves, and what it holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Appearance {
    /// The model.
    pub model: ModelId,
    /// How its body is held.
    pub motion: Motion,
    /// What is in its right hand.
    pub held: Option<ModelId>,
}

impl Appearance {
    /// Someone who stands with empty hands.
    pub fn standing(model: ModelId) -> Self {
        Self {
            model,
            motion: Motion::default(),
            held: None,
        }
    }
}

/// The components a player begins with at `point`, feet on the ground, looking that way.
pub fn components(point: ChartPoint, look: Look) -> (Position, Look, Body, Health, Appearance) {
    (
        Position(point),
        look,
        Body(Character::at(point.pos)),
        Health(FULL_HEALTH),
        Appearance::standing(ModelId::Astronaut),
    )
}

/// The unit-or-shorter ground direction the player wants to go, in the chart's frame.
pub fn wish(actions: &Actions, look: &Look) -> DVec3 {
    let ahead = look.heading();
    let right = DVec3::new(-ahead.z, 0.0, ahead.x);
    (ahead * actions.forward + right * actions.strafe).clamp_length_max(1.0)
}

/// Carries a body into the next chart when it has left its own; returns whether it did.
/// Position, velocity and heading all turn with the chart, so in the space nothing changes.
pub fn cross(
    strategy: &dyn Atlas,
    position: &mut Position,
    look: &mut Look,
    body: &mut Body,
) -> bool {
    let Some(crossing) = strategy.cross(position.0) else {
        return false;
    };
    position.0 = crossing.point;
    look.follow(crossing.turn_rad);
    body.0.velocity = crossing.turn_vector(body.0.velocity);
    true
}

/// The eye of a first-person view, `height_m` above the feet.
pub fn eye(position: &Position, look: &Look, dial: f64, height_m: f64) -> Eye {
    let mut point = position.0;
    point.pos.y += height_m;
    Eye {
        point,
        yaw: look.yaw,
        pitch: look.pitch,
        roll: 0.0,
        dial,
        lift_m: height_m,
    }
}

/// What a body does of itself: how it moves relative to where it faces. Death, flight and what is held are left to add.
pub fn doing(look: &Look, body: &Body) -> Doing {
    let velocity = body.0.velocity;
    let ahead = look.heading();
    let right = DVec3::new(-ahead.z, 0.0, ahead.x);
    Doing {
        way: DVec2::new(velocity.dot(ahead), velocity.dot(right)),
        rise_m_s: velocity.y,
        grounded: body.0.grounded,
        impact_m_s: body.0.impact_m_s,
        pitch_rad: look.pitch,
        ..Doing::default()
    }
}

/// The angle within (-pi, pi].
pub fn wrap_angle(angle_rad: f64) -> f64 {
    use std::f64::consts::{PI, TAU};
    PI - (PI - angle_rad).rem_euclid(TAU)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use antipode_geometry::{ChartId, Geometry, strategy};

    use super::*;

    fn level(yaw: f64) -> Look {
        Look { yaw, pitch: 0.0 }
    }

    #[test]
    fn angles_wrap_to_one_turn() {
        assert!((wrap_angle(3.0 * PI) - PI).abs() < 1e-12);
        assert!((wrap_angle(-3.0 * PI) - PI).abs() < 1e-12);
        assert!((wrap_angle(-0.5) + 0.5).abs() < 1e-15);
    }

    #[test]
    fn forward_goes_where_one_looks_and_strafe_to_the_right_of_it() {
        let look = Look {
            yaw: FRAC_PI_2,
            pitch: 0.3,
        };
        let go = wish(
            &Actions {
                forward: 1.0,
                ..Actions::default()
            },
            &look,
        );
        assert!((go - DVec3::Z).length() < 1e-12);
        let side = wish(
            &Actions {
                strafe: 1.0,
                ..Actions::default()
            },
            &look,
        );
        assert!((side - DVec3::NEG_X).length() < 1e-12);
        let both = wish(
            &Actions {
                forward: 1.0,
                strafe: 1.0,
                ..Actions::default()
            },
            &look,
        );
        assert!((both.length() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn the_view_never_passes_the_vertical() {
        let mut look = Look {
            yaw: 0.0,
            pitch: 0.0,
        };
        look.turn(0.0, 10.0);
        assert!(look.pitch < FRAC_PI_2);
        look.turn(0.0, -20.0);
        assert!(look.pitch > -FRAC_PI_2);
    }

    #[test]
    fn over_the_equator_a_body_keeps_its_speed_and_its_way_through_the_space() {
        let sphere = strategy(Geometry::Spherical, 32.0);
        let rim = sphere.domain(ChartId::FIRST).radius_m().unwrap_or(0.0);
        let point = ChartPoint::a(DVec3::new(rim + 0.3, 8.0, 0.0));
        let (mut position, mut look, mut body, ..) = components(point, level(0.4));
        body.0.velocity = DVec3::new(3.0, -1.0, 2.0);
        let before = sphere.distance_m(
            point,
            ChartPoint::a(DVec3::new(rim - 5.0, 8.0, 0.0)),
            &eye(&position, &look, 0.0, 1.62),
        );
        assert!(cross(&*sphere, &mut position, &mut look, &mut body));
        assert_eq!(position.0.chart, ChartId::SECOND);
        assert!((body.0.velocity.length() - 14f64.sqrt()).abs() < 1e-9);
        assert!((body.0.velocity.y + 1.0).abs() < 1e-12);
        let after = sphere.distance_m(
            position.0,
            ChartPoint::a(DVec3::new(rim - 5.0, 8.0, 0.0)),
            &eye(&position, &look, 0.0, 1.62),
        );
        assert!((before - after).abs() < 1e-9);
        assert!(
            !cross(&*sphere, &mut position, &mut look, &mut body),
            "stands firmly in the other hemisphere"
        );
    }
}
