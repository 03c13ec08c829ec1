//! The tables in `assets/tables` as types. Each macro reads a table while the crate that calls it is compiled, and writes out
//! its rows as a static `ROWS` of that crate's type `Row`, with a type that has a variant for each where code needs them by
//! name. A table that is not sound ends the build with the file, the line and the field.
//!
//! One reader serves all (`reader`, `places`); a table is a file here with its row, what makes that sound, and how it is
//! written out.

mod biomes;
mod hints;
mod items;
mod models;
mod places;
mod reader;
mod sounds;
mod source;

use std::path::{Path, PathBuf};

use proc_macro::TokenStream;

use reader::Assets;
use source::Source;

/// `Item` of `items.ron`: what can be carried. `Row`, `Lies`, `Held` and `Stands` are to be there.
#[proc_macro]
pub fn items(_: TokenStream) -> TokenStream {
    expand::<items::Item>()
}

/// `ModelId` of `models.ron`: what figures are drawn with besides items. `Row` and `ModelShape` are to be there.
#[proc_macro]
pub fn models(_: TokenStream) -> TokenStream {
    expand::<models::Model>()
}

/// The rows of `biomes.ron`. `Row`, `Cover` and `Palette` are to be there.
#[proc_macro]
pub fn biomes(_: TokenStream) -> TokenStream {
    expand::<biomes::Biome>()
}

/// `Sound` of `sounds.ron`, with its files. `Row`, `Group` and `Sample`, the number of a file, are to be there.
#[proc_macro]
pub fn sounds(_: TokenStream) -> TokenStream {
    expand::<sounds::Sound>()
}

/// `Lesson` of `hints.ron`. `Row`, `Needs`, `Done` and `action`, which finds an action by its id or ends the build with what
/// it is to say, are to be there.
#[proc_macro]
pub fn hints(_: TokenStream) -> TokenStream {
    expand::<hints::Hint>()
}

/// What a table is written out as, or an error of the compiler.
fn expand<R: Source>() -> TokenStream {
    let code = code::<R>().and_then(|code| {
        code.parse()
            .map_err(|error| format!("{}: {error}", R::FILE))
    });
    code.unwrap_or_else(|wrong| {
        let error = format!("compile_error!({wrong:?});");
        error.parse().unwrap_or_default()
    })
}

fn code<R: Source>() -> Result<String, String> {
    // The compiler runs this for a crate in `crates`.
    let of_crate = std::env::var("CARGO_MANIFEST_DIR")
        .map_err(|error| format!("CARGO_MANIFEST_DIR: {error}"))?;
    let root = PathBuf::from(of_crate).join("../..");
    let text = std::fs::read_to_string(root.join(R::FILE))
        .map_err(|error| format!("{}: {error}", R::FILE))?;
    let has = |file: &Path| root.join("assets").join(file).is_file();
    let table = reader::read::<R>(&text, Assets(&has))?;
    // A file that is included is watched: a change of the table compiles the crate anew.
    let watched = format!(
        "const _: &[u8] = include_bytes!(concat!(env!(\"CARGO_MANIFEST_DIR\"), \"/../../{}\"));",
        R::FILE
    );
    Ok(source::of(&table) + &watched)
}
