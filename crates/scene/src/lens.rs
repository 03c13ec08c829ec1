//! Through which picture the world is seen: the map of its space, and the dial under the wheel.
//!
//! The world itself never changes with it. Every map's dial is flat at zero, so that is where one map gives way
//! to the other: the dial glides to zero, the map is swapped, and the dial glides to the goal of the new one.
//! At zero the raised map still lights the land by its curved normals, though it puts every point where the flat
//! picture does whatever its radius. So its curvature glides to nothing too, and comes back with it.

use std::sync::Arc;

use antipode_geometry::{Dial, Geometry, Horizon, HyperbolicMap, Raised, Strategy, picture};

use crate::tuning::{DIAL_REMAINDER_PER_S, DIAL_SWAP_AT};

/// Share of the world's curvature at which maps are swapped: light no longer tells it from none.
const SHARE_SWAP_AT: f64 = 1e-3;

/// A glide that is this near to its goal is there.
const ARRIVES: f64 = 1e-4;

/// One way to take pictures of a world.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LensView {
    /// The only picture of a spherical world, and the unbent one of a flat world.
    Plain,
    /// A map of a hyperbolic world.
    Map(HyperbolicMap),
    /// A flat world, bent.
    Bent,
}

impl LensView {
    fn dial(self) -> Option<Dial> {
        match self {
            Self::Plain => None,
            Self::Map(HyperbolicMap::Raised) => Some(Raised::DIAL),
            Self::Map(HyperbolicMap::Horizon) => Some(Horizon::DIAL),
            Self::Bent => Some(Horizon::BEND_DIAL),
        }
    }
}

/// Where each picture's dial is set, whichever is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DialGoals {
    /// Of the raised map, 0 to 20.
    pub raised: f64,
    /// Of the horizon map, 0 to 20.
    pub horizon: f64,
    /// Of the bend of flat worlds, -20 (spherical) to 20 (hyperbolic).
    pub bend: f64,
}

impl Default for DialGoals {
    fn default() -> Self {
        Self {
            raised: Raised::DIAL.default,
            horizon: Horizon::DIAL.default,
            bend: Horizon::BEND_DIAL.default,
        }
    }
}

/// The picture of a world: which one is shown, which one is wanted, and the dial that glides between them.
#[derive(Clone, Debug)]
pub struct Lens {
    world: Arc<dyn Strategy>,
    shown: LensView,
    wanted: LensView,
    goals: DialGoals,
    value: f64,
    /// Share of the world's own curvature that is shown, 0 to 1; below 1 only while maps change.
    share: f64,
    strategy: Arc<dyn Strategy>,
}

impl Lens {
    /// The picture of a new world in that space, its dial at rest.
    pub fn new(world: Arc<dyn Strategy>) -> Self {
        let view = if world.geometry() == Geometry::Hyperbolic {
            LensView::Map(HyperbolicMap::default())
        } else {
            LensView::Plain
        };
        let mut lens = Self {
            shown: view,
            wanted: view,
            goals: DialGoals::default(),
            value: 0.0,
            share: 1.0,
            strategy: Arc::clone(&world),
            world,
        };
        lens.arrive(view);
        lens
    }

    /// The strategy that pictures are taken with at this moment.
    pub fn strategy(&self) -> &Arc<dyn Strategy> {
        &self.strategy
    }

    /// The map of a hyperbolic world: the one asked for, while the other still gives way to it.
    pub fn map(&self) -> Option<HyperbolicMap> {
        match self.wanted {
            LensView::Map(map) => Some(map),
            LensView::Plain | LensView::Bent => None,
        }
    }

    /// Goal of the dial of a hyperbolic world.
    pub fn curvature(&self) -> Option<f64> {
        self.map().map(|_| self.goal())
    }

    /// Goal of the dial of a flat world whose picture is bent.
    pub fn bend(&self) -> Option<f64> {
        (self.wanted == LensView::Bent).then(|| self.goal())
    }

    /// Smallest and largest setting of the dial under the wheel, if there is one now.
    pub fn range(&self) -> Option<(f64, f64)> {
        self.wanted.dial().map(|dial| (dial.min, dial.max))
    }

