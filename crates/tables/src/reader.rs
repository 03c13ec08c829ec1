//! Reads a table and looks whether it is sound. Every error names the file, the line and the field.

use std::path::Path;

use serde::de::DeserializeOwned;

use crate::places::{Place, field_at, line_of, no_number, places};

/// What a field says that it may not.
#[derive(Debug, PartialEq)]
pub(crate) struct Fault {
    /// Its name; of a field of a field both with a dot between them.
    pub field: &'static str,
    /// What is wrong with it, as a sentence goes on after the field.
    pub wrong: String,
}

/// A row of a table: what its fields are, the head of the table says.
pub(crate) trait Row: DeserializeOwned {
    /// The table, from the checkout.
    const FILE: &'static str;

    /// Its name, of small letters, digits and hyphens, by which code and saves know it.
    fn id(&self) -> &str;

    /// Whether its fields are sound.
    ///
    /// # Errors
    /// The first that is not.
    fn check(&self, assets: Assets<'_>) -> Result<(), Fault>;
}

/// Which files there are.
#[derive(Clone, Copy)]
pub(crate) struct Assets<'a>(pub &'a dyn Fn(&Path) -> bool);

impl Assets<'_> {
    /// Whether a folder of `assets` has a file that a field names.
    pub fn need(self, field: &'static str, folder: &str, file: &str) -> Result<(), Fault> {
        let is_there = !file.is_empty() && (self.0)(&Path::new(folder).join(file));
        let wrong = format!("is {file:?}, and assets/{folder} has no such file");
        need(field, is_there, &wrong)
    }
}

/// A fault of a field where something does not hold.
pub(crate) fn need(field: &'static str, holds: bool, wrong: &str) -> Result<(), Fault> {
    let wrong = wrong.to_owned();
    if holds {
        Ok(())
    } else {
        Err(Fault { field, wrong })
    }
}

/// A table that is sound.
pub(crate) struct Table<'t, R> {
    pub rows: Vec<R>,
    places: Vec<Place<'t>>,
}

impl<R: Row> Table<'_, R> {
    /// What is said of a fault of the row at a place.
    pub fn told(&self, row: usize, fault: &Fault) -> String {
        told(&self.places, row, &self.rows[row], fault)
    }
}

fn told<R: Row>(places: &[Place<'_>], place: usize, row: &R, fault: &Fault) -> String {
    let Fault { field, wrong } = fault;
    let (file, line) = (R::FILE, line_of(places, place, field));
    format!("{file}:{line}: {field} of {:?} {wrong}", row.id())
}

/// Reads a table.
///
/// # Errors
/// What is wrong, with the file, the line and the field.
pub(crate) fn read<'t, R: Row>(text: &'t str, assets: Assets<'_>) -> Result<Table<'t, R>, String> {
    let (file, places) = (R::FILE, places(text));
    let options =
        ron::Options::default().with_default_extension(ron::extensions::Extensions::IMPLICIT_SOME);
    let rows: Vec<R> = options
        .from_str(text)
        .map_err(|error| unread(file, &places, &error))?;
    if let Some((line, column)) = no_number(text) {
        let field = field_at(&places, (line, column));
        let (field, id) = field.map_or(("", ""), |(field, id)| (field.path.as_str(), id));
        return Err(format!(
            "{file}:{line}: {field} of {id:?} is to be a number"
        ));
    }
    if rows.is_empty() {
        return Err(format!("{file}:1: the table has no row"));
    }
    for (place, row) in rows.iter().enumerate() {
        named(row, &rows[..place])
            .and_then(|()| row.check(assets))
            .map_err(|fault| told(&places, place, row, &fault))?;
    }
    Ok(Table { rows, places })
}

/// What cannot be read at all.
fn unread(file: &str, places: &[Place<'_>], error: &ron::error::SpannedError) -> String {
    use ron::error::Error::{MissingStructField, NoSuchStructField};
    let (start, code) = (error.span.start, &error.code);
    let line = start.line;
    match (code, field_at(places, (line, start.col))) {
        // That is seen at its row's end.
        (MissingStructField { field, .. }, Some((Place { row, .. }, id))) => {
            let line = line_of(places, *row, field);
            format!("{file}:{line}: {field} of {id:?} is missing")
        }
        // The reader names the field.
        (NoSuchStructField { .. }, Some((_, id))) => format!("{file}:{line}: {id:?}: {code}"),
        (_, Some((field, id))) => format!("{file}:{line}: {} of {id:?}: {code}", field.path),
        (_, None) => format!("{file}:{line}: {code}"),
    }
}

fn named<R: Row>(row: &R, before: &[R]) -> Result<(), Fault> {
    let is_part = |part: &str| {
        let is_of_id = |c: u8| c.is_ascii_lowercase() || c.is_ascii_digit();
        !part.is_empty() && part.bytes().all(is_of_id)
    };
    let is_id = row.id().starts_with(|c: char| c.is_ascii_lowercase());
    need(
        "id",
        is_id && row.id().split('-').all(is_part),
        "is to be words of the letters a to z and digits with - between them",
    )?;
    let is_new = before.iter().all(|other| other.id() != row.id());
    need("id", is_new, "is the id of an earlier row, too")
}

/// How tables are broken in tests.
#[cfg(test)]
pub(crate) mod testing {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;

    /// What is said of a table, after `sound` in it became `unsound`. Files with `none` in their name are not there.
    fn told<R: Row>(text: &str, sound: &str, unsound: &str) -> String {
        assert!(text.contains(sound), "{sound}");
        let text = text.replacen(sound, unsound, 1);
        let has = |path: &Path| !path.to_string_lossy().contains("none");
        read::<R>(&text, Assets(&has)).err().unwrap_or_default()
    }

    /// Each case is what stands in a sound table, what is put in its place, and what is said of that after the file's name.
    pub fn refuses<R: Row>(text: &str, cases: &[(&str, &str, &str)]) {
        assert_eq!(told::<R>(text, "", ""), "");
        for (sound, unsound, start) in cases {
            let message = told::<R>(text, sound, unsound);
            let start = format!("{}:{start}", R::FILE);
            assert!(message.starts_with(&start), "{message}\nis not\n{start}");
        }
    }
}
