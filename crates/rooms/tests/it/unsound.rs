//! Files that are not sound, each told with its line and field.

use antipode_rooms::{RoomError, read};

const SOUND: &str = r##"(
    version: 1,
    name: "Test",
    sentence: "Nothing is strange here.",
    gravity: (0, -9.81, 0),
    sky: (colour: "#8fb7e6", light: 0.35),
    sun: (aim: (-60, 50), power: 1),
    fog: (colour: "#ffffff", reach: 300),
    spawn: (at: (0, 0, 0), look: (-90, 0)),
    objects: [
        (name: "floor", at: (0, -0.5, 0), what: Box(size: (200, 1, 200))),
        (
            name: "wall",
            at: (1, 2, 3),
            turn: (45, 0, 0),
            what: Arch(size: (1, 3, 3), opening: (1, 2)),
            surface: (
                colour: "#c04030",
                checker: (colour: "#ffffff", size: 0.5),
                texture: (file: "textures/brick.png", size: 2),
            ),
            group: "house",
        ),
        (name: "house", what: Group),
        (name: "lamp", at: (0, 3, 0), what: Light(power: 8)),
        (
            name: "tunnel",
            at: (0, 2, -20),
            what: Aberration(
                half: (1, 2, 5),
                axis: Z,
                felt: 50,
                sides: Walls,
            ),
        ),
        (
            name: "second",
            at: (0, 2, -40),
            turn: (30, 0, 0),
            what: Aberration(half: (1, 1, 1), stretch: (2, 2, 2), sides: Soft),
        ),
        (name: "steps", what: Stairs(size: (2, 1, 1), steps: 5)),
        (name: "car", what: Model(file: "models/car.glb")),
        (name: "board", what: Sign(text: "Mind the step.")),
    ],
)
"##;

fn refusal(text: &str) -> String {
    read("room.ron", text.as_bytes()).unwrap_err().to_string()
}

#[test]
fn what_is_not_sound_is_told_with_its_line_and_field() {
    assert!(
        read("room.ron", SOUND.as_bytes()).is_ok(),
        "{}",
        refusal(SOUND)
    );
    // What is written in place of what, the line, and what the sentence has to name.
    let cases: &[(&str, &str, usize, &[&str])] = &[
        ("version: 1", "version: 0", 2, &["version is 0"]),
        (
            "name: \"Test\"",
            "name: \"  \"",
            3,
            &["name ", "one character"],
        ),
        (
            "Nothing is",
            "Nothing\\u{202e} is",
            4,
            &["sentence", "202e"],
        ),
        ("-9.81, 0),", "-9810, 0),", 5, &["gravity", "-9810"]),
        ("-9.81, 0),", "NaN, 0),", 5, &["gravity", "NaN"]),
        ("light: 0.35", "light: -1", 6, &["sky.light", "-1"]),
        ("\"#8fb7e6\"", "\"blue\"", 6, &["sky", "#c04030"]),
        ("aim: (-60, 50)", "aim: (-60, 91)", 7, &["sun.aim", "pitch"]),
        ("reach: 300", "reach: 0.1", 8, &["fog.reach"]),
        (
            "at: (0, 0, 0)",
            "at: (0, 0, 1e9)",
            9,
            &["spawn.at", "1000000000"],
        ),
        (
            "(200, 1, 200)",
            "(200, 0, 200)",
            11,
            &["size of \"floor\"", "0.01 to 1000 m"],
        ),
        ("\"wall\"", "\"floor\"", 13, &["name of object 2", "unique"]),
        ("\"wall\"", "\"wall=1\"", 13, &["name of object 2", "'='"]),
        ("(1, 2, 3)", "(1, inf, 3)", 14, &["at of \"wall\"", "inf"]),
        (
            "turn: (45,",
            "turn: (4500,",
            15,
            &["turn of \"wall\"", "degrees"],
        ),
        (
            "opening: (1, 2)",
            "opening: (4, 2)",
            16,
            &["opening of \"wall\"", "less wide"],
        ),
        ("size: 0.5", "size: -0.5", 19, &["size of \"wall\""]),
        (
            "textures/brick.png",
            "textures/../../brick.png",
            20,
            &["file of \"wall\"", "leads out"],
        ),
        (
            "textures/brick.png",
            "/etc/brick.png",
            20,
            &["file of \"wall\"", "leads out"],
        ),
        (
            "group: \"house\"",
            "group: \"barn\"",
            22,
            &["group of \"wall\"", "barn"],
        ),
        (
            "\"house\", what: Group",
            "\"house\", group: \"house\", what: Group",
            24,
            &["group of \"house\"", "itself"],
        ),
        ("power: 8", "power: 1e6", 25, &["power of \"lamp\""]),
        (
            "half: (1, 2, 5)",
            "half: (1, 0, 5)",
            30,
            &["half of \"tunnel\""],
        ),
        ("felt: 50", "felt: 5000", 32, &["felt of \"tunnel\"", "320"]),
        (
            "axis: Z,\n",
            "\n",
            34,
            &["either axis and felt, or stretch"],
        ),
        ("sides: Walls", "sides: Wals", 33, &["what.sides", "Wals"]),
        (
            "at: (0, 2, -40)",
            "at: (0, 2, -24)",
            38,
            &["at of \"second\"", "\"tunnel\"", "parallel"],
        ),
        (
            "(2, 2, 2)",
            "(2, 2, 40)",
            40,
            &["stretch of \"second\"", "1/32 to 32"],
        ),
        (
            "(2, 2, 2), sides: Soft",
            "(2, 2, 2), sides: Walls",
            40,
            &["sides of \"second\"", "enter"],
        ),
        ("steps: 5", "steps: 0", 42, &["steps of \"steps\""]),
        ("steps: 5", "steps: 5, size: (1, 1, 1)", 42, &["size"]),
        (
            "models/car.glb",
            "models/car.exe",
            43,
            &["file of \"car\"", "glb"],
        ),
        ("text: \"Mind", "words: \"Mind", 44, &["words"]),
    ];
    for (old, new, line, names) in cases {
        assert_eq!(SOUND.matches(old).count(), 1, "{old}");
        let said = refusal(&SOUND.replace(old, new));
        assert!(
            said.starts_with(&format!("room.ron:{line}: ")),
            "{new}: {said}"
        );
        for name in *names {
            assert!(said.contains(name), "{new}: {said}");
        }
        assert!(!said.contains('\n') && said.ends_with('.'), "{said}");
    }
}

