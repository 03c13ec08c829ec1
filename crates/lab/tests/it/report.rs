//! Reports as others see them: JSON that reads back, a page that needs nothing else, verdicts that count.

use antipode_lab::{Axis, Cell, Picture, Plot, Report, Scale, Section, Series, Table, html};

fn report(met: bool) -> Report {
    let axis = |label: &str, scale| Axis {
        label: label.into(),
        scale,
    };
    let table = |title: &str| Table {
        title: title.into(),
        columns: ["What", "Worst", "Passed", "Note"]
            .map(str::to_owned)
            .into(),
        rows: vec![vec![
            Cell::Text("<script>alert(1)</script>".into()),
            Cell::Figure(0.1 + 0.2, "ulp".into()),
            Cell::Verdict(met),
            Cell::Empty,
        ]],
    };
    Report {
        made_on: vec![("Adapter".into(), "\"software\" & more".into())],
        sections: vec![Section {
            id: "accuracy-port".into(),
            title: "The port".into(),
            method: vec!["Measured with care.".into()],
            tables: vec![table("First table"), table("Second table")],
            plots: vec![Plot {
                id: "p".into(),
                title: "Error against distance".into(),
                x: axis("d", Scale::Logarithmic),
                y: axis("error", Scale::Linear),
                series: vec![Series {
                    name: "ours".into(),
                    points: vec![(1e-8, 1.0 / 3.0), (1e3, -5e-324)],
                    joined: true,
                }],
            }],
            pictures: vec![],
        }],
    }
}

#[test]
fn a_report_reads_back_as_it_was_written() {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("deep/down/report.json");
    report(true).write_json(&file).unwrap();
    assert_eq!(Report::read(&file).unwrap(), report(true));
}

#[test]
fn what_is_no_report_is_refused_in_a_sentence_that_names_the_file() {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("not.json");
    std::fs::write(&file, "[]").unwrap();
    let words = Report::read(&file).unwrap_err().to_string();
    assert!(
        words.contains("not.json") && words.contains("lab all --json"),
        "{words}"
    );
    let words = Report::read(&directory.path().join("none"))
        .unwrap_err()
        .to_string();
    assert!(words.contains("none cannot be read"), "{words}");
    // A file stands where the directory would have to be.
    let words = report(true).write_page(&file).unwrap_err().to_string();
    assert!(words.contains("cannot be written"), "{words}");
}

#[test]
fn the_page_has_every_table_and_needs_nothing_else() {
    let page = html::page(&report(true));
    for title in ["First table", "Second table", "Error against distance"] {
        assert!(page.contains(title), "{title}");
    }
    assert_eq!(page.matches("<table>").count(), 2);
    assert_eq!(page.matches("<svg").count(), 1);
    for outside in ["<script", "<link", "<img", "src=", "@import", "url("] {
        assert!(!page.contains(outside), "{outside}");
    }
    // The only address is the name of SVG's own namespace, which nothing is fetched from.
    let addresses = page.matches("://").count();
    assert_eq!(
        addresses,
        page.matches("xmlns=\"http://www.w3.org/2000/svg\"").count()
    );
    assert!(page.contains("&quot;software&quot; &amp; more"));
    assert!(page.contains("prefers-color-scheme: dark"));
}

#[test]
fn pictures_are_in_the_page_itself_and_read_back() {
    let mut shown = report(true);
    shown.sections[0].pictures.push(Picture {
        title: "Day & night".into(),
        png: "iVBORw0KGgo=".into(),
    });
    let page = html::page(&shown);
    assert!(page.contains("<img src=\"data:image/png;base64,iVBORw0KGgo=\""));
    assert!(page.contains("alt=\"Day &amp; night\""), "{page}");
    let json = shown.to_json().unwrap();
    assert_eq!(serde_json::from_str::<Report>(&json).unwrap(), shown);
    // Reports of before there were pictures are read as well.
    assert!(!report(true).to_json().unwrap().contains("pictures"));
}

#[test]
fn one_bad_verdict_fails_a_report_and_is_named() {
    assert!(report(true).passed() && report(true).failures().is_empty());
    let bad = report(false);
    assert!(!bad.passed());
    assert_eq!(bad.failures().len(), 2);
    assert!(html::page(&bad).contains("FAIL"));
}
