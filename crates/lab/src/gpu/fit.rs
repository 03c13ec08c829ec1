//! What a triangle and a pixel cost, told apart by least squares over frames that have many of one and few of the other.
//!
//! Model: a frame of V views with T million triangles and P million pixels in all takes t = a V + b T + c P milliseconds.
//! Long frames are measured as exactly as short ones in parts of themselves, so the sum of ((a V + b T + c P) / t - 1)^2
//! is made least. It is ||A x - 1||^2 with the rows (V, T, P) / t of A and x = (a, b, c); its gradient 2 A'(A x - 1)
//! is zero where A'A x = A'1.
//! Standard errors: x = (A'A)^-1 A'1 is linear in the measurements, so independent errors of variance s^2 in each row
//! make the covariance s^2 (A'A)^-1, and s^2 is the sum of squares over the number of frames less three.

use glam::{DMat3, DVec3};

/// One kind of frame: what it draws, and how long that takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    /// Views of the land.
    pub views: usize,
    /// Triangles, millions.
    pub triangles_m: f64,
    /// Pixels, millions.
    pub pixels_m: f64,
    /// Milliseconds, above zero.
    pub ms: f64,
}

/// A cost and its standard error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// Milliseconds.
    pub ms: f64,
    /// The standard error, milliseconds.
    pub off_ms: f64,
}

/// The costs that explain some frames best.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// Of a view in which next to nothing is drawn.
    pub view: Cost,
    /// Of a million triangles.
    pub triangles: Cost,
    /// Of a million pixels.
    pub pixels: Cost,
    /// Root of the mean square by which frames stray from the model, as a share of their times.
    pub rms: f64,
    /// The most that a frame strays, as a share of its time.
    pub worst: f64,
}

/// Least determinant of (A'A) with its columns brought to unit length, for the costs to be told apart: that of two
/// columns an angle apart is the square of its sine.
const LEAST_APART: f64 = 1e-6;

impl Load {
    fn row(&self) -> DVec3 {
        DVec3::new(self.views as f64, self.triangles_m, self.pixels_m) / self.ms
    }
}

impl Fit {
    /// The costs behind some frames; nothing where they are fewer than four, a time is not above zero, or triangles and
    /// pixels rise together so that they cannot be told apart.
    pub fn of(loads: &[Load]) -> Option<Self> {
        let freedom = loads.len().checked_sub(3).filter(|n| *n > 0)?;
        if loads.iter().any(|load| load.ms.is_nan() || load.ms <= 0.0) {
            return None;
        }
        let (mut normal, mut right) = (DMat3::ZERO, DVec3::ZERO);
        for row in loads.iter().map(Load::row) {
            normal += DMat3::from_cols(row * row.x, row * row.y, row * row.z);
            right += row;
        }
        let diagonal = DVec3::new(normal.x_axis.x, normal.y_axis.y, normal.z_axis.z);
        let apart = normal.determinant() / diagonal.element_product();
        if apart.is_nan() || apart <= LEAST_APART {
            return None;
        }
        let inverse = normal.inverse();
        let costs = inverse * right;
        let strays: Vec<f64> = loads.iter().map(|it| it.row().dot(costs) - 1.0).collect();
        let squares: f64 = strays.iter().map(|stray| stray * stray).sum();
        let variance = squares / freedom as f64;
        let cost = |ms: f64, own: f64| Cost {
            ms,
            off_ms: (variance * own).sqrt(),
        };
        Some(Self {
            view: cost(costs.x, inverse.x_axis.x),
            triangles: cost(costs.y, inverse.y_axis.y),
            pixels: cost(costs.z, inverse.z_axis.z),
            rms: (squares / loads.len() as f64).sqrt(),
            worst: strays.iter().fold(0.0, |most, it| most.max(it.abs())),
        })
    }

    /// Whether triangles and pixels each cost more than twice their standard errors.
    pub fn is_sure(&self) -> bool {
        let mut costs = [self.triangles, self.pixels].into_iter();
        costs.all(|cost| cost.ms > 2.0 * cost.off_ms)
    }

