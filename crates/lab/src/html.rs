//! A report as one page that needs nothing else: style and plots are in it, and there are no scripts.

use std::fmt::Write;

use crate::docs;
use crate::figure;
use crate::gpu;
use crate::report::{Cell, Picture, Report, Section, Table};
use crate::svg::{self, escape};
use crate::text::is_figures;

const STYLE: &str = include_str!("report.css");

/// The whole page.
pub fn page(report: &Report) -> String {
    let title = title(report);
    let mut out = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>Antipode: {title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <h1>Antipode: {title}</h1>\n"
    );
    summary(&mut out, report);
    for part in &report.sections {
        section(&mut out, part);
    }
    out.push_str("</body>\n</html>\n");
    out
}

fn title(report: &Report) -> &'static str {
    let parts = || report.sections.iter();
    if parts().any(|part| part.id.starts_with(gpu::PREFIX)) {
        "graphics laboratory"
    } else if parts().all(|part| docs::TERRAIN.has(part)) {
        "terrain laboratory"
    } else {
        "exactness laboratory"
    }
}

fn summary(out: &mut String, report: &Report) {
    let verdicts: Vec<bool> = report
        .sections
        .iter()
        .flat_map(|section| &section.tables)
        .flat_map(|table| table.rows.iter().flatten())
        .filter_map(|cell| match cell {
            Cell::Verdict(met) => Some(*met),
            _ => None,
        })
        .collect();
    let met = verdicts.iter().filter(|met| **met).count();
    let class = if met == verdicts.len() { "good" } else { "bad" };
    if !verdicts.is_empty() {
        let _ = writeln!(
            out,
            "<p class=\"{class}\">{met} of {} bars are met.</p>",
            verdicts.len()
        );
    }
    out.push_str("<dl>\n");
    for (name, value) in &report.made_on {
        let _ = writeln!(out, "<dt>{}</dt><dd>{}</dd>", escape(name), escape(value));
    }
    out.push_str("</dl>\n<nav><ul>\n");
    for section in &report.sections {
        let (id, title) = (escape(&section.id), escape(&section.title));
        let mark = if section.passed() {
            ""
        } else {
            " <span class=\"bad\">FAIL</span>"
        };
        let _ = writeln!(out, "<li><a href=\"#{id}\">{title}</a>{mark}</li>");
    }
    out.push_str("</ul></nav>\n");
}

fn section(out: &mut String, section: &Section) {
    let _ = writeln!(
        out,
        "<section id=\"{}\">\n<h2>{}</h2>",
        escape(&section.id),
        escape(&section.title)
    );
    for paragraph in &section.method {
        let _ = writeln!(out, "<p>{}</p>", escape(paragraph));
    }
    for part in &section.tables {
        table(out, part);
    }
    for plot in &section.plots {
        let _ = writeln!(
            out,
            "<figure>\n<figcaption>{}</figcaption>\n{}</figure>",
            escape(&plot.title),
            svg::plot(plot)
        );
    }
    for Picture { title, png } in &section.pictures {
        let (title, png) = (escape(title), escape(png));
        let _ = writeln!(
            out,
            "<figure>\n<figcaption>{title}</figcaption>\n\
             <img src=\"data:image/png;base64,{png}\" alt=\"{title}\">\n</figure>"
        );
    }
    out.push_str("</section>\n");
}

fn table(out: &mut String, table: &Table) {
    let _ = writeln!(
        out,
        "<div class=\"wide\"><table>\n<caption>{}</caption>\n<thead><tr>",
        escape(&table.title)
    );
    for column in &table.columns {
        let _ = write!(out, "<th>{}</th>", escape(column));
    }
    out.push_str("</tr></thead>\n<tbody>\n");
    let right: Vec<bool> = (0..table.columns.len())
        .map(|i| is_figures(table, i))
        .collect();
    for row in &table.rows {
        let failed = row.contains(&Cell::Verdict(false));
        out.push_str(if failed {
            "<tr class=\"failed\">"
        } else {
            "<tr>"
        });
        for (i, entry) in row.iter().enumerate() {
            let class = match entry {
                Cell::Verdict(true) => " class=\"good\"",
                Cell::Verdict(false) => " class=\"bad\"",
                _ if right.get(i) == Some(&true) => " class=\"figure\"",
                _ => "",
            };
            let _ = write!(out, "<td{class}>{}</td>", escape(&figure::cell(entry)));
        }
        out.push_str("</tr>\n");
    }
    out.push_str("</tbody></table></div>\n");
}
