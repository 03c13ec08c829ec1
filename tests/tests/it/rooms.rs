//! Rooms by the program: every room of the game is entered, walked into, looked at and photographed, and one is made, changed,
//! kept and deleted.

use std::collections::HashSet;

use antipode_rooms::shipped::{self, ROOMS};
use antipode_testing::may_skip;
use antipode_tests::program::{field, number, run, run_with};
use antipode_tests::seam::picture;

#[test]
fn every_room_of_the_game_is_entered_and_seen() {
    let saves = tempfile::tempdir().unwrap();
    let options = ["--adapter", "software", "--size", "160x90"];
    let adapter = run_with(saves.path(), "room new\nshot probe.png", &options);
    if adapter.status != Some(0) && may_skip("a software adapter") {
        return;
    }
    let enter = |room: &shipped::Shipped| {
        let id = room.id;
        // Not on to the stair, which rises.
        let time = if id == "endless-stair" { 0.8 } else { 1.2 };
        format!("room load {id}\nhold KeyW {time}\nwait 1\naim -90 -10\nprobe\nshot {id}.png\n")
    };
    let script: String = ROOMS.iter().map(enter).collect();
    let run = run_with(saves.path(), &script, &options);
    for (number_of, room) in ROOMS.iter().enumerate() {
        let id = room.id;
        let probe = run.probe(number_of);
        assert!(field(probe, "pick.object").is_string(), "{id}: {probe}");
        assert_eq!(field(probe, "player.grounded"), true, "{id}");
        assert!(number(probe, "player.pos.1").abs() < 0.3, "{id}");
        assert!(
            number(probe, "player.pos.2") < 5.0,
            "{id} was not walked in"
        );
        let seen = picture(&saves.path().join(format!("{id}.png")));
        let colours: HashSet<_> = seen.pixels().map(|it| it.0.map(|it| it / 16)).collect();
        assert!(colours.len() > 20, "{id} is flat: {}", colours.len());
        let light = seen.pixels().map(|it| u64::from(it.0[1])).sum::<u64>();
        let mean = light / u64::from(seen.width() * seen.height());
        assert!((30..230).contains(&mean), "{id} has a mean of {mean}");
    }
}

#[test]
fn a_room_is_made_changed_kept_and_deleted() {
    let saves = tempfile::tempdir().unwrap();
    let dir = saves.path().to_path_buf();
    let made = run(
        &dir,
        "room new name=Mine\nadd box name=wall at=0,1,-6 size=4,2,0.2\nadd ball name=b at=9,1,0 radius=1\n\
         undo\nredo\nremove b\nchange wall at=0,1,-7\nroom save\naim -90 0\nprobe\nhold KeyW 3\nprobe\n\
         room save name=Other\nroom list",
    );
    let probe = made.probe(0);
    assert_eq!(field(probe, "room"), "Mine");
    assert_eq!(field(probe, "pick.object"), "wall");
    assert!((number(probe, "pick.felt") - 6.9).abs() < 1e-6, "{probe}");
    assert_eq!(field(probe, "objects").as_array().unwrap().len(), 2);
    let stopped = made.probe(1);
    assert!((number(stopped, "player.pos.2") + 6.55).abs() < 0.02);
    assert!(number(stopped, "felt_speed") < 0.3);
    let names: Vec<_> = made.probe(2).as_array().unwrap().iter().collect();
    assert_eq!(names.len(), ROOMS.len() + 2);
    let again = run(
        &dir,
        "room load Other\nprobe\nroom delete Mine\nroom list\nnew euclidean\nprobe",
    );
    let probe = again.probe(0);
    assert_eq!(field(probe, "objects.1.name"), "wall");
    assert_eq!(number(probe, "objects.1.pos.2"), -7.0);
    assert_eq!(again.probe(1).as_array().unwrap().len(), ROOMS.len() + 1);
    assert_eq!(field(again.probe(2), "geometry"), "euclidean");
}

#[test]
fn copies_of_the_games_rooms_have_its_own_words_in_their_files() {
    let saves = tempfile::tempdir().unwrap();
    let script = "set language de\nroom load long-house\nroom save name=Kopie\nset language en\n\
                  room load long-house\nroom save name=Copy\nprobe";
    assert_eq!(field(run(saves.path(), script).probe(0), "room"), "Copy");
    let text = |slug: &str| {
        std::fs::read_to_string(saves.path().join(format!("rooms/{slug}/room.ron"))).unwrap()
    };
    // What is shown is in the language of who plays, and changes with it.
    assert!(text("kopie").contains("this house is 8 metres long"));
    assert!(text("copy").contains("this house is 8 metres long"));
}

#[test]
fn what_makes_no_sense_is_told_with_its_line() {
    let saves = tempfile::tempdir().unwrap();
    for (script, said) in [
        ("room load nothing", "no room \"nothing\""),
        ("add box name=a size=1,1,1", "no room is open"),
        ("new euclidean\nredo", "no room is open"),
        ("room new\ngive lamp 1", "\"give\" is for worlds"),
        ("room new\nset time 150", "\"set\" is for worlds"),
        ("room new\nadd box name=a", "say its size"),
        ("room new\nundo", "nothing to undo"),
        ("room new\nroom save", "has no name"),
        ("room load long-house\nroom save", "comes with the game"),
        ("room new\nteleport 5000 0 0", "farther than 1000 m"),
    ] {
        let run = run(saves.path(), script);
        let line = script.lines().count();
        assert_ne!(run.status, Some(0), "{script}");
        let told = &run.stderr;
        assert!(told.contains(&format!("line {line}: ")), "{script}: {told}");
        assert!(told.contains(said), "{script}: {told}");
    }
}

#[test]
fn a_script_looks_by_the_rules_that_a_player_does() {
    let saves = tempfile::tempdir().unwrap();
    let options = ["--adapter", "software", "--size", "96x64"];
    let adapter = run_with(saves.path(), "room new\nshot probe.png", &options);
    if adapter.status != Some(0) && may_skip("a software adapter") {
        return;
    }
    let script = "room load four-tunnels\ntap F1\nteleport -8 0 -18\naim -80 2\nwait 0.5\nshot exact.png\ntap KeyH\nshot split.png\n\
         tap KeyH\nshot thesis.png\ntap KeyH\nshot plain.png\ntap KeyH\nshot again.png";
    run_with(saves.path(), script, &options);
    let of = |name: &str| picture(&saves.path().join(format!("{name}.png")));
    let differs = |one: &str, other: &str, columns: std::ops::Range<u32>| {
        let (one, other) = (of(one), of(other));
        let far = |x, y| {
            let (a, b) = (one.get_pixel(x, y).0, other.get_pixel(x, y).0);
            a.iter().zip(b).any(|(a, b)| a.abs_diff(b) > 12)
        };
        let places = columns.flat_map(|x| (0..64).map(move |y| (x, y)));
        places.filter(|(x, y)| far(*x, *y)).count()
    };
    assert!(differs("exact", "thesis", 0..96) > 100);
    assert!(differs("exact", "plain", 0..96) > 100);
    assert_eq!(differs("split", "exact", 52..96), 0, "right exactly");
    assert_eq!(differs("split", "thesis", 0..44), 0, "left by the thesis");
    assert_eq!(differs("exact", "again", 0..96), 0);
}
