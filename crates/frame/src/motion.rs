//! What a body does becomes how it is held: which clips move it, from where to where they fade, and how far its feet
//! have walked. Advanced with the steps of a world or a room, so that the same steps give the same picture.

use std::f64::consts::PI;

use glam::DVec2;

use crate::posture::{Clip, Posture};

/// Metres that a cycle of the walk covers, two steps: the speed at which the clip's feet stand still, times its length.
pub const WALK_STRIDE_M: f64 = 1.4 * 0.78;
/// Metres that a cycle of the run covers.
pub const RUN_STRIDE_M: f64 = 4.5 * 0.54;
/// Speeds from which a walk becomes a run, and at which nothing is left of it, in metres per second.
pub const RUNS_FROM_M_S: (f64, f64) = (1.8, 3.2);
/// Slowest fall whose end bends the knees, in metres per second.
pub const LANDS_FROM_M_S: f64 = 2.5;
/// Slower than this, in m/s, the feet stand.
const STANDS_M_S: f64 = 0.15;
/// From this speed on, in m/s, nothing is left of standing.
const WALKS_M_S: f64 = 0.6;
/// Slower steps, in m/s, are not heard.
const HEARD_FROM_M_S: f64 = 0.3;
/// A figure that moves at a larger angle than this to its front walks backwards, radians.
const BACKWARDS_RAD: f64 = 1.85;
/// How fast the legs turn to where they go, per second.
const TWIST_RATE_PER_S: f64 = 10.0;
/// A body is in the air when it was for so long, seconds: walking down a slope leaves the ground all the time.
const FLIES_AFTER_S: f64 = 0.12;
/// A figure that leaves the ground at this speed or more has jumped, m/s.
const JUMPS_FROM_M_S: f64 = 1.5;
/// A figure that falls faster than this has lost the ground for good, m/s.
const FALLS_FROM_M_S: f64 = 7.0;
/// When in the jump the feet leave the ground, and when it has become hanging in the air, seconds.
const PUSH_S: f32 = 0.10;
const HANG_S: f32 = 0.62;
/// How long a landing bends the knees, seconds, and the speed of fall that bends them all the way, m/s.
const LANDING_S: f64 = 0.16;
const LANDING_MOST_M_S: f64 = 9.0;
/// How long being hit is seen, seconds, and how fast it comes and goes.
const HIT_S: f32 = 0.46;
const HIT_FADE_S: f64 = 0.08;
/// All clips that go round have done so a whole number of times after this, seconds; others have long ended.
const LONG_AGO_S: f32 = 600.0;
/// How long it takes to sit down, seconds.
const SITS_FADE_S: f64 = 0.5;
/// How long it takes to take something in hand, seconds.
const HOLD_FADE_S: f64 = 0.16;

/// What a body does in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Doing {
    /// Velocity over the ground, ahead and to the right of where it faces, m/s.
    pub way: DVec2,
    /// Velocity upwards, m/s.
    pub rise_m_s: f64,
    /// Whether it stands or walks on something.
    pub grounded: bool,
    /// Speed of the fall that ended in this step, m/s.
    pub impact_m_s: f64,
    /// Whether it flies as a spectator.
    pub flying: bool,
    /// Whether it is dead.
    pub dead: bool,
    /// Whether something is in its hand.
    pub holds: bool,
    /// Whether it crouches to rest, where it stands on something.
    pub sits: bool,
    /// Whether what it sits on is a stone behind it.
    pub perches: bool,
    /// How far it looks up, radians.
    pub pitch_rad: f64,
}

/// How a body is held, and what is needed to tell how it will be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    posture: Posture,
    /// Cycles of the gait; backwards it counts down.
    cycles: f64,
    air_s: f64,
    landing_left_s: f64,
    landing_depth: f32,
    struck: bool,
}