    /// The dial's value in use at this moment; zero is the flat picture.
    pub fn value(&self) -> f64 {
        self.value
    }

    /// What the dial glides to once the picture asked for is shown.
    pub fn goal(&self) -> f64 {
        self.goal_of(self.wanted)
    }

    /// Where every picture's dial is set.
    pub fn goals(&self) -> DialGoals {
        self.goals
    }

    /// Turns the dial under the wheel by notches of 1.
    pub fn turn(&mut self, notches: f64) {
        if let Some(dial) = self.wanted.dial() {
            let goal = (self.goal() + notches).clamp(dial.min, dial.max);
            self.set_goal(self.wanted, goal);
        }
    }

    /// Asks for the space's other picture: the other map of a hyperbolic world, bent or not in a flat one.
    /// Returns false where there is no other.
    pub fn turn_map(&mut self) -> bool {
        self.wanted = match (self.world.geometry(), self.wanted) {
            (_, LensView::Map(map)) => LensView::Map(map.other()),
            (_, LensView::Bent) => LensView::Plain,
            (Geometry::Euclidean, LensView::Plain) => LensView::Bent,
            (_, LensView::Plain) => return false,
        };
        true
    }

    /// Shows a map at once. Returns false where the world has no maps.
    pub fn set_map(&mut self, map: HyperbolicMap) -> bool {
        let fits = self.map().is_some();
        if fits {
            self.arrive(LensView::Map(map));
        }
        fits
    }

    /// Sets the dial of a hyperbolic world at once. Returns false when out of range or there is none.
    pub fn set_curvature(&mut self, value: f64) -> bool {
        let LensView::Map(map) = self.wanted else {
            return false;
        };
        self.set_at_once(LensView::Map(map), value)
    }

    /// Bends a flat world's picture at once, up to 20 hyperbolic and down to -20 spherical; 0 unbends it.
    /// Returns false when out of range or the world is not flat.
    pub fn set_bend(&mut self, value: f64) -> bool {
        if self.world.geometry() != Geometry::Euclidean || !self.set_at_once(LensView::Bent, value)
        {
            return false;
        }
        if value == 0.0 {
            self.arrive(LensView::Plain);
        }
        true
    }

    /// Sets the dial of a bent picture at once; 0 shows it flat, and bent it stays. Returns false when out of range
    /// or the picture is not bent.
    pub(crate) fn set_bend_dial(&mut self, value: f64) -> bool {
        self.bend().is_some() && self.set_at_once(LensView::Bent, value)
    }

    /// Shows at once what it glides to.
    pub(crate) fn settle(&mut self) {
        self.arrive(self.wanted);
    }

    /// Takes over what a save tells; settings out of range are left as they are in a new world.
    pub fn restore(&mut self, map: HyperbolicMap, bent: bool, goals: DialGoals) {
        let maps = HyperbolicMap::ALL.map(LensView::Map);
        let saved = [goals.raised, goals.horizon];
        for (view, goal) in maps
            .into_iter()
            .zip(saved)
            .chain([(LensView::Bent, goals.bend)])
        {
            if fits(view, goal) {
                self.set_goal(view, goal);
            }
        }
        let view = match self.world.geometry() {
            Geometry::Hyperbolic => LensView::Map(map),
            Geometry::Euclidean if bent => LensView::Bent,
            _ => LensView::Plain,
        };
        self.arrive(view);
    }

    /// Glides for `dt_s` seconds; the last ten-thousandth is taken at once so that the dial comes to rest.
    pub fn glide(&mut self, dt_s: f64) {
        let changes = self.shown != self.wanted;
        let fades = matches!(self.shown, LensView::Map(_));
        let faded = !fades || self.share <= SHARE_SWAP_AT;
        if changes && self.value.abs() <= DIAL_SWAP_AT && faded {
            self.value = 0.0;
            self.show(self.wanted);
            return;
        }
        let goal = if changes { 0.0 } else { self.goal() };
        let share = if changes && fades { 0.0 } else { 1.0 };
        self.value = glided(self.value, goal, dt_s);
        if self.share != share {
            self.share = glided(self.share, share, dt_s);
            self.show(self.shown);
        }
    }

