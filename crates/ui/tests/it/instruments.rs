//! The compass and the map on every size of window.

use crate::common::hud::{full_hud, hud, hud_in, says};
use crate::common::painted;
use antipode_language::{Language, Texts};
use antipode_ui::{HudModel, mirror_place};
use egui::{Pos2, Rect, Shape, Vec2, vec2};
use egui_kittest::Harness;

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
            // Its name stands over it, and where there is no room for that, or no map, beside the time.
            let named = painted(shown.output()).into_iter();
            let named = named.filter(|text| text.text.contains("Toxic flats"));
            let [name] = &named.map(|text| text.rect).collect::<Vec<_>>()[..] else {
                panic!("the land has one name at {size}");
            };
            let is_over = name.min.y > 0.5 * size.y && name.max.y < land.min.y;
            assert_eq!(is_over, size.y > 700.0, "{name} {land} at {size}");
            let without = HudModel {
                compass: None,
                map: None,
                ..full_hud()
            };
            let bare = hud_in(language, without, size);
            assert!(!says(&bare, &way) && map_rect(&bare).is_none());
            assert!(says(&bare, "Toxic flats"));
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
    let without_mirror = HudModel {
        mirror: false,
        ..full_hud()
    };
    let shown = hud(without_mirror, vec2(640.0, 360.0));
    assert!(says(&shown, "B · equator 402 m"));
}

#[test]
fn the_compass_stands_below_the_mirror_and_makes_room_for_it_in_a_low_window() {
    let equator = |size: Vec2| {
        let shown = hud(full_hud(), size);
        let mut texts = painted(shown.output()).into_iter();
        texts.find(|it| it.text == "B · equator 402 m")
    };
    let size = vec2(1280.0, 720.0);
    let below = equator(size).expect("the compass is there").rect.min.y;
    assert!(below > mirror_place(size.x, size.y).max.y, "{below}");
    assert!(equator(vec2(640.0, 360.0)).is_none());
}
