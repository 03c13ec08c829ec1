//! A room changed by commands.

use antipode_rooms::aberration::{Axis, Lengths, Sides};
use antipode_rooms::{Room, What, read, space_so_far, write};
use antipode_workshop::Document;
use glam::DVec3;
use proptest::prelude::*;

fn editor() -> Document {
    Document::new(Room::new("Test"))
}

fn steps(it: &Document) -> (usize, usize) {
    let history = it.history();
    let made = history.made();
    (made, history.steps().len() - made)
}

fn apply(editor: &mut Document, command: &str) -> Result<(), String> {
    let words: Vec<&str> = command.split(' ').collect();
    editor.command(&words).map_err(|error| error.to_string())
}

#[track_caller]
fn done(editor: &mut Document, command: &str) {
    apply(editor, command).unwrap();
}

#[test]
fn a_room_is_built_by_commands() {
    let mut it = editor();
    for command in [
        "add box name=wall at=0,1,-5 size=4,2,0.2 colour=#c04030 checker=#ffffff,0.5",
        "add ball name=ball at=1,0.5,-3 radius=0.5 glow=0.5 finish=mirror texture=textures/a.png,2",
        "add cylinder name=pole radius=0.1 height=3",
        "add ramp name=ramp size=2,1,1 turn=90,0,0",
        "add stairs name=stairs size=2,1,1 steps=5",
        "add arch name=gate size=0.2,3,3 opening=1,2",
        "add model name=car file=models/car.glb scale=2",
        "add light name=lamp at=0,3,0 power=8 colour=#ffeecc",
        "add aberration name=tunnel at=0,1,-20 half=1,1,5 axis=z felt=50 outline=on",
        "add aberration name=soft at=20,1,-20 half=1,1,1 stretch=2,1,2 sides=legacy exit=inverse ways=both",
        "add sign name=sign text=Look! size=2,1",
        "add spawn at=0,0,4 look=0,10",
        "group house wall gate",
        "change house at=0,0,-10",
        "change wall name=front at=0,1,0",
    ] {
        done(&mut it, command);
    }
    let room = it.room();
    assert_eq!(room.objects.len(), 13);
    assert_eq!(room.spawn.at, DVec3::new(0.0, 0.0, 4.0));
    assert_eq!(
        room.find("front").unwrap().1.group.as_deref(),
        Some("house")
    );
    let What::Aberration(tunnel) = room.find("tunnel").unwrap().1.what else {
        panic!()
    };
    assert_eq!(
        tunnel.lengths,
        Lengths::Felt {
            axis: Axis::Z,
            felt_m: 50.0
        }
    );
    assert_eq!(tunnel.sides, Sides::Walls);
    assert!(tunnel.outline);
    assert_eq!(
        read("room.ron", write(room).unwrap().as_bytes()).unwrap(),
        *room
    );
    done(&mut it, "change house name=barn");
    assert_eq!(
        it.room().find("gate").unwrap().1.group.as_deref(),
        Some("barn")
    );
    done(&mut it, "change tunnel felt=70");
    done(&mut it, "change tunnel outline=off");
    let What::Aberration(tunnel) = it.room().find("tunnel").unwrap().1.what else {
        panic!()
    };
    assert!(!tunnel.outline);
    assert!(apply(&mut it, "change tunnel outline=maybe").is_err());
    done(&mut it, "remove barn");
    assert!(it.room().find("gate").is_none() && it.room().find("front").is_none());
}

#[test]
fn what_makes_no_sense_is_refused_and_changes_nothing() {
    let mut it = editor();
    done(
        &mut it,
        "add aberration name=one at=0,1,-20 half=1,1,5 axis=z felt=50",
    );
    let before = it.room().clone();
    for (command, words) in [
        ("", "no command"),
        ("build box", "no command \"build\""),
        ("add", "Say what to add"),
        ("add cube name=a", "no kind \"cube\""),
        ("add box name=a", "say its size"),
        ("add box size=1,1,1", "say its name"),
        ("add box name=a size=1,1", "3 numbers"),
        ("add box name=a size=1,1,x", "no number"),
        ("add box name=a size=1,1,NaN", "no number"),
        (
            "add box name=a size=1,1,0",
            "Size of \"a\" is to be 0.01 to 1000",
        ),
        ("add box name=floor size=1,1,1", "unique"),
        (
            "add box name=a size=1,1,1 radius=2",
            "\"radius\" is no word",
        ),
        ("add box name=a size=1,1,1 size=1,1,1", "said twice"),
        ("add box name=a size=1,1,1 colour=red", "no colour"),
        ("add box name=a size=1,1,1 group=b", "no group of that name"),
        ("add ball name=a radius", "says nothing"),
        ("add model name=a file=../a.glb", "leads out"),
        ("add aberration name=a half=1,1,1", "either axis and felt"),
        ("add aberration name=a half=1,1,1 axis=w felt=2", "x, y, z"),
        (
            "add aberration name=a at=1,1,-20 turn=10,0,0 half=1,1,5 axis=z felt=50",
            "\"one\"",
        ),
        ("change one stretch=2,2,2", "nobody could enter"),
        ("change nothing at=0,0,0", "nothing called \"nothing\""),
        ("remove nothing", "nothing called"),
        ("remove", "one thing"),
        ("group a nothing", "nothing called"),
        ("group one floor", "unique"),
        ("undo 0", "1 to 10000"),
        ("redo", "nothing to redo"),
    ] {
        let said = apply(&mut it, command).unwrap_err();
        assert!(said.contains(words), "{command}: {said}");
        assert!(said.ends_with('.') || said.ends_with("=..."), "{said}");
        assert_eq!(*it.room(), before, "{command}");
    }
    assert_eq!(steps(&it), (1, 0));
}

