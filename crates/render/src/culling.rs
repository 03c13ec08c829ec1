//! Which figures a frame is to have, found before they are posed: by balls that hold them in any posture, against what
//! the picture shows and what the map of their shadows does.

use std::f64::consts::PI;

use antipode_frame::{Figure, Frame};
use antipode_geometry::{ChartPoint, Eye, Projection, Viewer};
use glam::DVec3;

use crate::hand::{MUZZLE_M, grip_m};
use crate::models::{Loaded, number};
use crate::plan::{FramePlan, Tolerance};
use crate::rig::Reach;
use crate::shadow::{Light, Shot, key_body};

/// Room for what rounding takes, as a part of a ball's radius.
const SLACK: f64 = 0.01;
/// How far a soft shadow reaches past what throws it, metres.
const SOFT_M: f64 = 0.25;
/// Room for how far a light goes on before its map is drawn anew, and for what strays at the sides of a picture, radians.
const LIGHT_SLACK: f64 = 0.02;

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
            radius_m: f64::from(reach_m) * figure.level.most_stretch() * (1.0 + SLACK),
        }
    }
}

/// What is wanted of a figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wanted {
    /// Whether it may be in the picture.
    pub seen: bool,
    /// The heights towards the light between which it lies, if it may fall on the map of figures' shadows.
    pub falls: Option<[f64; 2]>,
    /// Whether it may do so where the picture shows it.
    pub shades: bool,
}

/// The map on which the shadows of figures fall.
#[derive(Clone, Copy, Debug)]
pub struct Falls {
    /// What it is a picture of.
    pub shot: Shot,
    /// Whether other views than the frame's own show it.
    pub is_shared: bool,
}

/// What shows figures in a frame.
pub struct Shown<'a> {
    frame: &'a Frame,
    view: Viewer<'a>,
    sides: [DVec3; 4],
    map: Option<Shot>,
    /// Sheets through the eye that no shadow passes towards the picture, by their normals in view coordinates.
    barriers: Vec<DVec3>,
}

impl<'a> Shown<'a> {
    /// What the picture shows, and the map of figures' shadows if there is one. Figures that are carried by one matrix
    /// stray by the tolerance.
    pub fn new(frame: &'a Frame, plan: &FramePlan, map: Option<Falls>) -> Self {
        let stray_px = Tolerance::of(frame.view.quality).shape_px;
        let sides = plan.bounds.sides(frame, stray_px);
        let own = map.filter(|map| !map.is_shared);
        Self {
            frame,
            view: frame.view.strategy.viewer(&frame.view.eye),
            sides,
            map: map.map(|map| map.shot),
            barriers: own.map_or(Vec::new(), |map| barriers(frame, sides, &map.shot.light)),
        }
    }

    /// What is wanted of what a ball holds.
    ///
    /// What is behind one of the picture's sides is not seen: [`antipode_geometry::Optics::ball_rises_m`]. In a closed world
    /// too, where what is behind the eye comes round as view coordinates do. Of a view that is moved that is not known.
    pub fn wants(&self, ball: &Ball) -> Wanted {
        let strategy = &*self.frame.view.strategy;
        let falls = self.map.and_then(|map| map.ball_heights(strategy, ball));
        if self.frame.view.is_moved() {
            return Wanted {
                seen: true,
                falls,
                shades: falls.is_some(),
            };
        }
        let at = (self.view)(ball.middle).truncate();
        let is_behind = |sheets: &[DVec3], radius_m: f64| {
            let rises_m = strategy.ball_rises_m(&self.frame.view.eye, ball.middle, radius_m);
            sheets.iter().any(|side| side.dot(at) < -rises_m)
        };
        let seen = !is_behind(&self.sides, ball.radius_m);
        let shadow_m = ball.radius_m + SOFT_M;
        Wanted {
            seen,
            falls,
            shades: falls.is_some() && (seen || !is_behind(&self.barriers, shadow_m)),
        }
    }
}

/// Sheets through the eye that no shadow of a light passes towards the picture, by their normals towards it.
///
/// A ray ends at the antipode of its light, straight away from one that is far off. Where rays are geodesics of the picture a
/// sheet's product with a ray's point is a sinusoid of its length, or linear: negative at both ends of less than half a
/// period, it is so between. So the picture's sides are such sheets where they have that antipode behind them. Where
/// pictures bend rays, which are straight in the chart, upright sheets are: those beside the picture are the same in both.
fn barriers(frame: &Frame, sides: [DVec3; 4], light: &Light) -> Vec<DVec3> {
    let (view, strategy) = (&frame.view, &frame.view.strategy);
    let (sheets, toward) = match light {
        Light::Far { toward, .. } => {
            let [right, up, front] = view.axes();
            let toward = DVec3::new(toward.dot(right), toward.dot(up), -toward.dot(front));
            let is_flat = !strategy.radius_at_m(&view.eye).is_finite();
            let sheets = match (is_flat, strategy.keeps_azimuths()) {
                (true, _) => sides.to_vec(),
                (false, true) => beside(&view.eye, &view.projection),
                (false, false) => Vec::new(),
            };
            (sheets, toward)
        }
        Light::Star { .. } => {
            let Some(body) = key_body(frame) else {
                return Vec::new();
            };
            (
                sides.to_vec(),
                view.point(body).truncate().normalize_or_zero(),
            )
        }
    };
    let mut sheets = sheets;
    sheets.retain(|side| side.dot(toward) > LIGHT_SLACK);
    sheets
}

/// The upright sheets through the eye that have a picture between them; none where it shows what is straight up or down.
fn beside(eye: &Eye, projection: &Projection) -> Vec<DVec3> {
    let [x, y] = [1.0 / projection.sx, 1.0 / projection.sy];
    let (sin, cos) = eye.yaw.sin_cos();
    let turn = |corner: [f64; 2]| {
        let way = eye.to_chart(DVec3::new(corner[0], corner[1], -1.0));
        (way.z * cos - way.x * sin).atan2(way.x * cos + way.z * sin)
    };
    let turns = [[-x, -y], [-x, y], [x, -y], [x, y]].map(turn);
    let least = turns.into_iter().fold(f64::INFINITY, f64::min) - LIGHT_SLACK;
    let most = turns.into_iter().fold(f64::NEG_INFINITY, f64::max) + LIGHT_SLACK;
    if most - least >= PI {
        return Vec::new();
    }
    let normal = |turn: f64, sign: f64| {
        let (sin, cos) = (eye.yaw + turn).sin_cos();
        eye.to_view(sign * DVec3::new(sin, 0.0, -cos))
    };
    vec![normal(most, 1.0), normal(least, -1.0)]
}
