//! A quick run of what is measured of a graphics card, on a software adapter: every section is there with figures that are
//! numbers, and what is missing is said wherever somebody looks.

use std::path::{Path, PathBuf};

use antipode_lab::gpu::{self, News, Outcome, Plan};
use antipode_lab::{Cell, Effort, Report, Section, html};
use antipode_render::{AdapterChoice, Gpu};
use antipode_testing::{needed, skipped};

/// In the order of the report.
const SECTIONS: [&str; 6] = [
    "gpu-missing",
    "gpu-short",
    "gpu-cost",
    "gpu-frames",
    "gpu-pictures",
    "accuracy-functions",
];

fn plan(adapter: AdapterChoice) -> Plan {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests");
    Plan {
        effort: Effort { quick: true },
        adapter,
        game: PathBuf::from("/nowhere/antipode"),
        scenes: tests.join("scenes"),
    }
}

/// The outcome, and what was warned of on the way.
fn run(adapter: AdapterChoice) -> (Outcome, Vec<String>) {
    let mut warned = Vec::new();
    let outcome = gpu::run(&plan(adapter), &mut |news| {
        if let News::Warning(words) = news {
            warned.push(words.to_owned());
        }
        Ok(())
    });
    (outcome.unwrap(), warned)
}

/// The figures of the first table of a section, without its column of words.
fn figures(section: &Section) -> Vec<Vec<f64>> {
    let figure = |cell: &Cell| match cell {
        Cell::Figure(value, _) => Some(*value),
        _ => None,
    };
    let rows = section.tables[0].rows.iter();
    rows.map(|row| row.iter().filter_map(figure).collect())
        .collect()
}

fn all_finite(section: &Section) -> bool {
    let rows = section.tables.iter().flat_map(|table| &table.rows);
    let mut cells = rows.flatten();
    cells.all(|cell| !matches!(cell, Cell::Figure(value, _) if !value.is_finite()))
}

#[test]
fn a_quick_run_has_every_section_and_says_what_is_missing() {
    let adapter = Gpu::headless(AdapterChoice::Software);
    if needed("a software adapter", adapter).is_none() {
        return;
    }
    let (Outcome { report, lacks }, warned) = run(AdapterChoice::Software);
    let ids: Vec<&str> = report.sections.iter().map(|it| it.id.as_str()).collect();
    assert_eq!(ids, SECTIONS);
    assert!(report.sections.iter().all(all_finite));
    let of = |id: &str| report.sections.iter().find(|it| it.id == id).unwrap();
    // Three spaces: triangles, pixels and a view with their errors, how far frames stray, and rounds.
    let costs = figures(of("gpu-cost"));
    assert_eq!(costs.iter().map(Vec::len).collect::<Vec<_>>(), [9; 3]);
    // Three sizes each, p50 to p99 in order by both clocks, triangles and frames.
    let frames = figures(of("gpu-frames"));
    assert_eq!(frames.len(), 9);
    for row in &frames {
        assert!(row[0] > 0.0 && row[..3].is_sorted() && row[3..6].is_sorted());
        assert!(
            row[0] <= row[3] && row[6] > 1000.0 && row[7] >= 3.0,
            "{row:?}"
        );
    }
    assert!(of("accuracy-functions").tables[0].rows.len() > 15);
    // The game is missing, and software draws: on the page, in the JSON and to whoever listens.
    let [page, json] = [html::page(&report), report.to_json().unwrap()];
    for words in ["there is no game at /nowhere/antipode", "SOFTWARE: "] {
        assert!(warned.iter().any(|it| it.contains(words)), "{warned:?}");
        assert!(page.contains(words) && json.contains(words), "{words}");
    }
    assert!(
        lacks.len() == 1 && lacks[0].contains("--game FILE"),
        "{lacks:?}"
    );
    assert_eq!(serde_json::from_str::<Report>(&json).unwrap(), report);
}

#[test]
fn without_a_card_the_report_says_so_and_nothing_takes_its_place() {
    if Gpu::headless(AdapterChoice::Gpu).is_ok() {
        skipped("there is a graphics card here");
        return;
    }
    let (Outcome { report, lacks }, warned) = run(AdapterChoice::Gpu);
    assert_eq!(warned, lacks);
    assert!(lacks[0].starts_with("Nothing was measured. No graphics card was found"));
    let ids: Vec<&str> = report.sections.iter().map(|it| it.id.as_str()).collect();
    assert_eq!(ids, ["gpu-missing"]);
    assert!(html::page(&report).contains("No graphics card was found"));
    let adapter = report.made_on.iter().find(|(name, _)| name == "Adapter");
    assert!(adapter.is_some_and(|(_, value)| value.starts_with("none")));
}
