//! Makes the type [`Item`] of the table of items. A table that is not sound ends the build with the file, the line and the
//! field.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

#[path = "src/table.rs"]
mod table;

use table::{Lies, Row};

/// The checkout, from this crate.
const ROOT: &str = "../..";
const TABLE: &str = "assets/tables/items.ron";
const MODELS: &str = "assets/models";

fn main() -> ExitCode {
    match make() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn make() -> Result<(), String> {
    let env = |name: &str| std::env::var(name).map_err(|e| format!("{name}: {e}"));
    let root = Path::new(&env("CARGO_MANIFEST_DIR")?).join(ROOT);
    let file = root.join(TABLE);
    println!("cargo::rerun-if-changed={}", file.display());
    println!("cargo::rerun-if-changed=src/table.rs");
    let text = std::fs::read_to_string(&file).map_err(|e| format!("{TABLE}: {e}"))?;
    let models = root.join(MODELS);
    let rows = table::read(TABLE, &text, |name| models.join(name).is_file())?;
    let out = PathBuf::from(env("OUT_DIR")?).join("item.rs");
    std::fs::write(&out, source(&rows, &models)).map_err(|e| format!("{}: {e}", out.display()))
}

/// The text of the type.
fn source(rows: &[Row], models: &Path) -> String {
    let (mut variants, mut all, mut table) = (String::new(), String::new(), String::new());
    for row in rows {
        let name = table::variant(&row.id);
        let (what, id) = (&row.what, &row.id);
        let (on_its_side, height_m) = match row.lies {
            Lies::Upright { height_m } => (false, height_m),
            Lies::OnItsSide { height_m } => (true, height_m),
        };
        let [model, icon] =
            [&row.model, &row.icon].map(|file| models.join(file).display().to_string());
        let _ = write!(
            variants,
            "    #[doc = {what:?}]\n    #[serde(rename = {id:?})]\n    {name},\n"
        );
        let _ = write!(all, "Self::{name}, ");
        let _ = write!(
            table,
            "    Properties {{\n        id: {id:?},\n        model: include_bytes!({model:?}),\n        icon: \
             include_bytes!({icon:?}),\n        most_in_slot: {},\n        at_start: {},\n        lies: Lies {{ \
             on_its_side: {on_its_side}, height_m: {height_m:?} }},\n        held: {:?},\n        digs_per_s: \
             {:?},\n        shines: {},\n    }},\n",
            row.most_in_slot, row.at_start, row.held, row.digs_per_s, row.shines
        );
    }
    let count = rows.len();
    // A static is in the program once, wherever it is read from.
    format!(
        "/// A kind of thing that the player can hold.\n\
         #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]\n\
         pub enum Item {{\n{variants}}}\n\n\
         impl Item {{\n    /// Every item, in the order in which a new player finds them in the slots.\n    \
         pub const ALL: [Self; {count}] = [{all}];\n}}\n\n\
         /// What the table says of each, by its place.\n\
         static PROPERTIES: [Properties; {count}] = [\n{table}];\n"
    )
}
