//! What steps places, turns and sizes take while they are dragged.

/// Steps of drags; none where a step is 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Snap {
    /// Of places and lengths, metres.
    pub grid_m: f64,
    /// Of turns, degrees.
    pub turn_deg: f64,
}

impl Snap {
    /// A length on the grid.
    pub fn length(&self, metres: f64) -> f64 {
        nearest(metres, self.grid_m)
    }

    /// A turn by whole steps, radians.
    pub fn turn(&self, rad: f64) -> f64 {
        nearest(rad.to_degrees(), self.turn_deg).to_radians()
    }
}

fn nearest(value: f64, step: f64) -> f64 {
    if step > 0.0 {
        (value / step).round() * step
    } else {
        value
    }
}
