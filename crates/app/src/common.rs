//! The options that every command understands.

use std::path::PathBuf;

use antipode_scene::frame::Quality;
use antipode_settings::Preset;
use clap::{Args, ValueEnum};

use crate::log::LogLevel;

/// Options that every command understands.
#[derive(Clone, Debug, Args)]
pub struct Common {
    /// Where worlds are kept.
    #[arg(long, global = true, value_name = "DIR")]
    pub saves_dir: Option<PathBuf>,
    /// What draws the pictures.
    #[arg(long, global = true, value_enum, default_value_t = Adapter::Auto)]
    pub adapter: Adapter,
    /// How much exactness pictures trade for speed: fast, balanced or exact [default: the settings', for commands
    /// balanced].
    #[arg(long, global = true)]
    pub quality: Option<Quality>,
    /// For what pictures are made: auto, card or software [default: the settings', for commands auto].
    #[arg(long, global = true, value_parser = parse_preset)]
    pub preset: Option<Preset>,
    /// The file of the settings; without it commands go by the defaults, and the window by the player's own file.
    #[arg(long, global = true, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// Size of the window or the pictures in pixels.
    #[arg(long, global = true, value_parser = parse_size, default_value = "1280x720", value_name = "WxH")]
    pub size: (u32, u32),
    /// How far land is loaded, in chunks of 32 metres, 1 to 16.
    #[arg(long, global = true, value_name = "CHUNKS", value_parser = clap::value_parser!(u32).range(1..=16))]
    pub view_distance: Option<u32>,
    /// How much the log says [default: warn for the window, error for commands].
    #[arg(long, global = true, value_enum)]
    pub log: Option<LogLevel>,
}

/// What draws the pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Adapter {
    /// A graphics card if there is one, else software.
    Auto,
    /// A graphics card, or fail.
    Gpu,
    /// Software rendering.
    Software,
    /// No pictures at all.
    None,
}

fn parse_preset(word: &str) -> Result<Preset, String> {
    let known = Preset::IDS.join(", ");
    Preset::from_id(word).ok_or_else(|| format!("\"{word}\" is no preset; there are {known}"))
}

fn parse_size(text: &str) -> Result<(u32, u32), String> {
    let wrong =
        || format!("\"{text}\" is not a size; write it like 1280x720, each side from 64 to 8192");
    let (width, height) = text.split_once('x').ok_or_else(wrong)?;
    let side = |s: &str| {
        s.parse::<u32>()
            .ok()
            .filter(|n| (64..=8192).contains(n))
            .ok_or_else(wrong)
    };
    Ok((side(width)?, side(height)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_read_and_nonsense_is_refused() {
        assert_eq!(parse_size("640x360"), Ok((640, 360)));
        for wrong in ["640", "x", "0x0", "-1x5", "640x99999", "640x360x2", "axb"] {
            assert!(parse_size(wrong).is_err(), "{wrong} passed");
        }
    }
}
