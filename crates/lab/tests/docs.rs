//! docs/accuracy.md is what the generator makes from the committed measurements, byte for byte.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

use antipode_lab::{Report, docs};

fn docs_directory() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs")
}

const REMAKE: &str = "remake it: antipode lab docs --json docs/measurements/lab.json --docs docs";

#[test]
fn the_document_and_its_plots_are_made_from_the_committed_measurements() {
    let directory = docs_directory();
    let report = Report::read(&directory.join("measurements/lab.json")).unwrap();
    let made = docs::document(&report).unwrap();
    let text = fs::read_to_string(directory.join(docs::NAME)).unwrap();
    assert!(text == made.text, "docs/accuracy.md is stale; {REMAKE}");
    let folder = directory.join(docs::PLOTS);
    for (name, plot) in &made.plots {
        let file = fs::read_to_string(folder.join(name)).unwrap_or_default();
        assert!(file == *plot, "docs/accuracy/{name} is stale; {REMAKE}");
    }
    let extra = docs::plots_in(&folder).len();
    assert_eq!(
        extra,
        made.plots.len(),
        "plots that nothing shows; {REMAKE}"
    );
}

#[test]
fn the_committed_measurements_are_full_ones_and_answer_every_question_of_the_template() {
    let report = Report::read(&docs_directory().join("measurements/lab.json")).unwrap();
    assert!(report.made_on.contains(&("Run".into(), "full".into())));
    let text = docs::document(&report).unwrap().text;
    assert!(!text.contains(docs::NOT_MEASURED), "a hole is not filled");
}
