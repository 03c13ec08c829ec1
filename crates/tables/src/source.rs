//! A sound table as the text of Rust code: a type with a variant for each row where code needs them by name, and the rows.

use std::fmt::Write as _;

use crate::reader::{Fault, Row, Table};

/// What else than its rows a table says of the code that is made of it.
pub(crate) trait Source: Row {
    /// The type that has a variant for each row.
    const NAMES: Option<Names>;

    /// What its variant is, as a sentence of the code's documents.
    fn what(&self) -> &str;

    /// The row as an expression of the type `Row` of the crate that takes the table.
    fn expression(&self, told: &dyn Fn(&Fault) -> String) -> String;

    /// What stands before the rows.
    fn preface(_rows: &[Self]) -> String {
        String::new()
    }
}

/// A type with a variant for each row.
pub(crate) struct Names {
    pub name: &'static str,
    /// What one is, as a sentence of the code's documents.
    pub about: &'static str,
    /// What it derives besides what every such type does.
    pub derives: &'static str,
    /// Whether its variants are written in files by the ids of their rows.
    pub is_written: bool,
    /// What a list of them all is called, and what is said of it.
    pub list: (&'static str, &'static str),
    /// A variant for what has no row.
    pub other: &'static str,
}

/// The code of a table.
pub(crate) fn of<R: Source>(table: &Table<'_, R>) -> String {
    let mut code = R::NAMES.map_or_else(String::new, |names| enumeration(&names, &table.rows));
    code += &R::preface(&table.rows);
    let count = table.rows.len();
    // A static is in the program once, wherever it is read from.
    let _ = write!(
        code,
        "/// What the table says of each, in its order.\nstatic ROWS: [Row; {count}] = ["
    );
    for (place, row) in table.rows.iter().enumerate() {
        let _ = write!(
            code,
            "{}, ",
            row.expression(&|fault| table.told(place, fault))
        );
    }
    code + "];"
}

fn enumeration<R: Source>(names: &Names, rows: &[R]) -> String {
    let Names {
        name,
        about,
        derives,
        is_written,
        list: (list, all),
        other,
    } = names;
    let (mut variants, mut each) = (String::new(), String::new());
    for row in rows {
        if *is_written {
            let _ = write!(variants, "#[serde(rename = {:?})] ", row.id());
        }
        let variant = variant(row.id());
        let _ = write!(variants, "#[doc = {:?}] {variant}, ", row.what());
        let _ = write!(each, "Self::{variant}, ");
    }
    let count = rows.len();
    format!(
        "#[doc = {about:?}] #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, {derives})] pub enum {name} {{ {variants} \
         {other} }} impl {name} {{ #[doc = {all:?}] pub const {list}: [Self; {count}] = [{each}]; }} "
    )
}

/// A file of a folder of `assets`, built in.
pub(crate) fn embedded(folder: &str, file: &str) -> String {
    let path = format!("/../../assets/{folder}/{file}");
    format!("include_bytes!(concat!(env!(\"CARGO_MANIFEST_DIR\"), {path:?}))")
}

/// The name of a row's variant: `pickaxe-iron` is `PickaxeIron`.
pub(crate) fn variant(id: &str) -> String {
    let capital = |word: &str| {
        let mut letters = word.chars();
        let first = letters.next().map(|c| c.to_ascii_uppercase());
        first.into_iter().chain(letters).collect::<String>()
    };
    id.split('-').map(capital).collect()
}
