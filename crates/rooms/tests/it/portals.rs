//! Portals in files and in commands.

use antipode_rooms::{Room, read, write};

/// A room of these portals, one a line from line 2 on: name and what else the object says.
fn room(portals: &[(&str, &str)]) -> Result<Room, String> {
    let line = |(name, rest): &(&str, &str)| format!("(name: \"{name}\", {rest}),\n");
    let objects: String = portals.iter().map(line).collect();
    let text = format!("(version: 1, name: \"portals\", objects: [\n{objects}])");
    read("room.ron", text.as_bytes()).map_err(|error| error.to_string())
}

const ONE: &str = "at: (0, 1, 0), what: Portal(size: (2, 2), to: \"other\")";
const OTHER: &str = "at: (9, 1, 0), what: Portal(size: (2, 2), to: \"one\")";

#[test]
fn what_is_wrong_with_a_portal_is_told_with_line_and_field() {
    assert_eq!(room(&[("one", ONE), ("other", OTHER)]).err(), None);
    let soft = "what: Aberration(half: (1, 1, 1), stretch: (2, 2, 2), sides: Soft)";
    let cases: &[(&str, &str, &str, &[&str])] = &[
        ("one\"", "nobody\"", "3: to of \"other\"", &["its partner"]),
        (
            "one\"",
            "other\"",
            "2: to of \"one\"",
            &["\"other\"", "lead back"],
        ),
        (
            "(2, 2)",
            "(2, 3)",
            "2: size of \"one\"",
            &["\"other\"", "similar"],
        ),
        ("(2, 2)", "(80, 80)", "2: size of \"one\"", &["32 times"]),
        (
            "(9, 1, 0)",
            "(0, 2, 0)",
            "3: at of \"other\"",
            &["\"one\"", "overlap"],
        ),
        (
            "one\")",
            "one\", sides: 2)",
            "2: sides of \"one\"",
            &["\"other\""],
        ),
        (
            "one\")",
            "one\", sides: 3)",
            "3: sides of \"other\"",
            &["1 or 2"],
        ),
        (
            "size: (2, 2)",
            "polygon: [(0, 0), (1, 0)]",
            "3: polygon of \"other\"",
            &["3 to 16"],
        ),
        (
            "size: (2, 2)",
            "polygon: [(0, 0), (2, 0), (0.5, 0.5), (0, 2)]",
            "3: polygon of \"other\"",
            &["convex"],
        ),
        ("size: (2, 2), ", "", "3: ", &["either size or polygon"]),
    ];
    for (old, new, told, names) in cases {
        assert_eq!(OTHER.matches(old).count(), 1, "{old}");
        let said = room(&[("one", ONE), ("other", &OTHER.replace(old, new))]).unwrap_err();
        assert!(
            said.starts_with(&format!("room.ron:{told}")),
            "{new}: {said}"
        );
        for name in *names {
            assert!(said.contains(name), "{new}: {said}");
        }
        assert!(!said.contains('\n') && said.ends_with('.'), "{said}");
    }
    let said = room(&[("one", ONE), ("other", OTHER), ("box", soft)]).unwrap_err();
    assert!(said.starts_with("room.ron:2: at of \"one\""), "{said}");
    assert!(said.contains("side of the aberration \"box\""), "{said}");
}

#[test]
fn a_pair_is_written_as_it_is_read() {
    let mirrored =
        "turn: (90, 0, 10), what: Portal(polygon: [(0, 0), (2, 0), (0, 1)], to: \"b\", sides: 2)";
    let image =
        "at: (9, 1, 0), what: Portal(polygon: [(0, 0), (0, 2), (-4, 0)], to: \"a\", sides: 2)";
    let made = room(&[("a", mirrored), ("b", image)]).unwrap();
    let text = write(&made).unwrap();
    assert!(
        text.contains("Portal(polygon: [(0, 0), (2, 0), (0, 1)], to: \"b\", sides: 2)"),
        "{text}"
    );
    assert_eq!(read("room.ron", text.as_bytes()).unwrap(), made);
}
