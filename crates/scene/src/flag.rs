//! Flags: planted to find a place again, with a name that map and compass show.

use crate::actors::ActorId;
use crate::fixture::Behaviour;
use crate::outbox::Outbox;

/// Characters of a name at most.
pub const LONGEST_NAME: usize = 24;
/// Whether it is not seen but changes how others are: directions, joiners, marks of the byte order.
fn is_unseen(c: char) -> bool {
    let ranges = [
        '\u{200b}'..='\u{200f}',
        '\u{202a}'..='\u{202e}',
        '\u{2060}'..='\u{2069}',
    ];
    c == '\u{feff}' || ranges.iter().any(|range| range.contains(&c))
}

/// What of a text can be a flag's name: one line that can be seen, its ends trimmed, of [`LONGEST_NAME`] characters at most.
pub fn tidy_name(text: &str) -> String {
    let seen: String = text.chars().filter(|c| !is_unseen(*c)).collect();
    let line = seen.split(char::is_control).map(str::trim);
    let words: Vec<&str> = line.filter(|part| !part.is_empty()).collect();
    let short: String = words.join(" ").chars().take(LONGEST_NAME).collect();
    short.trim_end().to_owned()
}

/// What has a name.
pub(crate) struct Named;

impl Behaviour for Named {
    /// Asks for its name.
    fn touch(&self, id: ActorId, outbox: &mut Outbox) -> bool {
        outbox.names_flag = Some(id);
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_one_short_line() {
        for (text, name) in [
            ("Home", "Home"),
            ("  at the\nriver\t ", "at the river"),
            ("\u{7}\n", ""),
            ("\u{200b}\u{202e}", ""),
            ("a\u{202e}b", "ab"),
            ("Überlingen 湖", "Überlingen 湖"),
        ] {
            assert_eq!(tidy_name(text), name);
        }
        let long = tidy_name(&"ä ".repeat(40));
        assert_eq!(long.chars().count(), LONGEST_NAME - 1);
        assert_eq!(tidy_name(&long), long);
    }
}