#[test]
fn what_a_newer_game_has_written_is_told_before_its_riddles() {
    let text = SOUND
        .replace("version: 1", "version: 2")
        .replace("gravity", "gravities");
    let said = refusal(&text);
    assert!(
        said.starts_with("room.ron:2: version 2 is of a newer version"),
        "{said}"
    );
}

#[test]
fn what_is_no_text_or_too_long_is_refused() {
    let read = |bytes: &[u8]| read("room.ron", bytes).unwrap_err().to_string();
    assert!(read(b"").starts_with("room.ron:1: "));
    let said = read(b"(\nversion: 1,\n\xff)");
    assert!(
        said.starts_with("room.ron:3: the file is not text"),
        "{said}"
    );
    let said = read(&vec![b' '; 3 << 20]);
    assert!(said.contains("3145728 bytes"), "{said}");
    let long = format!("(version: 1, {}: 1)", "name".repeat(9999));
    assert!(
        read(long.as_bytes()).len() < 700,
        "a name that nobody knows"
    );
    let deep = format!("(version: 1, name: {}", "(".repeat(100_000));
    assert!(read(deep.as_bytes()).starts_with("room.ron:1: "));
}

#[test]
fn counts_have_bounds() {
    let many = |what: &str, count: usize| {
        let object = |it: usize| {
            format!(
                "(name: \"a{it}\", at: ({}, 0, 0), what: {what}),\n",
                it % 900
            )
        };
        let objects = (0..count).map(object).collect::<Vec<_>>().concat();
        read(
            "room.ron",
            format!("(version: 1, name: \"many\", objects: [\n{objects}])").as_bytes(),
        )
    };
    assert!(many("Ball(radius: 1)", 2000).is_ok());
    let said = many("Ball(radius: 1)", 2001).unwrap_err().to_string();
    assert!(said.starts_with("room.ron:1: objects has 2001"), "{said}");
    assert!(many("Light(power: 1)", 8).is_ok());
    let said = many("Light(power: 1)", 9).unwrap_err().to_string();
    assert!(
        said.starts_with("room.ron:10: what of \"a8\"") && said.contains("at most 8 lights"),
        "{said}"
    );
    let small = "Aberration(half: (0.1, 1, 1), axis: Y, felt: 4)";
    assert!(many(small, 256).is_ok());
    let said = many(small, 257).unwrap_err().to_string();
    assert!(said.contains("at most 256 aberrations"), "{said}");
    let said = many("Aberration(half: (4.5, 1, 1), axis: Y, felt: 4)", 256)
        .unwrap_err()
        .to_string();
    assert!(said.contains("lie in one another"), "{said}");
}

#[test]
fn the_field_is_told_for_a_program_too() {
    let error = read(
        "x/room.ron",
        SOUND.replace("felt: 50", "felt: -1").as_bytes(),
    )
    .unwrap_err();
    let RoomError::Text { file, line, fault } = error else {
        panic!("{error}")
    };
    assert_eq!(
        (file.as_str(), line, fault.path.as_str()),
        ("x/room.ron", 32, "objects[4].what.felt")
    );
}

#[test]
fn what_the_description_shows_is_sound() {
    let text = include_str!("../../../../docs/rooms.md");
    let room = text
        .split("```ron\n")
        .nth(1)
        .and_then(|it| it.split("```").next())
        .unwrap();
    let room = read("room.ron", room.as_bytes()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(room.objects.len(), 3);
}
