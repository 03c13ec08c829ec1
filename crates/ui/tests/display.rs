//! The display over the world on every size of window: what it shows, and that nothing overlaps or leaves the screen.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

mod common;

use std::sync::Arc;

use antipode_language::{Language, Texts};
use antipode_ui::{
    CompassModel, CurvatureView, DialKind, EquatorView, FigureModel, HarmModel, HintModel,
    HudModel, MapMark, MapModel, MarkKind, Relief, ReliefNode, SlotIcon, SlotView, SpeechModel,
    apply_theme, show_hud, tints_of,
};
use common::{SIZES, SMALLEST, everywhere, painted};
use egui::{Pos2, Rect, Shape, Vec2, vec2};
use egui_kittest::Harness;

fn pickaxe(label: &str, icon: SlotIcon) -> SlotView {
    SlotView {
        label: label.to_owned(),
        icon,
        count: Some(1),
    }
}

fn full_hud() -> HudModel {
    let mut slots = vec![SlotView::default(); 10];
    slots[1] = pickaxe("Wooden pickaxe", SlotIcon::PickaxeWood);
    slots[2] = pickaxe("Iron pickaxe", SlotIcon::PickaxeIron);
    slots[3] = pickaxe("Diamond pickaxe", SlotIcon::PickaxeDiamond);
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
        brush_radius_m: Some(5.0),
        speed_km_h: None,
        show_crosshair: true,
        loading: Some(0.43),
        time_label: "12:40".to_owned(),
        notice: Some("You are near the edge of the loaded land.".to_owned()),
        hint: Some(HintModel {
            text: "Change how space is pictured: Wheel up and Wheel down".to_owned(),
            footer: "6 of 7 · skip: N".to_owned(),
        }),
        cheated: true,
        figures: None,
        compass: Some(CompassModel {
            heading_rad: 0.9,
            equator: Some(EquatorView {
                hemisphere: 'B',
                distance_m: 402.1,
                bearing_rad: 4.0,
            }),
        }),
        map: Some(map()),
        health: Some(0.4),
        harm: Some(HarmModel {
            strength: 0.7,
            solid: false,
            from_rad: Some(2.0),
        }),
        struck: true,
        wounds: Vec::new(),
        speech: None,
    }
}

