//! The ground of a chart as bodies have it that move there: in metres of the space about them.
//!
//! Where bodies move in the chart itself it is the chart's ground as it is. Elsewhere what is near a body is carried into the
//! body's own frame for each question: feet and centres are told in the chart, and velocities and normals in metres of the space
//! along the axes of the chart's frame at the body, which a level way turns.

use antipode_geometry::{BodyFrame, ChartId, ChartPoint, Strategy};
use glam::{DQuat, DVec3};

use crate::{ChartGround, PhysicsWorld};

/// What is solid in a chart, for bodies.
#[derive(Clone, Copy, Debug)]
pub struct BodyGround<'a> {
    pub(crate) ground: &'a ChartGround,
    /// The space and the chart, where bodies do not move in the chart itself.
    curved: Option<(&'a dyn Strategy, ChartId)>,
}

impl ChartGround {
    /// This ground for bodies that move in the chart itself.
    pub fn in_chart(&self) -> BodyGround<'_> {
        BodyGround {
            ground: self,
            curved: None,
        }
    }
}

impl PhysicsWorld {
    /// What is solid in a chart, for bodies.
    pub fn for_bodies<'a>(&'a self, space: &'a dyn Strategy, chart: ChartId) -> BodyGround<'a> {
        BodyGround {
            ground: self.chart(chart),
            curved: (!space.moves_in_chart()).then_some((space, chart)),
        }
    }
}

impl BodyGround<'_> {
    /// Whether bodies move in frames of their own.
    pub(crate) fn curved(&self) -> bool {
        self.curved.is_some()
    }

    /// What a body moves in at a place of the chart (m); none where that is the chart.
    pub(crate) fn frame(&self, at: DVec3) -> Option<BodyFrame<'_>> {
        let (space, chart) = self.curved?;
        BodyFrame::of(space, ChartPoint::new(chart, at))
    }
}

/// Where a body is in the chart that has come so far (m) from a place there, of which a frame is, and by how many radians its
/// directions have turned, as by [`antipode_geometry::Crossing`].
pub(crate) fn arrival(frame: Option<&BodyFrame<'_>>, from: DVec3, off: DVec3) -> (DVec3, f64) {
    frame.map_or((from + off, 0.0), |frame| {
        let arrival = frame.arrival(off);
        (arrival.point.pos, arrival.turn_rad)
    })
}

/// A velocity that takes the turn of its way; to the bit itself where there is none.
pub(crate) fn turned(velocity: DVec3, turn_rad: f64) -> DVec3 {
    if turn_rad == 0.0 {
        velocity
    } else {
        DQuat::from_rotation_y(turn_rad) * velocity
    }
}
