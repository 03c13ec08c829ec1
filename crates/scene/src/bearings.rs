//! Lays things out as on a map around the player: bearings, north, the equator, and what stands about.
//!
//! A map is of the sheet at height 0, which lines along the ground never leave in any space: each place is drawn in
//! the direction in which the shortest line to it sets out, at that line's length (azimuthal equidistant). In worlds in
//! squares, whose plane has more room than any sheet of paper, it is drawn nearer, as `on_map_m` has it (conformal
//! disc). The picture's dial has no part in it.

use std::f64::consts::PI;

use antipode_geometry::{ChartPoint, Eye, Strategy, Viewer};
use antipode_items::Item;
use glam::{DVec2, DVec3};

use crate::actors::{ActorId, Actors};
use crate::bot;
use crate::fixture;
use crate::npc::any_heading;
use crate::situation::Situation;
use crate::world::World;

/// North of worlds without an equator, as a heading of the space that its charts are turned in: the way of -x, about which
/// the stars turn. The sun comes up at -z, to the right of it.
const OPEN_NORTH_RAD: f64 = PI;

/// Which way the player looks, and where that is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bearings {
    /// Heading of the view, radians from +x towards +z of the player's chart.
    pub heading_rad: f64,
    /// Heading of north. In a world with an equator north is a place, where -x of hemisphere A meets the equator; so
    /// nothing turns when the equator is crossed.
    pub north_rad: f64,
    /// The player's hemisphere and the nearest point of the equator, in a world that has one.
    pub equator: Option<Equator>,
    /// The way home, in a world in squares.
    pub home: Option<Home>,
}

/// The way to where one began, in the first square of a world in squares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Home {
    /// How many squares away it is: how many edges are between at least.
    pub squares: usize,
    /// How far it is along the ground sheet, metres.
    pub distance_m: f64,
    /// The heading that leads there.
    pub heading_rad: f64,
}

/// The nearest point of the equator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equator {
    /// The letter of the player's hemisphere.
    pub hemisphere: char,
    /// How far it is along the ground sheet, metres.
    pub distance_m: f64,
    /// The heading that leads there.
    pub heading_rad: f64,
}

/// Where on the way to the edge of a map a car beyond it is marked.
const EDGE: f64 = 0.94;

/// What is marked on a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LandmarkKind {
    /// A lamp that was put down.
    Lamp,
    /// Someone who means no harm.
    Neutral,
    /// Someone who fights the player.
    Hostile,
    /// A car that nobody drives.
    Car,
    /// A flag that was planted.
    Flag,
    /// A door.
    Door,
    /// A breadcrumb.
    Crumb,
    /// Where one began, in a world in squares.
    Home,
}

/// Something on the map.
#[derive(Clone, Debug, PartialEq)]
pub struct Landmark {
    /// What it is.
    pub kind: LandmarkKind,
    /// Its name, of what has one; else empty.
    pub name: String,
    /// Metres of the map from the player along +x and +z of the player's chart.
    pub at: DVec2,
}

/// Places points on a map about one of them.
pub(crate) struct Locator<'a> {
    strategy: &'a dyn Strategy,
    eye: &'a Eye,
    view: Viewer<'a>,
}

/// The eye of a map about a point.
pub(crate) fn map_eye(about: ChartPoint) -> Eye {
    Eye {
        point: on_sheet(about),
        ..Eye::default()
    }
}

fn on_sheet(point: ChartPoint) -> ChartPoint {
    ChartPoint::new(point.chart, point.pos.with_y(0.0))
}

/// How far from a map's middle a place is drawn that is so many metres away along the ground sheet, in metres of the map.
///
/// In worlds in squares it is Poincare's disc, which keeps all angles: a length of `d` is seen as `2 R tanh(d / 2 R)`, in the
/// middle as long as it is, and the disc of radius 2 R holds the whole plane.
pub(crate) fn on_map_m(strategy: &dyn Strategy, away_m: f64) -> f64 {
    if strategy.tiled().is_none() {
        return away_m;
    }
    let double_m = 2.0 * strategy.radius_m();
    double_m * (away_m / double_m).tanh()
}

