//! The backpack by mouse and by keys: what each press, drag and key asks for, in every language and window.

use crate::common::painted;
use antipode_items::Item;
use antipode_language::{Language, Texts};
use antipode_ui::{Backpack, BackpackModel, BackpackWish, MakingModel, SlotView, apply_theme};
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};

/// The screen over slots that never change: what was asked for is noted.
pub struct Bag {
    pub texts: Texts,
    pub screen: Backpack,
    pub slots: Vec<SlotView>,
    pub carried: Option<SlotView>,
    pub making: Option<MakingModel>,
    pub wishes: Vec<BackpackWish>,
}

pub fn view(label: &str, item: Item, count: u32) -> SlotView {
    SlotView {
        label: label.to_owned(),
        item: Some(item),
        count: (count > 1).then_some(count),
    }
}

/// A gun, bullets and lamps in the hotbar, one lamp in the backpack.
pub fn bag() -> Bag {
    let mut slots = vec![SlotView::default(); 40];
    slots[0] = view("Gun", Item::Gun, 1);
    slots[4] = view("Bullet", Item::Bullet, 64);
    slots[5] = view("Lamp", Item::Lamp, 10);
    slots[21] = view("Lamp", Item::Lamp, 1);
    let mut screen = Backpack::default();
    screen.open();
    Bag {
        texts: Texts::default(),
        screen,
        slots,
        carried: None,
        making: None,
        wishes: Vec::new(),
    }
}

fn show(ctx: &egui::Context, bag: &mut Bag) {
    let model = BackpackModel {
        texts: &bag.texts,
        slots: &bag.slots,
        selected: 0,
        carried: bag.carried.as_ref(),
        making: bag.making.as_ref(),
    };
    let wishes = bag.screen.show(ctx, &model);
    for wish in &wishes {
        match wish {
            // As much of the game as the screen sees of it.
            BackpackWish::Click(slot) | BackpackWish::ClickOther(slot) => {
                let there = bag.slots[usize::from(*slot)].clone();
                let carries = bag.carried.is_some();
                bag.carried = Some(there).filter(|there| !carries && there.count.is_some());
            }
            BackpackWish::Make(_) => {}
            _ => bag.carried = None,
        }
    }
    bag.wishes.extend(wishes);
}

pub fn harness(bag: Bag, size: Vec2) -> Harness<'static, Bag> {
    let mut harness = Harness::builder()
        .with_size(size)
        .with_max_steps(8)
        .allow_missing_glyphs()
        .with_context_setup(apply_theme)
        .build_ui_state(|ui, bag: &mut Bag| show(ui.ctx(), bag), bag);
    harness.run_ok();
    harness
}

fn window() -> Harness<'static, Bag> {
    harness(bag(), vec2(1280.0, 720.0))
}

pub fn asked(harness: &mut Harness<'_, Bag>) -> Vec<BackpackWish> {
    harness.run_ok();
    std::mem::take(&mut harness.state_mut().wishes)
}

fn at(harness: &Harness<'_, Bag>, label: &str) -> Pos2 {
    harness.get_by_label(label).rect().center()
}

fn press(harness: &Harness<'_, Bag>, pos: Pos2, button: PointerButton, pressed: bool) {
    harness.event(Event::PointerButton {
        pos,
        button,
        pressed,
        modifiers: Modifiers::NONE,
    });
}

fn drag(harness: &mut Harness<'_, Bag>, from: Pos2, to: Pos2) -> Vec<BackpackWish> {
    harness.event(Event::PointerMoved(from));
    press(harness, from, PointerButton::Primary, true);
    harness.event(Event::PointerMoved(to));
    press(harness, to, PointerButton::Primary, false);
    asked(harness)
}

const LAMPS: &str = "Slot 6: Lamp × 10";

