//! Values over time, joined as glTF 2.0, 3.11 and appendix C have it.

use glam::{Quat, Vec3, Vec4};

/// How the values between two keys are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// Straight for vectors, on the shortest arc for turns.
    Linear,
    /// The earlier key's.
    Step,
    /// Cubic Hermite splines; each key has an incoming tangent, a value and an outgoing tangent.
    CubicSpline,
}

/// What can be interpolated.
pub trait Value: Copy {
    /// Between two keys, `t` in 0 to 1.
    fn between(self, other: Self, t: f32) -> Self;
    /// The sum of values times shares.
    fn sum(terms: [(Self, f32); 4]) -> Self;
}

impl Value for Vec3 {
    fn between(self, other: Self, t: f32) -> Self {
        self.lerp(other, t)
    }

    fn sum(terms: [(Self, f32); 4]) -> Self {
        terms.into_iter().map(|(v, share)| v * share).sum()
    }
}

impl Value for Quat {
    fn between(self, other: Self, t: f32) -> Self {
        self.slerp(other, t)
    }

    /// Componentwise and then of unit length, as appendix C asks.
    fn sum(terms: [(Self, f32); 4]) -> Self {
        let sum: Vec4 = terms
            .into_iter()
            .map(|(q, share)| Vec4::from(q) * share)
            .sum();
        sum.try_normalize().map_or(terms[0].0, Quat::from_vec4)
    }
}

/// A value over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve<T> {
    /// Seconds, growing from 0 or more; at least one.
    pub times: Vec<f32>,
    /// One for each time; three with [`Interpolation::CubicSpline`]: tangent in, value, tangent out.
    pub values: Vec<T>,
    /// What joins the keys.
    pub interpolation: Interpolation,
}

impl<T: Value> Curve<T> {
    /// The value at a time in seconds; before the first key and after the last it holds theirs.
    pub fn at(&self, time_s: f32) -> Option<T> {
        let next = self.times.partition_point(|&t| t <= time_s);
        let (Some(before), true) = (next.checked_sub(1), next < self.times.len()) else {
            return self.key(next.min(self.times.len().checked_sub(1)?));
        };
        let span = self.times[next] - self.times[before];
        let t = (time_s - self.times[before]) / span;
        let (a, b) = (self.key(before)?, self.key(next)?);
        // Not by the formulas, whose rounding would open a loop where its ends are the same key.
        if t <= 0.0 {
            return Some(a);
        }
        match self.interpolation {
            Interpolation::Step => Some(a),
            Interpolation::Linear => Some(a.between(b, t)),
            Interpolation::CubicSpline => {
                let (out, into) = (
                    *self.values.get(3 * before + 2)?,
                    *self.values.get(3 * next)?,
                );
                // Appendix C: tangents are per second, so the span carries them to the unit interval.
                let (t2, t3) = (t * t, t * t * t);
                Some(T::sum([
                    (a, 2.0 * t3 - 3.0 * t2 + 1.0),
                    (out, span * (t3 - 2.0 * t2 + t)),
                    (b, 3.0 * t2 - 2.0 * t3),
                    (into, span * (t3 - t2)),
                ]))
            }
        }
    }

    fn key(&self, index: usize) -> Option<T> {
        let at = if self.interpolation == Interpolation::CubicSpline {
            3 * index + 1
        } else {
            index
        };
        self.values.get(at).copied()
    }
}

impl Curve<Vec3> {
    /// Points whose convex hull holds every value. A Hermite segment is a Bezier curve with the control points
    /// p0, p0 + m0 dt/3, p1 - m1 dt/3, p1, and a Bezier curve stays within the hull of its control points.
    pub fn hull(&self) -> Vec<Vec3> {
        if self.interpolation != Interpolation::CubicSpline {
            return self.values.clone();
        }
        let mut out: Vec<Vec3> = self.values.chunks_exact(3).map(|key| key[1]).collect();
        for (k, times) in self.times.windows(2).enumerate() {
            let third = (times[1] - times[0]) / 3.0;
            if let Some([_, from, leaving, arriving, to, _]) = self.values.get(3 * k..3 * k + 6) {
                out.extend([*from + *leaving * third, *to - *arriving * third]);
            }
        }
        out
    }
}