impl Default for Motion {
    /// A body that stands.
    fn default() -> Self {
        let mut posture = Posture::default();
        for clip in [Clip::Jump, Clip::Die, Clip::Hit] {
            posture.put(clip, 0.0, LONG_AGO_S);
        }
        Self {
            posture,
            cycles: 0.0,
            air_s: 0.0,
            landing_left_s: 0.0,
            landing_depth: 0.0,
            struck: false,
        }
    }
}

impl Motion {
    /// How the body is held now.
    pub fn posture(&self) -> Posture {
        self.posture
    }

    /// Cycles of the gait since the beginning: each has two steps.
    pub fn cycles(&self) -> f64 {
        self.cycles
    }

    /// The body is hit: it will be seen from the next step on.
    pub fn strike(&mut self) {
        self.struck = true;
    }

    /// Lets a step pass. Returns whether a foot came down.
    pub fn pass(&mut self, doing: &Doing, dt_s: f64) -> bool {
        let was_in_air = self.air_s > 0.0;
        self.air_s = if doing.grounded {
            0.0
        } else {
            self.air_s + dt_s
        };
        self.pass_time(dt_s as f32);
        if !doing.grounded && !was_in_air && doing.rise_m_s > JUMPS_FROM_M_S {
            // Well in the air at once: the crouch before a jump would come too late.
            self.air_s = FLIES_AFTER_S.max(dt_s);
            self.posture
                .put(Clip::Jump, self.posture.share(Clip::Jump), PUSH_S);
        }
        self.land(doing, dt_s);
        let foot_down = self.walk(doing, dt_s);
        let (goals, fade_s) = self.goals(doing);
        self.fade(&goals, fade_s, dt_s);
        self.overlay(doing, dt_s);
        self.posture.pitch_rad = doing.pitch_rad as f32;
        foot_down
    }

    /// Moves on all clips that go by time. Those that go round do so together, so that their moments stay small.
    fn pass_time(&mut self, dt_s: f32) {
        for (clip, moment) in Clip::ALL.into_iter().zip(&mut self.posture.moments) {
            *moment = match clip {
                Clip::Walk | Clip::Run | Clip::Land => *moment,
                Clip::Idle | Clip::Fall | Clip::Hold | Clip::Sit | Clip::Rest | Clip::Perch => {
                    (*moment + dt_s) % LONG_AGO_S
                }
                Clip::Jump | Clip::Die | Clip::Hit => (*moment + dt_s).min(LONG_AGO_S),
            };
        }
    }

    /// Bends the knees after a fall.
    fn land(&mut self, doing: &Doing, dt_s: f64) {
        self.landing_left_s = (self.landing_left_s - dt_s).max(0.0);
        if doing.impact_m_s >= LANDS_FROM_M_S {
            self.landing_left_s = LANDING_S;
            self.landing_depth = (doing.impact_m_s / LANDING_MOST_M_S).min(0.9) as f32;
        }
    }

    /// Moves the feet on by the ground covered, so that they do not slide, and turns the legs to where they go.
    fn walk(&mut self, doing: &Doing, dt_s: f64) -> bool {
        let speed_m_s = doing.way.length();
        let walks = doing.grounded && !doing.dead && speed_m_s > STANDS_M_S;
        let mut goal_rad = 0.0;
        let before = self.cycles;
        if walks {
            let angle_rad = doing.way.y.atan2(doing.way.x);
            let backwards = angle_rad.abs() > BACKWARDS_RAD;
            goal_rad = if backwards {
                angle_rad - PI.copysign(angle_rad)
            } else {
                angle_rad
            };
            let covered = speed_m_s * dt_s / stride_m(speed_m_s);
            self.cycles += if backwards { -covered } else { covered };
        }
        let twist_rad = f64::from(self.posture.twist_rad);
        let share = (TWIST_RATE_PER_S * dt_s).min(1.0);
        self.posture.twist_rad = (twist_rad + (goal_rad - twist_rad) * share) as f32;
        let cycle = self.cycles.rem_euclid(1.0) as f32;
        self.posture.moments[Clip::Walk as usize] = cycle;
        self.posture.moments[Clip::Run as usize] = cycle;
        let half = |cycles: f64| (2.0 * cycles).floor();
        walks && speed_m_s > HEARD_FROM_M_S && half(before) != half(self.cycles)
    }

