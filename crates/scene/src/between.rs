//! Pictures between two steps of the simulation.
//!
//! [`Between`] keeps the poses before the last step, and a frame shows a share of the way from them to the poses after
//! it. The simulation knows nothing of this. The player sees a turn of the look at once: the older poses are turned
//! as the last step turned, and both are turned by what the next step will turn.
//!
//! A figure is not shown on the way if it did not move there by itself: if it came, went, died, changed its camera or
//! its seat, or if it is farther away than anything gets in a step.

use antipode_frame::hand::{kick_between, swing_between};
use antipode_geometry::{Atlas, ChartPoint, Crossing};
use glam::DQuat;

use crate::actions::Actions;
use crate::camera::{CameraPose, LookTurn, keep_clear};
use crate::frame::{BeamLight, Figure, Frame, LampLight};
use crate::frame::{Clip, Posture};
use crate::moment::{Mark, Moment, Seen, Who};
use crate::photo::Viewpoint;
use crate::player::wrap_angle;
use crate::scene::Scene;
use crate::tuning::{DAY_S, STEP_S};

/// Nothing gets farther in a step, in metres: 90 m/s.
const LEAP_M: f64 = 1.5;
/// The day gets no farther in a step, in seconds.
const DAY_LEAP_S: f64 = 2.0 * STEP_S;

/// When a picture is taken, and which way the player looks by then.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shutter {
    /// Share of the last step that is shown, 0 to 1: all of it is the scene as it is.
    pub share: f64,
    /// How far the next step is going to turn the view.
    pub turned: LookTurn,
}

/// The poses before the last step, and the picture between them and those after it.
#[derive(Debug, Default)]
pub struct Between {
    before: Option<Moment>,
    /// Those that the last frame went to; the next step begins there.
    after: Option<Moment>,
    seen: Option<Seen>,
}

impl Between {
    /// Advances the scene by a step. `shown`: whether frames are to come before the next one.
    pub fn step(&mut self, scene: &mut Scene, actions: &Actions, shown: bool) {
        if shown {
            let is_now = |it: &Moment| it.simulated_s == scene.simulated_s();
            let mut before = self
                .after
                .take()
                .filter(is_now)
                .unwrap_or_else(|| scene.moment());
            before.turn(actions.look_turn());
            self.before = Some(before);
        }
        scene.step(actions);
    }

    /// The snapshot to draw. Terrain changes are handed over once, as by [`Scene::frame`].
    pub fn frame(
        &mut self,
        scene: &mut Scene,
        shutter: Shutter,
        fov_y_rad: f64,
        aspect: f64,
        world_id: u64,
    ) -> Frame {
        let moment = self.moment(scene, shutter);
        self.seen = Some(Seen::of(&moment));
        scene.frame_of(moment, fov_y_rad, aspect, world_id)
    }

    /// The snapshot to draw from elsewhere while the world stands still between two steps.
    pub fn frame_from(
        &self,
        scene: &mut Scene,
        share: f64,
        view: &Viewpoint,
        fov_y_rad: f64,
        aspect: f64,
        world_id: u64,
    ) -> Frame {
        let moment = self.on_the_way(&*scene.sim.world.strategy, scene.moment_from(view), share);
        scene.frame_of(moment, fov_y_rad, aspect, world_id)
    }

    /// A camera that sees what the player sees.
    pub fn viewpoint(&mut self, scene: &Scene, shutter: Shutter) -> Viewpoint {
        let moment = self.moment(scene, shutter);
        let view = Viewpoint::of(scene);
        Viewpoint {
            eye: antipode_geometry::Eye {
                dial: view.eye.dial,
                ..moment.camera.eye
            },
            time_of_day_s: moment.time_of_day_s,
            ..view
        }
    }

    /// What the last frame was taken with; that of the last step before there is one.
    pub fn seen(&self, scene: &Scene) -> Seen {
        self.seen.clone().unwrap_or_else(|| scene.seen())
    }

    fn moment(&mut self, scene: &Scene, shutter: Shutter) -> Moment {
        let after = scene.moment();
        let mut moment = self.on_the_way(&*scene.sim.world.strategy, after.clone(), shutter.share);
        self.after = Some(after);
        if !shutter.turned.is_none() {
            moment.turn(shutter.turned);
            keep_clear(&mut moment.camera, &scene.sim.world.physics);
        }
        moment
    }

    fn on_the_way(&self, world: &dyn Atlas, after: Moment, share: f64) -> Moment {
        let is_last = |before: &&Moment| {
            let apart_s = after.simulated_s - before.simulated_s;
            (0.5 * STEP_S..1.5 * STEP_S).contains(&apart_s)
        };
        match self.before.as_ref().filter(is_last) {
            Some(before) if share < 1.0 => after.coming_from(before, world, share.max(0.0)),
            _ => after,
        }
    }
}

