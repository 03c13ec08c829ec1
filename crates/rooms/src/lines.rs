//! Where in the text of a file each of its fields stands.
//!
//! The library that reads the text tells places of what it cannot read only; what it reads and this crate refuses has to
//! be found again. So the text is walked once more, by its brackets, names, commas and strings alone. A field is known
//! by its path: `objects[3].what.size`.

use std::fmt::Write;
use std::ops::Range;

/// Nothing of a room lies deeper; what does is not looked at.
const MOST_DEEP: usize = 24;

/// A bracket that is open.
struct Frame {
    is_list: bool,
    /// How long the path is without what is in this bracket.
    base: usize,
    index: usize,
    /// Where the field or element began that is being read.
    began: Option<usize>,
}

/// Walks a text.
struct Walk<'t, F> {
    text: &'t [u8],
    at: usize,
    path: String,
    open: Vec<Frame>,
    word: Range<usize>,
    seen: F,
}

/// Tells every field and element of a text, each when it ends: its path, and the bytes from the first of its name to
/// the last of its value. What the text leaves open ends where the text does. Stops when `seen` returns false.
fn walk(text: &str, seen: impl FnMut(&str, Range<usize>) -> bool) {
    let mut walk = Walk {
        text: text.as_bytes(),
        at: 0,
        path: String::new(),
        open: Vec::new(),
        word: 0..0,
        seen,
    };
    let mut goes_on = true;
    while goes_on && walk.at < walk.text.len() {
        goes_on = walk.step();
    }
    while goes_on && !walk.open.is_empty() {
        goes_on = walk.close();
    }
}

impl<F: FnMut(&str, Range<usize>) -> bool> Walk<'_, F> {
    /// Takes the next token; whether to go on.
    fn step(&mut self) -> bool {
        let byte = self.text[self.at];
        match byte {
            b'(' | b'[' | b'{' => self.opened(byte == b'['),
            b')' | b']' | b'}' => {
                let goes_on = self.close();
                self.at += 1;
                goes_on
            }
            b',' => {
                let goes_on = self.end();
                if let Some(frame) = self.open.last_mut() {
                    frame.index += 1;
                }
                self.at += 1;
                goes_on
            }
            b':' => {
                self.name();
                self.at += 1;
                true
            }
            b'/' if self.text.get(self.at + 1) == Some(&b'/') => {
                self.at += self
                    .rest()
                    .iter()
                    .position(|it| *it == b'\n')
                    .unwrap_or(self.rest().len());
                true
            }
            b'/' if self.text.get(self.at + 1) == Some(&b'*') => {
                self.comment();
                true
            }
            b'"' | b'\'' => {
                self.element(self.at);
                self.quoted(byte);
                true
            }
            _ if byte.is_ascii_alphanumeric() || byte == b'_' || byte == b'-' => {
                self.element(self.at);
                self.words();
                true
            }
            _ => {
                self.at += 1;
                true
            }
        }
    }

    /// Goes into a bracket; whether it is not too deep.
    fn opened(&mut self, is_list: bool) -> bool {
        self.element(self.at);
        self.at += 1;
        self.open.push(Frame {
            is_list,
            base: self.path.len(),
            index: 0,
            began: None,
        });
        self.open.len() <= MOST_DEEP
    }

    fn rest(&self) -> &[u8] {
        &self.text[self.at..]
    }

    /// In a list, notes that an element begins.
    fn element(&mut self, at: usize) {
        if let Some(frame) = self
            .open
            .last_mut()
            .filter(|it| it.is_list && it.began.is_none())
        {
            frame.began = Some(at);
            self.path.truncate(frame.base);
            // Writing into a string cannot fail.
            let _ = write!(self.path, "[{}]", frame.index);
        }
    }

    /// The word before a colon is the name of a field.
    fn name(&mut self) {
        let Some(frame) = self
            .open
            .last_mut()
            .filter(|it| !it.is_list && it.began.is_none())
        else {
            return;
        };
        frame.began = Some(self.word.start);
        self.path.truncate(frame.base);
        if frame.base > 0 {
            self.path.push('.');
        }
        self.path
            .push_str(&String::from_utf8_lossy(&self.text[self.word.clone()]));
    }

    /// Ends the field or element that is being read; whether to go on.
    fn end(&mut self) -> bool {
        let Some(frame) = self.open.last_mut() else {
            return true;
        };
        let Some(began) = frame.began.take() else {
            return true;
        };
        let value = &self.text[began..self.at];
        let blanks = value
            .iter()
            .rev()
            .take_while(|it| it.is_ascii_whitespace())
            .count();
        let goes_on = (self.seen)(&self.path, began..self.at - blanks);
        self.path.truncate(frame.base);
        goes_on
    }

    fn close(&mut self) -> bool {
        let goes_on = self.end();
        self.open.pop();
        goes_on
    }

    fn words(&mut self) {
        let is_part = |it: &u8| it.is_ascii_alphanumeric() || b"_-.+#".contains(it);
        let length = self.rest().iter().take_while(|it| is_part(it)).count();
        self.word = self.at..self.at + length;
        self.at += length;
        let hashes = self.text[self.word.clone()]
            .iter()
            .rev()
            .take_while(|it| **it == b'#')
            .count();
        let is_raw = self.text[self.word.start] == b'r' && self.word.len() == hashes + 1;
        if is_raw && self.rest().first() == Some(&b'"') {
            let end = [b"\"".as_slice(), &vec![b'#'; hashes]].concat();
            let body = &self.text[self.at + 1..];
            let found = body.windows(end.len()).position(|it| it == end);
            self.at = found.map_or(self.text.len(), |found| self.at + 1 + found + end.len());
        }
    }

    fn quoted(&mut self, quote: u8) {
        let mut at = self.at + 1;
        while let Some(byte) = self.text.get(at) {
            at += 1;
            if *byte == b'\\' {
                at += 1;
            } else if *byte == quote {
                break;
            }
        }
        self.at = at.min(self.text.len());
    }

    /// Comments of this kind lie in one another.
    fn comment(&mut self) {
        let mut deep = 0_u32;
        loop {
            match self.rest() {
                [b'/', b'*', ..] => {
                    deep += 1;
                    self.at += 2;
                }
                [b'*', b'/', ..] => {
                    deep -= 1;
                    self.at += 2;
                    if deep == 0 {
                        return;
                    }
                }
                [] => return,
                _ => self.at += 1,
            }
        }
    }
}

