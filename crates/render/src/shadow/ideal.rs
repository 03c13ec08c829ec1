//! A key light that is an ideal point of hyperbolic space: that in which the sun stands as the eye sees it.
//!
//! All geodesics to it are upright in the half space over a plane, so that a map is a parallel picture there;
//! docs/shadows.md has the coordinates.

use antipode_frame::View;
use antipode_geometry::{ChartPoint, Eye, Strategy};
use glam::{DVec3, DVec4};

use super::caster::Caster;
use super::light::{Crop, Light, across};

/// From the ideal point in which a direction of the sky's axes at the eye ends. As the eye has it that is the null vector
/// (direction, 1), which goes to the model about the middle of the eye's chart as points do.
pub(super) fn ideal(sky: DVec3, view: &View) -> Light {
    let (strategy, eye) = (&*view.strategy, &view.eye);
    let radius_m = strategy.radius_m();
    let frame = DVec3::AXES.map(|axis| axis * strategy.in_sky_axes(eye.point, axis).dot(sky));
    let seen = eye.to_view(frame.into_iter().sum());
    let null = strategy.view_matrix(eye).inverse() * (seen * radius_m).extend(1.0);
    let toward = null.truncate().normalize_or(DVec3::Y);
    Light::Far {
        toward,
        across: across(toward),
        anchor: ChartPoint::new(eye.point.chart, DVec3::ZERO),
        per_m: 1.0 / radius_m,
    }
}

impl Light {
    /// The way to an ideal point from a point of the space, in the frame of an eye there: its null vector as that has it, by
    /// its first three.
    pub(super) fn toward_from(&self, view: &View) -> DVec3 {
        let Self::Far {
            toward,
            anchor,
            per_m,
            ..
        } = self
        else {
            return DVec3::Y;
        };
        let (strategy, eye) = (&*view.strategy, &view.eye);
        let way = strategy.between(anchor.chart, eye.point.chart);
        let null = strategy.view_matrix(eye) * way * (*toward / *per_m).extend(1.0);
        null.truncate().normalize_or(DVec3::Y)
    }

    /// A ball of hyperbolic space that holds a box: its middle, and R sinh of its radius over R, metres. By its corners, between
    /// which it bulges by less than a tenth: a bound by how far a chart stretches anywhere about it is e^40 times as much towards
    /// a corner of a square, and what a map's depth holds goes by the widest of all balls.
    pub(super) fn ball_about(strategy: &dyn Strategy, of: &Caster) -> (ChartPoint, f64) {
        let (middle, eye) = (ChartPoint::new(of.chart, of.middle()), Eye::default());
        let corner_m = |corner: u32| {
            let sign = |axis: u32| f64::from(2 * (corner >> axis & 1)) - 1.0;
            let by = of.reach() * DVec3::new(sign(0), sign(1), sign(2));
            strategy.distance_m(middle, middle.moved(by), &eye)
        };
        let most_m = (0..8).map(corner_m).fold(0.0, f64::max);
        let radius_m = strategy.radius_m();
        (middle, radius_m * (1.1 * most_m / radius_m).sinh())
    }

    /// The heights between which a ball lies, by the base of its middle and its radius as [`Self::ball_about`] has it, if any of it
    /// falls on a crop.
    ///
    /// In the half space over the plane with the light at infinity a point is at `t = 1/q` over its place h there, and a
    /// ball about it of the radius r is a ball about (h, t cosh r) of the radius t sinh r. The height is
    /// `R/2 (t^2 + h^2 - 1)`, h in radii.
    pub(super) fn heights_of(
        &self,
        strategy: &dyn Strategy,
        crop: &Crop,
        (base, rises_m): (DVec4, f64),
    ) -> Option<[f64; 2]> {
        let at = self.on_plane(crop.face, base);
        let spread = self.length_on_plane(base, rises_m);
        if (at - crop.centre).abs().max_element() > crop.half + spread {
            return None;
        }
        let radius_m = strategy.radius_m();
        let (sinh, t) = (rises_m / radius_m, self.length_on_plane(base, 1.0));
        let away = (at / radius_m).length().hypot(t * sinh.hypot(1.0));
        let height = |out: f64| 0.5 * radius_m * (out.max(0.0).powi(2) - 1.0);
        Some([height(away - t * sinh), height(away + t * sinh)])
    }
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{ChartId, Geometry, strategy};

    use super::*;

    /// Of the size of a chunk with trees, towards the corner of a square.
    #[test]
    fn a_ball_holds_its_box_and_is_not_much_larger() {
        for radius_m in [30.152, 60.305, 120.61] {
            let space = strategy(Geometry::HyperbolicWorld, radius_m);
            let share = radius_m / 60.305;
            for (middle, reach) in [
                ([0.0, 10.0, 0.0], [18.0, 15.0, 18.0]),
                ([-17.0, 42.0, 13.5], [24.0, 17.0, 22.0]),
                ([-24.0, -20.0, -30.0], [12.0, 15.0, 11.0]),
            ] {
                let [middle, reach] = [middle, reach].map(|it| DVec3::from(it) * share);
                let of = Caster::new(ChartId::FIRST, middle - reach, middle + reach);
                let (about, rises_m) = Light::ball_about(&*space, &of);
                let ball_m = (rises_m / radius_m).asinh() * radius_m;
                let mut farthest_m: f64 = 0.0;
                for i in 0..125 {
                    let step = |of: i32| f64::from(of % 5) / 2.0 - 1.0;
                    let by = reach * DVec3::new(step(i), step(i / 5), step(i / 25));
                    farthest_m =
                        farthest_m.max(space.distance_m(about, about.moved(by), &Eye::default()));
                }
                let times = ball_m / farthest_m;
                assert!((1.0..1.2).contains(&times), "{radius_m} {middle}: {times}");
            }
        }
    }
}
