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
    /// Its pictures; most sections have none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub pictures: Vec<Picture>,
}

/// A picture, as a page can show it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Picture {
    /// What is to be seen.
    pub title: String,
    /// The PNG file in base64, with padding.
    pub png: String,
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

impl Cell {
    /// Words.
    pub fn text(words: impl Into<String>) -> Self {
        Self::Text(words.into())
    }

    /// A figure and its unit, which may be empty.
    pub fn figure(value: impl Into<f64>, unit: &str) -> Self {
        Self::Figure(value.into(), unit.to_owned())
    }

    /// A share of a number of things.
    pub fn percent(part: usize, whole: usize) -> Self {
        Self::figure(100.0 * part as f64 / whole.max(1) as f64, "%")
    }

    /// A number of things.
    pub fn count(n: usize) -> Self {
        Self::figure(n as f64, "")
    }
}

impl Table {
    /// Rows under headings.
    pub fn new(
        title: impl Into<String>,
        columns: impl IntoIterator<Item: Into<String>>,
        rows: impl IntoIterator<Item = Vec<Cell>>,
    ) -> Self {
        Self {
            title: title.into(),
            columns: columns.into_iter().map(Into::into).collect(),
            rows: rows.into_iter().collect(),
        }
    }
}

impl Scale {
    /// An axis divided so.
    pub fn axis(self, label: impl Into<String>) -> Axis {
        Axis {
            label: label.into(),
            scale: self,
        }
    }

    /// The axis across and the one upwards, both divided so.
    pub fn axes(self, across: &str, upwards: &str) -> [Axis; 2] {
        [across, upwards].map(|label| self.axis(label))
    }
}

impl Plot {
    /// What is drawn, over the axis across and the one upwards.
    pub fn new(
        id: impl Into<String>,
        title: impl Into<String>,
        [x, y]: [Axis; 2],
        series: impl IntoIterator<Item = Series>,
    ) -> Self {
        Self {
            id: id.into(),
            title: title.into(),
            x,
            y,
            series: series.into_iter().collect(),
        }
    }
}

impl Series {
    /// Points joined by a line.
    pub fn line(name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self {
            name: name.into(),
            points: points.into_iter().collect(),
            joined: true,
        }
    }

    /// Points by themselves.
    pub fn dots(name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self {
            joined: false,
            ..Self::line(name, points)
        }
    }
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
    /// A section without plots.
    pub fn new(
        id: impl Into<String>,
        title: impl Into<String>,
        method: impl IntoIterator<Item: Into<String>>,
        tables: impl IntoIterator<Item = Table>,
    ) -> Self {
        Self {
            id: id.into(),
            title: title.into(),
            method: method.into_iter().map(Into::into).collect(),
            tables: tables.into_iter().collect(),
            plots: Vec::new(),
            pictures: Vec::new(),
        }
    }

    /// With plots.
    #[must_use]
    pub fn with(self, plots: impl IntoIterator<Item = Plot>) -> Self {
        Self {
            plots: plots.into_iter().collect(),
            ..self
        }
    }

    /// Whether every verdict in every table is good.
    pub fn passed(&self) -> bool {
        let cells = self
            .tables
            .iter()
            .flat_map(|table| table.rows.iter().flatten());
        !cells.into_iter().any(|cell| *cell == Cell::Verdict(false))
    }
}
