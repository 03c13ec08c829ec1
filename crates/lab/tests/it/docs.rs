//! docs/accuracy.md and docs/terrain.md are whole: they answer every question of their templates, and show each plot.

use std::fs;
use std::path::{Path, PathBuf};

use antipode_lab::docs::{ALL, Kind, NOT_MEASURED, plots_in};

fn docs_directory() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs")
}

fn document(kind: &Kind) -> String {
    fs::read_to_string(docs_directory().join(kind.name)).unwrap()
}

#[test]
fn the_documents_are_of_full_runs_and_answer_every_question_of_their_templates() {
    for kind in ALL {
        let text = document(kind);
        assert!(text.contains("- Run: full"), "{}", kind.name);
        assert!(!text.contains(NOT_MEASURED), "{} has a hole", kind.name);
        assert!(!text.contains("{{"), "{} has a hole", kind.name);
    }
}

#[test]
fn the_documents_show_the_plots_that_are_there_and_no_others() {
    for kind in ALL {
        let text = document(kind);
        let plots = plots_in(&docs_directory().join(kind.plots));
        assert!(!plots.is_empty());
        for plot in &plots {
            let file = plot.file_name().unwrap().to_str().unwrap();
            assert!(text.contains(file), "nothing shows {file}");
        }
        let shown = text.matches(&format!("]({}/", kind.plots)).count();
        assert_eq!(shown, plots.len(), "{}", kind.name);
    }
}
