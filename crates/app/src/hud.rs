//! Fills the model of the heads-up display from the scene.

use antipode_geometry::{ChartPoint, Curvature, Eye, HyperbolicMap};
use antipode_language::Texts;
use antipode_scene::day::hour;
use antipode_scene::tuning::FULL_HEALTH;
use antipode_scene::{CameraMode, Item, Lens, Scene, Seen, Stack};
use antipode_ui::{
    CurvatureView, DialKind, FigureModel, HudModel, SlotView, SpeechModel, WoundModel,
};
use glam::DVec3;

use crate::{hud_brush, wording};

/// What the display shows of a scene over a picture that was taken so, with what drawing it took where the player wants
/// to know.
pub fn model(
    texts: &Texts,
    scene: &Scene,
    seen: &Seen,
    fps: f32,
    figures: Option<FigureModel>,
) -> HudModel {
    let feet = scene.feet();
    // Told from the world's origin: from the eye, which never moves in its own space, it would say nothing.
    let origin = Eye {
        point: ChartPoint::a(DVec3::ZERO),
        lift_m: 0.0,
        ..scene.head()
    };
    let pictured = scene.lens().strategy();
    let curved = pictured.curved(&origin, feet);
    HudModel {
        fps,
        chart: feet.pos.to_array(),
        curved: curved.to_array(),
        curved_is_flat: pictured.curvature_at(&origin) == Curvature::FLAT,
        slots: slots(texts, scene),
        selected: usize::from(scene.inventory().selected()),
        curvature: dial(scene.lens()),
        hemisphere: scene
            .strategy()
            .globe()
            .map(|globe| globe.hemisphere(feet.chart)),
        geometry: wording::geometry(texts, scene.setup().geometry),
        land: scene
            .land_name()
            .map_or_else(String::new, |name| wording::land(texts, name)),
        brush_radius_m: brush_radius_m(scene),
        brush: hud_brush::model(texts, scene),
        speed_km_h: scene.driven_car().map(|car| 3.6 * car.speed_m_s),
        mirror: false,
        against: scene
            .against_placing()
            .map(|why| wording::unfit_here(texts, why)),
        show_crosshair: scene.camera_mode() == CameraMode::First
            || scene.inventory().held().is_some(),
        loading: None,
        time_label: clock(scene.local_time_s()),
        notice: None,
        hint: None,
        cheated: scene.cheated(),
        figures,
        compass: None,
        sighting: None,
        map: None,
        health: Some((scene.health() / FULL_HEALTH) as f32),
        damage: None,
        struck: false,
        hidden_foes: Vec::new(),
        wounds: wounds(scene, seen),
        room: None,
        speech: speech(texts, scene, seen),
    }
}

/// How wide the brush is, where one is in hand.
fn brush_radius_m(scene: &Scene) -> Option<f64> {
    let held = scene.inventory().held().filter(|_| !scene.is_driving());
    let brush = held.and_then(Item::brush_strength_per_s);
    brush.map(|_| scene.brush_radius_m())
}

/// What was said last, and where in the picture it is.
fn speech(texts: &Texts, scene: &Scene, seen: &Seen) -> Option<SpeechModel> {
    let said = scene.speech(seen, scene.viewing().fov_y_rad)?;
    Some(SpeechModel {
        text: wording::said(texts, said.greets, said.line),
        at: said.at.map(|at| [at.x as f32, at.y as f32]),
    })
}

/// The hotbar; none at the wheel, where nothing of it can be used and the bonnet is to be seen.
fn slots(texts: &Texts, scene: &Scene) -> Vec<SlotView> {
    if scene.is_driving() {
        return Vec::new();
    }
    let stacks = scene.inventory().hotbar().iter();
    stacks.map(|stack| slot(texts, *stack)).collect()
}

/// The health of others who are hurt.
fn wounds(scene: &Scene, seen: &Seen) -> Vec<WoundModel> {
    let wounds = scene.wounds(seen, scene.viewing().fov_y_rad);
    let shown = wounds.iter().map(|wound| WoundModel {
        at: [wound.at.x as f32, wound.at.y as f32],
        half_width: wound.half_width as f32,
        share: wound.share as f32,
    });
    shown.collect()
}

/// The dial under the wheel, if there is one now.
fn dial(lens: &Lens) -> Option<CurvatureView> {
    let kind = match lens.map() {
        Some(HyperbolicMap::Raised) => DialKind::Raised,
        Some(HyperbolicMap::Horizon) => DialKind::Horizon,
        None => DialKind::Bend,
    };
    lens.range().map(|(min, max)| CurvatureView {
        kind,
        value: lens.value(),
        min,
        max,
    })
}

/// What a slot shows of what lies in it.
pub fn slot(texts: &Texts, held: Option<Stack>) -> SlotView {
    match held {
        None => SlotView {
            label: String::new(),
            item: None,
            count: None,
        },
        Some(Stack { item, count }) => SlotView {
            label: wording::item(texts, item),
            item: Some(item),
            count: (count > 1).then_some(count),
        },
    }
}

/// Time of day as a clock of 24 hours, or a dash where there is none.
pub fn clock(time_of_day_s: Option<f64>) -> String {
    let Some(time_s) = time_of_day_s else {
        return "–".to_owned();
    };
    let minutes = (hour(time_s) * 60.0) as u32;
    format!("{:02}:{:02}", minutes / 60, minutes % 60)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noon_is_when_the_sun_stands_highest_and_midnight_wraps() {
        assert_eq!(clock(Some(0.0)), "06:00");
        assert_eq!(clock(Some(150.0)), "12:00");
        assert_eq!(clock(Some(450.0)), "00:00");
        assert_eq!(clock(Some(599.9)), "05:59");
        assert_eq!(clock(None), "–");
    }
}
