//! Where the fields of a table are written: what an error needs to name the line and the field.

/// A field of a row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Place<'t> {
    /// Which row, counted from 0.
    pub row: usize,
    /// Its name; of a field of a field both with a dot between them.
    pub path: String,
    /// Line and column, counted from 1.
    pub at: (usize, usize),
    /// The text or the word that it is.
    value: &'t str,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Token<'t> {
    Open,
    Close,
    Colon,
    /// A word or a number.
    Word(&'t str),
    /// What stands between quotes.
    Text(&'t str),
}

/// All fields of a table, in their order.
pub(crate) fn places(text: &str) -> Vec<Place<'_>> {
    let tokens = tokens(text);
    // The list is the first bracket, its rows are those in it.
    let (mut names, mut rows) = (Vec::<&str>::new(), 0_usize);
    let mut found = Vec::new();
    for (number, (token, at)) in tokens.iter().enumerate() {
        match token {
            Token::Open => {
                rows += usize::from(names.len() == 1);
                names.push("");
            }
            Token::Close => {
                names.pop();
            }
            Token::Word(name) if tokens.get(number + 1).map(|it| it.0) == Some(Token::Colon) => {
                let (Some(last), Some(row)) = (names.last_mut(), rows.checked_sub(1)) else {
                    continue;
                };
                *last = name;
                let path: Vec<&str> = names.iter().copied().filter(|it| !it.is_empty()).collect();
                let value = match tokens.get(number + 2) {
                    Some((Token::Word(value) | Token::Text(value), _)) => value,
                    _ => "",
                };
                found.push(Place {
                    row,
                    path: path.join("."),
                    at: *at,
                    value,
                });
            }
            _ => {}
        }
    }
    found
}

/// The line of a field, or of its row's first field where it has no such field.
pub(crate) fn line_of(places: &[Place<'_>], row: usize, path: &str) -> usize {
    let mut own = places.iter().filter(|it| it.row == row);
    let field = own.clone().find(|it| it.path == path);
    field.or_else(|| own.next()).map_or(1, |it| it.at.0)
}

/// The field in which a line and a column are, and the id of its row.
pub(crate) fn field_at<'a, 't>(
    places: &'a [Place<'t>],
    at: (usize, usize),
) -> Option<(&'a Place<'t>, &'t str)> {
    let field = places.iter().take_while(|it| it.at <= at).last()?;
    let mut row = places.iter().filter(|it| it.row == field.row);
    let id = row.find(|it| it.path == "id");
    Some((field, id.map_or("", |it| it.value)))
}

/// The first place of what reads as a number and has no value.
pub(crate) fn no_number(text: &str) -> Option<(usize, usize)> {
    let is_none = |token: &Token<'_>| {
        let Token::Word(word) = token else {
            return false;
        };
        matches!(word.trim_start_matches(['-', '+']), "inf" | "NaN")
    };
    let mut tokens = tokens(text).into_iter();
    tokens.find(|(token, _)| is_none(token)).map(|(_, at)| at)
}

fn tokens(text: &str) -> Vec<(Token<'_>, (usize, usize))> {
    let mut found = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let mut rest = line;
        while let Some(first) = rest.chars().next() {
            let at = (number + 1, line.len() - rest.len() + 1);
            let (token, length) = match first {
                '/' if rest.starts_with("//") => break,
                '(' | '[' | '{' => (Some(Token::Open), 1),
                ')' | ']' | '}' => (Some(Token::Close), 1),
                ':' => (Some(Token::Colon), 1),
                '"' => {
                    let length = quoted(rest);
                    (
                        Some(Token::Text(rest[1..length].trim_end_matches('"'))),
                        length,
                    )
                }
                c if is_of_word(c) => {
                    let length = rest.find(|c| !is_of_word(c)).unwrap_or(rest.len());
                    (Some(Token::Word(&rest[..length])), length)
                }
                other => (None, other.len_utf8()),
            };
            found.extend(token.map(|token| (token, at)));
            rest = &rest[length..];
        }
    }
    found
}

fn is_of_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '_' | '.' | '-' | '+')
}

/// How long a text in quotes is that a line begins with, in bytes with both quotes.
fn quoted(line: &str) -> usize {
    let mut escaped = false;
    for (at, c) in line.char_indices().skip(1) {
        if c == '"' && !escaped {
            return at + 1;
        }
        escaped = c == '\\' && !escaped;
    }
    line.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "// id: \"none\"\n[ (id: \"a: (\", held: (up: -1.5e3, by: [(1, 2)]), many: 3), // many: 4\n (\n  \
                        what: \"\\\"id: b\",\n  id: \"b\",\n  held: Some(Deep(up: NaN)))]";

    #[test]
    fn fields_are_found_wherever_they_stand_and_nothing_in_texts_and_comments_is_one() {
        let all = places(TEXT);
        let found: Vec<_> = all
            .iter()
            .map(|it| (it.row, it.path.as_str(), it.at))
            .collect();
        assert_eq!(
            found,
            [
                (0, "id", (2, 4)),
                (0, "held", (2, 16)),
                (0, "held.up", (2, 23)),
                (0, "held.by", (2, 35)),
                (0, "many", (2, 50)),
                (1, "what", (4, 3)),
                (1, "id", (5, 3)),
                (1, "held", (6, 3)),
                (1, "held.up", (6, 19)),
            ]
        );
        assert_eq!(line_of(&all, 1, "held.up"), 6);
        assert_eq!(line_of(&all, 1, "many"), 4, "of a missing field its row's");
        let at = |at| field_at(&all, at).map(|(field, id)| (field.path.as_str(), id));
        assert_eq!(at((2, 28)), Some(("held.up", "a: (")));
        assert_eq!(at((1, 1)), None);
        assert_eq!(no_number(TEXT), Some((6, 23)));
    }
}
