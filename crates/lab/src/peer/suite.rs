//! Which representations are compared by which tests, and their medians.

use super::chart;
use super::disk::Disk;
use super::halfplane::HalfPlane;
use super::linear::{BARE, COLUMNS, LIFTED, Linear, PUBLISHED};
use super::model::Model;
use super::number::{Counted, Number, Operations, count};
use super::outcome::Outcome;
use super::polar::Polar;
use super::reference::Pair;
use super::trials::{self, Keeping};
use super::walkers::{self, Parting};

/// One of the tests. What each does is told in the documentation of the module above.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Test {
    /// An isometry round a loop.
    LoopIso,
    /// A point round a loop.
    LoopAny,
    /// Distance and angle of a far tile.
    AngleDist,
    /// The distance of two neighbours on a large circle.
    Similarity,
    /// The distance of two opposite points of a large circle.
    Dissimilarity,
    /// Two walkers on one line, until their tiles part.
    Walk,
    /// The same, until their distance is wrong.
    WalkDistance,
    /// A point that comes and goes.
    Close,
}

impl Test {
    /// All of them, in the order of the tables.
    pub const ALL: [Self; 8] = [
        Self::LoopIso,
        Self::LoopAny,
        Self::AngleDist,
        Self::Similarity,
        Self::Dissimilarity,
        Self::Walk,
        Self::WalkDistance,
        Self::Close,
    ];

    /// The published name.
    pub fn name(self) -> &'static str {
        match self {
            Self::LoopIso => "loop_iso",
            Self::LoopAny => "loop_any",
            Self::AngleDist => "angledist",
            Self::Similarity => "similarity",
            Self::Dissimilarity => "dissimilarity",
            Self::Walk => "walk",
            Self::WalkDistance => "walk (distance)",
            Self::Close => "close",
        }
    }

    /// What its figures count.
    pub fn unit(self) -> &'static str {
        match self {
            Self::LoopIso | Self::LoopAny | Self::AngleDist | Self::Close => "tiles",
            Self::Similarity | Self::Dissimilarity => "radii",
            Self::Walk | Self::WalkDistance => "steps",
        }
    }

    /// Whether its result depends on the tolerance.
    pub fn has_tolerance(self) -> bool {
        self != Self::Walk
    }
}

/// How far a run of a test got, within a tolerance, from a seed.
#[derive(Clone, Copy, Debug)]
enum Trial {
    /// Takes part in every test.
    Every(fn(Test, f64, u64) -> Outcome),
    /// None where the test means nothing.
    Some(fn(Test, f64, u64) -> Option<Outcome>),
}

/// A representation in some precision.
#[derive(Clone, Debug)]
pub struct Subject {
    /// Of the representation.
    pub name: &'static str,
    /// Of the precision.
    pub precision: &'static str,
    /// Whether it is measured against the others: it keeps the camera-relative rule.
    pub is_ours: bool,
    /// What its operations cost; none where there are none of its own.
    pub costs: Option<Costs>,
    trial: Trial,
}

/// The machine operations behind each operation of a representation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Costs {
    /// A turn from its angle.
    pub spin: Operations,
    /// A translation from its length.
    pub push: Operations,
    /// An isometry on a point.
    pub apply: Operations,
    /// An isometry after another.
    pub compose: Operations,
    /// The way back.
    pub inverse: Operations,
    /// The translation that takes the origin to a point.
    pub push_to: Operations,
    /// A point's distance.
    pub distance: Operations,
    /// A point's direction.
    pub angle: Operations,
}

fn drop_it<T>(value: T) {
    drop(std::hint::black_box(value));
}

/// What a representation's operations cost, on isometries and points in general position.
fn costs<M: Model<N = Counted>>() -> Costs {
    let number = Counted::of;
    let motion = |turn, along, then| {
        let turned = M::compose(&M::spin(number(turn)), &M::push(number(along)));
        M::compose(&turned, &M::spin(number(then)))
    };
    let (first, second) = (motion(0.3, 0.4, 0.5), motion(-0.2, 0.7, 0.1));
    let point = M::apply(&motion(0.6, 0.5, 0.0), &M::origin());
    Costs {
        spin: count(|| drop_it(M::spin(number(0.5)))),
        push: count(|| drop_it(M::push(number(0.5)))),
        apply: count(|| drop_it(M::apply(&first, &point))),
        compose: count(|| drop_it(M::compose(&first, &second))),
        inverse: count(|| drop_it(M::inverse(&first))),
        push_to: count(|| drop_it(M::push_to(&point))),
        distance: count(|| drop_it(M::distance(&point))),
        angle: count(|| drop_it(M::angle(&point))),
    }
}