impl Moment {
    /// Turns the camera, and what the player holds with it.
    fn turn(&mut self, turned: LookTurn) {
        let about = self.camera.about;
        let turn = self.camera.turn(turned);
        let is_own = |who: &Who| matches!(who, Who::Shot | Who::InHand);
        let go_round = |point: &mut ChartPoint| {
            if point.chart == about.chart {
                point.pos = about.pos + turn * (point.pos - about.pos);
            }
        };
        for (_, lamp) in self.lit.lamps.iter_mut().filter(|(who, _)| is_own(who)) {
            go_round(&mut lamp.point);
        }
        for (_, beam) in self.lit.beams.iter_mut().filter(|(who, _)| is_own(who)) {
            go_round(&mut beam.point);
            beam.direction = turn * beam.direction;
        }
        let is_afoot = |who: &Who| matches!(who, Who::Player { drives: None, .. });
        for (_, own) in self.figures.iter_mut().filter(|(who, _)| is_afoot(who)) {
            own.turn = DQuat::from_rotation_y(-turned.right_rad) * own.turn;
        }
        self.put_mark();
    }

    fn put_mark(&mut self) {
        if let Some(mark) = &mut self.mark {
            mark.put_before(&self.camera.eye, &*self.strategy);
        }
    }

    /// A share of the way here from the moment before.
    fn coming_from(mut self, before: &Self, world: &dyn Atlas, share: f64) -> Self {
        let way = Way { world, share };
        way.all(&mut self.figures, &before.figures);
        way.all(&mut self.lit.lamps, &before.lit.lamps);
        way.all(&mut self.lit.beams, &before.lit.beams);
        self.simulated_s = mix(before.simulated_s, self.simulated_s, share);
        if self.taker != before.taker {
            return self;
        }
        if let Some(camera) = way.camera(&before.camera, &self.camera) {
            self.camera = camera;
            let (strategy, dial) = self.lens.between(&before.lens, share);
            self.strategy = strategy;
            self.camera.eye.dial = dial;
        }
        let day_s = self.time_of_day_s - before.time_of_day_s;
        let day_s = day_s - DAY_S * (day_s / DAY_S).round();
        if day_s.abs() < DAY_LEAP_S {
            self.time_of_day_s = (self.time_of_day_s - day_s * (1.0 - share)).rem_euclid(DAY_S);
        }
        if let (Some(hand), Some(from)) = (&mut self.hand, &before.hand) {
            *hand = hand.between(from, share as f32);
        }
        if let (Some(mark), Some(from)) = (&mut self.mark, &before.mark) {
            go_mark(mark, from, share);
        }
        self.put_mark();
        self
    }
}

/// A share of the way between two poses, in a world.
struct Way<'a> {
    world: &'a dyn Atlas,
    share: f64,
}

impl Way<'_> {
    /// Brings each to where it is on the way from its pose before.
    fn all<T: Pose>(&self, after: &mut [(Who, T)], before: &[(Who, T)]) {
        // Both are in about the same order.
        let mut next = 0;
        for (who, pose) in after {
            // One that stands in a door is shown twice, and one that has passed it comes from where its other part was.
            let places = (next.min(before.len())..before.len()).chain(0..next.min(before.len()));
            let mut those = places.filter(|at| before[*at].0 == *who);
            let came = those.find_map(|at| {
                let from = before[at].1.point();
                Some((at, self.place(from, pose.point())?))
            });
            let Some((at, (point, turn))) = came else {
                continue;
            };
            next = at + 1;
            pose.go(&before[at].1, point, turn, self.share);
        }
    }

    /// A place on the way, and how the pose before is turned into its chart; none where nothing gets in a step.
    fn place(&self, from: ChartPoint, to: ChartPoint) -> Option<(ChartPoint, DQuat)> {
        let carried = self.carried(from, to)?;
        let way = to.pos - carried.point.pos;
        let is_leap = way.length() > LEAP_M;
        (!is_leap).then(|| (to.moved(way * (self.share - 1.0)), carried.rotation()))
    }

    /// A point as it is written in the chart of another.
    fn carried(&self, point: ChartPoint, to: ChartPoint) -> Option<Crossing> {
        self.world.carry_near(point, to)
    }

    /// A camera on the way. How far the way is tells what it goes round: an arm may grow at once.
    fn camera(&self, before: &CameraPose, after: &CameraPose) -> Option<CameraPose> {
        let (about, _) = self.place(before.about, after.about)?;
        let (from, to) = (before.eye, after.eye);
        let carried = self.carried(from.point, to.point)?;
        let mut eye = to;
        eye.point.pos = carried.point.pos.lerp(to.point.pos, self.share);
        eye.yaw = mix_angle(from.yaw - carried.turn_rad, to.yaw, self.share);
        eye.pitch = mix(from.pitch, to.pitch, self.share);
        eye.roll = mix_angle(from.roll, to.roll, self.share);
        eye.lift_m = mix(from.lift_m, to.lift_m, self.share);
        Some(CameraPose {
            eye,
            about,
            ..*after
        })
    }
}

