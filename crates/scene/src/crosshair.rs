//! What is under the crosshair: the one answer by which the player digs and builds, shoots, puts lamps down and takes
//! them up, gets into cars and talks. What else is to be aimed at gets its question here.

use std::f64::consts::PI;

use antipode_geometry::{ChartPoint, Eye};
use antipode_items::{Item, Stands};
use antipode_physics::meets_capsule;
use glam::{DVec3, DVec4};
use hecs::Entity;

use crate::actors::ActorId;
use crate::aimed::ViewParams;
use crate::bot::Bot;
use crate::car::CarView;
use crate::car::tuning::IN_VIEW;
use crate::fixture::{self, Fixture};
use crate::npc::mind::Mind;
use crate::npc::{apart_m, sees};
use crate::pick::{Meets, Pick, over, pick_among};
use crate::player::{Health, Position};
use crate::projectile::{Standing, ways, within};
use crate::situation::Situation;

/// Angle from the middle of the view within which one is talked to, in radians.
const AHEAD_RAD: f64 = 40.0 * PI / 180.0;
/// What of somebody has to be in sight, as a share of the height from the feet.
const BREAST: f64 = 0.7;

/// The eye of a picture, and how far the head lies beyond it, in metres.
struct AimRay {
    eye: Eye,
    past_head_m: f64,
}

/// The crosshair of a viewer of a picture.
pub(crate) struct Crosshair<'a> {
    now: Situation<'a>,
    params: ViewParams,
}

impl<'a> Crosshair<'a> {
    /// That by which the player aims.
    pub fn aimed(now: Situation<'a>) -> Self {
        Self::through(now, now.aiming())
    }

    /// That of a picture which is taken through `params`.
    pub fn through(now: Situation<'a>, params: ViewParams) -> Self {
        Self { now, params }
    }

    /// The first ground within `reach_m` metres beyond the head.
    pub fn ground(&self, reach_m: f64) -> Pick {
        let ray = self.ray();
        self.first(&ray, reach_m, &|_, _| None)
    }

    /// The first of the ground and of others.
    pub fn ground_or_figure(&self, reach_m: f64) -> Pick {
        let others: Vec<Standing> = self
            .now
            .standing()
            .into_iter()
            .filter(|it| it.entity != self.now.actors.player)
            .collect();
        self.first(&self.ray(), reach_m, &|a, b| {
            let ways = ways(&*self.now.world.strategy, a, b.pos);
            let met = |it: &Standing| {
                let way = within(&ways, it.feet.chart)?;
                it.meets(way.from, way.to, 0.0)
            };
            others.iter().filter_map(met).reduce(f64::min)
        })
    }

    /// What stands there of one kind, or of any, and its number, if it is nearer than the ground.
    pub fn fixture(&self, item: Option<Item>, reach_m: f64) -> Option<(Item, ActorId)> {
        let asked = |it: &Fixture| item.is_none_or(|item| it.item == item);
        let all = fixture::map(self.now.actors, |id, it| {
            asked(it).then(|| (id, it.clone()))
        });
        let all: Vec<(ActorId, Fixture)> = all.into_iter().flatten().collect();
        if all.is_empty() {
            return None;
        }
        let found = self.first(&self.ray(), reach_m, &|a, b| {
            let met = all.iter().filter_map(|(_, it)| self.fixture_met(it, a, b));
            met.reduce(f64::min)
        });
        let off_m = |it: &Fixture| {
            let foot = over(&*self.now.world.strategy, found.point, it.foot.point).pos;
            let Stands {
                heights_m: [low_m, high_m],
                radius_m,
                ..
            } = *it.stands;
            let up_m = found.point.pos.y - foot.y;
            let up_m = up_m.max(low_m + radius_m).min(high_m - radius_m);
            found.point.pos.distance(foot + DVec3::Y * up_m)
        };
        let (id, nearest) = all
            .iter()
            .min_by(|a, b| off_m(&a.1).total_cmp(&off_m(&b.1)))?;
        let is_met = found.hit && off_m(nearest) < 2.0 * nearest.stands.radius_m;
        is_met.then_some((nearest.item, *id))
    }

    /// The nearest car about the middle of the view, or about the player where it need not be in view.
    pub fn car(&self, reach_m: f64, in_view: bool) -> Option<CarView> {
        let (head, feet) = (self.now.head(), self.now.feet());
        let pictured = &*self.params.strategy;
        let cars = self.now.actors.car_views().into_iter();
        cars.filter(|car| !in_view || is_in_view(pictured.view_point(&head, car.middle())))
            .map(|car| (pictured.distance_m(feet, car.point, &head), car))
            .filter(|(far_m, _)| *far_m <= reach_m)
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, car)| car)
    }

    /// Whether nothing hides a place from the player.
    pub fn sees(&self, place: ChartPoint) -> bool {
        sees(
            &*self.params.strategy,
            self.now.world,
            &self.now.head(),
            place,
        )
    }

    /// The nearest living peaceful one ahead and in sight, and its number.
    pub fn listener(&self, reach_m: f64) -> Option<(Entity, u32)> {
        let Situation { world, actors, .. } = self.now;
        let (eye, feet) = (self.now.head(), self.now.feet());
        let pictured = &*self.params.strategy;
        let is_ahead = |point: ChartPoint| {
            let view = pictured.view_point(&eye, point).truncate();
            -view.normalize_or_zero().z > AHEAD_RAD.cos()
        };
        let mut query = actors
            .ecs
            .query::<(Entity, &Bot, &Position, &Health, &Mind)>();
        query
            .iter()
            .filter(|(_, bot, _, health, mind)| {
                health.0 > 0.0 && !bot.hostile && mind.angry_s <= 0.0
            })
            .map(|(entity, bot, position, ..)| {
                let breast = position
                    .0
                    .moved(DVec3::Y * (BREAST * actors.tuning.height_m));
                let away_m = apart_m(&*world.strategy, feet, position.0);
                (away_m, bot.id, entity, breast)
            })
            .filter(|(away_m, .., breast)| {
                *away_m < reach_m && is_ahead(*breast) && sees(pictured, world, &eye, *breast)
            })
            .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)))
            .map(|(_, id, entity, _)| (entity, id))
    }

    fn ray(&self) -> AimRay {
        let eye = self.now.camera_beside(&self.params).eye;
        AimRay {
            past_head_m: self.now.past_head_m(&self.params, &eye),
            eye,
        }
    }

    fn first(&self, ray: &AimRay, reach_m: f64, meets: Meets<'_>) -> Pick {
        let (strategy, world) = (&*self.params.strategy, self.now.world);
        pick_among(
            strategy,
            &world.physics,
            world.doors.as_ref(),
            meets,
            &ray.eye,
            ray.past_head_m,
            reach_m,
        )
    }

    fn fixture_met(&self, it: &Fixture, a: ChartPoint, b: ChartPoint) -> Option<f64> {
        let Stands {
            heights_m: [low_m, high_m],
            radius_m,
            ..
        } = *it.stands;
        let foot = over(&*self.now.world.strategy, a, it.foot.point).pos + DVec3::Y * low_m;
        meets_capsule(a.pos, b.pos, 0.0, foot, high_m - low_m, radius_m)
    }
}

/// Whether a point in view coordinates is about in the picture.
fn is_in_view(view: DVec4) -> bool {
    let (aside, up) = IN_VIEW;
    view.z < 0.0 && view.x.abs() <= aside * -view.z && view.y.abs() <= up * -view.z
}
