//! Far tiles, and somebody who walks on the plane.

use antipode_geometry::tiling::{Frame, Side};
use glam::{DMat4, DVec4};
use proptest::prelude::{Strategy as Generator, any, prop};

/// Up to so many sides, drawn.
pub fn sides(most: usize) -> impl Generator<Value = Vec<Side>> {
    prop::collection::vec(any::<u8>().prop_map(Side::new), 1..most)
}

/// How far a tile's centre is from the root's, radii.
pub fn distance(frame: &Frame) -> f64 {
    frame.to_root().distance()
}

/// The first tile more than so far out, always to a child, over the first side of the drawn ones that leads to one.
pub fn outward(drawn: &[Side], radii: f64) -> Frame {
    let mut frame = Frame::ROOT;
    for side in drawn.iter().cycle() {
        let next = frame.neighbour(*side).unwrap();
        let child = next.back == Side::PARENT && next.frame != Frame::ROOT;
        // From every tile a child lies over side 0.
        let next = if child {
            next
        } else {
            frame.neighbour(Side::new(0)).unwrap()
        };
        frame = next.frame;
        if distance(&frame) > radii {
            break;
        }
    }
    frame
}

/// Somebody who walks on the plane and keeps its address: a tile, and how they stand in its frame, as the directions of their
/// +x, up and +z, and the point.
#[derive(Clone, Copy)]
pub struct Hiker {
    pub frame: Frame,
    pub pose: DMat4,
}

impl Hiker {
    pub fn at(frame: &Frame) -> Self {
        Self {
            frame: *frame,
            pose: DMat4::IDENTITY,
        }
    }

    /// Straight on along +x, so many radii, in steps of at most a hundredth.
    pub fn walk(&mut self, radii: f64) {
        let steps = (radii * 100.0).ceil().max(1.0);
        let (sinh, cosh) = ((radii / steps).sinh(), (radii / steps).cosh());
        let step = DMat4::from_cols(
            DVec4::new(cosh, 0.0, 0.0, sinh),
            DVec4::Y,
            DVec4::Z,
            DVec4::new(sinh, 0.0, 0.0, cosh),
        );
        for _ in 0..steps as usize {
            self.pose *= step;
            let place = self.frame.place(self.pose.w_axis).unwrap();
            self.frame = place.frame;
            self.pose = place.way.lorentz() * self.pose;
        }
    }

    /// From +x towards +z.
    pub fn turn(&mut self, angle_rad: f64) {
        let (sin, cos) = angle_rad.sin_cos();
        self.pose *= DMat4::from_cols(
            DVec4::new(cos, 0.0, sin, 0.0),
            DVec4::Y,
            DVec4::new(-sin, 0.0, cos, 0.0),
            DVec4::W,
        );
    }

    /// Where another is, as this one sees it.
    pub fn sight(&self, other: &Self) -> DVec4 {
        let way = self.frame.between(&other.frame).unwrap().lorentz();
        inverse(self.pose) * (way * other.pose.w_axis)
    }

    /// How far another is, radii.
    pub fn distance(&self, other: &Self) -> f64 {
        let at = self.sight(other);
        at.x.hypot(at.z).asinh()
    }
}

/// The inverse of a Lorentz matrix: `G M^T G`, G = diag(1, 1, 1, -1).
pub fn inverse(matrix: DMat4) -> DMat4 {
    let flip = DMat4::from_diagonal(DVec4::new(1.0, 1.0, 1.0, -1.0));
    flip * matrix.transpose() * flip
}
