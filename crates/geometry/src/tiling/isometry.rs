//! Moves of the hyperbolic plane onto itself that keep the tiling, exactly.

use glam::{DMat4, DVec4};

use super::{Golden, Side, TilingError};

/// The square root of the golden ratio: what x and z are measured in, in radii.
const UNIT: f64 = 1.272_019_649_514_069;
const MINUS_ONE: Golden = Golden::ONE.negated();

/// A matrix on (x, z, w) that keeps `w^2 - phi (x^2 + z^2)` and turns no picture into its mirror image. All are products
/// of [`STEP`](Self::STEP) and [`QUARTER`](Self::QUARTER).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Isometry {
    /// Where the axes of x, z and w go.
    columns: [[Golden; 3]; 3],
}

impl Isometry {
    /// Leaves everything where it is.
    pub const IDENTITY: Self = Self {
        columns: [
            [Golden::ONE, Golden::ZERO, Golden::ZERO],
            [Golden::ZERO, Golden::ONE, Golden::ZERO],
            [Golden::ZERO, Golden::ZERO, Golden::ONE],
        ],
    };
    /// The step along x to the centre of the neighbour: `x' = phi x + w`, `w' = phi x + phi w`.
    ///
    /// In radii it is the boost `X' = cosh(d) X + sinh(d) W`, `W' = sinh(d) X + cosh(d) W` with `cosh(d) = phi`,
    /// `sinh(d) = sqrt(phi^2 - 1) = sqrt(phi)`, and `X = sqrt(phi) x`.
    pub const STEP: Self = Self {
        columns: [
            [Golden::PHI, Golden::ZERO, Golden::PHI],
            [Golden::ZERO, Golden::ONE, Golden::ZERO],
            [Golden::ONE, Golden::ZERO, Golden::PHI],
        ],
    };
    /// The quarter turn about the centre, from x to z.
    pub const QUARTER: Self = Self {
        columns: [
            [Golden::ZERO, Golden::ONE, Golden::ZERO],
            [MINUS_ONE, Golden::ZERO, Golden::ZERO],
            [Golden::ZERO, Golden::ZERO, Golden::ONE],
        ],
    };

    /// The matrix's columns: where the axes of x, z and w go, each as (x, z, w).
    pub fn columns(&self) -> [[Golden; 3]; 3] {
        self.columns
    }

    /// From coordinates in the frame of a tile's neighbour to those in the tile's own, by the side of the tile that the
    /// neighbour lies over and by the neighbour's side at that edge.
    ///
    /// # Errors
    /// None: its numbers are 0, 1 and phi with their signs.
    pub fn crossing(side: Side, back: Side) -> Result<Self, TilingError> {
        // The step alone arrives with the side 2 at the edge it came over.
        let turns = Side::PARENT.quarters_from(back);
        Ok(Self::IDENTITY
            .turned(side.number())
            .stepped()?
            .turned(turns))
    }

    /// This move after another: the product of the matrices.
    ///
    /// # Errors
    /// [`TilingError::OutOfReach`] where a number of the result is out of range.
    pub fn times(&self, other: &Self) -> Result<Self, TilingError> {
        let rows = self.rows();
        let mut columns = other.columns;
        for (column, theirs) in columns.iter_mut().zip(other.columns) {
            for (number, row) in column.iter_mut().zip(rows) {
                *number = Golden::dot(row, theirs)?;
            }
        }
        Ok(Self { columns })
    }

    /// This move after a step along x.
    ///
    /// # Errors
    /// As [`times`](Self::times).
    pub fn stepped(&self) -> Result<Self, TilingError> {
        let [x, z, w] = self.columns;
        let (mut x_to, mut w_to) = (x, w);
        for i in 0..3 {
            let far = w[i].times_phi()?;
            x_to[i] = x[i].times_phi()?.plus(far)?;
            w_to[i] = x[i].plus(far)?;
        }
        Ok(Self {
            columns: [x_to, z, w_to],
        })
    }

    /// This move after so many quarter turns about the centre.
    #[must_use]
    pub fn turned(&self, quarters: u8) -> Self {
        let [x, z, w] = self.columns;
        let minus = |column: [Golden; 3]| column.map(Golden::negated);
        let (x, z) = match quarters % 4 {
            0 => (x, z),
            1 => (z, minus(x)),
            2 => (minus(x), minus(z)),
            _ => (minus(z), x),
        };
        Self { columns: [x, z, w] }
    }

    /// The way back. With `G = diag(phi, phi, -1)`, `M^T G M = G`, so that it is `G^-1 M^T G`.
    ///
    /// # Errors
    /// As [`times`](Self::times).
    pub fn inverse(&self) -> Result<Self, TilingError> {
        let [x, z, w] = self.rows();
        let back = |row: [Golden; 3]| -> Result<[Golden; 3], TilingError> {
            Ok([row[0], row[1], row[2].times_phi()?.negated()])
        };
        let far = [w[0].over_phi()?.negated(), w[1].over_phi()?.negated(), w[2]];
        Ok(Self {
            columns: [back(x)?, back(z)?, far],
        })
    }

    /// Where a vector (x, z, w) goes.
    ///
    /// # Errors
    /// As [`times`](Self::times).
    pub fn moved(&self, vector: [Golden; 3]) -> Result<[Golden; 3], TilingError> {
        let [x, z, w] = self.rows();
        Ok([
            Golden::dot(x, vector)?,
            Golden::dot(z, vector)?,
            Golden::dot(w, vector)?,
        ])
    }

    /// The move as a matrix on points (X, Y, Z, W) of the space in radii, each number within 1e-15 of itself: it is
    /// exact until here. Heights stay.
    pub fn lorentz(&self) -> DMat4 {
        let [x, z, w] = self.columns.map(|column| column.map(Golden::to_f64));
        DMat4::from_cols(
            DVec4::new(x[0], 0.0, x[1], x[2] / UNIT),
            DVec4::Y,
            DVec4::new(z[0], 0.0, z[1], z[2] / UNIT),
            DVec4::new(w[0] * UNIT, 0.0, w[1] * UNIT, w[2]),
        )
    }

    /// How far the move takes the centre, in radii.
    pub fn distance(&self) -> f64 {
        let [x, z, _] = self.columns[2].map(Golden::to_f64);
        (UNIT * x.hypot(z)).asinh()
    }

    fn rows(&self) -> [[Golden; 3]; 3] {
        let [x, z, w] = self.columns;
        [0, 1, 2].map(|i| [x[i], z[i], w[i]])
    }
}
