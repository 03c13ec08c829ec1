//! Through what a world can be looked at.

use std::sync::Arc;

use crate::{Dial, Horizon, HyperbolicMap, Raised, Strategy};

/// One way to take pictures of a world.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ViewMode {
    /// As its own space has it.
    #[default]
    Plain,
    /// A map of a hyperbolic world.
    Map(HyperbolicMap),
    /// A flat world, bent.
    Bent,
}

impl ViewMode {
    /// The dial that bends the picture, zero being flat: land that is seen by one is not curved itself.
    pub fn dial(self) -> Option<Dial> {
        match self {
            Self::Plain => None,
            Self::Map(HyperbolicMap::Raised) => Some(Raised::DIAL),
            Self::Map(HyperbolicMap::Horizon) => Some(Horizon::DIAL),
            Self::Bent => Some(Horizon::BEND_DIAL),
        }
    }

    /// That of a save which names a map and says whether the picture is bent, among the views of a world: as far as the
    /// world has it.
    pub fn saved(views: &[Self], map: HyperbolicMap, bent: bool) -> Self {
        let named = [Some(Self::Map(map)), bent.then_some(Self::Bent)];
        let had = named.into_iter().flatten().find(|it| views.contains(it));
        had.or_else(|| views.first().copied()).unwrap_or_default()
    }

    /// The space that pictures of a world are taken with, with a share of the world's curvature above 0. Whatever is not
    /// about pictures is as in the world.
    pub fn of(self, world: &Arc<dyn Strategy>, share: f64) -> Arc<dyn Strategy> {
        let radius_m = world.radius_m() / share;
        match self {
            Self::Plain => Arc::clone(world),
            Self::Map(HyperbolicMap::Raised) => Arc::new(Raised::new(radius_m)),
            Self::Map(HyperbolicMap::Horizon) => Arc::new(Horizon::hyperbolic(radius_m)),
            Self::Bent => Arc::new(Horizon::bent()),
        }
    }
}
