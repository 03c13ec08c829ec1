//! The bend of the thesis by J. L. Redondo Tello (2021), to be compared with: it depends on where the camera looks.
//!
//! With m and M the least and the greatest component of the directions of two opposite corners of the picture, along each
//! axis of the scene, f_i(r) = 2 smoothstep(m_i, M_i, r_i) - 1, and at a face r <- normalize(r + d f(r)), component by
//! component, with d = 1/s - 1. Axes are those of the scene even where the box is turned.

use glam::DVec3;

/// The directions of two opposite corners of a picture, component by component.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureCorners {
    /// Least components.
    pub low: DVec3,
    /// Greatest components.
    pub high: DVec3,
}

impl PictureCorners {
    /// Of two directions of length 1 in the scene.
    pub fn new(one: DVec3, opposite: DVec3) -> Self {
        Self {
            low: one.min(opposite),
            high: one.max(opposite),
        }
    }

    /// f(r), each component from -1 to 1.
    pub fn share(&self, r: DVec3) -> DVec3 {
        let width = self.high - self.low;
        let one = |i: usize| {
            // Where both corners agree the step is a jump, as on the adapters that the thesis ran on.
            let t = ((r[i] - self.low[i]) / width[i].max(1e-30)).clamp(0.0, 1.0);
            2.0 * t * t * (3.0 - 2.0 * t) - 1.0
        };
        DVec3::new(one(0), one(1), one(2))
    }

    /// The direction r bent by d, or by its inverse where `d` has its sign turned; r itself where nothing is left of it.
    pub fn bend(&self, r: DVec3, d: DVec3) -> DVec3 {
        (r + d * self.share(r)).try_normalize().unwrap_or(r)
    }
}
