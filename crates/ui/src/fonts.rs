//! The fonts: egui's own, which have every Latin letter the game needs, and Chinese characters behind them.

use std::sync::Arc;

use egui::{Context, FontData, FontDefinitions};

/// GB 2312 and what the locale files use besides; `assets/fonts/README.md` tells where it comes from.
const CHINESE: &[u8] = include_bytes!("../../../assets/fonts/NotoSansSC-subset.otf");

/// What every word is written in.
pub(crate) fn definitions() -> FontDefinitions {
    let mut fonts = FontDefinitions::default();
    let name = "Noto Sans SC";
    let chinese = Arc::new(FontData::from_static(CHINESE));
    fonts.font_data.insert(name.to_owned(), chinese);
    for chain in fonts.families.values_mut() {
        chain.push(name.to_owned());
    }
    fonts
}

/// Adds the game's fonts; may be called again.
pub(crate) fn add(ctx: &Context) {
    ctx.set_fonts(definitions());
}
