//! What a script may say, and what is told of its mistakes.

use antipode_geometry::HyperbolicMap;
use antipode_scene::frame::Quality;
use antipode_settings::{Settings, Value};

use super::*;

fn one(line: &str) -> Result<Order, Mistake> {
    parse(line).map(|mut lines| lines.remove(0).order)
}

#[test]
fn comments_blank_lines_and_quotes_are_read() {
    let lines =
        parse("# a comment\n\n  new hyperbolic seed=7 name=\"My # world\" # trailing\nprobe")
            .unwrap_or_default();
    assert_eq!(lines.len(), 2);
    assert_eq!(lines[0].number, 3);
    let Order::New(world) = &lines[0].order else {
        unreachable!("a new world was asked for")
    };
    assert_eq!(
        (world.name.as_deref(), world.seed),
        (Some("My # world"), Some(7))
    );
}

#[test]
fn mistakes_name_their_line() {
    for (text, line) in [
        ("jump", 1),
        ("probe\nwait -1", 2),
        ("wait NaN", 1),
        ("wait inf", 1),
        ("hold KeyÄ 1", 1),
        ("hold KeyW", 1),
        ("new toroidal", 1),
        ("new euclidean colour=red", 1),
        ("new euclidean seed=-1", 1),
        ("new euclidean name=\"\"", 1),
        ("new euclidean name=\" \"", 1),
        ("set curvature 21", 1),
        ("set gravity 1", 1),
        ("set map flat", 1),
        ("set map", 1),
        ("set bend 20.5", 1),
        ("set bend NaN", 1),
        ("set quality best", 1),
        ("teleport 0 0 NaN", 1),
        ("teleport 0 0 0 C", 1),
        ("shot picture.jpg", 1),
        ("give gold 1", 1),
        ("give pickaxe-iron 0", 1),
        ("click MIDDLE", 1),
        ("load \"open", 1),
        ("perf 0", 1),
        ("probe now", 1),
    ] {
        let mistake = parse(text).err();
        assert_eq!(mistake.map(|m| m.line), Some(line), "{text} passed");
    }
}

#[test]
fn a_byte_order_mark_is_skipped_and_long_words_are_cut() {
    assert_eq!(one("\u{feff}probe"), Ok(Order::Probe));
    let long = "x".repeat(100_000);
    for line in [
        long.clone(),
        format!("load {long}"),
        format!("wait {long}"),
        format!("new euclidean name={long}"),
    ] {
        let said = parse(&line).err().map(|mistake| mistake.to_string());
        assert!(
            said.is_some_and(|words| words.len() < 200),
            "{}",
            &line[..20]
        );
    }
}

#[test]
fn orders_carry_their_numbers() {
    assert_eq!(
        one("hold KeyW 1.5"),
        Ok(Order::Hold(Input::Key("KeyW"), 1.5))
    );
    assert_eq!(
        one("hold LEFT 2"),
        Ok(Order::Hold(Input::Mouse(MouseButton::Left), 2.0))
    );
    assert_eq!(one("aim -90 10.5"), Ok(Order::Aim(-90.0, 10.5)));
    assert_eq!(
        one("teleport 1 2 3 B"),
        Ok(Order::Teleport([1.0, 2.0, 3.0], ChartId::SECOND))
    );
    assert_eq!(one("set fly on"), Ok(Order::Set(Setting::Fly(true))));
    assert_eq!(
        one("set map horizon"),
        Ok(Order::Set(Setting::Map(HyperbolicMap::Horizon)))
    );
    assert_eq!(one("set bend -7.5"), Ok(Order::Set(Setting::Bend(-7.5))));
    assert_eq!(
        one("set quality fast"),
        Ok(Order::Set(Setting::Quality(Quality::Fast)))
    );
    assert_eq!(one("settle"), Ok(Order::Settle(60.0)));
}

#[test]
fn no_text_makes_the_reader_panic() {
    for text in [
        "\"",
        "#",
        "\u{0}\u{0}",
        "new =",
        "new euclidean =",
        "set set set set",
        "🦀 🦀",
        "hold \"\" \"\"",
    ] {
        let _ = parse(text);
    }
}

#[test]
fn set_knows_every_setting_of_the_player_and_what_it_takes() {
    let defaults = Settings::default();
    for field in antipode_settings::fields() {
        let value = defaults.get(field);
        let order = one(&format!("set {} {value}", field.id));
        assert!(
            matches!(order, Ok(Order::Set(_))),
            "{}: {order:?}",
            field.id
        );
    }
    let order = Order::Set(Setting::Own("head-dip", Value::Switch(false)));
    assert!(!order.cheats());
    assert_eq!(one("set head-dip off").ok(), Some(order));
    for wrong in [
        "set head-dip maybe",
        "set field-of-view 200",
        "set language klingon",
    ] {
        assert!(one(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn words_of_rooms_are_orders_or_mistakes() {
    let room = |order| Ok(Order::Room(order));
    assert_eq!(
        one("room new name=\"My room\" gravity=0,-1.6,0"),
        room(RoomOrder::New {
            name: Some("My room".to_owned()),
            gravity: Some([0.0, -1.6, 0.0]),
        })
    );
    let house = || "The long house".to_owned();
    assert_eq!(
        one("room load \"The long house\""),
        room(RoomOrder::Load(house()))
    );
    assert_eq!(
        one("room load name=\"The long house\""),
        room(RoomOrder::Load(house()))
    );
    assert_eq!(one("room save"), room(RoomOrder::Save(None)));
    assert_eq!(one("room list"), room(RoomOrder::List));
    assert_eq!(one("room versions"), room(RoomOrder::Versions));
    assert_eq!(one("room older 3"), room(RoomOrder::Older(3)));
    let words = ["room", "set", "sky=#123456"].map(str::to_owned);
    assert_eq!(
        one("room set sky=\"#123456\""),
        Ok(Order::Edit(words.to_vec()))
    );
    assert_eq!(
        one("carry none a \"b c\""),
        Ok(Order::Edit(
            ["carry", "none", "a", "b c"].map(str::to_owned).to_vec()
        ))
    );
    assert_eq!(one("undo"), Ok(Order::Edit(vec!["undo".to_owned()])));
    assert!(matches!(
        one("add box name=a size=1,1,1"),
        Ok(Order::Edit(words)) if words.len() == 4
    ));
    for (mistake, said) in [
        ("room", "too few"),
        ("room load", "too few"),
        (
            "room paint x",
            "new, load, save, delete, list, versions, older, set",
        ),
        ("room new gravity=1,2", "three numbers"),
        ("room new gravity=0,-1e9,0", "out of range"),
        ("room new name=", "will not do"),
        ("room older x", "no number of an older version"),
        ("room older 0", "no number of an older version"),
        ("add box", "too few"),
        ("remove", "too few"),
    ] {
        let told = parse(mistake).err().map_or_else(String::new, |it| it.what);
        assert!(told.contains(said), "{mistake}: {told}");
    }
}