#[test]
fn each_button_of_the_mouse_asks_for_its_own() {
    let mut harness = window();
    harness.get_by_label(LAMPS).click();
    assert_eq!(asked(&mut harness), [BackpackWish::Click(5)]);
    harness.get_by_label("Slot 12: empty").click();
    assert_eq!(asked(&mut harness), [BackpackWish::Click(11)]);
    harness.get_by_label(LAMPS).click_secondary();
    assert_eq!(asked(&mut harness), [BackpackWish::ClickOther(5)]);
    harness.get_by_label("Slot 12: empty").click_secondary();
    assert_eq!(asked(&mut harness), [BackpackWish::ClickOther(11)]);
    harness
        .get_by_label(LAMPS)
        .click_modifiers(Modifiers::SHIFT);
    assert_eq!(asked(&mut harness), [BackpackWish::Send(5)]);
    harness.get_by_label(LAMPS).click_modifiers(Modifiers::CTRL);
    assert_eq!(asked(&mut harness), [BackpackWish::ClickOther(5)]);
}

#[test]
fn a_drag_takes_where_it_begins_and_ends_where_it_is_let_go() {
    let mut harness = window();
    let (lamps, free) = (at(&harness, LAMPS), at(&harness, "Slot 30: empty"));
    let (click, outside) = (BackpackWish::Click(5), egui::pos2(20.0, 400.0));
    assert_eq!(
        drag(&mut harness, lamps, free),
        [click, BackpackWish::EndDrag(29)]
    );
    assert_eq!(
        drag(&mut harness, lamps, outside),
        [click, BackpackWish::LetGo { whole: true }]
    );
    let between = lamps - vec2(0.0, 34.0);
    assert_eq!(
        drag(&mut harness, lamps, between),
        [click, BackpackWish::EndDrag(40)],
        "beside every slot it goes back"
    );
    let button = at(&harness, "Throw away");
    assert_eq!(
        drag(&mut harness, lamps, button),
        [click, BackpackWish::LetGo { whole: true }]
    );
    assert_eq!(
        drag(&mut harness, free, lamps),
        [BackpackWish::Click(29)],
        "nothing was taken"
    );
}

#[test]
fn a_whole_drag_in_one_slow_frame_is_the_same_drag() {
    let mut harness = window();
    let (lamps, free) = (at(&harness, LAMPS), at(&harness, "Slot 30: empty"));
    let button = |pos, pressed| Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    harness.input_mut().events.extend([
        Event::PointerMoved(lamps),
        button(lamps, true),
        Event::PointerMoved(free),
        button(free, false),
    ]);
    assert_eq!(
        asked(&mut harness),
        [BackpackWish::Click(5), BackpackWish::EndDrag(29)]
    );
}

#[test]
fn what_is_at_the_pointer_is_thrown_outside_and_by_its_button() {
    let mut harness = window();
    harness.state_mut().carried = Some(view("Lamp", Item::Lamp, 10));
    let outside = egui::pos2(20.0, 400.0);
    press(&harness, outside, PointerButton::Secondary, true);
    press(&harness, outside, PointerButton::Secondary, false);
    assert_eq!(asked(&mut harness), [BackpackWish::LetGo { whole: false }]);
    press(&harness, outside, PointerButton::Primary, true);
    assert_eq!(asked(&mut harness), [], "nothing is left to throw");
    harness.state_mut().carried = Some(view("Lamp", Item::Lamp, 10));
    harness.run_ok();
    harness.get_by_label("Throw away").click();
    assert_eq!(asked(&mut harness), [BackpackWish::LetGo { whole: true }]);
    harness.get_by_label("Close").click();
    assert_eq!(asked(&mut harness), [BackpackWish::Close]);
}

pub fn focused(harness: &Harness<'_, Bag>) -> String {
    harness
        .root()
        .children_recursive()
        .map(|node| node.accesskit_node())
        .find(|node| node.is_focused() && node.role() != egui::Role::Window)
        .and_then(|node| node.label())
        .unwrap_or_default()
}

#[test]
fn arrows_in_one_frame_after_another_move_one_slot_each() {
    let mut harness = Harness::builder()
        .with_size(vec2(800.0, 600.0))
        .with_context_setup(apply_theme)
        .with_max_steps(1)
        .build_ui_state(|ui, bag: &mut Bag| show(ui.ctx(), bag), bag());
    for _ in 0..4 {
        harness.input_mut().events.push(Event::Key {
            key: Key::ArrowRight,
            physical_key: None,
            pressed: true,
            repeat: false,
            modifiers: Modifiers::NONE,
        });
        harness.step();
    }
    assert_eq!(focused(&harness), "Slot 5: Bullet × 64");
}

