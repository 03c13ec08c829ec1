//! Reports on disk: JSON in and out, the page, and the document with its plots.

use std::fs;
use std::path::Path;

use crate::docs::{self, Document, Kind};
use crate::error::LabError;
use crate::report::Report;
use crate::{html, json};

impl Report {
    /// The report as JSON, one row or curve to a line, with a final newline.
    ///
    /// # Errors
    /// [`LabError::Template`] when a figure cannot be written, which no finite figure causes.
    pub fn to_json(&self) -> Result<String, LabError> {
        json::to_string(self)
            .map(|text| text + "\n")
            .map_err(|e| LabError::Template(e.to_string()))
    }

    /// Reads what [`Report::to_json`] wrote.
    ///
    /// # Errors
    /// [`LabError::Read`] or [`LabError::NoReport`].
    pub fn read(path: &Path) -> Result<Self, LabError> {
        let text = fs::read_to_string(path).map_err(|source| LabError::Read {
            path: path.to_owned(),
            source,
        })?;
        serde_json::from_str(&text).map_err(|e| LabError::NoReport {
            path: path.to_owned(),
            why: e.to_string(),
        })
    }

    /// Writes the JSON, and the directory it goes into.
    ///
    /// # Errors
    /// [`LabError::Write`], or [`LabError::NoReport`] when a figure is not finite: JSON has no word
    /// for that, and the file could not be read back.
    pub fn write_json(&self, path: &Path) -> Result<(), LabError> {
        let text = self.to_json()?;
        serde_json::from_str::<Self>(&text).map_err(|e| LabError::NoReport {
            path: path.to_owned(),
            why: format!("a figure is not finite: {e}"),
        })?;
        write(path, &text)
    }

    /// Writes `index.html` into a directory, which is made.
    ///
    /// # Errors
    /// [`LabError::Write`].
    pub fn write_page(&self, directory: &Path) -> Result<(), LabError> {
        write(&directory.join("index.html"), &html::page(self))
    }

    /// Writes the documents that the report has sections of, each with its plots, into a directory, which is made.
    /// Plots of an earlier report that this one does not have are removed.
    ///
    /// # Errors
    /// [`LabError::Write`], or [`LabError::Template`].
    pub fn write_docs(&self, directory: &Path) -> Result<(), LabError> {
        let told = |kind: &&&Kind| self.sections.iter().any(|section| kind.has(section));
        for kind in docs::ALL.iter().filter(told) {
            self.write_document(kind, directory)?;
        }
        Ok(())
    }

    fn write_document(&self, kind: &Kind, directory: &Path) -> Result<(), LabError> {
        let Document { text, plots } = kind.document(self)?;
        let folder = directory.join(kind.plots);
        for old in docs::plots_in(&folder) {
            if !plots.iter().any(|(name, _)| folder.join(name) == old) {
                fs::remove_file(&old).map_err(|source| LabError::Write { path: old, source })?;
            }
        }
        for (name, plot) in &plots {
            write(&folder.join(name), plot)?;
        }
        write(&directory.join(kind.name), &text)
    }
}

fn write(path: &Path, text: &str) -> Result<(), LabError> {
    let failed = |source| LabError::Write {
        path: path.to_owned(),
        source,
    };
    if let Some(parent) = path.parent() {
        fs::create_dir_all(parent).map_err(failed)?;
    }
    fs::write(path, text).map_err(failed)
}
