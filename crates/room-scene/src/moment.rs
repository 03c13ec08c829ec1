//! A moment of a room, as a picture shows it: from where it is seen, who walks, what flies and lies there, and what lightens.

use antipode_rays::{Eye, Lamp, Mover};

use crate::figure::RoomFigure;
use crate::held::InHand;
use crate::scene::RoomScene;

/// What a picture of a moment shows beside what stays.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// From where it is seen.
    pub eye: Eye,
    /// Who walks.
    pub figure: RoomFigure,
    /// What is held before the eye.
    pub hand: Option<InHand>,
    /// What has come into the room since it was entered.
    pub things: Vec<Mover>,
    /// All that lightens.
    pub lamps: Vec<Lamp>,
}

/// How far the view is turned that no step has taken in yet, radians to the right and upwards.
pub type Turn = (f64, f64);

impl RoomScene {
    /// The moment after the last step.
    pub fn now(&self) -> Moment {
        self.moment(1.0, (0.0, 0.0))
    }

    /// The moment at a share of the way of the last step, 0 at its beginning and 1 at its end, along the way that was gone. The
    /// view is not between two steps but turned as far as it was asked to: nobody waits for that.
    pub fn moment(&self, share: f64, (right_rad, up_rad): Turn) -> Moment {
        let mut look = self.look;
        look.turn(right_rad, up_rad);
        let eye = self.eye_at(share, &look);
        Moment {
            eye,
            figure: self.figure_between(share),
            hand: self.held_between(&eye, share),
            things: self.movers_between(share),
            lamps: self.lamps_between(share),
        }
    }
}
