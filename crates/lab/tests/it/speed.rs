//! The variants whose speed is compared must compute the same thing, each within its own error, or a wrong formula
//! would be praised for being quick. Nothing here looks at a clock.

use antipode_lab::speed::{Variant, cpu_section, frontier};
use antipode_lab::{Cell, Effort, Section, Table};

const QUICK: Effort = Effort { quick: true };

fn variant(name: &str, ns: f64, error: f64) -> Variant {
    Variant {
        name: name.to_owned(),
        ns,
        error,
        not_numbers: 0,
        used: "",
    }
}

#[test]
fn the_frontier_is_who_nobody_beats_in_both() {
    let quick = variant("quick and rough", 1.0, 1e-2);
    let middle = variant("slower, truer", 5.0, 1e-5);
    let worse = variant("slower than that and no truer", 6.0, 1e-5);
    let rougher = variant("as quick and rougher", 5.0, 1e-4);
    let best = variant("slow and true", 50.0, 1e-9);
    let broken = Variant {
        not_numbers: 1,
        ..variant("quick, true, and once no number", 2.0, 0.0)
    };
    let close = variant("within what timing can tell", 5.1, 1e-5);
    let all = [quick, middle, worse, rougher, best, broken, close];
    assert_eq!(
        frontier(&all),
        [true, true, false, false, true, false, true]
    );
}

#[test]
fn one_who_fails_is_on_the_frontier_only_by_being_the_quickest() {
    let failing = Variant {
        not_numbers: 3,
        ..variant("quickest, fails", 1.0, 0.0)
    };
    assert_eq!(
        frontier(&[failing.clone(), variant("works", 2.0, 1.0)]),
        [true, true]
    );
    assert_eq!(
        frontier(&[failing, variant("works and is quicker", 0.5, 1.0)]),
        [false, true]
    );
    assert!(frontier(&[]).is_empty());
}

fn figure(cell: &Cell) -> f64 {
    match cell {
        Cell::Figure(value, _) => *value,
        other => panic!("{other:?} is no figure"),
    }
}

fn words(cell: &Cell) -> &str {
    match cell {
        Cell::Text(words) => words,
        other => panic!("{other:?} are no words"),
    }
}

fn table<'a>(section: &'a Section, title: &str) -> &'a Table {
    let mut found = section.tables.iter().filter(|t| t.title.starts_with(title));
    let table = found
        .next()
        .unwrap_or_else(|| panic!("no table \"{title}\""));
    assert!(found.next().is_none(), "two tables \"{title}\"");
    table
}

fn row<'a>(table: &'a Table, name: &str) -> &'a [Cell] {
    let found = table.rows.iter().find(|row| words(&row[0]) == name);
    found.unwrap_or_else(|| panic!("no \"{name}\" in \"{}\"", table.title))
}

/// Beginning of a table's title, a variant, and the most it may be wrong by.
const BOUNDS: [(&str, &str, f64); 32] = [
    (
        "Port of one vertex by the exponential",
        "textbook: p sinh(d)/d, library, f32",
        5.0,
    ),
    ("Port of one vertex by the exponential", "series, f32", 4.0),
    (
        "Port of one vertex by the exponential",
        "f64, then rounded",
        0.5001,
    ),
    (
        "Port of one vertex by the raised",
        "textbook: port then boost, library, f32",
        2e-5,
    ),
    (
        "Port of one vertex by the raised",
        "port then boost, series, f32",
        2e-5,
    ),
    (
        "Port of one vertex by the raised",
        "closed form, library, f32",
        2e-6,
    ),
    (
        "Port of one vertex by the raised",
        "closed form, series, f32",
        5e-7,
    ),
    (
        "Port of one vertex by the raised",
        "port then boost, f64, then rounded",
        1e-6,
    ),
    (
        "Port of one vertex by the raised",
        "closed form, f64, then rounded",
        1e-7,
    ),
    (
        "Port of one vertex by the raised",
        "one frame an object, the map's differential",
        5e-3,
    ),
    (
        "Port of one vertex by the horizon",
        "closed form, library, f32",
        5e-7,
    ),
    (
        "Port of one vertex by the horizon",
        "closed form, series, f32",
        5e-7,
    ),
    (
        "Port of one vertex by the horizon",
        "one frame an object, the map's differential",
        1e-2,
    ),
    (
        "Port of one vertex by the sphere",
        "closed form, library, f32",
        4e-6,
    ),
    (
        "Port of one vertex by the sphere",
        "closed form, series, f32",
        4e-6,
    ),
    (
        "Port of one vertex by the sphere",
        "one frame an object, the map's differential",
        5e-3,
    ),
    (
        "Brightness of one vertex in hyperbolic",
        "exact: inverse transpose, series, f32",
        1e-6,
    ),
    (
        "Brightness of one vertex in hyperbolic",
        "exact four-vector, own length",
        1e-3,
    ),
    (
        "Brightness of one vertex on the sphere",
        "exact: inverse transpose, series, f32",
        1e-6,
    ),
    (
        "View of one vertex",
        "camera taken off first, then port, f32",
        2e-7,
    ),
    (
        "View of one vertex",
        "hyperboloid coordinates kept, view matrix, f64",
        1e-9,
    ),
    (
        "Distance of two points in hyperbolic",
        "asinh of the chord, library, f32",
        1e-6,
    ),
    (
        "Distance of two points in hyperbolic",
        "asinh of the chord, series, f32",
        1e-6,
    ),
    (
        "Distance of two points in hyperbolic",
        "asinh of the chord, f64",
        1e-14,
    ),
    (
        "Distance of two points in hyperbolic",
        "acosh of the inner product, f64",
        1e-10,
    ),
    (
        "Distance of two points on the sphere",
        "atan2 of the chords, library, f32",
        5e-7,
    ),
    (
        "Distance of two points on the sphere",
        "atan2 of the chords, series, f32",
        5e-7,
    ),
    (
        "Distance of two points on the sphere",
        "atan2 of the chords, f64",
        1e-14,
    ),
    (
        "Translation matrix on the sphere",
        "from half the angle, series, f32",
        5e-6,
    ),
    (
        "Translation matrix on the sphere",
        "from half the angle, library, f32",
        5e-6,
    ),
    (
        "Translation matrix in hyperbolic",
        "textbook: by 1/(1 + w), library, f32",
        5e-5,
    ),
    (
        "Translation matrix in hyperbolic",
        "from half the angle, series, f32",
        5e-5,
    ),
];

