//! The mind of a figure: what it is doing, what it wants, what it remembers. How it comes to want it is in `choice`.

use antipode_geometry::ChartPoint;
use glam::DVec3;

use super::cover::Cover;
use super::dice::Dice;
use super::seats::Seat;
use super::tuning::{FIRST_SHOT_S, LISTENS_S, RESTS_S, WATCHES_AGAIN_S, WATCHES_S};
use crate::frame::Figure;
use crate::tuning::{FLASH_S, KICK_S, STEP_S};

/// What a figure is doing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum State {
    /// Rests.
    #[default]
    Idle,
    /// Walks where it wants to.
    Wander,
    /// Looks at the player, or where a noise came from.
    Watch,
    /// Steps aside.
    Aside,
    /// Sits by a lamp or on a stone.
    Sit,
    /// Comes after the player.
    Chase,
    /// Fights at its distance.
    Fight,
    /// Hides from the player behind what stands on the land, and looks out to shoot.
    Cover,
    /// Looks for the player where it was last known to be.
    Search,
    /// Runs away.
    Flee,
    /// Is dead.
    Dead,
}

impl State {
    /// The word of a probe.
    pub fn name(self) -> &'static str {
        match self {
            Self::Idle => "idle",
            Self::Wander => "wander",
            Self::Watch => "watch",
            Self::Aside => "aside",
            Self::Sit => "sit",
            Self::Chase => "chase",
            Self::Fight => "fight",
            Self::Cover => "cover",
            Self::Search => "search",
            Self::Flee => "flee",
            Self::Dead => "dead",
        }
    }

    /// Whether it has to do with a player who is fought.
    pub(crate) fn is_combat(self) -> bool {
        matches!(self, Self::Search) || self.shoots()
    }

    /// Whether it shoots at the player whom it sees.
    pub(crate) fn shoots(self) -> bool {
        matches!(self, Self::Chase | Self::Fight | Self::Cover)
    }
}

/// What is known of the player who is fought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Known {
    /// Where the feet were seen last, or a shot was heard.
    pub feet: ChartPoint,
    /// Since then, in seconds; zero while in sight.
    pub ago_s: f64,
}

/// A place to go to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Goal {
    pub point: ChartPoint,
    /// How near is there, in metres.
    pub within_m: f64,
    /// Share of the walking speed.
    pub pace: f64,
    /// What is sat by or on there.
    pub sits: Option<Sits>,
}

/// What somebody sits by or on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Sits {
    /// A lamp whose light is there.
    Lamp(ChartPoint),
    /// A stone or a stump.
    Stone(Seat),
}

/// What is remembered between two thoughts.
#[derive(Clone, Debug)]
pub(crate) struct Mind {
    pub state: State,
    /// Since the state began, in seconds.
    pub since_s: f64,
    pub dice: Dice,
    pub goal: Option<Goal>,
    /// The steps to the goal, the last first.
    pub steps: Vec<ChartPoint>,
    /// Since the steps were found, in seconds.
    pub planned_s: f64,
    /// Where to look; the way one goes if there is nothing.
    pub face: Option<ChartPoint>,
    pub known: Option<Known>,
    /// How long a neutral one stays angry, in seconds.
    pub angry_s: f64,
    /// What is fled from, and for how long yet, in seconds.
    pub fear: Option<(ChartPoint, f64)>,
    /// How long the display has pointed to one whom the picture hides, in seconds; none who is to be seen.
    pub hidden_s: Option<f64>,
    /// Until the next shot, in seconds.
    pub fires_in_s: f64,
    /// Since the last shot, in seconds.
    pub fired_s: f64,
    /// How long this rest or look lasts, in seconds.
    pub lasts_s: f64,
    /// Until a player is looked at again, in seconds.
    pub bored_s: f64,
    /// Where it was when it last got on, and for how long it has not, in seconds.
    pub anchor: Option<ChartPoint>,
    pub stuck_s: f64,
    /// Times in a row that it was stuck.
    pub stuck: u32,
    /// Places that turned out to be no way, and for how long that is remembered, in seconds.
    pub blocked: Vec<(ChartPoint, f64)>,
    /// Whether it has stood on ground since it came.
    pub has_landed: bool,
    /// How often it was talked to.
    pub told: u32,
    /// Which way it goes round the player, 1 or -1.
    pub side: f64,
    /// Where exactly to be, once the steps have led near it.
    pub spot: Option<ChartPoint>,
    /// The stone that it sits on, or is about to or gets up from; until it sits on one again, in seconds.
    pub seat: Option<Seat>,
    pub sits_again_s: f64,
    /// What it hides behind; how long yet it wants to, and until it looks for something again, in seconds.
    pub cover: Option<Cover>,
    pub under_fire_s: f64,
    pub covers_again_s: f64,
}