impl<'a> Locator<'a> {
    /// A map about an eye's place.
    pub fn new(strategy: &'a dyn Strategy, eye: &'a Eye) -> Self {
        Self {
            strategy,
            eye,
            view: strategy.viewer(eye),
        }
    }

    /// Where a point is on the map, by [`on_map_m`].
    pub fn on_map(&self, point: ChartPoint) -> DVec2 {
        let at = self.at(point);
        let away_m = at.length();
        at.normalize_or_zero() * on_map_m(self.strategy, away_m)
    }

    /// The way to a point along the ground sheet: metres along +x and +z of the chart at the map's middle.
    pub fn at(&self, point: ChartPoint) -> DVec2 {
        let view = (self.view)(on_sheet(point));
        let away_m = self.strategy.eye_distance_m(self.eye, view);
        // The eye looks along +x and has +z at its right.
        DVec2::new(-view.z, view.x).normalize_or_zero() * away_m
    }
}

/// Which way the player looks, and where that is.
pub(crate) fn bearings(now: Situation<'_>) -> Bearings {
    let feet = now.feet();
    let globe = now.world.strategy.globe();
    let equator = globe.map(|globe| {
        let (x, z) = (feet.pos.x, feet.pos.z);
        Equator {
            hemisphere: globe.hemisphere(feet.chart),
            distance_m: (globe.equator_m() - x.hypot(z)).max(0.0),
            heading_rad: z.atan2(x),
        }
    });
    Bearings {
        heading_rad: now.head().yaw,
        north_rad: north_rad(&*now.world.strategy, feet),
        equator,
        home: home(now),
    }
}

/// The way to where one began, which is in the first square.
fn home(now: Situation<'_>) -> Option<Home> {
    let (strategy, feet) = (&*now.world.strategy, now.feet());
    let squares = strategy.tiled()?.edges_from_first(feet.chart)?;
    let eye = map_eye(feet);
    let at = Locator::new(strategy, &eye).at(now.start());
    Some(Home {
        squares,
        distance_m: at.length(),
        heading_rad: at.y.atan2(at.x),
    })
}

fn north_rad(strategy: &dyn Strategy, feet: ChartPoint) -> f64 {
    let Some(globe) = strategy.globe() else {
        if strategy.shader().daylight.has_axes {
            return any_heading(strategy, feet.chart, OPEN_NORTH_RAD);
        }
        let along = |axis: DVec3| -strategy.in_sky_axes(feet, axis).x;
        return along(DVec3::Z).atan2(along(DVec3::X));
    };
    let eye = map_eye(feet);
    let at = Locator::new(strategy, &eye).at(globe.north());
    if at == DVec2::ZERO {
        return OPEN_NORTH_RAD;
    }
    at.y.atan2(at.x)
}

/// The way to a flag, a door, a car or a breadcrumb.
#[derive(Clone, Debug, PartialEq)]
pub struct FlagWay {
    /// Which one.
    pub id: ActorId,
    /// Its name; may be empty.
    pub name: String,
    /// How far it is along the ground sheet, metres.
    pub distance_m: f64,
    /// The heading that leads there, radians of the player's chart.
    pub heading_rad: f64,
}

impl FlagWay {
    /// The way that leads so many metres along x and z of the player's chart.
    pub(crate) fn to(id: ActorId, name: String, at: DVec2) -> Self {
        Self {
            id,
            name,
            distance_m: at.length(),
            heading_rad: at.y.atan2(at.x),
        }
    }
}

/// The ways to all flags, in the order in which they were planted.
pub(crate) fn flag_ways(world: &World, actors: &Actors) -> Vec<FlagWay> {
    ways_to(world, actors, Item::Flag)
}

/// The ways to the doors, to the older one first.
pub(crate) fn door_ways(world: &World, actors: &Actors) -> Vec<FlagWay> {
    ways_to(world, actors, Item::Door)
}