fn as_coordinates<M: Model>(test: Test, tolerance: f64, seed: u64) -> Outcome {
    let kept = Keeping::Coordinates;
    match test {
        Test::LoopIso => trials::loop_iso::<M>(kept, seed, tolerance),
        Test::LoopAny => trials::loop_any::<M>(kept, seed, tolerance),
        Test::AngleDist => trials::angledist::<M>(kept, seed, tolerance),
        Test::Similarity => trials::pair::<M>(Pair::Similar, seed, tolerance),
        Test::Dissimilarity => trials::pair::<M>(Pair::Opposite, seed, tolerance),
        Test::Walk => walkers::apart::<M>(Parting::Tiles, seed),
        Test::WalkDistance => walkers::apart::<M>(Parting::Distance(tolerance), seed),
        Test::Close => trials::close::<M>(kept, seed, tolerance),
    }
}

fn camera_relative<N: Number>(test: Test, tolerance: f64, seed: u64) -> Outcome {
    let kept = Keeping::Tiles;
    match test {
        Test::LoopIso => trials::loop_iso::<Disk<N>>(kept, seed, tolerance),
        Test::LoopAny => trials::loop_any::<Disk<N>>(kept, seed, tolerance),
        Test::AngleDist => trials::angledist::<Disk<N>>(kept, seed, tolerance),
        Test::Similarity => chart::pair_relative::<N>(Pair::Similar, seed, tolerance),
        Test::Dissimilarity => chart::pair_relative::<N>(Pair::Opposite, seed, tolerance),
        Test::Walk => walkers::beside::<N>(Parting::Tiles, seed),
        Test::WalkDistance => walkers::beside::<N>(Parting::Distance(tolerance), seed),
        Test::Close => trials::close::<Disk<N>>(kept, seed, tolerance),
    }
}

fn in_chart<N: Number>(test: Test, tolerance: f64, seed: u64) -> Option<Outcome> {
    match test {
        Test::AngleDist => Some(chart::angledist::<N>(seed, tolerance)),
        Test::Similarity => Some(chart::pair::<N>(Pair::Similar, seed, tolerance)),
        Test::Dissimilarity => Some(chart::pair::<N>(Pair::Opposite, seed, tolerance)),
        _ => None,
    }
}

fn both(name: &'static str, trials: [Trial; 2], costs: Option<Costs>) -> [Subject; 2] {
    let precisions = [<f32 as Number>::NAME, <f64 as Number>::NAME];
    [0, 1].map(|at| Subject {
        name,
        precision: precisions[at],
        is_ours: false,
        costs,
        trial: trials[at],
    })
}

fn peers<A: Model, B: Model, C: Model<N = Counted>>() -> [Subject; 2] {
    let trials = [
        Trial::Every(as_coordinates::<A>),
        Trial::Every(as_coordinates::<B>),
    ];
    both(A::NAME, trials, Some(costs::<C>()))
}

/// All of them: the peers, then the port's own types, then the camera-relative rule.
pub fn subjects() -> Vec<Subject> {
    let chart = both(
        "exponential chart",
        [Trial::Some(in_chart::<f32>), Trial::Some(in_chart::<f64>)],
        None,
    );
    let ours = [
        Trial::Every(camera_relative::<f32>),
        Trial::Every(camera_relative::<f64>),
    ];
    let ours = both("camera-relative", ours, Some(costs::<Disk<Counted>>()));
    let ours = ours.map(|subject| Subject {
        is_ours: true,
        ..subject
    });
    [
        peers::<Linear<f32, PUBLISHED>, Linear<f64, PUBLISHED>, Linear<Counted, PUBLISHED>>(),
        peers::<Linear<f32, BARE>, Linear<f64, BARE>, Linear<Counted, BARE>>(),
        peers::<Linear<f32, COLUMNS>, Linear<f64, COLUMNS>, Linear<Counted, COLUMNS>>(),
        peers::<Linear<f32, LIFTED>, Linear<f64, LIFTED>, Linear<Counted, LIFTED>>(),
        peers::<HalfPlane<f32>, HalfPlane<f64>, HalfPlane<Counted>>(),
        peers::<Polar<f32>, Polar<f64>, Polar<Counted>>(),
        peers::<Disk<f32>, Disk<f64>, Disk<Counted>>(),
        chart,
        ours,
    ]
    .concat()
}

/// The medians of one subject, in the order of [`Test::ALL`].
pub type Medians = [Option<Outcome>; Test::ALL.len()];

impl Subject {
    /// The median of a test over so many seeds.
    pub fn median(&self, test: Test, tolerance: f64, seeds: u64) -> Option<Outcome> {
        let runs: Option<Vec<_>> = (0..seeds)
            .map(|seed| match self.trial {
                Trial::Every(run) => Some(run(test, tolerance, seed)),
                Trial::Some(run) => run(test, tolerance, seed),
            })
            .collect();
        Outcome::median(runs?)
    }

    /// The medians at each of two tolerances. What does not depend on them is run once.
    pub fn medians(&self, tolerances: [f64; 2], seeds: u64) -> [Medians; 2] {
        let first = Test::ALL.map(|test| self.median(test, tolerances[0], seeds));
        let mut second = first;
        for (median, test) in second.iter_mut().zip(Test::ALL) {
            if test.has_tolerance() {
                *median = self.median(test, tolerances[1], seeds);
            }
        }
        [first, second]
    }
}
