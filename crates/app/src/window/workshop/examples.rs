//! The page of what is possible: six kits with their pictures and words.

use antipode_language::Texts;
use antipode_ui::workshop::ExampleRow;
use egui::{ColorImage, Context, TextureHandle, TextureOptions};

macro_rules! pictures {
    ($($id:literal),* $(,)?) => {
        &[$(($id, include_bytes!(concat!("../../../../../assets/workshop/", $id, ".png")))),*]
    };
}

/// The examples in their order, each with its picture: PNG, 320 by 180 pixels.
const EXAMPLES: &[(&str, &[u8])] = pictures![
    "tunnel-longer",
    "tunnel-shorter",
    "house",
    "portals",
    "portals-of-size",
    "falling-loop",
];

/// Their pictures, once they have been read.
#[derive(Default)]
pub struct Pictures(Vec<Option<TextureHandle>>);

impl Pictures {
    /// What the page shows. Pictures are read when it is asked for first.
    pub fn rows(&mut self, context: &Context, texts: &Texts) -> Vec<ExampleRow> {
        if self.0.is_empty() {
            let all = EXAMPLES.iter();
            let all = all.map(|(id, png)| texture(context, &format!("example {id}"), png));
            self.0 = all.collect();
        }
        let row = |((id, _), picture): (&(&str, &[u8]), &Option<TextureHandle>)| ExampleRow {
            id: (*id).to_owned(),
            label: texts.say(&format!("workshop-example-{id}")),
            about: texts.say(&format!("workshop-example-{id}-about")),
            picture: picture.as_ref().map(TextureHandle::id),
        };
        EXAMPLES.iter().zip(&self.0).map(row).collect()
    }
}

/// A picture as the interface shows it; none where the file is none.
pub fn texture(context: &Context, name: &str, png: &[u8]) -> Option<TextureHandle> {
    let picture = image::load_from_memory(png).ok()?.to_rgba8();
    let size = [picture.width() as usize, picture.height() as usize];
    let picture = ColorImage::from_rgba_unmultiplied(size, &picture);
    Some(context.load_texture(name, picture, TextureOptions::LINEAR))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::window::workshop::kits::KITS;

    #[test]
    fn every_example_is_a_kit_with_a_picture_and_words() {
        let context = Context::default();
        let rows = Pictures::default().rows(&context, &Texts::default());
        assert_eq!(rows.len(), 6);
        for row in rows {
            assert!(KITS.iter().any(|(id, _)| *id == row.id), "{}", row.id);
            assert!(row.picture.is_some(), "{}", row.id);
            assert!(!row.about.contains("workshop-"), "{}", row.about);
        }
    }
}
