//! The rows of `assets/tables/items.ron`, and what makes them sound. The build reads the table by this, and tests do.

use serde::Deserialize;

/// A row: what its fields are, the head of the table says.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Row {
    pub id: String,
    pub what: String,
    pub model: String,
    pub icon: String,
    pub most_in_slot: u32,
    pub at_start: u32,
    pub lies: Lies,
    pub held: Held,
    #[serde(default)]
    pub digs_per_s: Option<f32>,
    #[serde(default)]
    pub shines: bool,
}

/// How it lies on level ground.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub enum Lies {
    /// As it stands.
    Upright { height_m: f64 },
    /// What has a grip.
    OnItsSide { height_m: f64 },
}

/// How it is held before the eye.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Held {
    pub place_m: [f32; 3],
    pub turn_rad: [f32; 3],
    pub grip_m: [f32; 3],
}

/// Reads a table.
///
/// # Errors
/// What is wrong, with the file's name, the line and the field.
pub fn read(file: &str, text: &str, has: impl Fn(&str) -> bool) -> Result<Vec<Row>, String> {
    let options =
        ron::Options::default().with_default_extension(ron::extensions::Extensions::IMPLICIT_SOME);
    let rows: Vec<Row> = options
        .from_str(text)
        .map_err(|e| format!("{file}:{}: {}", e.span.start.line, e.code))?;
    for (place, row) in rows.iter().enumerate() {
        if let Some((field, wrong)) = wrong(row, &rows[..place], &has) {
            let line = line_of(text, place, field);
            return Err(format!("{file}:{line}: {field} of {:?} {wrong}", row.id));
        }
    }
    Ok(rows)
}

/// The first field of a row that is not sound, and what is wrong with it.
fn wrong(row: &Row, before: &[Row], has: impl Fn(&str) -> bool) -> Option<(&'static str, String)> {
    let is_word = |part: &str| !part.is_empty() && part.bytes().all(|c| c.is_ascii_lowercase());
    let (Lies::Upright { height_m } | Lies::OnItsSide { height_m }) = row.lies;
    let missing =
        |name: &str| (!has(name)).then(|| format!("is {name:?}, and there is no such file"));
    let checks = [
        (
            "id",
            (!row.id.split('-').all(is_word))
                .then(|| "is to be words of the letters a to z with - between them".to_owned()),
        ),
        (
            "id",
            before
                .iter()
                .any(|other| other.id == row.id)
                .then(|| "is the id of an earlier row, too".to_owned()),
        ),
        ("model", missing(&row.model)),
        ("icon", missing(&row.icon)),
        (
            "most_in_slot",
            (row.most_in_slot == 0).then(|| "is to be 1 or more".to_owned()),
        ),
        (
            "lies",
            (!(0.0..=1.0).contains(&height_m))
                .then(|| "is to be 0 to 1 m over the ground".to_owned()),
        ),
        (
            "digs_per_s",
            row.digs_per_s
                .is_some_and(|rate| !(rate > 0.0 && rate.is_finite()))
                .then(|| "is to be more than 0".to_owned()),
        ),
    ];
    let mut checks = checks.into_iter();
    checks.find_map(|(field, wrong)| Some((field, wrong?)))
}

/// The line of a field of the row at a place, counted from 1.
fn line_of(text: &str, place: usize, field: &str) -> usize {
    let begins = |line: &str, field: &str| {
        let line = line.trim_start_matches([' ', '(']);
        line.strip_prefix(field)
            .is_some_and(|rest| rest.trim_start().starts_with(':'))
    };
    let mut lines = text.lines().enumerate();
    let row = lines
        .by_ref()
        .filter(|(_, line)| begins(line, "id"))
        .nth(place);
    let first = row.map_or(0, |(number, _)| number);
    let mut here = text.lines().enumerate().skip(first);
    here.find(|(_, line)| begins(line, field))
        .map_or(first, |(number, _)| number)
        + 1
}

/// The name of a row's variant: `pickaxe-iron` is `PickaxeIron`.
pub fn variant(id: &str) -> String {
    let capital = |word: &str| {
        let mut letters = word.chars();
        let first = letters.next().map(|c| c.to_ascii_uppercase());
        first.into_iter().chain(letters).collect::<String>()
    };
    id.split('-').map(capital).collect()
}
