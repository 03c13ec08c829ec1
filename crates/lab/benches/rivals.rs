//! Ours beside every rival library in one run: `cargo bench -p antipode-lab`. Under `cargo test` a short run.

use antipode_lab::{Effort, terrain, text};

fn main() {
    let effort = Effort {
        quick: !std::env::args().any(|argument| argument == "--bench"),
    };
    for section in [
        terrain::field_section(effort),
        terrain::mesh_section(effort),
    ] {
        print!("{}", text::section(&section));
    }
}
