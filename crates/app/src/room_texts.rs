//! What is read in the rooms that come with the game, in the player's language. It is found by what their files say, so that a
//! player's copy of such a room speaks that language as well, as long as nobody has changed what is read there.

use std::collections::HashMap;

use antipode_language::Texts;
use antipode_rooms::shipped;

/// From the words of the files to those that are shown.
#[derive(Clone, Debug, Default)]
pub struct RoomTexts(HashMap<String, String>);

impl RoomTexts {
    /// In that language.
    pub fn of(texts: &Texts) -> Self {
        let told = |(text, key): &(String, String)| {
            let key = format!("room-{key}");
            texts.has(&key).then(|| (text.clone(), texts.say(&key)))
        };
        Self(shipped::words().iter().filter_map(told).collect())
    }

    /// What is shown of a text: the game's own in the player's language, all others as they are.
    pub fn say<'a>(&'a self, text: &'a str) -> &'a str {
        self.0.get(text).map_or(text, String::as_str)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use antipode_language::Language;

    use super::*;

    #[test]
    fn words_of_the_game_are_told_in_the_language_and_a_players_own_as_they_are() {
        let room = shipped::find("long-house").unwrap().room().unwrap();
        let german = RoomTexts::of(&Texts::new(Language::German));
        let told = german.say(&room.sentence);
        assert!(told.contains("79") && told != room.sentence, "{told}");
        let mine = format!("{} Look!", room.sentence);
        assert_eq!(german.say(&mine), mine);
    }
}