#[test]
fn every_variant_keeps_to_its_error_and_the_textbook_shows_its_own() {
    let section = cpu_section(QUICK);
    for (title, name, most) in BOUNDS {
        let row = row(table(&section, title), name);
        let error = figure(&row[3]);
        assert!(error <= most, "{title}, {name}: {error:e} over {most:e}");
    }
    // What the textbook gets wrong has to be found wrong.
    let not_numbers = |title: &str, name: &str| figure(&row(table(&section, title), name)[4]);
    assert_eq!(
        not_numbers(
            "Port of one vertex by the exp",
            "textbook: p sinh(d)/d, library, f32"
        ),
        1.0
    );
    assert!(
        not_numbers(
            "Distance of two points in",
            "acosh of the inner product, f32"
        ) > 0.0
    );
    assert!(
        not_numbers(
            "Translation matrix on",
            "textbook: by 1/(1 + w), library, f32"
        ) > 0.0
    );
    let error = |title: &str, name: &str| figure(&row(table(&section, title), name)[3]);
    assert!(
        error(
            "View of one vertex",
            "hyperboloid coordinates kept, view matrix, f32"
        ) > 1e-3
    );
    assert!(error("Brightness of one vertex in", "carried like a direction") > 0.1);
    assert!(
        error(
            "Brightness of one vertex in",
            "exact four-vector, flat length"
        ) > 0.5
    );
    assert!(error("Brightness of one vertex on", "carried like a direction") > 0.1);
    for space in ["on the sphere", "in hyperbolic space"] {
        let title = format!("One of 10000 camera moves {space}");
        assert!(error(&title, "never made orthonormal") > 1e-5);
        assert!(error(&title, "made orthonormal each step") < 1e-6);
    }
}

#[test]
fn what_the_game_uses_is_never_not_a_number_and_leaves_no_chunk_out() {
    let section = cpu_section(QUICK);
    let mut used = 0;
    for table in section
        .tables
        .iter()
        .filter(|t| t.columns.last().is_some_and(|c| c == "in the game"))
    {
        for row in table.rows.iter().filter(|row| !words(&row[6]).is_empty()) {
            used += 1;
            assert_eq!(figure(&row[4]), 0.0, "{}: {}", table.title, words(&row[0]));
        }
    }
    assert!(used >= 20, "only {used}");
    let culling = table(&section, "Culling");
    let flat = culling
        .rows
        .iter()
        .filter(|row| words(&row[1]).starts_with("flat frustum"));
    for row in flat {
        assert!(
            figure(&row[3]) > 0.1,
            "{}: the flat frustum culls rightly",
            words(&row[0])
        );
    }
    assert!(section.passed());
}

#[test]
fn a_frame_for_an_object_errs_with_the_square_of_its_size() {
    let section = cpu_section(QUICK);
    let frames = table(&section, "One frame for an object");
    let error = |map: &str, edge: f64, away: f64| {
        let at = |row: &&Vec<Cell>| {
            words(&row[0]) == map && figure(&row[1]) == edge && figure(&row[2]) == away
        };
        figure(&frames.rows.iter().find(at).expect("a row")[3])
    };
    for map in ["raised", "horizon", "sphere"] {
        let ratio = error(map, 1.0, 20.0) / error(map, 0.25, 20.0);
        assert!((12.0..20.0).contains(&ratio), "{map}: {ratio}");
        assert!(error(map, 1.0, 40.0) < error(map, 1.0, 10.0), "{map}");
    }
}

/// A section without what a clock has a say in.
fn timeless(section: &Section) -> Vec<Vec<Vec<Cell>>> {
    let by_clock = ["time", "to the game's", "frontier", "time per chunk"];
    let kept = |table: &Table| -> Vec<usize> {
        (0..table.columns.len())
            .filter(|&i| !by_clock.contains(&table.columns[i].as_str()))
            .collect()
    };
    let rows = |table: &Table| {
        let kept = kept(table);
        table
            .rows
            .iter()
            .map(|row| kept.iter().map(|&i| row[i].clone()).collect())
            .collect()
    };
    section.tables.iter().map(rows).collect()
}

#[test]
fn two_runs_find_the_same_errors() {
    assert_eq!(timeless(&cpu_section(QUICK)), timeless(&cpu_section(QUICK)));
}