    /// What the model says that a frame takes, milliseconds.
    pub fn told_ms(&self, load: &Load) -> f64 {
        let drawn = self.triangles.ms * load.triangles_m + self.pixels.ms * load.pixels_m;
        self.view.ms * load.views as f64 + drawn
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;
    use crate::random::Numbers;

    /// Views, triangles and pixels: few pixels and many triangles, then the other way round.
    const DRAWN: [(usize, f64, f64); 8] = [
        (2, 0.3, 0.005),
        (4, 0.6, 0.01),
        (6, 0.9, 0.015),
        (8, 1.2, 0.02),
        (8, 0.02, 0.23),
        (8, 0.02, 0.92),
        (8, 0.03, 2.07),
        (8, 0.04, 3.69),
    ];

    fn loads(costs: [f64; 3], noise: impl Fn(usize) -> f64) -> Vec<Load> {
        let [view, triangles, pixels] = costs;
        let load = |(i, (views, triangles_m, pixels_m))| Load {
            views,
            triangles_m,
            pixels_m,
            ms: (view * views as f64 + triangles * triangles_m + pixels * pixels_m)
                * (1.0 + noise(i)),
        };
        DRAWN.into_iter().enumerate().map(load).collect()
    }

    #[test]
    fn known_costs_are_found_again() {
        for costs in [[0.02, 0.6, 0.25], [0.4, 250.0, 90.0], [0.0, 0.1, 2.0]] {
            let fit = Fit::of(&loads(costs, |_| 0.0)).unwrap();
            let found = [fit.view, fit.triangles, fit.pixels];
            for (found, known) in found.iter().zip(costs) {
                assert!((found.ms - known).abs() < 1e-9 * (1.0 + known), "{fit:?}");
                assert!(found.off_ms < 1e-6, "{fit:?}");
            }
            assert!(fit.rms < 1e-12 && fit.worst < 1e-12, "{fit:?}");
            assert!(fit.is_sure());
        }
    }

    #[test]
    fn with_noise_the_known_costs_lie_within_what_the_errors_say() {
        let costs = [0.02, 0.6, 0.25];
        let mut within = 0;
        let runs = 200;
        for seed in 0..runs {
            let mut numbers = Numbers::new(seed);
            let noise: Vec<f64> = DRAWN.map(|_| numbers.between(-0.05, 0.05)).into();
            let fit = Fit::of(&loads(costs, |i| noise[i])).unwrap();
            assert!(fit.worst <= 0.1 && fit.rms <= fit.worst, "{fit:?}");
            let found = [fit.view, fit.triangles, fit.pixels];
            let near = |(found, known): (&Cost, f64)| (found.ms - known).abs() < 2.6 * found.off_ms;
            within += usize::from(found.iter().zip(costs).all(near));
        }
        // 2.6 standard errors hold 95 of 100 with five frames to spare; here three at once.
        assert!(within as u64 >= runs * 8 / 10, "{within} of {runs}");
    }

    #[test]
    fn a_cost_that_drowns_in_noise_is_unsure() {
        let noise = |i: usize| if i.is_multiple_of(2) { 0.4 } else { -0.4 };
        let fit = Fit::of(&loads([1.0, 0.1, 0.1], noise)).unwrap();
        assert!(!fit.is_sure(), "{fit:?}");
    }

    #[test]
    fn what_cannot_be_told_apart_is_not_told() {
        let together = |i: usize| Load {
            views: 8,
            triangles_m: i as f64,
            pixels_m: 2.0 * i as f64,
            ms: 1.0 + i as f64,
        };
        assert_eq!(Fit::of(&[1, 2, 3, 4, 5].map(together)), None);
        assert_eq!(Fit::of(&loads([1.0; 3], |_| 0.0)[..3]), None);
        let mut broken = loads([1.0; 3], |_| 0.0);
        broken[0].ms = f64::NAN;
        assert_eq!(Fit::of(&broken), None);
    }
}
