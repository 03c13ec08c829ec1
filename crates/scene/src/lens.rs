//! The lens through which the world is seen: the map of its space, and the dial under the wheel.
//!
//! The lens never changes the world itself. Every map's dial is flat at zero, so the maps are swapped there: the dial
//! glides to zero, the map is swapped, and the dial glides to the goal of the new map.
//! At zero the raised map still lights the land by its curved normals, though it puts every point where the flat
//! picture does whatever its radius. So its curvature glides to nothing too, and comes back with it.

use std::sync::Arc;

use antipode_geometry::{Horizon, HyperbolicMap, Map, Raised, Strategy, ViewMode};

use crate::tuning::{DIAL_REMAINDER_PER_S, DIAL_SWAP_AT};

/// Share of the world's curvature at which maps are swapped: light no longer tells it from none.
const SHARE_SWAP_AT: f64 = 1e-3;

/// A glide that is this near to its goal is there.
const ARRIVES: f64 = 1e-4;

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
    shown: ViewMode,
    wanted: ViewMode,
    goals: DialGoals,
    value: f64,
    /// Share of the world's own curvature that is shown, 0 to 1; below 1 only while maps change.
    share: f64,
    strategy: Arc<dyn Strategy>,
}

impl Lens {
    /// The picture of a new world in that space, its dial at rest.
    pub fn new(world: Arc<dyn Strategy>) -> Self {
        let view = own_view(&*world);
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

    /// The space of the world that is pictured.
    pub(crate) fn world(&self) -> &Arc<dyn Strategy> {
        &self.world
    }

    /// The strategy that pictures are taken with at this moment.
    pub fn strategy(&self) -> &Arc<dyn Strategy> {
        &self.strategy
    }

    /// The map of a hyperbolic world: the one asked for, while the other still gives way to it.
    pub fn map(&self) -> Option<HyperbolicMap> {
        match self.wanted {
            ViewMode::Map(map) => Some(map),
            ViewMode::Plain | ViewMode::Bent => None,
        }
    }

    /// Goal of the dial of a hyperbolic world.
    pub fn curvature(&self) -> Option<f64> {
        self.map().map(|_| self.goal())
    }

    /// Goal of the dial of a flat world whose picture is bent.
    pub fn bend(&self) -> Option<f64> {
        (self.wanted == ViewMode::Bent).then(|| self.goal())
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
        let views = self.world.view_modes();
        let after = views.iter().skip_while(|it| **it != self.wanted).nth(1);
        let Some(next) = after.or(views.first()).filter(|it| **it != self.wanted) else {
            return false;
        };
        self.wanted = *next;
        true
    }

    /// Shows a map at once. Returns false where the world has no maps.
    pub fn set_map(&mut self, map: HyperbolicMap) -> bool {
        let has = self.has(ViewMode::Map(map));
        if has {
            self.arrive(ViewMode::Map(map));
        }
        has
    }

    /// Sets the dial of a hyperbolic world at once. Returns false when out of range or there is none.
    pub fn set_curvature(&mut self, value: f64) -> bool {
        let ViewMode::Map(map) = self.wanted else {
            return false;
        };
        self.set_at_once(ViewMode::Map(map), value)
    }

    /// Bends a flat world's picture at once, up to 20 hyperbolic and down to -20 spherical; 0 unbends it.
    /// Returns false when out of range or the world is not flat.
    pub fn set_bend(&mut self, value: f64) -> bool {
        if !self.has(ViewMode::Bent) || !self.set_at_once(ViewMode::Bent, value) {
            return false;
        }
        if value == 0.0 {
            self.arrive(ViewMode::Plain);
        }
        true
    }

    /// Sets the dial of a bent picture at once; 0 shows it flat, and bent it stays. Returns false when out of range
    /// or the picture is not bent.
    pub(crate) fn set_bend_dial(&mut self, value: f64) -> bool {
        self.bend().is_some() && self.set_at_once(ViewMode::Bent, value)
    }

    /// Shows at once what it glides to.
    pub(crate) fn settle(&mut self) {
        self.arrive(self.wanted);
    }

    /// Takes over what a save tells; settings out of range are left as they are in a new world.
    pub fn restore(&mut self, map: HyperbolicMap, bent: bool, goals: DialGoals) {
        let maps = HyperbolicMap::ALL.map(ViewMode::Map);
        let saved = [goals.raised, goals.horizon];
        for (view, goal) in maps
            .into_iter()
            .zip(saved)
            .chain([(ViewMode::Bent, goals.bend)])
        {
            if fits(view, goal) {
                self.set_goal(view, goal);
            }
        }
        let view = ViewMode::saved(self.world.view_modes(), map, bent);
        self.arrive(view);
    }

    /// Glides for `dt_s` seconds; the last ten-thousandth is taken at once so that the dial comes to rest.
    pub fn glide(&mut self, dt_s: f64) {
        let changes = self.shown != self.wanted;
        let fades = matches!(self.shown, ViewMode::Map(_));
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
    pub(crate) fn at(&self) -> (ViewMode, f64, f64) {
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

    fn has(&self, view: ViewMode) -> bool {
        self.world.view_modes().contains(&view)
    }

    fn goal_of(&self, view: ViewMode) -> f64 {
        match view {
            ViewMode::Plain => 0.0,
            ViewMode::Map(HyperbolicMap::Raised) => self.goals.raised,
            ViewMode::Map(HyperbolicMap::Horizon) => self.goals.horizon,
            ViewMode::Bent => self.goals.bend,
        }
    }

    fn set_goal(&mut self, view: ViewMode, goal: f64) {
        match view {
            ViewMode::Plain => {}
            ViewMode::Map(HyperbolicMap::Raised) => self.goals.raised = goal,
            ViewMode::Map(HyperbolicMap::Horizon) => self.goals.horizon = goal,
            ViewMode::Bent => self.goals.bend = goal,
        }
    }

    fn set_at_once(&mut self, view: ViewMode, goal: f64) -> bool {
        let fits = fits(view, goal);
        if fits {
            self.set_goal(view, goal);
            self.arrive(view);
        }
        fits
    }

    /// Shows a picture with its dial at its goal.
    fn arrive(&mut self, view: ViewMode) {
        self.wanted = view;
        self.value = self.goal();
        self.share = 1.0;
        self.show(view);
    }

    fn show(&mut self, view: ViewMode) {
        self.shown = view;
        self.strategy = self.pictured(view, self.share);
    }

    /// The strategy of a picture of this world, with a share of its curvature.
    pub(crate) fn pictured(&self, view: ViewMode, share: f64) -> Arc<dyn Strategy> {
        view.of(&self.world, share.max(SHARE_SWAP_AT))
    }
}

/// The world's own picture: that of every new world.
pub(crate) fn own_view(world: &dyn Map) -> ViewMode {
    world.view_modes().first().copied().unwrap_or_default()
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
pub(crate) fn is_own(view: ViewMode, value: f64, share: f64) -> bool {
    match view {
        ViewMode::Plain => true,
        ViewMode::Bent => value == 0.0,
        ViewMode::Map(map) => {
            map == HyperbolicMap::Raised && value == Raised::DIAL.default && share == 1.0
        }
    }
}

/// Whether a dial can be set to a value; no dial can be set to what is no number.
fn fits(view: ViewMode, goal: f64) -> bool {
    view.dial()
        .is_some_and(|dial| (dial.min..=dial.max).contains(&goal))
}

#[cfg(test)]
mod tests;
