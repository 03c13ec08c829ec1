//! What a measurement says, as plain data: sections of tables and plots, each with its verdict.

use serde::{Deserialize, Serialize};

/// Everything one run of the laboratory found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// Program version, machine and adapter: name and value, in order.
    pub made_on: Vec<(String, String)>,
    /// The suites that ran, in order.
    pub sections: Vec<Section>,
}

/// One suite, or one part of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Section {
    /// Short and stable, for links and file names: `accuracy`, `peers`, `speed-cpu`.
    pub id: String,
    /// Its heading.
    pub title: String,
    /// How it was measured and how to read it, in paragraphs.
    pub method: Vec<String>,
    /// Its tables.
    pub tables: Vec<Table>,
    /// Its plots.
    pub plots: Vec<Plot>,
}

/// Rows of figures under named columns.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// What the rows are about.
    pub title: String,
    /// The heading of each column, with its unit where all rows share one.
    pub columns: Vec<String>,
    /// As many cells in each row as there are columns.
    pub rows: Vec<Vec<Cell>>,
}

/// One entry of a table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Cell {
    /// Words.
    Text(String),
    /// A figure and its unit, which may be empty.
    Figure(f64, String),
    /// Whether a bar was met. A report with one that was not has failed.
    Verdict(bool),
    /// Nothing to say.
    Empty,
}

/// How an axis is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By powers of ten; only positive values are drawn.
    Logarithmic,
}

/// One axis of a plot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Axis {
    /// What it shows, with its unit.
    pub label: String,
    /// How it is divided.
    pub scale: Scale,
}

/// Curves or dots over two axes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plot {
    /// Short and stable, for file names.
    pub id: String,
    /// Its heading.
    pub title: String,
    /// Across.
    pub x: Axis,
    /// Upwards.
    pub y: Axis,
    /// What is drawn.
    pub series: Vec<Series>,
}

/// One curve, or one kind of dots.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Series {
    /// Its name in the legend.
    pub name: String,
    /// Points in order.
    pub points: Vec<(f64, f64)>,
    /// Whether the points are joined by a line.
    pub joined: bool,
}

impl Report {
    /// Whether every verdict in every table is good.
    pub fn passed(&self) -> bool {
        self.sections.iter().all(Section::passed)
    }

    /// The rows with a bad verdict, each by its words: `port, d from 1e-4 to 3, GPU`.
    pub fn failures(&self) -> Vec<String> {
        let rows = self
            .sections
            .iter()
            .flat_map(|section| &section.tables)
            .flat_map(|table| &table.rows);
        rows.filter(|row| row.contains(&Cell::Verdict(false)))
            .map(|row| {
                let words = row.iter().filter_map(|cell| match cell {
                    Cell::Text(words) if !words.is_empty() => Some(words.as_str()),
                    _ => None,
                });
                words.take(3).collect::<Vec<_>>().join(", ")
            })
            .collect()
    }
}

impl Section {
    /// Whether every verdict in every table is good.
    pub fn passed(&self) -> bool {
        let cells = self
            .tables
            .iter()
            .flat_map(|table| table.rows.iter().flatten());
        !cells.into_iter().any(|cell| *cell == Cell::Verdict(false))
    }
}
