//! The page of the backpack on which things are made: what mouse and keys ask for there, and how it looks in every
//! language and window.

use crate::backpack::{Bag, asked, bag, focused, harness, view};
use crate::common::{SIZES, SMALLEST, everywhere, painted};
use antipode_items::Item;
use antipode_language::{Language, Texts};
use antipode_ui::{BackpackWish, EarthView, MakingModel, PartView, RecipeView, Tint};
use egui::{Key, Pos2, Rect, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};

fn tint(ground: [u8; 3]) -> Tint {
    let specks = [250, 250, 250];
    Tint { ground, specks }
}

fn part(label: &str, needs_m3: f64, has_m3: f64) -> PartView {
    PartView {
        label: label.to_owned(),
        tint: tint([90, 80, 70]),
        needs_m3,
        has_m3,
    }
}

fn recipe(label: &str, item: Item, count: u32, parts: Vec<PartView>) -> RecipeView {
    RecipeView {
        made: view(label, item, count),
        possible: parts.iter().all(|part| part.has_m3 >= part.needs_m3),
        parts,
    }
}

/// Five things: the first cannot be made, nor can the last.
fn making() -> MakingModel {
    let coal = |needs| part("coal", needs, 2.34);
    let copper = |needs| part("copper", needs, 0.2);
    let earth = |label: &str, m3| EarthView {
        label: label.to_owned(),
        tint: tint([120, 90, 40]),
        m3,
    };
    MakingModel {
        recipes: vec![
            recipe("Door", Item::Door, 1, vec![coal(1.0), copper(3.0)]),
            recipe("Lamp", Item::Lamp, 2, vec![coal(0.5)]),
            recipe("Bullet", Item::Bullet, 10, vec![copper(0.05), coal(0.1)]),
            recipe("Flag", Item::Flag, 1, vec![copper(0.1)]),
            recipe("Gun", Item::Gun, 1, vec![coal(0.5), copper(2.0)]),
        ],
        earth: vec![earth("coal", 2.34), earth("copper", 0.2)],
    }
}

const DOOR: &str = "Make Door: coal 2.3 of 1.0 m³ · copper 0.2 of 3.0 m³";
const CARRIED: &str = "You carry: · coal 2.3 m³ · copper 0.2 m³ · Coal lies in beds from 2 m below the ground on, copper in \
     veins from 4 m, often under clay, and crystal from 7 m, under gravel, and in the halls of caves.";
const LAMP: &str = "Make Lamp × 2: coal 2.3 of 0.5 m³";
const BULLETS: &str = "Make Bullet × 10: copper 0.20 of 0.05 m³ · coal 2.3 of 0.1 m³";
const GUN: &str = "Make Gun: coal 2.3 of 0.5 m³ · copper 0.2 of 2.0 m³";

fn with_recipes() -> Bag {
    Bag {
        making: Some(making()),
        ..bag()
    }
}

fn slots(size: Vec2) -> Harness<'static, Bag> {
    harness(with_recipes(), size)
}

/// The page, turned to by the pointer.
fn page(own: Bag, size: Vec2) -> Harness<'static, Bag> {
    let button = own.texts.say("backpack-make");
    let mut harness = harness(own, size);
    harness.get_by_label(&button).click();
    harness.run_ok();
    harness
}

fn keys(harness: &mut Harness<'_, Bag>, keys: &[Key]) {
    for key in keys {
        harness.key_press(*key);
        harness.run_ok();
    }
}

#[test]
fn without_anything_to_make_there_is_no_page_and_no_way_to_it() {
    let mut harness = harness(bag(), vec2(1280.0, 720.0));
    assert!(harness.query_by_label("Make things").is_none());
    keys(&mut harness, &[Key::ArrowDown]);
    assert_eq!(focused(&harness), "Close");
    harness.state_mut().making = Some(making());
    harness.run_ok();
    harness.get_by_label("Make things").click();
    harness.run_ok();
    harness.get_by_label(LAMP);
    harness.state_mut().making = None;
    harness.run_ok();
    harness.get_by_label("Slot 1: Gun");
}

#[test]
fn the_mouse_turns_the_page_and_makes_what_is_possible_and_nothing_else() {
    let mut harness = page(with_recipes(), vec2(1280.0, 720.0));
    assert!(harness.query_by_label("Slot 1: Gun").is_none());
    assert_eq!(asked(&mut harness), []);
    harness.get_by_label(CARRIED);
    harness.get_by_label(BULLETS).click();
    assert_eq!(asked(&mut harness), [BackpackWish::Make(2)]);
    for label in [DOOR, GUN] {
        let node = harness.get_by_label(label);
        assert!(node.accesskit_node().is_disabled(), "{label}");
        node.click();
        assert_eq!(asked(&mut harness), [], "{label}");
    }
    assert!(!harness.get_by_label(LAMP).accesskit_node().is_disabled());
    harness.get_by_label("Slots").click();
    assert_eq!(asked(&mut harness), []);
    harness.get_by_label("Slot 6: Lamp × 10");
    assert_eq!(focused(&harness), "Slot 1: Gun", "what is in hand");
}