/// What has a place in the chart.
trait Pose: Copy {
    fn point(&self) -> ChartPoint;

    /// Goes to a place on the way from another pose, whose directions take a turn to be of the same chart.
    fn go(&mut self, from: &Self, point: ChartPoint, turn: DQuat, share: f64);
}

impl Pose for Figure {
    fn point(&self) -> ChartPoint {
        self.point
    }

    fn go(&mut self, from: &Self, point: ChartPoint, turn: DQuat, share: f64) {
        let by = point.pos - self.point.pos;
        self.cut = self.cut.map(|cut| cut.from_origin_moved(by));
        self.point = point;
        self.turn = (turn * from.turn).slerp(self.turn, share);
        go_posture(&mut self.posture, &from.posture, share as f32);
    }
}

impl Pose for LampLight {
    fn point(&self) -> ChartPoint {
        self.point
    }

    fn go(&mut self, _: &Self, point: ChartPoint, _: DQuat, _: f64) {
        self.point = point;
    }
}

impl Pose for BeamLight {
    fn point(&self) -> ChartPoint {
        self.point
    }

    fn go(&mut self, from: &Self, point: ChartPoint, turn: DQuat, share: f64) {
        self.point = point;
        let way = (turn * from.direction).lerp(self.direction, share);
        self.direction = way.normalize_or(self.direction);
    }
}

/// Moments of clips go on from those before; one that has begun anew is where it is.
fn go_posture(posture: &mut Posture, from: &Posture, share: f32) {
    for clip in Clip::ALL {
        let number = clip as usize;
        posture.shares[number] = mix_f32(from.shares[number], posture.shares[number], share);
        let (before, after) = (from.moments[number], posture.moments[number]);
        posture.moments[number] = match clip {
            Clip::Walk | Clip::Run => {
                let by = after - before;
                (before + (by - by.round()) * share).rem_euclid(1.0)
            }
            _ if after >= before => mix_f32(before, after, share),
            _ => after,
        };
    }
    let twist = f64::from(posture.twist_rad);
    posture.twist_rad = mix_angle(f64::from(from.twist_rad), twist, f64::from(share)) as f32;
    posture.pitch_rad = mix_f32(from.pitch_rad, posture.pitch_rad, share);
    posture.swing = swing_between(from.swing, posture.swing, share);
    posture.kick = kick_between(from.kick, posture.kick, share);
}

fn go_mark(mark: &mut Mark, from: &Mark, share: f64) {
    if mark.marker.shape == from.marker.shape {
        mark.way = from.way.lerp(mark.way, share).normalize_or(mark.way);
        mark.away_m = mix(from.away_m, mark.away_m, share);
        mark.marker.radius_m = mix(from.marker.radius_m, mark.marker.radius_m, share);
    }
}

fn mix(from: f64, to: f64, share: f64) -> f64 {
    to - (to - from) * (1.0 - share)
}

fn mix_f32(from: f32, to: f32, share: f32) -> f32 {
    to - (to - from) * (1.0 - share)
}

/// By the shorter way.
fn mix_angle(from: f64, to: f64, share: f64) -> f64 {
    to - wrap_angle(to - from) * (1.0 - share)
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{ChartPoint, Geometry, strategy};
    use glam::DVec3;

    use super::*;
    use crate::actors::ActorId;
    use antipode_items::Item;

    #[test]
    fn what_falls_is_shown_on_its_way_in_the_step_in_which_another_goes() {
        let lamp = |number, y| {
            let point = ChartPoint::a(DVec3::new(f64::from(number), y, 0.0));
            (
                Who::Fixture(Item::Lamp, ActorId(number)),
                Figure::standing(Item::Lamp.into(), point, 0.0),
            )
        };
        let before = [lamp(0, 5.0), lamp(1, 5.0), lamp(2, 5.0)];
        let mut after = [lamp(1, 4.0), lamp(2, 5.0), lamp(3, 9.0)];
        let world = strategy(Geometry::Euclidean, 0.0);
        let way = Way {
            world: &*world,
            share: 0.25,
        };
        way.all(&mut after, &before);
        let heights = after.map(|(_, figure)| figure.point.pos.y);
        assert_eq!(heights, [4.75, 5.0, 9.0]);
    }
}
