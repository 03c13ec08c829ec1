//! Pictures of the parts, as the game draws them: PNG, 128 by 96 pixels. The test `every_part_has_a_picture_as_the_game_draws_it` makes
//! them anew where `ANTIPODE_REMAKE_PICTURES` is set.

use antipode_ui::workshop::PartRow;
use egui::{Context, TextureHandle};

use super::examples::texture;

macro_rules! pictures {
    ($($id:literal),* $(,)?) => {
        &[$(($id, include_bytes!(concat!("../../../../../assets/workshop/parts/", $id, ".png")))),*]
    };
}

/// What parts are known by, and their pictures.
pub const PICTURES: &[(&str, &[u8])] = pictures![
    "house", "tunnel", "portals", "portal", "hall", "box", "wall", "floor", "stairs", "ramp",
    "arch", "pyramid", "cylinder", "ball", "light", "sign",
];

/// The pictures, once they have been read.
#[derive(Default)]
pub struct PartPictures(Vec<(&'static str, Option<TextureHandle>)>);

impl PartPictures {
    /// Gives rows their pictures. These are read when they are asked for first.
    pub fn add_to(&mut self, context: &Context, rows: &mut [PartRow]) {
        if self.0.is_empty() {
            let all = PICTURES.iter();
            let all = all.map(|(id, png)| (*id, texture(context, &format!("part {id}"), png)));
            self.0 = all.collect();
        }
        for row in rows.iter_mut().filter(|row| row.picture.is_none()) {
            let known = self.0.iter().find(|(id, _)| *id == row.id);
            row.picture = known.and_then(|(_, it)| it.as_ref().map(TextureHandle::id));
        }
    }
}

#[cfg(test)]
mod tests;
