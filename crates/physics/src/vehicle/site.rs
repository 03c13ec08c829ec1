//! Where an arena lies in a space whose bodies do not move in the chart: in metres of the space about a place near its first
//! vehicle, at its height.
//!
//! An arena's own places, stances and velocities are told from the site and along its frame; those of a vehicle, for all others, in
//! the chart that it belongs to, along that chart's frame there.

use std::sync::Arc;

use antipode_geometry::{BodyFrame, ChartId, ChartPoint, Crossing, Strategy};
use glam::DVec3;

use super::VehicleMotion;

/// The place about which an arena lies.
#[derive(Clone, Debug)]
pub(super) struct Site {
    space: Arc<dyn Strategy>,
    at: ChartPoint,
}

impl Site {
    /// About a place of a space whose bodies do not move in the chart.
    pub fn about(space: &Arc<dyn Strategy>, at: ChartPoint) -> Self {
        Self {
            space: Arc::clone(space),
            at,
        }
    }

    /// The place.
    pub fn at(&self) -> ChartPoint {
        self.at
    }

    /// The space.
    pub fn space(&self) -> &dyn Strategy {
        &*self.space
    }

    /// Metres of the space about the place.
    pub fn frame(&self) -> Option<BodyFrame<'_>> {
        BodyFrame::of(&*self.space, self.at)
    }

    /// Where a point of the world is from the site, and the turn that a direction takes which is told along the site's frame, to
    /// be told along that of the point; none where the site's chart does not reach so far.
    pub fn seen(&self, point: ChartPoint) -> Option<Crossing> {
        let over = if point.chart == self.at.chart {
            Crossing::within(point)
        } else {
            self.space.carry_near(point, self.at)?
        };
        let frame = self.frame()?;
        let off = frame.offsets()(over.point.pos);
        Some(Crossing {
            point: ChartPoint::new(self.at.chart, off),
            turn_rad: frame.arrival(off).turn_rad - over.turn_rad,
        })
    }

    /// A motion of the site as others know it, in a chart where that reaches so far, and the turn of its directions.
    pub fn told(&self, own: &VehicleMotion, chart: ChartId) -> (VehicleMotion, f64) {
        let arrival = self.frame().map_or_else(
            || Crossing::within(self.at.moved(own.place)),
            |frame| frame.arrival(own.place),
        );
        let arrival = self
            .space
            .carry(arrival.point, chart)
            .map_or(arrival, |over| Crossing {
                turn_rad: arrival.turn_rad + over.turn_rad,
                ..over
            });
        (own.carried(&arrival), arrival.turn_rad)
    }

    /// A short way in a chart from a point of it, in metres of the space along the chart's frame there.
    pub fn way(&self, from: ChartPoint, way: DVec3) -> DVec3 {
        self.space.in_frame(from, way)
    }
}

/// What a vehicle is to the arena that it is in, where that has a site.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sited {
    /// The arena's number.
    pub room: u64,
    /// Its motion as the arena has it.
    pub own: VehicleMotion,
    /// The turn of a direction of the arena to be told as the vehicle's motion is, radians.
    pub turn_rad: f64,
}
