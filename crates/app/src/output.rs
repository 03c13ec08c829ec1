//! Prints for the program: answers on standard output, mistakes and the log on standard error. Nothing else may open
//! either (`clippy.toml` beside this crate), so whatever is printed is escaped here: names, words of scripts and paths
//! come from outside, and a terminal obeys the control characters in them. A full disk or a reader that has gone is a
//! failure here, never a panic.

use std::backtrace::{Backtrace, BacktraceStatus};
use std::borrow::Cow;
use std::fmt::Write as _;
use std::io::{self, Write};
use std::panic::PanicHookInfo;

use antipode_storage::is_unprintable;
use tracing_subscriber::fmt::MakeWriter;

use crate::failure::Failure;

/// The text as one line in which nothing controls a terminal, turns the order of the text round or cannot be seen: such
/// characters are written as JSON writes them, so that a line of JSON stays one and means the same.
pub fn escaped(text: &str) -> Cow<'_, str> {
    if !text.contains(is_unprintable) {
        return Cow::Borrowed(text);
    }
    let mut safe = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        match c {
            '\n' => safe.push_str("\\n"),
            '\r' => safe.push_str("\\r"),
            '\t' => safe.push_str("\\t"),
            c if is_unprintable(c) => {
                for unit in c.encode_utf16(&mut [0; 2]) {
                    // Formatting into a String does not fail.
                    let _ = write!(safe, "\\u{unit:04x}");
                }
            }
            c => safe.push(c),
        }
    }
    Cow::Owned(safe)
}

/// The lines of a text, each [`escaped`].
pub fn escaped_lines(text: &str) -> String {
    text.lines()
        .flat_map(|line| [escaped(line), "\n".into()])
        .collect()
}

/// Prints a line on standard output.
///
/// # Errors
/// When standard output is full or closed.
#[expect(clippy::disallowed_methods, reason = "the one place that prints")]
pub fn line(text: &str) -> Result<(), Failure> {
    write_line(&mut io::stdout().lock(), text)
}

/// Prints a text of several lines on standard output.
///
/// # Errors
/// As [`line()`].
pub fn lines(text: &str) -> Result<(), Failure> {
    text.lines().try_for_each(line)
}

/// Says on standard error what went wrong. Where even that cannot be written, the exit status must do.
#[expect(clippy::disallowed_methods, reason = "the one place that prints")]
pub fn complain(text: &str) {
    let _ = writeln!(io::stderr().lock(), "antipode: {}", escaped(text));
}

/// Says on standard error that the program has a fault, as the standard library does.
pub fn complain_of_panic(panic: &PanicHookInfo<'_>) {
    let thread = std::thread::current();
    let name = thread.name().unwrap_or("unnamed");
    complain(&format!(
        "thread {name} {}",
        panic.to_string().replace('\n', " ")
    ));
    let trace = Backtrace::capture();
    if trace.status() == BacktraceStatus::Captured {
        trace.to_string().lines().for_each(complain);
    }
}

fn write_line(out: &mut impl Write, text: &str) -> Result<(), Failure> {
    writeln!(out, "{}", escaped(text))
        .and_then(|()| out.flush())
        .map_err(|e| Failure::Runtime(format!("Standard output cannot be written: {e}")))
}

/// Where the log of the terminal goes.
#[expect(clippy::disallowed_methods, reason = "the one place that prints")]
pub fn log_to_terminal() -> Escaping<fn() -> io::Stderr> {
    Escaping(io::stderr)
}

/// Writers of a log whose events come out as one [`escaped`] line each.
#[derive(Clone, Debug)]
pub struct Escaping<M>(pub M);

impl<'a, M: MakeWriter<'a>> MakeWriter<'a> for Escaping<M> {
    type Writer = EscapingWriter<M::Writer>;

    fn make_writer(&'a self) -> Self::Writer {
        EscapingWriter(self.0.make_writer())
    }
}

/// Writes whole events, as the log hands them over.
#[derive(Debug)]
pub struct EscapingWriter<W>(W);

impl<W: Write> Write for EscapingWriter<W> {
    fn write(&mut self, event: &[u8]) -> io::Result<usize> {
        let text = String::from_utf8_lossy(event);
        let body = text.strip_suffix('\n').unwrap_or(&text);
        self.0
            .write_all(format!("{}\n", escaped(body)).as_bytes())?;
        Ok(event.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Full;

    impl Write for Full {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(io::ErrorKind::StorageFull.into())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn what_a_terminal_would_obey_is_written_out_and_the_rest_is_left() {
        let evil = "a\u{1b}[2J\u{9b}1m\u{7f}\n\r\t\u{202e}\u{2066}\u{2028}\u{e0041}z";
        let safe = escaped(evil);
        assert_eq!(
            safe,
            r"a\u001b[2J\u009b1m\u007f\n\r\t\u202e\u2066\u2028\udb40\udc41z"
        );
        for plain in ["", "Żółw №1 世界 👩\u{200d}🚀 \"q\" \\n", "שלום"] {
            assert!(matches!(escaped(plain), Cow::Borrowed(same) if same == plain));
        }
        assert_eq!(escaped_lines("a\nb\u{7}"), "a\nb\\u0007\n");
    }

    #[test]
    fn a_line_of_json_stays_one_and_means_the_same() {
        let name = "a\u{9b}\u{7f}\u{202e}\u{e0041}\u{1b}\n";
        let json = serde_json::json!({ "name": name }).to_string();
        let read: Option<serde_json::Value> = serde_json::from_str(&escaped(&json)).ok();
        assert_eq!(read.map(|read| read["name"].clone()), Some(name.into()));
    }

    #[test]
    fn an_event_of_the_log_is_one_line() {
        let mut out = EscapingWriter(Vec::new());
        assert!(out.write_all(b"WARN a\nb\x1b[2J\n").is_ok());
        assert_eq!(String::from_utf8_lossy(&out.0), "WARN a\\nb\\u001b[2J\n");
    }

    #[test]
    fn a_line_that_cannot_be_written_is_a_failure_in_words() {
        let mut there = Vec::new();
        assert!(write_line(&mut there, "hello").is_ok());
        assert_eq!(there, b"hello\n");
        let said = write_line(&mut Full, "hello").map_err(|failure| failure.to_string());
        assert!(said.is_err_and(|words| words.starts_with("Standard output cannot be written")));
    }
}
