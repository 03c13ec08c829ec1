//! The fonts: egui's own, which have every Latin letter the game needs, and Chinese characters behind them.

use egui::epaint::text::{FontInsert, FontPriority, InsertFontFamily};
use egui::{Context, FontData, FontFamily};

/// GB 2312 and what the locale files use besides; `assets/fonts/README.md` tells where it comes from.
const CHINESE: &[u8] = include_bytes!("../../../assets/fonts/NotoSansSC-subset.otf");

/// Adds the game's fonts; may be called again.
pub(crate) fn add(ctx: &Context) {
    let behind = |family| InsertFontFamily {
        family,
        priority: FontPriority::Lowest,
    };
    ctx.add_font(FontInsert::new(
        "Noto Sans SC",
        FontData::from_static(CHINESE),
        vec![
            behind(FontFamily::Proportional),
            behind(FontFamily::Monospace),
        ],
    ));
}
