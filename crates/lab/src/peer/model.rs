//! What a representation of the hyperbolic plane has to offer, and the moves of the heptagrid
//! made from it.
//!
//! Lengths are in radii of curvature. Angles are counterclockwise from the first axis. Each tile
//! has its own frame, with its centre at the origin and edge k in the direction `2 pi k / 7`.

use std::f64::consts::PI;

use super::number::Number;
use super::tiling::{EDGES, Tile, Tiling};

/// A representation of points and orientation-preserving isometries.
pub trait Model {
    /// Its precision.
    type N: Number;
    /// An isometry.
    type Isometry: Clone;
    /// A point.
    type Point: Clone;
    /// What it is called in tables.
    const NAME: &'static str;

    /// The isometry that moves nothing.
    fn identity() -> Self::Isometry;
    /// The point that isometries turn about.
    fn origin() -> Self::Point;
    /// Counterclockwise turn about the origin, in radians.
    fn spin(angle: Self::N) -> Self::Isometry;
    /// Translation along the first axis, in radii.
    fn push(distance: Self::N) -> Self::Isometry;
    /// `second` first, then `first`.
    fn compose(first: &Self::Isometry, second: &Self::Isometry) -> Self::Isometry;
    /// The image of a point.
    fn apply(isometry: &Self::Isometry, point: &Self::Point) -> Self::Point;
    /// The way back.
    fn inverse(isometry: &Self::Isometry) -> Self::Isometry;
    /// The translation that takes the origin to a point.
    fn push_to(point: &Self::Point) -> Self::Isometry;
    /// Distance from the origin, in radii.
    fn distance(point: &Self::Point) -> Self::N;
    /// Direction from the origin, in radians.
    fn angle(point: &Self::Point) -> Self::N;
}

/// Something that isometries act on, so that a path can be followed by a point or by a pose.
pub trait Carried<M: Model>: Clone {
    /// The image under an isometry.
    #[must_use]
    fn carried(&self, isometry: &M::Isometry) -> Self;
}

/// An isometry that is carried by composing.
#[derive(Clone, Debug)]
pub struct Pose<I>(pub I);

/// A point that is carried by its image.
#[derive(Clone, Debug)]
pub struct Spot<P>(pub P);

impl<M: Model> Carried<M> for Pose<M::Isometry> {
    fn carried(&self, isometry: &M::Isometry) -> Self {
        Self(M::compose(isometry, &self.0))
    }
}

impl<M: Model> Carried<M> for Spot<M::Point> {
    fn carried(&self, isometry: &M::Isometry) -> Self {
        Self(M::apply(isometry, &self.0))
    }
}

/// The distance between the centres of neighbouring heptagons, in radii: the side opposite
/// `2 pi / 3` of the triangle with angles `2 pi / 3`, `pi / 7`, `pi / 7`, by the cosine rule for
/// angles. Each precision works it out for itself, as the published tests do.
pub fn edge_length<N: Number>() -> N {
    let corner = N::of(2.0 * PI) / N::of(3.0);
    let half = N::of(PI) / N::of(EDGES as f64);
    let cosh = (corner.cos() + half.cos() * half.cos()) / (half.sin() * half.sin());
    (cosh + (cosh * cosh - N::of(1.0)).sqrt()).ln()
}

/// The moves from tile to tile in one representation, worked out once.
#[derive(Clone, Debug)]
pub struct Moves<M: Model> {
    /// By the number of the edge that leads back: turned so that it points along the first axis.
    turned_back: Vec<M::Isometry>,
    push: M::Isometry,
    /// By the number of the edge crossed: turned so that the first axis points along it.
    turned: Vec<M::Isometry>,
}

impl<M: Model> Default for Moves<M> {
    fn default() -> Self {
        Self::new()
    }
}

impl<M: Model> Moves<M> {
    /// All of them.
    pub fn new() -> Self {
        let part = M::N::of(2.0 * PI) / M::N::of(EDGES as f64);
        let angles = (0..EDGES).map(|edge| M::N::of(edge as f64) * part);
        Self {
            turned_back: angles
                .clone()
                .map(|angle| M::spin(M::N::of(PI) - angle))
                .collect(),
            push: M::push(edge_length()),
            turned: angles.map(M::spin).collect(),
        }
    }

    /// `carried` from the frame of a neighbour into the frame of a tile: the neighbour lies
    /// across `edge`, which it numbers `back`; both below [`EDGES`].
    pub fn cross<C: Carried<M>>(&self, edge: usize, back: usize, carried: &C) -> C {
        carried
            .carried(&self.turned_back[back])
            .carried(&self.push)
            .carried(&self.turned[edge])
    }

    /// `carried` from the frame of the last tile of a path into the frame of its first, one tile
    /// at a time. A pair of tiles that are no neighbours is no move.
    pub fn along<C: Carried<M>>(&self, tiling: &mut Tiling, path: &[Tile], carried: C) -> C {
        path.windows(2).rev().fold(carried, |carried, pair| {
            match tiling.edge_between(pair[0], pair[1]) {
                Some((edge, back)) => self.cross(edge, back, &carried),
                None => carried,
            }
        })
    }
}