/// The line of a field, from 1; of the nearest one around it that the text has, or 1.
pub(crate) fn line_of(text: &str, path: &str) -> usize {
    let mut best: (usize, usize) = (0, 0);
    walk(text, |seen, range| {
        let is_around = path
            .strip_prefix(seen)
            .is_some_and(|rest| rest.is_empty() || rest.starts_with('.') || rest.starts_with('['));
        if is_around && seen.len() > best.0 {
            best = (seen.len(), range.start);
        }
        best.0 < path.len()
    });
    line_at(text.as_bytes(), best.1)
}

/// The line, from 1, of a byte of a text.
pub(crate) fn line_at(text: &[u8], at: usize) -> usize {
    text[..at].split(|it| *it == b'\n').count()
}

/// The innermost field that a byte of a text is in; none outside of all.
pub(crate) fn path_at(text: &str, at: usize) -> Option<String> {
    let mut found = None;
    walk(text, |seen, range| {
        if range.start <= at && at <= range.end {
            found = Some(seen.to_owned());
        }
        found.is_none()
    });
    found
}

/// Where a field's value stands in a text.
pub(crate) fn value_of(text: &str, path: &str) -> Option<Range<usize>> {
    let mut found = None;
    walk(text, |seen, range| {
        if seen == path {
            found = Some(range);
        }
        found.is_none()
    });
    let field = found?;
    let colon = text.get(field.clone())?.find(':')?;
    let value = &text[field.start + colon + 1..field.end];
    Some(field.end - value.trim_start().len()..field.end)
}

/// The byte of a line and column, both from 1, as the library that reads the text tells them.
pub(crate) fn byte_at(text: &str, line: usize, column: usize) -> usize {
    let start: usize = text
        .split_inclusive('\n')
        .take(line.saturating_sub(1))
        .map(str::len)
        .sum();
    let row = text.get(start..).unwrap_or_default();
    let offset = row
        .char_indices()
        .nth(column.saturating_sub(1))
        .map_or(row.len(), |(at, _)| at);
    start + offset
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r##"// A room. (, [ : "
(
    name: "Tunnel, with: (brackets [",  /* a /* nested */ comment, */
    gravity: (0, -9.81,
        0),
    raw: r#"quote " , (("#,
    objects: [
        (name: "floor", what: Box(size: (1, 2, 3))),
        (
            name: 'c',
            what: Aberration(
                half: (1, 1, 1),
                felt: -7,
            ),
        ),
    ],
)
"##;

    #[test]
    fn fields_are_found_by_their_path() {
        for (path, line) in [
            ("name", 3),
            ("gravity", 4),
            ("raw", 6),
            ("objects", 7),
            ("objects[0]", 8),
            ("objects[0].what.size", 8),
            ("objects[1]", 9),
            ("objects[1].name", 10),
            ("objects[1].what", 11),
            ("objects[1].what.half", 12),
            ("objects[1].what.felt", 13),
            // What is not there is told of what is around it.
            ("objects[1].at", 9),
            ("objects[1].what.sides", 11),
            ("objects[12].at", 7),
            ("fog.reach", 1),
        ] {
            assert_eq!(line_of(TEXT, path), line, "{path}");
        }
    }

    #[test]
    fn places_are_in_fields_and_values_have_places() {
        let at = |what: &str| TEXT.find(what).and_then(|at| path_at(TEXT, at));
        assert_eq!(at("-7").as_deref(), Some("objects[1].what.felt"));
        assert_eq!(at("-9.81").as_deref(), Some("gravity"));
        assert_eq!(at("A room"), None);
        assert_eq!(
            value_of(TEXT, "name").map(|it| &TEXT[it]),
            Some("\"Tunnel, with: (brackets [\"")
        );
        assert_eq!(value_of(TEXT, "nothing"), None);
        assert_eq!(&TEXT[byte_at(TEXT, 13, 23)..][..2], "-7");
        assert_eq!(byte_at("ä", 1, 2), 2);
        assert_eq!(byte_at("", 9, 9), 0);
    }

    #[test]
    fn what_is_broken_off_is_told_as_well() {
        let text = "(objects: [(name: \"a\", what: Box(size: (1, oops";
        assert_eq!(
            path_at(text, text.len()).as_deref(),
            Some("objects[0].what.size")
        );
        for cut in 0..TEXT.len() {
            if let Some(part) = TEXT.get(..cut) {
                line_of(part, "objects[1].what.felt");
                path_at(part, cut);
            }
        }
    }
}
