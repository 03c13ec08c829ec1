//! Just enough of Rust's grammar to tell strings from comments and to find calls.

/// A piece of source.
#[derive(Clone, Debug, PartialEq)]
pub enum Token {
    /// A name or a number.
    Word(String),
    /// What a string says, escapes as they are written.
    Text(String),
    /// Any other character.
    Mark(char),
}

impl Token {
    /// What a string says.
    pub fn text(&self) -> Option<&str> {
        match self {
            Self::Text(text) => Some(text),
            _ => None,
        }
    }
}

/// The tokens of a source, without comments and blanks.
pub fn of(source: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut rest = source;
    while let Some(c) = rest.chars().next() {
        rest = if let Some(comment) = rest.strip_prefix("//") {
            comment.split_once('\n').map_or("", |(_, rest)| rest)
        } else if let Some(comment) = rest.strip_prefix("/*") {
            comment.split_once("*/").map_or("", |(_, rest)| rest)
        } else if let Some((text, rest)) = raw_string(rest) {
            tokens.push(Token::Text(text.to_owned()));
            rest
        } else if c == '"' {
            let length = string_length(&rest[1..]);
            tokens.push(Token::Text(rest[1..=length].to_owned()));
            rest.get(length + 2..).unwrap_or("")
        } else if c == '\'' {
            after_quote(rest)
        } else if c.is_alphanumeric() || c == '_' {
            let is_part = |c: char| c.is_alphanumeric() || c == '_';
            let end = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
            tokens.push(Token::Word(rest[..end].to_owned()));
            &rest[end..]
        } else {
            if !c.is_whitespace() {
                tokens.push(Token::Mark(c));
            }
            &rest[c.len_utf8()..]
        };
    }
    tokens
}

/// Bytes up to the quote that ends a string.
fn string_length(text: &str) -> usize {
    let mut escaped = false;
    text.find(|c| {
        let ends = c == '"' && !escaped;
        escaped = c == '\\' && !escaped;
        ends
    })
    .unwrap_or(text.len())
}

fn raw_string(rest: &str) -> Option<(&str, &str)> {
    let marked = rest.strip_prefix('r')?;
    let text = marked.trim_start_matches('#');
    let end = format!("\"{}", &marked[..marked.len() - text.len()]);
    text.strip_prefix('"')?.split_once(end.as_str())
}

/// What follows a character, or the quote of a lifetime.
fn after_quote(rest: &str) -> &str {
    let mut chars = rest[1..].chars();
    let (first, second) = (chars.next(), chars.next());
    match (first, second) {
        (Some('\\'), Some(escaped)) => {
            let after = 2 + escaped.len_utf8();
            rest[after..].split_once('\'').map_or("", |(_, rest)| rest)
        }
        (Some(c), Some('\'')) => &rest[2 + c.len_utf8()..],
        _ => &rest[1..],
    }
}

/// All up to the tests at the end of a file.
pub fn without_tests(mut tokens: Vec<Token>) -> Vec<Token> {
    let word = |name: &str| Token::Word(name.to_owned());
    let mark = Token::Mark;
    let tests = [
        mark('#'),
        mark('['),
        word("cfg"),
        mark('('),
        word("test"),
        mark(')'),
        mark(']'),
        word("mod"),
        word("tests"),
        mark('{'),
    ];
    let begin = tokens
        .windows(tests.len())
        .position(|window| window == tests);
    tokens.truncate(begin.unwrap_or(tokens.len()));
    tokens
}

#[test]
fn strings_are_told_from_comments_and_characters() {
    let source = r##"a.b("c\"d", '"', '\'', 'x /* "e" */ // "f"
        r#"g"h"#, '\u{1f}')"##;
    let texts: Vec<_> = of(source)
        .into_iter()
        .filter_map(|token| token.text().map(str::to_owned))
        .collect();
    assert_eq!(texts, ["c\\\"d", "g\"h"]);
}