#[test]
fn the_keys_turn_the_page_walk_through_it_and_make() {
    let mut harness = slots(vec2(1280.0, 720.0));
    keys(&mut harness, &[Key::ArrowDown]);
    assert_eq!(focused(&harness), "Make things");
    keys(&mut harness, &[Key::Enter]);
    assert_eq!(focused(&harness), LAMP, "the first that is possible");
    assert_eq!(asked(&mut harness), []);
    keys(&mut harness, &[Key::Enter, Key::Space]);
    assert_eq!(asked(&mut harness), [BackpackWish::Make(1); 2]);
    keys(&mut harness, &[Key::ArrowUp, Key::Enter]);
    assert_eq!(focused(&harness), DOOR);
    assert_eq!(asked(&mut harness), [], "it takes more than there is");
    keys(&mut harness, &[Key::Tab, Key::ArrowRight, Key::ArrowLeft]);
    assert_eq!(focused(&harness), LAMP, "sideways there is nothing");
    keys(&mut harness, &[Key::ArrowDown, Key::Enter]);
    assert_eq!(asked(&mut harness), [BackpackWish::Make(2)]);
    keys(&mut harness, &[Key::ArrowDown, Key::ArrowDown]);
    assert_eq!(focused(&harness), GUN);
    keys(&mut harness, &[Key::ArrowDown]);
    assert_eq!(focused(&harness), "Close");
    keys(&mut harness, &[Key::ArrowLeft]);
    assert_eq!(focused(&harness), "Slots");
    keys(&mut harness, &[Key::ArrowUp]);
    assert_eq!(focused(&harness), GUN);
    keys(&mut harness, &[Key::Tab, Key::Enter]);
    assert_eq!(asked(&mut harness), []);
    assert_eq!(focused(&harness), "Slot 1: Gun", "what is in hand");
}

#[test]
fn a_key_held_down_turns_the_page_or_makes_one_and_no_more() {
    let mut harness = slots(vec2(1280.0, 720.0));
    keys(&mut harness, &[Key::ArrowDown]);
    for key in [Key::Enter, Key::Space] {
        // Down and never up: egui tells repeats from presses by that.
        for _ in 0..3 {
            harness.key_down(key);
            harness.run_ok();
        }
        assert_eq!(focused(&harness), LAMP);
        let made = usize::from(key == Key::Space);
        assert_eq!(asked(&mut harness), vec![BackpackWish::Make(1); made]);
    }
}

#[test]
fn with_nothing_possible_the_first_of_all_has_the_focus() {
    let mut own = with_recipes();
    for recipe in own.making.iter_mut().flat_map(|it| &mut it.recipes) {
        recipe.possible = false;
    }
    let harness = page(own, vec2(1280.0, 720.0));
    assert_eq!(focused(&harness), DOOR);
}

#[test]
fn arrows_find_a_recipe_again_after_a_click_beside_all() {
    let mut harness = page(with_recipes(), vec2(1280.0, 720.0));
    let title = harness.get_by_label("Make things").rect().center();
    harness.hover_at(title);
    harness.drag_at(title);
    harness.drop_at(title);
    harness.run_ok();
    assert_eq!(focused(&harness), "");
    keys(&mut harness, &[Key::ArrowDown]);
    assert_eq!(focused(&harness), LAMP);
}

#[test]
fn slots_are_not_asked_for_where_they_are_not_seen() {
    let mut harness = slots(vec2(1280.0, 720.0));
    let lamps = harness.get_by_label("Slot 6: Lamp × 10").rect().center();
    let place = harness.get_by_label("Slot 30: empty").rect().center();
    harness.get_by_label("Slot 6: Lamp × 10").click();
    assert_eq!(asked(&mut harness), [BackpackWish::Click(5)]);
    let carried = harness.state().carried.clone();
    assert!(carried.is_some());
    harness.get_by_label("Make things").click();
    assert_eq!(asked(&mut harness), []);
    assert_eq!(harness.state().carried, carried, "it stays at the pointer");
    for place in [lamps, place] {
        harness.hover_at(place);
        harness.run_ok();
        harness.state_mut().screen.swap_with(3);
        harness.state_mut().screen.throw_one(false);
        assert_eq!(asked(&mut harness), []);
        harness.drag_at(place);
        harness.drop_at(place);
        let mut others = asked(&mut harness);
        others.retain(|wish| !matches!(wish, BackpackWish::Make(_)));
        assert_eq!(others, [], "at most a recipe lies there");
    }
    keys(&mut harness, &[Key::ArrowDown, Key::ArrowUp]);
    harness.state_mut().screen.swap_with(3);
    harness.state_mut().screen.throw_one(false);
    assert_eq!(asked(&mut harness), []);
    harness.state_mut().screen.throw_one(true);
    assert_eq!(asked(&mut harness), [BackpackWish::LetGo { whole: false }]);
}

