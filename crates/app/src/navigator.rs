//! Fills compass, map and signs of damage on the display from the scene.

use std::f64::consts::TAU;
use std::sync::Arc;

use antipode_language::Texts;
use antipode_scene::actors::ActorId;
use antipode_scene::bearings::{Bearings, FlagWay, LandmarkKind};
use antipode_scene::survey::{Extent, Survey, SurveyMap};
use antipode_scene::{Scene, Seen};
use antipode_settings::Settings;
use antipode_ui::{
    CompassModel, DamageModel, FlagView, GuidePlace, GuideView, HudModel, MapMark, MapModel,
    MarkKind, Relief, ReliefNode, tints_of,
};

use crate::wording;

/// Columns of land that the map takes in for each second: three in a frame of a sixtieth, a small part of its time.
const COLUMNS_PER_S: f64 = 180.0;
/// No frame takes in more.
const MOST_COLUMNS: f64 = 60.0;
/// So many times as many for the large map, which is looked at instead of the land.
const WIDE_COLUMNS: f64 = 8.0;
/// For a single picture, which shows all of the map.
pub const WHOLE_MAP: usize = usize::MAX;
/// How long damage is told of, seconds; with reduced motion it fades more slowly, from a weaker beginning.
const DAMAGE_S: f64 = 1.2;
const CALM_DAMAGE_S: f64 = 2.5;
const CALM_STRENGTH: f64 = 0.6;
/// How long a strike is told of, seconds.
const STRUCK_S: f64 = 0.25;

/// How many columns of land the map takes in for a frame after so many seconds: a slow machine's map must keep up
/// with those who run, too.
pub fn columns_for(frame_s: f64, extent: Extent) -> usize {
    let times = match extent {
        Extent::Near => 1.0,
        Extent::Wide => WIDE_COLUMNS,
    };
    let columns = (COLUMNS_PER_S * frame_s).clamp(1.0, MOST_COLUMNS);
    (columns * times).round() as usize
}

/// How much of the land the map shows, the large one or the one on the display.
pub fn extent_of(is_large: bool) -> Extent {
    if is_large { Extent::Wide } else { Extent::Near }
}

/// What the map may survey for a frame.
#[derive(Clone, Copy, Debug)]
pub struct SurveyOrder {
    /// The world's number.
    pub world: u64,
    /// How much of the land it shows.
    pub extent: Extent,
    /// How many columns of land may be taken in.
    pub columns: usize,
}

/// What the map keeps from one frame to the next.
#[derive(Debug, Default)]
pub struct Navigator {
    survey: Survey,
    /// The last plan, and as the display is given it.
    relief: Option<(Arc<SurveyMap>, Arc<Relief>)>,
}

impl Navigator {
    /// Adds to the display what the player has not switched off.
    pub fn add_to(
        &mut self,
        model: &mut HudModel,
        scene: &Scene,
        seen: &Seen,
        texts: &Texts,
        settings: &Settings,
        order: SurveyOrder,
    ) {
        let bearings = Bearings {
            heading_rad: seen.eye.yaw,
            ..scene.bearings()
        };
        model.compass = settings.compass.then(|| CompassModel {
            flags: ways_shown(texts, scene, bearings.heading_rad),
            ..compass(&bearings)
        });
        let has_map = settings.minimap || order.extent == Extent::Wide;
        model.sighting = scene.sighting().map(|it| wording::sighting(texts, &it));
        model.map = has_map.then(|| self.map(scene, &bearings, order));
        model.damage = damage(scene, &bearings, settings);
        let foes = scene.hidden_foes().into_iter();
        model.hidden_foes = foes
            .map(|way| (way - bearings.heading_rad).rem_euclid(TAU) as f32)
            .collect();
        model.struck = scene.struck_s_ago().is_some_and(|ago_s| ago_s < STRUCK_S);
    }

    fn map(&mut self, scene: &Scene, bearings: &Bearings, order: SurveyOrder) -> MapModel {
        let SurveyOrder {
            world,
            extent,
            columns,
        } = order;
        let plan = self.survey.look(scene, world, extent, columns);
        let relief = match self.relief.take() {
            Some((drawn, relief)) if Arc::ptr_eq(&drawn, &plan) => relief,
            _ => Arc::new(relief(&plan)),
        };
        let marks = scene.landmarks(plan.reach_m).into_iter();
        let marks = marks.map(|mark| MapMark {
            kind: match mark.kind {
                LandmarkKind::Lamp => MarkKind::Lamp,
                LandmarkKind::Neutral => MarkKind::Neutral,
                LandmarkKind::Hostile => MarkKind::Hostile,
                LandmarkKind::Car => MarkKind::Car,
                LandmarkKind::Flag => MarkKind::Flag,
                LandmarkKind::Door => MarkKind::Door,
                LandmarkKind::Crumb => MarkKind::Crumb,
                LandmarkKind::Home => MarkKind::Home,
            },
            name: antipode_ui::legible(&mark.name).into_owned(),
            at: mark.at.as_vec2().to_array(),
        });
        let map = MapModel {
            is_large: extent == Extent::Wide,
            relief: Arc::clone(&relief),
            heading_rad: bearings.heading_rad as f32,
            north_rad: (bearings.north_rad - bearings.heading_rad) as f32,
            marks: marks.collect(),
        };
        self.relief = Some((plan, relief));
        map
    }
}