    /// What the whole body fades to, and how quickly, seconds.
    fn goals(&self, doing: &Doing) -> (Posture, f64) {
        if doing.dead {
            return (Posture::of(Clip::Die, 0.0), 0.14);
        }
        if doing.flying {
            return (Posture::of(Clip::Jump, HANG_S), 0.25);
        }
        if self.air_s >= FLIES_AFTER_S {
            return if doing.rise_m_s < -FALLS_FROM_M_S {
                (Posture::of(Clip::Fall, 0.0), 0.3)
            } else {
                (Posture::of(Clip::Jump, HANG_S), 0.09)
            };
        }
        let speed_m_s = doing.way.length();
        if doing.sits && speed_m_s < STANDS_M_S {
            let clip = if doing.perches {
                Clip::Perch
            } else {
                Clip::Rest
            };
            return (Posture::of(clip, 0.0), SITS_FADE_S);
        }
        let run = run_share(speed_m_s) as f32;
        let walk = smooth((speed_m_s - STANDS_M_S) / (WALKS_M_S - STANDS_M_S)) as f32;
        let land = if self.landing_left_s > 0.0 {
            self.landing_depth
        } else {
            0.0
        };
        let rest = 1.0 - land;
        let goals = Posture::of(Clip::Idle, 0.0)
            .with(Clip::Idle, rest * (1.0 - walk), 0.0)
            .with(Clip::Walk, rest * walk * (1.0 - run), 0.0)
            .with(Clip::Run, rest * walk * run, 0.0)
            .with(Clip::Land, land, 0.0);
        (goals, if land > 0.0 { 0.07 } else { 0.14 })
    }

    /// Fades to the goals. A clip that comes from nothing begins at its beginning, or where the goal says.
    fn fade(&mut self, goals: &Posture, fade_s: f64, dt_s: f64) {
        for clip in Clip::WHOLE {
            let (share, goal) = (self.posture.share(clip), goals.share(clip));
            let from_nothing = share == 0.0 && goal > 0.0;
            let once = matches!(clip, Clip::Jump | Clip::Fall | Clip::Die);
            let is_under_way = clip == Clip::Jump && self.posture.moment(clip) < HANG_S;
            if from_nothing && once && !is_under_way {
                self.posture.moments[clip as usize] = goals.moment(clip);
            }
            self.posture.shares[clip as usize] = toward(share, goal, dt_s / fade_s);
        }
    }

    /// What lies over the whole body: being hit, and holding something.
    fn overlay(&mut self, doing: &Doing, dt_s: f64) {
        if self.struck {
            self.struck = false;
            self.posture
                .put(Clip::Hit, self.posture.share(Clip::Hit), 0.0);
        }
        let is_hit = !doing.dead && self.posture.moment(Clip::Hit) < HIT_S - HIT_FADE_S as f32;
        let holds = doing.holds && !doing.dead;
        for (clip, on, fade_s) in [
            (Clip::Hit, is_hit, HIT_FADE_S),
            (Clip::Hold, holds, HOLD_FADE_S),
        ] {
            let goal = f32::from(u8::from(on));
            let share = &mut self.posture.shares[clip as usize];
            *share = toward(*share, goal, dt_s / fade_s);
        }
    }
}

/// Metres that both feet together carry a body at a speed, in m/s.
fn stride_m(speed_m_s: f64) -> f64 {
    WALK_STRIDE_M + (RUN_STRIDE_M - WALK_STRIDE_M) * run_share(speed_m_s)
}

/// Share of the run at a speed, in m/s; the rest is the walk's.
fn run_share(speed_m_s: f64) -> f64 {
    let (from, to) = RUNS_FROM_M_S;
    smooth((speed_m_s - from) / (to - from))
}

fn smooth(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

fn toward(from: f32, to: f32, most: f64) -> f32 {
    from + (to - from).clamp(-most as f32, most as f32)
}

#[cfg(test)]
mod tests;
