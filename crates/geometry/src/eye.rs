//! The camera: a place in the chart and where it looks.

use glam::DVec3;

use crate::ChartPoint;

/// A camera in chart coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Eye {
    /// Where the camera is.
    pub point: ChartPoint,
    /// Heading in radians, from +x towards +z.
    pub yaw: f64,
    /// Elevation in radians, positive upwards, within a right angle of level.
    pub pitch: f64,
    /// How far the picture leans, radians, as a head does: positive with the right side down.
    pub roll: f64,
    /// The curvature under the player's wheel: of the raised map the offset c in metres, 0 to 20;
    /// of the horizon map eighty times the curvature in 1/m. Other spaces ignore it.
    pub dial: f64,
    /// Height over the sheet that the horizon map keeps level, the player's feet, in metres.
    pub lift_m: f64,
}

impl Eye {
    /// The unit chart direction the camera looks along.
    pub fn front(&self) -> DVec3 {
        let (sin_yaw, cos_yaw) = self.yaw.sin_cos();
        let (sin_pitch, cos_pitch) = self.pitch.sin_cos();
        DVec3::new(cos_yaw * cos_pitch, sin_pitch, sin_yaw * cos_pitch)
    }

    /// The unit chart direction to the picture's right; level without a roll.
    pub fn right(&self) -> DVec3 {
        let (sin_yaw, cos_yaw) = self.yaw.sin_cos();
        let level = DVec3::new(-sin_yaw, 0.0, cos_yaw);
        if self.roll == 0.0 {
            return level;
        }
        let (sin_roll, cos_roll) = self.roll.sin_cos();
        level * cos_roll - level.cross(self.front()) * sin_roll
    }

    /// The unit chart direction of the picture's up.
    pub fn up(&self) -> DVec3 {
        self.right().cross(self.front())
    }

    /// A chart direction at the eye in view coordinates (right, up, back).
    pub fn to_view(&self, chart: DVec3) -> DVec3 {
        DVec3::new(
            chart.dot(self.right()),
            chart.dot(self.up()),
            -chart.dot(self.front()),
        )
    }

    /// A direction in view coordinates (right, up, back) as a chart direction at the eye.
    pub fn to_chart(&self, view: DVec3) -> DVec3 {
        self.right() * view.x + self.up() * view.y - self.front() * view.z
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axes_are_right_handed_and_unit_at_every_heading() {
        for i in 0..40 {
            let eye = Eye {
                yaw: f64::from(i) * 0.7 - 9.0,
                pitch: f64::from(i % 9) * 0.35 - 1.4,
                roll: f64::from(i % 5) * 0.3 - 0.6,
                ..Eye::default()
            };
            let (right, up, back) = (eye.right(), eye.up(), -eye.front());
            assert!((right.cross(up) - back).length() < 1e-15);
            assert!((up.length() - 1.0).abs() < 1e-15);
            assert!(up.y >= 0.0);
            let down = -(eye.pitch.cos() * eye.roll.sin());
            assert!((right.y - down).abs() < 1e-15, "the right side goes down");
            let v = DVec3::new(0.3, -2.0, 1.1);
            assert!((eye.to_chart(eye.to_view(v)) - v).length() < 1e-14);
        }
    }

    #[test]
    fn a_heading_of_zero_looks_along_x_with_z_to_the_right() {
        let eye = Eye::default();
        assert_eq!(eye.front(), DVec3::X);
        assert_eq!(eye.right(), DVec3::Z);
        assert_eq!(eye.up(), DVec3::Y);
    }
}