#[test]
fn opened_anew_it_shows_the_slots() {
    let mut harness = page(with_recipes(), vec2(1280.0, 720.0));
    harness.state_mut().screen.close();
    harness.run_ok();
    harness.state_mut().screen.open();
    harness.run_ok();
    harness.get_by_label("Slot 1: Gun");
}

/// A dozen things of three kinds of ground each, and all kinds carried.
fn crowded(language: Language) -> Bag {
    let texts = Texts::new(language);
    let kinds = ["basalt", "crystal", "copper", "gravel", "clay"];
    let kinds = kinds.map(|kind| texts.say(&format!("ground-{kind}")));
    let parts: Vec<_> = kinds[..3]
        .iter()
        .zip([1234.25, 0.5, 20.0])
        .map(|(kind, needs)| part(kind, needs, 100.0))
        .collect();
    let door = texts.say("item-pickaxe-diamond");
    let earth = |kind: &String| EarthView {
        label: kind.clone(),
        tint: tint([99, 120, 130]),
        m3: 1234.56,
    };
    let making = MakingModel {
        recipes: (1..=12)
            .map(|count| recipe(&door, Item::PickaxeDiamond, count, parts.clone()))
            .collect(),
        earth: kinds.iter().chain(&kinds).map(earth).collect(),
    };
    Bag {
        texts,
        making: Some(making),
        ..bag()
    }
}

/// That no words lie on others, leave the window, or are cut off but where the list is scrolled.
fn fits(harness: &Harness<'_, Bag>, language: Language, size: Vec2) {
    let window = Rect::from_min_size(Pos2::ZERO, size);
    let texts = painted(harness.output());
    let seen = |rect: Rect, clip: Rect| rect.intersect(clip.intersect(window));
    for (index, text) in texts.iter().enumerate() {
        let shown = text.clip.intersect(window).expand(0.5).x_range();
        let whole = shown.contains(text.rect.min.x) && shown.contains(text.rect.max.x);
        assert!(
            whole && !text.elided,
            "“{}” is cut off at {size} in {language:?}",
            text.text
        );
        for other in &texts[..index] {
            let both = seen(text.rect, text.clip).intersect(seen(other.rect, other.clip));
            assert!(
                both.width() < 1.0 || both.height() < 1.0,
                "“{}” lies on “{}” at {size} in {language:?}",
                text.text,
                other.text
            );
        }
    }
}

#[test]
fn nothing_overlaps_or_leaves_the_window_in_any_language() {
    for (language, size) in everywhere(&SIZES) {
        let window = Rect::from_min_size(Pos2::ZERO, size);
        let mut harness = page(crowded(language), size);
        let words = |key: &str| Texts::new(language).say(key);
        let panel = antipode_ui::Backpack::panel(window).shrink(4.0);
        for key in ["backpack-slots", "backpack-throw", "backpack-close"] {
            let words = words(key);
            let button = harness.get_by_label(&words);
            assert!(
                panel.contains_rect(button.rect()),
                "{key} at {size} in {language:?}"
            );
        }
        for _ in 0..14 {
            fits(&harness, language, size);
            let label = focused(&harness);
            let rect = harness.get_by_label(&label).rect();
            let close = harness.get_by_label(&words("backpack-close")).rect();
            let over = rect.center().y < close.min.y || rect.min.y >= close.min.y - 1.0;
            assert!(
                panel.contains(rect.center()) && over,
                "{label} at {rect} in {size}"
            );
            keys(&mut harness, &[Key::ArrowDown]);
        }
        let slots = words("backpack-slots");
        harness.get_by_label(&slots).click();
        harness.run_ok();
        for text in painted(harness.output()) {
            let seen = text.clip.intersect(window).expand(0.5);
            assert!(seen.contains_rect(text.rect), "“{}” at {size}", text.text);
        }
    }
}

#[test]
fn no_window_is_too_small_for_the_page() {
    for size in SMALLEST {
        let mut harness = slots(size);
        keys(&mut harness, &[Key::ArrowDown, Key::Enter]);
        keys(&mut harness, &[Key::ArrowDown; 6]);
    }
}
