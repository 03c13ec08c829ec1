//! Spaces, frames and numbers for the planner's tests.

use std::sync::Arc;

use antipode_frame::{Content, Frame, View};
use antipode_geometry::{Eye, Geometry, HyperbolicMap, Projection, Strategy, picture};
use glam::DVec2;

/// The same numbers on every run.
pub struct Numbers(u64);

impl Numbers {
    /// Numbers that follow from a seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// From the first to before the second.
    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }

    /// A direction in the plane.
    pub fn turn(&mut self) -> DVec2 {
        DVec2::from_angle(self.between(0.0, std::f64::consts::TAU))
    }
}

/// Every space and map, with the range of the dial.
pub fn spaces() -> Vec<(&'static str, Arc<dyn Strategy>, [f64; 2])> {
    let (raised, horizon) = (HyperbolicMap::Raised, HyperbolicMap::Horizon);
    let of = |geometry, map, radius_m, bent| picture(geometry, radius_m, map, bent);
    let sphere = |radius_m| of(Geometry::Spherical, raised, radius_m, false);
    vec![
        (
            "flat",
            of(Geometry::Euclidean, raised, 0.0, false),
            [0.0; 2],
        ),
        (
            "bent",
            of(Geometry::Euclidean, raised, 0.0, true),
            [-20.0, 20.0],
        ),
        (
            "raised",
            of(Geometry::Hyperbolic, raised, 20.0, false),
            [0.0, 20.0],
        ),
        (
            "horizon",
            of(Geometry::Hyperbolic, horizon, 20.0, false),
            [0.0, 20.0],
        ),
        ("small sphere", sphere(16.0), [0.0; 2]),
        ("sphere", sphere(32.0), [0.0; 2]),
        ("large sphere", sphere(256.0), [0.0; 2]),
    ]
}

/// A frame without land or light, seen from the middle of the chart.
pub fn frame(space: &Arc<dyn Strategy>) -> Frame {
    let eye = Eye {
        lift_m: 1.62,
        ..Eye::default()
    };
    let projection = Projection::new(75_f64.to_radians(), 16.0 / 9.0, 0.02);
    let content = Content {
        loaded_world: 1,
        ..Content::default()
    };
    let view = View {
        fog_distance_m: 400.0,
        ..View::new(eye, projection, Arc::clone(space))
    };
    Frame::new(content, view)
}