/// What a flag is called.
pub fn flag_name(texts: &Texts, id: ActorId, name: &str) -> String {
    if name.is_empty() {
        let number = u64::from(id.0) + 1;
        texts.say_with("flag-unnamed", &[("number", number.into())])
    } else {
        antipode_ui::legible(name).into_owned()
    }
}

/// The ways to flags, doors and cars, and back along breadcrumbs.
fn ways_shown(texts: &Texts, scene: &Scene, heading_rad: f64) -> Vec<FlagView> {
    let view = |way: &FlagWay, name: String, mark: MarkKind| FlagView {
        name,
        distance_m: way.distance_m,
        bearing_rad: (way.heading_rad - heading_rad).rem_euclid(TAU),
        mark,
    };
    let flags = scene.flag_ways();
    let flags = flags
        .iter()
        .map(|way| view(way, flag_name(texts, way.id, &way.name), MarkKind::Flag));
    let doors = scene.door_ways();
    let doors = doors
        .iter()
        .map(|way| view(way, texts.say("item-door"), MarkKind::Door));
    let back = scene.way_back();
    let back = back
        .iter()
        .map(|way| view(way, texts.say("compass-way-back"), MarkKind::Crumb));
    let cars = scene.car_ways();
    let cars = cars
        .iter()
        .map(|way| view(way, String::new(), MarkKind::Car));
    flags.chain(doors).chain(back).chain(cars).collect()
}

fn compass(bearings: &Bearings) -> CompassModel {
    let heading_rad = bearings.heading_rad;
    let guide = |to: GuidePlace, distance_m: f64, way_rad: f64| GuideView {
        to,
        distance_m,
        bearing_rad: (way_rad - heading_rad).rem_euclid(TAU),
    };
    let equator = bearings.equator.map(|it| {
        let hemisphere = it.hemisphere;
        guide(
            GuidePlace::Equator { hemisphere },
            it.distance_m,
            it.heading_rad,
        )
    });
    let home = bearings.home.map(|it| {
        let squares = it.squares;
        guide(GuidePlace::Home { squares }, it.distance_m, it.heading_rad)
    });
    CompassModel {
        heading_rad: (heading_rad - bearings.north_rad).rem_euclid(TAU),
        guide: equator.or(home),
        flags: Vec::new(),
    }
}

fn relief(plan: &SurveyMap) -> Relief {
    let node = |node: &antipode_scene::survey::PlanNode| ReliefNode {
        at: node.at,
        share: node.share,
        light: node.light,
        sky: node.sky,
        tints: tints_of(node.colours),
    };
    Relief {
        reach_m: plan.reach_m as f32,
        nodes: plan.nodes.iter().map(node).collect(),
        patches: plan.patches.clone(),
        contours: plan.contours.clone(),
        edges: plan.edges.clone(),
    }
}

fn damage(scene: &Scene, bearings: &Bearings, settings: &Settings) -> Option<DamageModel> {
    let (ago_s, from_rad) = scene.last_hurt()?;
    let (first, lasts_s) = if settings.reduced_motion {
        (CALM_STRENGTH, CALM_DAMAGE_S)
    } else {
        (1.0, DAMAGE_S)
    };
    let left = 1.0 - ago_s / lasts_s;
    (left > 0.0).then(|| DamageModel {
        strength: (first * left) as f32,
        solid: settings.high_contrast,
        from_rad: from_rad.map(|from| (from - bearings.heading_rad).rem_euclid(TAU) as f32),
    })
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use antipode_scene::bearings::Equator;

    use super::*;

    #[test]
    fn the_compass_counts_clockwise_from_north_and_the_equator_from_straight_ahead() {
        let bearings = |heading_rad: f64| Bearings {
            heading_rad,
            north_rad: PI,
            equator: Some(Equator {
                hemisphere: 'B',
                distance_m: 12.0,
                heading_rad: FRAC_PI_2,
            }),
            home: None,
        };
        assert_eq!(compass(&bearings(PI)).heading_rad, 0.0);
        // Looking to where the sun comes up, at -z.
        let east = compass(&bearings(-FRAC_PI_2));
        assert!((east.heading_rad - FRAC_PI_2).abs() < 1e-12);
        let to = GuidePlace::Equator { hemisphere: 'B' };
        assert!(
            east.guide
                .is_some_and(|it| it.to == to && (it.bearing_rad - PI).abs() < 1e-12)
        );
    }
}
