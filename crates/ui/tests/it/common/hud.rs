//! A display with everything on it.

use std::sync::Arc;

use antipode_items::Item;
use antipode_language::{Language, Texts};
use antipode_ui::{
    BrushModel, CompassModel, CurvatureView, DamageModel, DialKind, FigureModel, FlagView,
    GuidePlace, GuideView, HintModel, HudModel, MapMark, MapModel, MarkKind, Relief, ReliefNode,
    SlotView, apply_theme, show_hud, tints_of,
};
use egui::{Pos2, Rect, Vec2};
use egui_kittest::Harness;

use super::painted;

pub fn pickaxe(label: &str, item: Item) -> SlotView {
    SlotView {
        label: label.to_owned(),
        item: Some(item),
        count: Some(1),
    }
}

pub fn full_hud() -> HudModel {
    let mut slots = vec![SlotView::default(); 10];
    slots[1] = pickaxe("Wooden pickaxe", Item::PickaxeWood);
    slots[2] = pickaxe("Iron pickaxe", Item::PickaxeIron);
    slots[3] = pickaxe("Diamond pickaxe", Item::PickaxeDiamond);
    HudModel {
        fps: 59.7,
        chart: [-12.344, 1.7, 3.0],
        curved: [0.1, -0.2, 0.3, 1.066],
        curved_is_flat: false,
        slots,
        selected: 3,
        curvature: Some(CurvatureView {
            kind: DialKind::Raised,
            value: 20.0,
            min: 5.0,
            max: 40.0,
        }),
        hemisphere: None,
        geometry: "hyperbolic".to_owned(),
        land: "Toxic flats".to_owned(),
        brush_radius_m: Some(5.0),
        brush: BrushModel::default(),
        speed_km_h: None,
        mirror: true,
        against: None,
        show_crosshair: true,
        loading: Some(0.43),
        time_label: "12:40".to_owned(),
        notice: Some("You are near the edge of the loaded land.".to_owned()),
        hint: Some(HintModel {
            text: "Change how space is pictured: Wheel up and Wheel down".to_owned(),
            footer: "6 of 7 · skip: N".to_owned(),
        }),
        cheated: true,
        room: None,
        figures: None,
        compass: Some(CompassModel {
            flags: vec![FlagView {
                name: "The longest name of all!".to_owned(),
                distance_m: 1402.1,
                bearing_rad: 0.05,
                mark: MarkKind::Flag,
            }],
            heading_rad: 0.9,
            guide: Some(GuideView {
                to: GuidePlace::Equator { hemisphere: 'B' },
                distance_m: 402.1,
                bearing_rad: 4.0,
            }),
        }),
        sighting: None,
        map: Some(map()),
        health: Some(0.4),
        damage: Some(DamageModel {
            strength: 0.7,
            solid: false,
            from_rad: Some(2.0),
        }),
        struck: true,
        hidden_foes: vec![2.0],
        wounds: Vec::new(),
        speech: None,
    }
}

/// A hill about the player, and one of each mark.
pub fn map() -> MapModel {
    let nodes = (0..21u8).flat_map(|i| (0..21u8).map(move |j| (i, j)));
    let node = |(i, j)| {
        let [x, z] = [i, j].map(|step| (f32::from(step) - 10.0) * 3.0);
        ReliefNode {
            at: [x, z],
            share: 1.0 - x.hypot(z) / 45.0,
            light: x / 30.0,
            sky: 1.0,
            tints: tints_of([[108, 88, 66], [78, 104, 66], [56, 108, 74]]),
        }
    };
    let corners = (0..20u32).flat_map(|i| (0..20u32).map(move |j| 21 * i + j));
    let kinds = [
        MarkKind::Lamp,
        MarkKind::Neutral,
        MarkKind::Hostile,
        MarkKind::Car,
    ];
    let mark = |(kind, x): (MarkKind, f32)| MapMark {
        kind,
        name: "The longest name of all!".to_owned(),
        at: [x, 9.0],
    };
    MapModel {
        is_large: false,
        relief: Arc::new(Relief {
            reach_m: 43.0,
            nodes: nodes.map(node).collect(),
            patches: corners.map(|a| [a, a + 21, a + 1, a + 22]).collect(),
            contours: vec![[[0.0, 3.0], [3.0, 0.0]]],
            edges: vec![[[-9.0, 20.0], [12.0, 18.0]]],
        }),
        heading_rad: 1.0,
        north_rad: -0.4,
        marks: kinds
            .into_iter()
            .zip([-12.0, 0.0, 12.0, 22.0])
            .map(mark)
            .collect(),
    }
}

/// With the large map, while one sights a triangle of flags.
pub fn large_map() -> HudModel {
    HudModel {
        map: Some(MapModel {
            is_large: true,
            ..map()
        }),
        sighting: Some(
            "Three flags: 51.8° + 51.8° + 51.9° = 155.5° · sides 64, 64, 64 m".to_owned(),
        ),
        ..full_hud()
    }
}

/// The display with everything that can be asked for.
pub fn measured_hud() -> HudModel {
    HudModel {
        figures: Some(FigureModel {
            frame_ms: Some(16.74),
            gpu_ms: None,
            picture: "horizon map 10.0".to_owned(),
            quality: "balanced".to_owned(),
            chunks_by_frame: 112,
            chunks_by_vertex: 31,
            chunks_refined: 4,
            chunks_by_level: [80, 40, 20, 3],
            triangles: 1_234_567,
            outside: 654_321,
            hidden: 76_543,
            small: 987,
            error_px: 0.4321,
            level_error_px: 2.4,
            dropped_s: 1234.5,
        }),
        ..full_hud()
    }
}

pub fn hud(model: HudModel, size: Vec2) -> Harness<'static, HudModel> {
    hud_in(Language::English, model, size)
}

pub fn hud_in(language: Language, model: HudModel, size: Vec2) -> Harness<'static, HudModel> {
    let texts = Texts::new(language);
    let mut harness = Harness::builder()
        .with_size(size)
        .with_context_setup(apply_theme)
        .build_ui_state(
            move |ui, model: &mut HudModel| {
                show_hud(ui.ctx(), &texts, model);
            },
            model,
        );
    harness.run();
    harness
}

pub fn says(harness: &Harness<'_, HudModel>, words: &str) -> bool {
    painted(harness.output())
        .iter()
        .any(|text| text.text.contains(words))
}

pub fn neither_overlaps_nor_leaves(language: Language, model: HudModel, size: Vec2) {
    let harness = hud_in(language, model, size);
    let texts = painted(harness.output());
    let window = Rect::from_min_size(Pos2::ZERO, size);
    for (index, text) in texts.iter().enumerate() {
        assert!(
            window.contains_rect(text.rect),
            "“{}” leaves {size}",
            text.text
        );
        for other in &texts[..index] {
            assert!(
                !text.rect.shrink(1.0).intersects(other.rect.shrink(1.0)),
                "“{}” lies on “{}” at {size}",
                text.text,
                other.text
            );
        }
    }
}
