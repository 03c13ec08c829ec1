//! The display over the world on every size of window: what it shows, and that nothing overlaps or leaves the screen.

use std::sync::Arc;

use crate::common::hud::{
    full_hud, hud, large_map, measured_hud, neither_overlaps_nor_leaves, says,
};
use crate::common::{SIZES, SMALLEST, everywhere};
use antipode_ui::{
    CompassModel, CurvatureView, DamageModel, DialKind, FlagView, GuidePlace, GuideView, HudModel,
    MapModel, MarkKind, SpeechModel,
};
use egui::{Shape, vec2};
use egui_kittest::Harness;

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
        let refused = HudModel {
            against: Some("too close to the other door".to_owned()),
            ..full_hud()
        };
        let sighted = HudModel {
            map: None,
            ..large_map()
        };
        for model in [full_hud(), measured_hud(), fair, refused, sighted] {
            if model.figures.is_some() && size.y < 300.0 {
                continue;
            }
            neither_overlaps_nor_leaves(language, model, size);
        }
    }
}

#[test]
fn the_large_map_names_its_marks_and_lies_over_the_middle() {
    let name = "The longest name of all!";
    let size = vec2(1280.0, 720.0);
    let large = HudModel {
        compass: None,
        ..large_map()
    };
    assert!(says(&hud(large, size), name));
    let small = HudModel {
        compass: None,
        ..full_hud()
    };
    assert!(!says(&hud(small, size), name), "there is no room for it");
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
fn damage_reddens_the_edge_and_is_gone_when_it_has_faded() {
    let hurt = |strength: f32, solid: bool| HudModel {
        damage: Some(DamageModel {
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
            flags: [0.0, f64::NAN, f64::INFINITY]
                .map(|bearing_rad| FlagView {
                    name: "Home ".repeat(300),
                    distance_m: f64::NAN,
                    bearing_rad,
                    mark: MarkKind::Flag,
                })
                .to_vec(),
            heading_rad: f64::NAN,
            guide: Some(GuideView {
                to: GuidePlace::Equator { hemisphere: 'A' },
                distance_m: f64::INFINITY,
                bearing_rad: f64::NAN,
            }),
        }),
        map: Some(MapModel {
            is_large: true,
            relief: Arc::default(),
            heading_rad: f32::NAN,
            north_rad: f32::INFINITY,
            marks: Vec::new(),
        }),
        health: Some(f32::NAN),
        damage: Some(DamageModel {
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
        hud(large_map(), size);
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
