//! Boxes that make space longer or shorter in them.
//!
//! One metre of the scene along the box's axis i feels like s_i metres in it. The common one has an axis and a felt
//! length: s = felt / length along the axis, 1 along the others, so that its two doors are the same inside and outside.

use glam::DVec3;
use serde::Deserialize;

/// A box that makes space longer or shorter in it.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(try_from = "Written")]
pub struct Aberration {
    /// Half its lengths along its own axes, metres of the scene.
    pub half: DVec3,
    /// What it does to lengths.
    pub lengths: Lengths,
    /// What happens at its side faces.
    pub sides: Sides,
    /// For whom it is there.
    pub ways: Ways,
    /// Whether its edges are drawn, where nothing stands before them.
    pub outline: bool,
}

/// What an aberration does to lengths.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Lengths {
    /// Along one axis it feels this long; the others are as they are.
    Felt {
        /// The axis.
        axis: Axis,
        /// Felt metres from end to end.
        felt_m: f64,
    },
    /// Felt metres for one metre of the scene, along each axis.
    Stretch(DVec3),
}

/// One of a box's own axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub enum Axis {
    /// The first: its front.
    X,
    /// The second: upward, if it is not turned.
    Y,
    /// The third: its right-hand side.
    Z,
}

/// What happens at the faces of an aberration that are no doors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Sides {
    /// They have walls, made by themselves: exact, nobody sees through.
    #[default]
    Walls,
    /// The felt direction stays the same.
    Soft,
    /// Light is refracted by Snell's law.
    Snell,
    /// The rule of the thesis, with its faults.
    Legacy {
        /// What a ray does when it leaves.
        #[serde(default)]
        exit: Exit,
    },
}

/// What a ray does when it leaves an aberration by the rule of the thesis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
pub enum Exit {
    /// It takes its first direction again.
    #[default]
    Original,
    /// It is bent back.
    Inverse,
    /// It is not bent.
    Nothing,
}

/// For whom an aberration is there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
pub enum Ways {
    /// For all who enter.
    #[default]
    Both,
    /// For those who enter by the end that its axis leads away from; others find the plain length.
    Forward,
}

/// How it stands in a file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename = "Aberration")]
struct Written {
    half: DVec3,
    #[serde(default)]
    axis: Option<Axis>,
    #[serde(default)]
    felt: Option<f64>,
    #[serde(default)]
    stretch: Option<DVec3>,
    #[serde(default)]
    sides: Sides,
    #[serde(default)]
    ways: Ways,
    #[serde(default)]
    outline: bool,
}

impl TryFrom<Written> for Aberration {
    type Error = &'static str;

    fn try_from(it: Written) -> Result<Self, Self::Error> {
        let lengths = match (it.axis, it.felt, it.stretch) {
            (Some(axis), Some(felt_m), None) => Lengths::Felt { axis, felt_m },
            (None, None, Some(stretch)) => Lengths::Stretch(stretch),
            _ => return Err("an aberration has either axis and felt, or stretch"),
        };
        Ok(Self {
            half: it.half,
            lengths,
            sides: it.sides,
            ways: it.ways,
            outline: it.outline,
        })
    }
}

impl Axis {
    /// All three.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// 0, 1 or 2.
    pub fn index(self) -> usize {
        match self {
            Self::X => 0,
            Self::Y => 1,
            Self::Z => 2,
        }
    }
}

impl Aberration {
    /// Felt metres for one metre of the scene along each of its axes.
    pub fn stretch(&self) -> DVec3 {
        match self.lengths {
            Lengths::Felt { axis, felt_m } => {
                let mut stretch = DVec3::ONE;
                stretch[axis.index()] = felt_m / (2.0 * self.half[axis.index()]);
                stretch
            }
            Lengths::Stretch(stretch) => stretch,
        }
    }

    /// The axes whose two faces are doors: congruent inside and outside, since nothing is stretched along them.
    pub fn doors(&self) -> [bool; 3] {
        let plain = self.stretch().to_array().map(|s| s == 1.0);
        [
            plain[1] && plain[2],
            plain[0] && plain[2],
            plain[0] && plain[1],
        ]
    }
}

/// The stretch of the thesis's number d: s = 1 / (1 + d). Nothing where that has no meaning, at d <= -1.
pub fn stretch_of_thesis(d: f64) -> Option<f64> {
    (d > -1.0 && d.is_finite()).then(|| 1.0 / (1.0 + d))
}

/// The thesis's number of a stretch, which is above 0: d = 1/s - 1.
pub fn thesis_of_stretch(stretch: f64) -> f64 {
    1.0 / stretch - 1.0
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use super::*;

    #[test]
    fn the_numbers_of_the_thesis_are_stretches() {
        let s = |d| stretch_of_thesis(d).unwrap();
        assert!((s(2.0) - 1.0 / 3.0).abs() < 1e-15);
        assert!((s(-0.8) - 5.0).abs() < 1e-14);
        assert_eq!(s(0.0), 1.0);
        for d in [-0.9, -0.8, 0.0, 0.7, 2.0, 31.0] {
            assert!((thesis_of_stretch(s(d)) - d).abs() < 1e-13, "{d}");
        }
        for meaningless in [-1.0, -2.0, f64::NAN, f64::INFINITY] {
            assert_eq!(stretch_of_thesis(meaningless), None);
        }
    }

    #[test]
    fn a_felt_length_stretches_its_own_axis_alone() {
        let it = Aberration {
            half: DVec3::new(4.75, 5.25, 39.5),
            lengths: Lengths::Felt {
                axis: Axis::Z,
                felt_m: 395.0,
            },
            sides: Sides::Walls,
            ways: Ways::Both,
            outline: false,
        };
        assert_eq!(it.stretch(), DVec3::new(1.0, 1.0, 5.0));
        assert_eq!(it.doors(), [false, false, true]);
        let all = Aberration {
            lengths: Lengths::Stretch(DVec3::splat(2.0)),
            ..it
        };
        assert_eq!(all.doors(), [false; 3]);
    }
}