#[test]
fn everything_is_done_by_keys() {
    let mut harness = window();
    assert_eq!(focused(&harness), "Slot 1: Gun", "what is in hand");
    let walk = |harness: &mut Harness<'_, Bag>, keys: &[Key]| {
        for key in keys {
            harness.key_press(*key);
            harness.run_ok();
        }
    };
    walk(&mut harness, &[Key::ArrowUp, Key::ArrowUp, Key::ArrowRight]);
    assert_eq!(focused(&harness), "Slot 22: Lamp");
    harness.key_press(Key::Enter);
    assert_eq!(asked(&mut harness), [BackpackWish::Click(21)]);
    harness.key_press_modifiers(Modifiers::SHIFT, Key::Enter);
    assert_eq!(asked(&mut harness), [BackpackWish::Send(21)]);
    harness.key_press_modifiers(Modifiers::CTRL, Key::Enter);
    assert_eq!(asked(&mut harness), [BackpackWish::ClickOther(21)]);
    harness.state_mut().screen.swap_with(8);
    harness.state_mut().screen.throw_one(false);
    harness.state_mut().screen.throw_one(true);
    assert_eq!(
        asked(&mut harness),
        [
            BackpackWish::Swap(21, 8),
            BackpackWish::Throw(21),
            BackpackWish::LetGo { whole: false }
        ]
    );
    harness.state_mut().carried = Some(view("Lamp", Item::Lamp, 10));
    walk(
        &mut harness,
        &[Key::ArrowDown, Key::ArrowDown, Key::ArrowDown],
    );
    assert_eq!(focused(&harness), "Throw away");
    walk(&mut harness, &[Key::Tab]);
    assert_eq!(focused(&harness), "Close");
}

#[test]
fn what_lies_under_the_pointer_is_told_and_what_it_does() {
    for language in Language::ALL {
        let mut own = bag();
        own.texts = Texts::new(language);
        let about = own.texts.say("item-lamp-about");
        let values = [("item", "Lamp".into()), ("count", 10.into())];
        let name = own.texts.say_with("backpack-item", &values);
        let mut harness = harness(own, vec2(1280.0, 720.0));
        let says = |harness: &Harness<'_, Bag>, words: &str| {
            painted(harness.output())
                .iter()
                .any(|text| text.text == words)
        };
        assert!(!says(&harness, &about));
        let slot = harness.state().texts.say_with(
            "backpack-slot",
            &[("number", 6.into()), ("item", name.as_str().into())],
        );
        harness.get_by_label(&slot).hover();
        harness.run_ok();
        assert!(
            says(&harness, &about) && says(&harness, &name),
            "{language:?}"
        );
    }
}

#[test]
fn no_words_are_cut_off_in_any_window_and_language() {
    for language in Language::ALL {
        for size in [
            vec2(320.0, 200.0),
            vec2(427.0, 240.0),
            vec2(640.0, 360.0),
            vec2(800.0, 600.0),
            vec2(2560.0, 1440.0),
        ] {
            let mut own = bag();
            own.texts = Texts::new(language);
            let slot = |own: &Bag, number: u32, item: &str| {
                let item = own.texts.say_with(
                    "backpack-item",
                    &[("item", item.into()), ("count", 64.into())],
                );
                let values = [("number", number.into()), ("item", item.into())];
                own.texts.say_with("backpack-slot", &values)
            };
            let bullets = slot(&own, 5, "Bullet");
            let mut harness = harness(own, size);
            harness.get_by_label(&bullets).hover();
            harness.run_ok();
            let window = Rect::from_min_size(Pos2::ZERO, size);
            for text in painted(harness.output()) {
                let seen = text.clip.intersect(window).expand(0.5);
                assert!(
                    seen.contains_rect(text.rect) && !text.elided,
                    "“{}” is cut off at {size} in {language:?}: {:?} of {seen:?}",
                    text.text,
                    text.rect
                );
            }
        }
    }
}

#[test]
fn no_window_is_too_small() {
    for size in [
        vec2(1.0, 1.0),
        vec2(1.0, 400.0),
        vec2(900.0, 2.0),
        vec2(40.0, 30.0),
    ] {
        harness(bag(), size);
    }
}
