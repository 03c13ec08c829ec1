//! Which figures a frame is to have, found before they are posed: by balls that hold them in any posture, against what
//! the picture shows and what the map of their shadows does.

use antipode_frame::{Figure, Frame};
use antipode_geometry::{ChartPoint, Viewer};
use glam::DVec3;

use crate::hand::{MUZZLE_M, grip_m};
use crate::models::{Loaded, number};
use crate::plan::{FramePlan, Tolerance};
use crate::rig::Reach;
use crate::shadow::Shot;

/// Room for what rounding takes, as a part of a ball's radius.
const SLACK: f64 = 0.01;

/// A ball of the chart.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    /// Its middle.
    pub middle: ChartPoint,
    /// Its radius, metres.
    pub radius_m: f64,
}

/// How far each model reaches.
#[derive(Debug)]
pub struct Reaches(Vec<Reach>);

impl Reaches {
    /// Those of the models.
    pub fn of(models: &[Loaded]) -> Self {
        let reach = |model: &Loaded| match &model.rig {
            Some(rig) => rig.reach(),
            None => Reach {
                body_m: model.shape.radius_m(),
                hand_m: 0.0,
            },
        };
        Self(models.iter().map(reach).collect())
    }

    /// A ball that holds a figure and what it holds, however it is turned and held: the way to the hand, to what is in
    /// it and to what comes out of that are no longer than their sum.
    pub fn ball(&self, figure: &Figure) -> Ball {
        let own = self.0[number(figure.model)];
        let mut reach_m = own.body_m;
        if let Some(held) = figure.held {
            let from_m = own.hand_m + grip_m(held).length();
            let flash_m = MUZZLE_M.length() + self.0[number(antipode_frame::ModelId::Flash)].body_m;
            let flash_m = if figure.flashes { flash_m } else { 0.0 };
            reach_m = reach_m.max(from_m + flash_m.max(self.0[number(held)].body_m));
        }
        Ball {
            middle: figure.point,
            radius_m: f64::from(reach_m) * (1.0 + SLACK),
        }
    }
}

/// What is wanted of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wanted {
    /// Whether it may be in the picture.
    pub seen: bool,
    /// Whether it may fall on the map of figures' shadows.
    pub shades: bool,
}

/// What shows figures in a frame.
pub struct Shown<'a> {
    frame: &'a Frame,
    view: Viewer<'a>,
    sides: [DVec3; 4],
    map: Option<Shot>,
}

impl<'a> Shown<'a> {
    /// What the picture shows, and the map of figures' shadows if there is one. Figures that are carried by one matrix
    /// stray by the tolerance.
    pub fn new(frame: &'a Frame, plan: &FramePlan, map: Option<Shot>) -> Self {
        let stray_px = Tolerance::of(frame.view.quality).shape_px;
        Self {
            frame,
            view: frame.view.strategy.viewer(&frame.view.eye),
            sides: plan.bounds.sides(frame, stray_px),
            map,
        }
    }

    /// What is wanted of what a ball holds.
    pub fn wants(&self, ball: &Ball) -> Wanted {
        let strategy = &*self.frame.view.strategy;
        Wanted {
            seen: self.sees(ball),
            shades: self.map.is_some_and(|map| map.may_hold(strategy, ball)),
        }
    }

    /// Whether a ball is behind none of the picture's sides: [`antipode_geometry::Optics::ball_rises_m`]. In a closed world too, where
    /// what is behind the eye comes round as view coordinates do. Of a view that is moved that is not known.
    fn sees(&self, ball: &Ball) -> bool {
        if self.frame.view.is_moved() {
            return true;
        }
        let (strategy, eye) = (&*self.frame.view.strategy, &self.frame.view.eye);
        let rises_m = strategy.ball_rises_m(eye, ball.middle, ball.radius_m);
        let at = (self.view)(ball.middle).truncate();
        !self.sides.iter().any(|side| side.dot(at) < -rises_m)
    }
}
