//! docs/accuracy.md and docs/terrain.md are what the generator makes from the committed measurements, byte for byte.

use std::fs;
use std::path::{Path, PathBuf};

use antipode_lab::Report;
use antipode_lab::docs::{ACCURACY, Kind, NOT_MEASURED, TERRAIN, plots_in};

/// Each document and the measurements that it is made from.
const DOCUMENTS: [(&Kind, &str); 2] = [(&ACCURACY, "lab.json"), (&TERRAIN, "terrain.json")];

fn docs_directory() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs")
}

fn measured(json: &str) -> Report {
    Report::read(&docs_directory().join("measurements").join(json)).unwrap()
}

#[test]
fn the_documents_and_their_plots_are_made_from_the_committed_measurements() {
    for (kind, json) in DOCUMENTS {
        let remake =
            format!("remake it: antipode lab docs --json docs/measurements/{json} --docs docs");
        let made = kind.document(&measured(json)).unwrap();
        let name = kind.name;
        let text = fs::read_to_string(docs_directory().join(name)).unwrap();
        assert!(text == made.text, "docs/{name} is stale; {remake}");
        let folder = docs_directory().join(kind.plots);
        for (plot, svg) in &made.plots {
            let file = fs::read_to_string(folder.join(plot)).unwrap_or_default();
            assert!(file == *svg, "{plot} of docs/{name} is stale; {remake}");
        }
        let extra = plots_in(&folder).len();
        assert_eq!(
            extra,
            made.plots.len(),
            "plots that nothing shows; {remake}"
        );
    }
}

#[test]
fn the_committed_measurements_are_full_ones_and_answer_every_question_of_the_templates() {
    for (kind, json) in DOCUMENTS {
        let report = measured(json);
        assert!(report.made_on.contains(&("Run".into(), "full".into())));
        let text = kind.document(&report).unwrap().text;
        assert!(
            !text.contains(NOT_MEASURED),
            "a hole of {} is not filled",
            kind.name
        );
    }
}

#[test]
fn the_log_of_the_flight_has_every_frame_of_two_kilometres() {
    let log = docs_directory().join("measurements/terrain-flight.csv");
    let text = fs::read_to_string(log).unwrap();
    let flown: Vec<f64> = text
        .lines()
        .skip(1)
        .filter_map(|line| line.split(',').nth(2)?.parse().ok())
        .collect();
    assert_eq!(flown.len(), text.lines().count() - 1);
    assert!(*flown.last().unwrap() >= 2000.0);
    assert!(flown.is_sorted());
}