/// The ways to the cars that nobody drives.
pub(crate) fn car_ways(world: &World, actors: &Actors) -> Vec<FlagWay> {
    let eye = map_eye(actors.feet());
    let locator = Locator::new(&*world.strategy, &eye);
    let cars = actors.car_views().into_iter().filter(|it| !it.driven);
    cars.map(|it| FlagWay::to(it.id, String::new(), locator.at(it.point)))
        .collect()
}

fn ways_to(world: &World, actors: &Actors, item: Item) -> Vec<FlagWay> {
    let eye = map_eye(actors.feet());
    let locator = Locator::new(&*world.strategy, &eye);
    fixture::map_of(actors, item, |id, it| {
        FlagWay::to(id, it.name.clone(), locator.at(it.foot.point))
    })
}

/// Lamps, breadcrumbs and everyone alive but the player, within a distance on the map; and cars, flags, doors and home, of which those
/// farther off are marked at the edge in their direction.
pub(crate) fn landmarks(now: Situation<'_>, reach_m: f64) -> Vec<Landmark> {
    use LandmarkKind::{Car, Crumb, Door, Flag, Home, Hostile, Lamp, Neutral};
    let (strategy, actors) = (&*now.world.strategy, now.actors);
    let eye = map_eye(actors.feet());
    let locator = Locator::new(strategy, &eye);
    let mark = |kind, point| Landmark {
        kind,
        name: String::new(),
        at: locator.on_map(point),
    };
    let stand = |item, kind| fixture::map_of(actors, item, |_, it| mark(kind, it.foot.point));
    let bots = bot::living(actors).into_iter().map(|it| {
        let kind = if it.fights { Hostile } else { Neutral };
        mark(kind, it.point)
    });
    let near = stand(Item::Crumb, Crumb).into_iter();
    let near = near.chain(stand(Item::Lamp, Lamp)).chain(bots);
    let near = near.filter(|it| it.at.length() <= reach_m);
    let cars = actors.car_views().into_iter();
    let cars = cars.filter(|it| !it.driven).map(|it| mark(Car, it.point));
    let flags = fixture::map_of(actors, Item::Flag, |_, it| Landmark {
        name: it.name.clone(),
        ..mark(Flag, it.foot.point)
    });
    let home = strategy.tiled().map(|_| mark(Home, now.start()));
    let far = cars.chain(flags).chain(stand(Item::Door, Door)).chain(home);
    let far = far.map(|it| Landmark {
        at: it.at.clamp_length_max(EDGE * reach_m),
        ..it
    });
    near.chain(far).collect()
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{ChartId, Geometry, strategy};
    use glam::DVec3;

    use super::*;

    #[test]
    fn in_open_worlds_the_map_is_the_plan_of_the_chart() {
        for geometry in [Geometry::Euclidean, Geometry::Hyperbolic] {
            let space = strategy(geometry, 20.0);
            let eye = map_eye(ChartPoint::a(DVec3::new(300.0, 17.0, -40.0)));
            let locator = Locator::new(&*space, &eye);
            for (x, z) in [(10.0, 0.0), (-3.0, 30.0), (25.0, -25.0)] {
                let at = locator.at(ChartPoint::a(DVec3::new(300.0 + x, 5.0, -40.0 + z)));
                assert!((at - DVec2::new(x, z)).length() < 1e-9, "{geometry} {at}");
            }
        }
    }

    #[test]
    fn over_the_equator_the_map_goes_on_as_the_ground_does() {
        let space = strategy(Geometry::Spherical, 32.0);
        let rim_m = space.domain(ChartId::FIRST).radius_m().unwrap_or_default();
        let eye = map_eye(ChartPoint::a(DVec3::new(0.0, 9.0, rim_m - 5.0)));
        let locator = Locator::new(&*space, &eye);
        let ahead = ChartPoint::a(DVec3::new(0.0, 9.0, rim_m + 7.0));
        let over = space
            .images(ahead, f64::INFINITY)
            .pop()
            .map(|crossing| crossing.point);
        let (here, there) = (locator.at(ahead), over.map(|over| locator.at(over)));
        assert!((here - DVec2::new(0.0, 12.0)).length() < 1e-9, "{here}");
        assert!(there.is_some_and(|there| (there - here).length() < 1e-9));
    }
}
