//! Places the health of wounded figures in the picture.

use antipode_geometry::{ChartPoint, Eye, Projection, Strategy};
use glam::{DVec2, DVec3};

use super::senses::sees_straight;
use crate::bot;
use crate::moment::Seen;
use crate::situation::Situation;
use crate::tuning::{BOT_HEALTH, NEAR_M};

/// Farther off than this no health is shown, in metres.
const SHOWN_M: f64 = 40.0;
/// How high over the crown it stands, and half its width, in metres.
const OVER_M: f64 = 0.25;
const HALF_WIDTH_M: f64 = 0.35;

/// The health of someone who is hurt, in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wound {
    /// Middle of the bar, from the picture's middle to the right and up, in halves of its height.
    pub at: DVec2,
    /// Half of the bar's width, in halves of the picture's height.
    pub half_width: f64,
    /// Health that is left, as a share of the full.
    pub share: f64,
}

/// The health of living figures that are hurt and in sight, in a picture that was taken so, of that vertical
/// field of view in radians.
pub(crate) fn wounds(
    now: Situation<'_>,
    pictured: &dyn Strategy,
    seen: &Seen,
    fov_y_rad: f64,
) -> Vec<Wound> {
    let eye = seen.eye;
    let tuning = &now.actors.tuning;
    let living = bot::living(now.actors).into_iter();
    let hurt = living.filter(|view| view.health < BOT_HEALTH);
    hurt.filter_map(|view| {
        let point = seen.place(view.bot.id, view.point);
        let over = point.moved(DVec3::Y * (tuning.height_m + OVER_M));
        let head = point.moved(DVec3::Y * tuning.eye_height_m());
        let away_m = pictured.eye_distance_m(&eye, pictured.view_point(&eye, over));
        let shown = away_m < SHOWN_M && sees_straight(pictured, now.world, &eye, head);
        let at = pictured_at(pictured, &eye, over, fov_y_rad);
        let side = over.moved(eye.right() * HALF_WIDTH_M);
        let end = pictured_at(pictured, &eye, side, fov_y_rad);
        let (at, end) = at.zip(end).filter(|_| shown)?;
        Some(Wound {
            at,
            half_width: at.distance(end),
            share: view.health / BOT_HEALTH,
        })
    })
    .collect()
}

/// Where a place is in the picture, from its middle to the right and up, in halves of its height; none behind the eye.
pub(super) fn pictured_at(
    pictured: &dyn Strategy,
    eye: &Eye,
    place: ChartPoint,
    fov_y_rad: f64,
) -> Option<DVec2> {
    let view = pictured.view_point(eye, place);
    // With an aspect of one both axes count in halves of the height.
    let projection = Projection::new(fov_y_rad, 1.0, NEAR_M);
    Projection::screen(pictured.clip_from_view(eye, &projection, view))
}