/// A hill about the player, and one of each mark.
fn map() -> MapModel {
    let nodes = (0..21u8).flat_map(|i| (0..21u8).map(move |j| (i, j)));
    let node = |(i, j)| {
        let [x, z] = [i, j].map(|step| (f32::from(step) - 10.0) * 3.0);
        ReliefNode {
            at: [x, z],
            share: 1.0 - x.hypot(z) / 45.0,
            light: x / 30.0,
        }
    };
    let corners = (0..20u32).flat_map(|i| (0..20u32).map(move |j| 21 * i + j));
    let kinds = [
        MarkKind::Lamp,
        MarkKind::Neutral,
        MarkKind::Hostile,
        MarkKind::Car,
    ];
    let mark = |(kind, x): (MarkKind, f32)| MapMark { kind, at: [x, 9.0] };
    MapModel {
        relief: Arc::new(Relief {
            tints: tints_of([[108, 88, 66], [78, 104, 66], [56, 108, 74]]),
            reach_m: 43.0,
            nodes: nodes.map(node).collect(),
            patches: corners.map(|a| [a, a + 21, a + 1, a + 22]).collect(),
            contours: vec![[[0.0, 3.0], [3.0, 0.0]]],
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

/// The display with everything that can be asked for.
fn measured_hud() -> HudModel {
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

fn hud(model: HudModel, size: Vec2) -> Harness<'static, HudModel> {
    hud_in(Language::English, model, size)
}

fn hud_in(language: Language, model: HudModel, size: Vec2) -> Harness<'static, HudModel> {
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

fn says(harness: &Harness<'_, HudModel>, words: &str) -> bool {
    painted(harness.output())
        .iter()
        .any(|text| text.text.contains(words))
}

#[test]
fn the_display_shows_every_figure() {
    let harness = hud(full_hud(), vec2(1280.0, 720.0));
    let all = [
        "60 fps",
        "hyperbolic",
        "12:40",
        "Diamond pickaxe",
        "20.0",
        "Curvature",
        "Brush 5.0 m",
        "43 %",
        "near the edge",
        "0",
        "9",
    ];
    for words in all {
        assert!(says(&harness, words), "{words}");
    }
    assert!(!says(&harness, "Hemisphere"));
}

#[test]
fn coordinates_and_the_mark_of_cheats_are_told_beside_the_frame_figures_only() {
    let (with, without) = (measured_hud(), full_hud());
    let with = hud(with, vec2(1280.0, 720.0));
    let without = hud(without, vec2(1280.0, 720.0));
    for words in [
        "x -12.34  y 1.70  z 3.00 m",
        "(0.100, -0.200, 0.300, 1.066)",
        "Cheats used",
    ] {
        assert!(says(&with, words), "{words}");
        assert!(!says(&without, words), "{words}");
    }
}

#[test]
fn frame_figures_are_shown_when_asked_for_and_only_then() {
    let all = [
        "60 fps   frame 16.7 ms   gpu n/a",
        "hyperbolic, horizon map 10.0, balanced",
        "112 by frame, 31 by vertex, 4 refined",
        "1 234 567 triangles",
        "654 321 outside, 76 543 hidden, 987 too small",
        "at most 0.432 px",
        "12:40",
    ];
    let (with, without) = (measured_hud(), full_hud());
    let with = hud(with, vec2(1280.0, 720.0));
    let without = hud(without, vec2(1280.0, 720.0));
    for words in all {
        assert!(says(&with, words), "{words}");
        assert!(words == "12:40" || !says(&without, words), "{words}");
    }
    assert_eq!(HudModel::default().figures, None);
}

#[test]
fn the_dial_says_what_it_turns() {
    for (kind, value, words) in [
        (DialKind::Raised, 20.0, "Curvature, raised"),
        (DialKind::Horizon, 20.0, "Curvature, horizon"),
        (DialKind::Bend, 7.0, "Bend, hyperbolic"),
        (DialKind::Bend, -7.0, "Bend, spherical"),
        (DialKind::Bend, 0.0, "Bend, flat"),
    ] {
        let view = CurvatureView {
            kind,
            value,
            min: -20.0,
            max: 20.0,
        };
        let model = HudModel {
            curvature: Some(view),
            ..full_hud()
        };
        assert!(says(&hud(model, vec2(640.0, 360.0)), words), "{words}");
    }
}

#[test]
fn in_a_car_the_display_tells_its_speed_in_the_place_of_the_brush() {
    let model = HudModel {
        speed_km_h: Some(-43.4),
        ..full_hud()
    };
    for size in [vec2(1280.0, 720.0), vec2(640.0, 360.0)] {
        let harness = hud(model.clone(), size);
        assert!(says(&harness, "43 km/h"));
        assert!(!says(&harness, "Brush"));
    }
}

#[test]
fn the_display_leaves_out_what_a_world_has_not() {
    let model = HudModel {
        hemisphere: Some('B'),
        curvature: None,
        brush_radius_m: None,
        curved_is_flat: true,
        ..measured_hud()
    };
    let harness = hud(model, vec2(1280.0, 720.0));
    assert!(says(&harness, "Hemisphere B") && says(&harness, "flat space"));
    assert!(!says(&harness, "Curvature") && !says(&harness, "Brush") && !says(&harness, "1.066"));
}

#[test]
fn the_display_neither_overlaps_nor_leaves_the_screen_in_any_language() {
    for (language, size) in everywhere(&[
        vec2(640.0, 360.0),
        vec2(427.0, 240.0),
        vec2(1280.0, 720.0),
        vec2(800.0, 600.0),
    ]) {
        let fair = HudModel {
            cheated: false,
            ..measured_hud()
        };
        for model in [full_hud(), measured_hud(), fair] {
            if model.figures.is_some() && size.y < 300.0 {
                continue;
            }
            neither_overlaps_nor_leaves(language, model, size);
        }
    }
}

fn neither_overlaps_nor_leaves(language: Language, model: HudModel, size: Vec2) {
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

/// What the land of the map covers, if it is drawn.
fn map_rect(harness: &Harness<'_, HudModel>) -> Option<Rect> {
    let many = |shape: &Shape| match shape {
        Shape::Mesh(mesh) if mesh.vertices.len() > 100 => Some(mesh.calc_bounds()),
        _ => None,
    };
    let mut shapes = harness.output().shapes.iter();
    shapes.find_map(|clipped| many(&clipped.shape))
}

#[test]
fn compass_and_map_are_there_where_there_is_room_and_only_if_wanted() {
    for size in [
        vec2(800.0, 600.0),
        vec2(1280.0, 720.0),
        vec2(1920.0, 1080.0),
    ] {
        for language in Language::ALL {
            let texts = Texts::new(language);
            let shown = hud_in(language, full_hud(), size);
            let values = [("letter", 'B'.into()), ("metres", 402.into())];
            let way = texts.say_with("compass-equator", &values);
            assert!(says(&shown, &way), "{language:?} {size}");
            let land = map_rect(&shown).expect("the map is there");
            assert!(land.width() > 60.0 && land.max.x < 0.3 * size.x, "{land}");
            // Hints end above the middle, and instruments and hotbar begin below the map.
            assert!(land.min.y > 0.5 * size.y, "{land} at {size}");
            for text in painted(shown.output()) {
                let north = text.text == texts.say("compass-north");
                assert!(
                    north || !land.intersects(text.rect.shrink(1.0)),
                    "“{}” lies on the map at {size}",
                    text.text
                );
            }
            let without = HudModel {
                compass: None,
                map: None,
                ..full_hud()
            };
            let bare = hud_in(language, without, size);
            assert!(!says(&bare, &way) && map_rect(&bare).is_none());
        }
    }
}

#[test]
fn the_map_is_there_at_a_scale_of_two_with_nothing_on_it() {
    // 1280 by 720 and 800 by 600 pixels.
    for size in [vec2(640.0, 360.0), vec2(400.0, 300.0)] {
        for (language, health, speed_km_h) in Language::ALL
            .into_iter()
            .flat_map(|l| [(l, None, None), (l, Some(0.4), None), (l, None, Some(50.0))])
        {
            let model = HudModel {
                health,
                speed_km_h,
                ..full_hud()
            };
            // So small a window has not room for every kind of message at once.
            let model = if size.y < 320.0 {
                HudModel {
                    loading: None,
                    notice: None,
                    ..model
                }
            } else {
                model
            };
            let north = Texts::new(language).say("compass-north");
            let shown = hud_in(language, model, size);
            let land = map_rect(&shown).unwrap_or_else(|| panic!("no map at {size}"));
            let screen = Rect::from_min_size(Pos2::ZERO, size);
            assert!(land.width() > 44.0 && screen.contains_rect(land), "{land}");
            assert!(
                land.min.y > 0.5 * size.y && land.max.x < 0.3 * size.x,
                "{land}"
            );
            for text in painted(shown.output()) {
                assert!(
                    text.text == north || !land.intersects(text.rect.shrink(1.0)),
                    "“{}” lies on the map at {size}",
                    text.text
                );
            }
        }
    }
}

#[test]
fn the_compass_stands_between_the_plates_at_640_by_360() {
    let shown = hud(full_hud(), vec2(640.0, 360.0));
    assert!(says(&shown, "B · equator 402 m"));
}

#[test]
fn health_is_shown_when_it_is_not_full() {
    let rects = |health: Option<f32>| {
        let model = HudModel {
            health,
            ..HudModel::default()
        };
        hud(model, vec2(1280.0, 720.0)).output().shapes.len()
    };
    assert_eq!(rects(Some(1.0)), rects(None));
    assert!(rects(Some(0.6)) > rects(None));
}

/// The corners of all that is drawn in a colour like red.
fn reds(harness: &Harness<'_, HudModel>) -> usize {
    let is_red = |shape: &Shape| match shape {
        Shape::Mesh(mesh) => mesh
            .vertices
            .iter()
            .any(|v| v.color.r() > 2 * v.color.g().max(v.color.b()).max(10)),
        _ => false,
    };
    let shapes = harness.output().shapes.iter();
    shapes.filter(|clipped| is_red(&clipped.shape)).count()
}

#[test]
fn harm_reddens_the_edge_and_is_gone_when_it_has_faded() {
    let hurt = |strength: f32, solid: bool| HudModel {
        harm: Some(HarmModel {
            strength,
            solid,
            from_rad: Some(1.0),
        }),
        ..HudModel::default()
    };
    let size = vec2(800.0, 600.0);
    assert_eq!(reds(&hud(hurt(0.8, false), size)), 1);
    assert_eq!(reds(&hud(hurt(0.0, false), size)), 0);
    assert_eq!(reds(&hud(HudModel::default(), size)), 0);
    // In high contrast a line that nothing shines through takes the place of the fade.
    assert_eq!(reds(&hud(hurt(0.8, true), size)), 0);
}

#[test]
fn the_display_survives_any_size_and_any_number() {
    let odd = HudModel {
        fps: f32::INFINITY,
        chart: [f64::NAN, 1e300, -1e300],
        curved: [f64::INFINITY; 4],
        slots: Vec::new(),
        selected: 99,
        curvature: Some(CurvatureView {
            kind: DialKind::Bend,
            value: f64::NAN,
            min: 1.0,
            max: 1.0,
        }),
        hemisphere: Some('B'),
        brush_radius_m: Some(f64::INFINITY),
        loading: Some(f32::NAN),
        compass: Some(CompassModel {
            heading_rad: f64::NAN,
            equator: Some(EquatorView {
                hemisphere: 'A',
                distance_m: f64::INFINITY,
                bearing_rad: f64::NAN,
            }),
        }),
        map: Some(MapModel {
            relief: Arc::default(),
            heading_rad: f32::NAN,
            north_rad: f32::INFINITY,
            marks: Vec::new(),
        }),
        health: Some(f32::NAN),
        harm: Some(HarmModel {
            strength: f32::NAN,
            solid: false,
            from_rad: Some(f32::NAN),
        }),
        speech: Some(SpeechModel {
            text: "So it is. ".repeat(300),
            at: Some([f32::INFINITY, f32::NAN]),
        }),
        ..full_hud()
    };
    for size in SIZES.into_iter().chain(SMALLEST) {
        hud(odd.clone(), size);
        hud(full_hud(), size);
        hud(measured_hud(), size);
        hud(HudModel::default(), size);
        for speed_km_h in [f64::NAN, f64::INFINITY, -1e300] {
            let speed_km_h = Some(speed_km_h);
            hud(
                HudModel {
                    speed_km_h,
                    ..full_hud()
                },
                size,
            );
        }
    }
}