    /// Whether it glides no more.
    pub(crate) fn rests(&self) -> bool {
        self.shown == self.wanted && self.value == self.goal() && self.share == 1.0
    }

    /// Whether the world's own picture is shown.
    pub(crate) fn is_own(&self) -> bool {
        is_own(self.shown, self.value, self.share)
    }

    /// What is shown at this moment: the picture, its dial, and the share of the curvature.
    pub(crate) fn at(&self) -> (LensView, f64, f64) {
        (self.shown, self.value, self.share)
    }

    /// Arrives at once where a glide would lead to.
    pub fn jump(&mut self) {
        if !self.rests() {
            self.arrive(self.wanted);
        }
    }

    /// Strategy and dial at a share of the way from where the glide was a step before. What was set at once is there.
    pub(crate) fn between(&self, before: &Self, share: f64) -> (Arc<dyn Strategy>, f64) {
        let glides = self.value != self.goal() || (self.value - before.value).abs() < ARRIVES;
        if self.shown != before.shown || !glides {
            return (Arc::clone(&self.strategy), self.value);
        }
        let mix = |from: f64, to: f64| to - (to - from) * (1.0 - share);
        let strategy = if self.share == before.share {
            Arc::clone(&self.strategy)
        } else {
            self.pictured(self.shown, mix(before.share, self.share))
        };
        (strategy, mix(before.value, self.value))
    }

    fn goal_of(&self, view: LensView) -> f64 {
        match view {
            LensView::Plain => 0.0,
            LensView::Map(HyperbolicMap::Raised) => self.goals.raised,
            LensView::Map(HyperbolicMap::Horizon) => self.goals.horizon,
            LensView::Bent => self.goals.bend,
        }
    }

    fn set_goal(&mut self, view: LensView, goal: f64) {
        match view {
            LensView::Plain => {}
            LensView::Map(HyperbolicMap::Raised) => self.goals.raised = goal,
            LensView::Map(HyperbolicMap::Horizon) => self.goals.horizon = goal,
            LensView::Bent => self.goals.bend = goal,
        }
    }

    fn set_at_once(&mut self, view: LensView, goal: f64) -> bool {
        let fits = fits(view, goal);
        if fits {
            self.set_goal(view, goal);
            self.arrive(view);
        }
        fits
    }

    /// Shows a picture with its dial at its goal.
    fn arrive(&mut self, view: LensView) {
        self.wanted = view;
        self.value = self.goal();
        self.share = 1.0;
        self.show(view);
    }

    fn show(&mut self, view: LensView) {
        self.shown = view;
        self.strategy = self.pictured(view, self.share);
    }

    /// The strategy of a picture of this world, with a share of its curvature.
    pub(crate) fn pictured(&self, view: LensView, share: f64) -> Arc<dyn Strategy> {
        let (map, bent) = match view {
            LensView::Plain => return Arc::clone(&self.world),
            LensView::Map(map) => (map, false),
            LensView::Bent => (HyperbolicMap::default(), true),
        };
        let radius_m = self.world.radius_m() / share.max(SHARE_SWAP_AT);
        picture(self.world.geometry(), radius_m, map, bent)
    }
}

/// One step of the glide from `value` to `goal`.
fn glided(value: f64, goal: f64, dt_s: f64) -> f64 {
    let next = goal + (value - goal) * DIAL_REMAINDER_PER_S.powf(dt_s);
    if (next - goal).abs() < ARRIVES {
        goal
    } else {
        next
    }
}

/// Whether that is a world's own picture: straight where space is flat, and the one that every new hyperbolic world
/// begins with.
pub(crate) fn is_own(view: LensView, value: f64, share: f64) -> bool {
    match view {
        LensView::Plain => true,
        LensView::Bent => value == 0.0,
        LensView::Map(map) => {
            map == HyperbolicMap::Raised && value == Raised::DIAL.default && share == 1.0
        }
    }
}

/// Whether a dial can be set to a value; no dial can be set to what is no number.
fn fits(view: LensView, goal: f64) -> bool {
    view.dial()
        .is_some_and(|dial| (dial.min..=dial.max).contains(&goal))
}

#[cfg(test)]
mod tests;
