//! The quick accuracy run passes on a software adapter, and says so loudly where there is none.

use std::collections::HashSet;

use antipode_lab::accuracy::{Bench, SUITES};
use antipode_lab::{Cell, Effort, Report, Section};
use antipode_render::AdapterChoice;

const QUICK: Effort = Effort { quick: true };

fn bench() -> Option<Bench> {
    let opened = Bench::open(QUICK, Some(AdapterChoice::Auto));
    antipode_testing::needed("a graphics adapter", opened)
}

fn run(bench: &Bench) -> Report {
    let sections = SUITES.iter().map(|suite| suite.run(bench).unwrap());
    Report {
        made_on: vec![],
        sections: sections.collect(),
    }
}

fn arithmetics(section: &Section) -> HashSet<&str> {
    let cells = section
        .tables
        .iter()
        .flat_map(|table| table.rows.iter().flatten());
    cells
        .filter_map(|cell| match cell {
            Cell::Text(words) => Some(words.as_str()),
            _ => None,
        })
        .filter(|words| words.starts_with("CPU f") || *words == "GPU")
        .collect()
}

#[test]
fn every_bar_is_met_on_the_adapter() {
    let Some(bench) = bench() else { return };
    let report = run(&bench);
    assert_eq!(report.failures(), Vec::<String>::new());
    let all: HashSet<&str> = report.sections.iter().flat_map(arithmetics).collect();
    for arithmetic in ["CPU f32", "CPU f64", "GPU"] {
        assert!(all.contains(arithmetic), "{arithmetic} was not measured");
    }
}

#[test]
fn without_an_adapter_the_rows_say_so_and_have_no_verdict() {
    let bench = Bench::open(QUICK, None).unwrap();
    let mut rows = 0;
    for section in run(&bench).sections {
        for row in section.tables.iter().flat_map(|table| &table.rows) {
            if row.contains(&Cell::Text("GPU".into())) {
                rows += 1;
                assert!(row.contains(&Cell::Text("NOT RUN".into())), "{row:?}");
                assert!(
                    !row.iter().any(|cell| matches!(cell, Cell::Verdict(_))),
                    "{row:?}"
                );
            }
        }
    }
    assert!(rows > 20, "{rows}");
}

#[test]
fn a_second_run_finds_the_same_figures() {
    let bench = Bench::open(QUICK, None).unwrap();
    assert_eq!(run(&bench), run(&bench));
}