impl Mind {
    /// The mind of a figure that has just come, by its own dice.
    pub fn new(mut dice: Dice) -> Self {
        let lasts_s = dice.between([0.0, RESTS_S]);
        let side = if dice.unit() < 0.5 { -1.0 } else { 1.0 };
        Self {
            state: State::Idle,
            since_s: 0.0,
            dice,
            goal: None,
            steps: Vec::new(),
            planned_s: f64::INFINITY,
            face: None,
            known: None,
            angry_s: 0.0,
            fear: None,
            hidden_s: None,
            fires_in_s: FIRST_SHOT_S,
            fired_s: f64::INFINITY,
            lasts_s,
            bored_s: 0.0,
            anchor: None,
            stuck_s: 0.0,
            stuck: 0,
            blocked: Vec::new(),
            has_landed: false,
            told: 0,
            side,
            spot: None,
            seat: None,
            sits_again_s: 0.0,
            cover: None,
            under_fire_s: 0.0,
            covers_again_s: 0.0,
        }
    }

    /// Begins to do something, unless it is done already. What was gone to before is let go.
    pub fn enter(&mut self, state: State) {
        if self.state == state {
            return;
        }
        // A figure that loses and finds its foe within a fight goes on counting to the next shot.
        if state.is_combat() && !self.state.is_combat() {
            self.fires_in_s = FIRST_SHOT_S;
        }
        self.state = state;
        self.since_s = 0.0;
        self.stuck = 0;
        self.halt();
    }

    /// Goes nowhere.
    pub fn halt(&mut self) {
        self.goal = None;
        self.spot = None;
        self.steps.clear();
        self.anchor = None;
        self.stuck_s = 0.0;
    }

    /// Sets out to a place; one that is much the same keeps the steps that were found.
    pub fn go(&mut self, goal: Goal) {
        let same = self.goal.is_some_and(|old| {
            old.point.chart == goal.point.chart && (old.point.pos - goal.point.pos).length() < 1e-6
        });
        if !same {
            self.planned_s = f64::INFINITY;
        }
        self.goal = Some(goal);
    }

    /// Moves a goal that wanders, without a new plan until the old one is stale.
    pub fn follow(&mut self, goal: Goal) {
        if self.goal.is_none() {
            self.planned_s = f64::INFINITY;
        }
        self.goal = Some(goal);
    }

    /// Rests for a while.
    pub fn rest(&mut self) {
        self.enter(State::Idle);
        self.halt();
        self.since_s = 0.0;
        self.lasts_s = self.dice.between([0.0, RESTS_S]);
    }

    /// Stops and looks at a place for a while.
    pub fn watch(&mut self, place: ChartPoint) {
        self.enter(State::Watch);
        self.halt();
        self.since_s = 0.0;
        self.face = Some(place);
        self.lasts_s = self.dice.between(WATCHES_S);
        self.bored_s = WATCHES_AGAIN_S;
    }

    /// Stops for a speaker who stands there, and listens.
    pub fn listen(&mut self, place: ChartPoint) {
        self.watch(place);
        self.lasts_s = LISTENS_S;
    }

    /// Lets a step's time pass.
    pub fn pass(&mut self) {
        self.since_s += STEP_S;
        self.planned_s += STEP_S;
        self.angry_s = (self.angry_s - STEP_S).max(0.0);
        self.fires_in_s -= STEP_S;
        self.hidden_s = self.hidden_s.map(|since_s| since_s + STEP_S);
        self.fired_s += STEP_S;
        for left_s in [
            &mut self.bored_s,
            &mut self.sits_again_s,
            &mut self.under_fire_s,
            &mut self.covers_again_s,
        ] {
            *left_s = (*left_s - STEP_S).max(0.0);
        }
        if let Some(known) = &mut self.known {
            known.ago_s += STEP_S;
        }
        self.fear = self
            .fear
            .map(|(from, left_s)| (from, left_s - STEP_S))
            .filter(|(_, left_s)| *left_s > 0.0);
        for spot in &mut self.blocked {
            spot.1 -= STEP_S;
        }
        self.blocked.retain(|(_, left_s)| *left_s > 0.0);
    }

    /// Shows the shot that was just fired.
    pub fn show_shot(&self, figure: &mut Figure) {
        if figure.held.is_some() && self.fired_s.is_finite() {
            figure.posture.kick = (-self.fired_s / KICK_S).exp() as f32;
            figure.flashes = self.fired_s < FLASH_S;
        }
    }

    /// Where a shot goes for a perfect aim: as much astray as chance has it.
    pub fn astray(&mut self, velocity: DVec3, most_rad: f64) -> DVec3 {
        let right = velocity.cross(DVec3::Y).normalize_or(DVec3::X);
        let up = right.cross(velocity).normalize_or(DVec3::Y);
        let mut off = || self.dice.between([-most_rad, most_rad]);
        let (to_right, to_top) = (off(), off());
        let speed = velocity.length();
        (velocity + (right * to_right + up * to_top) * speed).normalize_or(DVec3::Y) * speed
    }
}
