//! What an aberration is: a box, how space is stretched in it, and what its faces do.

use glam::{DMat3, DQuat, DVec3};

/// A box inside of which space is stretched along the box's own axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Aberration {
    /// What messages call it.
    pub name: String,
    /// Its middle, metres of the scene.
    pub centre: DVec3,
    /// Turns the box's axes into the scene's; of length 1.
    pub turn: DQuat,
    /// Half of its edges, metres of the scene, along its own axes.
    pub half: DVec3,
    /// Felt metres for a metre of scene along each of its own axes, from 1/32 to 32: above 1 it is bigger inside.
    pub stretch: DVec3,
    /// What its faces do to who crosses them.
    pub sides: Sides,
    /// Which way it is felt.
    pub ways: Ways,
}

/// What the faces of a box do. Faces whose two tangential stretches are 1 are its doors: there the first three are the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sides {
    /// Faces that are no doors are opaque walls, from both sides. A tunnel with these is exact Euclidean geometry.
    #[default]
    Walls,
    /// The felt direction is kept at every face.
    Soft,
    /// The tangential part of the covector p = A^T w, A = K^-1, is kept, as light does in glass; total reflection included.
    Snell,
    /// The bend that J. L. Redondo Tello's thesis gives to light, which depends on the camera; with its faults.
    Legacy(Exit),
}

/// The direction of light that leaves a box of [`Sides::Legacy`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Exit {
    /// That with which it came in.
    #[default]
    Original,
    /// The bend again with its sign turned.
    Inverse,
    /// That which it has.
    None,
}

/// Which way a box is felt.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Ways {
    /// Whichever way one goes.
    #[default]
    Both,
    /// Only by what heads along this axis of the box, 0 to 2, rather than against it; the rest crosses it as if it were
    /// not there. At right angles to the axis both agree where only this axis is stretched, so no picture has a seam.
    Along(u8),
}

impl Aberration {
    /// A tunnel along axis `axis`, 0 to 2, that feels `felt_m` metres long: stretched along this axis only, with walls.
    pub fn tunnel(centre: DVec3, turn: DQuat, half: DVec3, axis: usize, felt_m: f64) -> Self {
        let mut stretch = DVec3::ONE;
        stretch[axis] = felt_m / (2.0 * half[axis]);
        Self {
            name: "tunnel".to_owned(),
            centre,
            turn,
            half,
            stretch,
            sides: Sides::Walls,
            ways: Ways::Both,
        }
    }

    /// K = R diag(1/s) R^T: the displacement in the scene of a felt one inside.
    pub fn squeeze(&self) -> DMat3 {
        let turn = DMat3::from_quat(self.turn);
        turn * DMat3::from_diagonal(self.stretch.recip()) * turn.transpose()
    }

    /// Whether the two faces across axis `axis` are doors: whether the stretches along the other two are 1.
    pub fn is_door(&self, axis: usize) -> bool {
        (0..3).all(|other| other == axis || self.stretch[other] == 1.0)
    }

    /// Whether the two faces across axis `axis` are opaque.
    pub fn is_wall(&self, axis: usize) -> bool {
        self.sides == Sides::Walls && !self.is_door(axis)
    }
}

/// The stretch that the thesis's number d stands for: s = 1/(1 + d). None for d <= -1, which has no meaning: a speed of
/// nought or less.
pub fn stretch_of_legacy(d: f64) -> Option<f64> {
    (d > -1.0 && d.is_finite()).then(|| 1.0 / (1.0 + d))
}