#[test]
fn steps_are_taken_back_and_made_again() {
    let mut it = editor();
    for number in 0..1200 {
        done(&mut it, &format!("add ball name=ball{number} radius=1"));
    }
    assert_eq!(steps(&it), (1200, 0));
    done(&mut it, "undo 1150");
    assert_eq!(it.room().objects.len(), 51);
    done(&mut it, "undo 500");
    assert_eq!(it.room().objects.len(), 1);
    assert!(
        apply(&mut it, "undo")
            .unwrap_err()
            .contains("nothing to undo")
    );
    done(&mut it, "redo 499");
    done(&mut it, "change ball3 radius=2");
    assert_eq!(steps(&it), (500, 0), "what was undone is gone");
    done(&mut it, "change ball3 radius=2");
    assert_eq!(steps(&it), (500, 0), "what changes nothing is no step");
}

proptest! {
    #[test]
    fn back_and_forth_leads_to_the_same_room(choices in prop::collection::vec((0..6_u8, 0..8_u8), 1..40)) {
        let mut it = editor();
        let mut seen = vec![it.room().clone()];
        for (what, which) in choices {
            let command = match what {
                0 | 1 => format!("add ball name=b{which} radius=1"),
                2 => format!("change b{which} at={which},1,2"),
                3 => format!("remove b{which}"),
                4 => format!("group g{which} b{which}"),
                _ => format!("add spawn at={which},0,0"),
            };
            let before = steps(&it).0;
            let _ = apply(&mut it, &command);
            if steps(&it).0 > before {
                seen.push(it.room().clone());
            }
        }
        for room in seen.iter().rev().skip(1) {
            done(&mut it, "undo");
            prop_assert_eq!(it.room(), room);
        }
        for room in &seen[1..] {
            done(&mut it, "redo");
            prop_assert_eq!(it.room(), room);
        }
    }
}

#[test]
fn a_thing_is_loose_by_its_mass_and_stands_without_one() {
    let mut it = editor();
    done(
        &mut it,
        "add box name=crate at=0,1,-5 size=0.6,0.6,0.6 mass=12",
    );
    let mass = |it: &Document| it.room().find("crate").unwrap().1.mass;
    assert_eq!(mass(&it), Some(12.0));
    let text = write(it.room()).unwrap();
    assert!(text.contains("            mass: 12,\n"), "{text}");
    assert_eq!(read("room.ron", text.as_bytes()).unwrap(), *it.room());
    done(&mut it, "change crate mass=none");
    assert_eq!(mass(&it), None);
    assert!(!write(it.room()).unwrap().contains("mass"));
    done(&mut it, "undo");
    for (command, said) in [
        (
            "change crate mass=0",
            "Mass of \"crate\" is to be 0.1 to 10000 kg, and is 0",
        ),
        ("change crate mass=x", "mass=\"x\" is no number"),
        (
            "change crate size=20,1,1",
            "Size of \"crate\" is to be 0.1 to 10 m along each axis for something loose, and is 20",
        ),
        (
            "add stairs name=s size=1,1,1 steps=3 mass=5",
            "only a box, a ball, a cylinder, a pyramid or a ramp can be loose",
        ),
        (
            "add ball name=b radius=0.01 mass=5",
            "Radius of \"b\" is to be 0.05 to 5 m for something loose, and is 0.01",
        ),
    ] {
        let refusal = apply(&mut it, command).unwrap_err();
        assert!(refusal.contains(said), "{command}: {refusal}");
    }
    for number in 1..100 {
        let command = format!("add ball name=b{number} radius=0.2 mass=1");
        done(&mut it, &command);
    }
    let refusal = apply(&mut it, "add ball name=one radius=0.2 mass=1").unwrap_err();
    assert!(refusal.contains("at most 100 loose things"), "{refusal}");
}

#[test]
fn a_pair_is_built_by_commands_one_after_the_other_and_closed_until_it_fits() {
    let mut it = Document::new(Room::new("Test"));
    let mut done = |command: &str| {
        let words: Vec<&str> = command.split(' ').collect();
        let done = it.command(&words).map_err(|error| error.to_string());
        let open = space_so_far(it.room()).unwrap().1.len();
        (done, open, write(it.room()).is_ok())
    };
    let open = (Ok(()), 2, true);
    let closed = (Ok(()), 0, false);
    assert_eq!(done("add portal name=a at=0,2,-5 size=2,3 to=b"), closed);
    assert_eq!(done("add portal name=b at=9,2,-5 size=2,3 to=a"), open);
    assert_eq!(done("change a size=4,4"), closed);
    assert_eq!(done("change b polygon=-2,-2,2,-2,2,2,-2,2"), open);
    // A partner with another name stays one.
    assert_eq!(done("change b name=c"), open);
    assert_eq!(done("change a sides=2"), closed);
    assert_eq!(done("change c sides=2"), open);
    assert_eq!(done("remove c"), closed);
    assert_eq!(done("undo"), open);
    let (said, ..) = done("add portal name=d at=0,2,-5.0005 size=1,1 to=d");
    assert!(said.unwrap_err().contains("overlap"));
    let (said, ..) = done("add portal name=d at=0,9,-5");
    assert!(said.unwrap_err().contains("its to"));
    let (said, ..) = done("add portal name=d at=0,9,-5 to=d");
    assert!(said.unwrap_err().contains("its size or its polygon"));
}
