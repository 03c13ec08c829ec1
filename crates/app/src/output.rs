//! What the program prints. A full disk or a reader that has gone is a failure here, never a panic.

use std::io::Write;

use crate::failure::Failure;

/// Prints a line on standard output.
///
/// # Errors
/// When standard output is full or closed.
pub fn line(text: &str) -> Result<(), Failure> {
    write_line(&mut std::io::stdout().lock(), text)
}

/// Says on standard error what went wrong. Where even that cannot be written, the exit status must do.
pub fn complain(text: &str) {
    let _ = writeln!(std::io::stderr().lock(), "antipode: {text}");
}

fn write_line(out: &mut impl Write, text: &str) -> Result<(), Failure> {
    writeln!(out, "{text}")
        .and_then(|()| out.flush())
        .map_err(|e| Failure::Runtime(format!("Standard output cannot be written: {e}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Full;

    impl Write for Full {
        fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
            Err(std::io::ErrorKind::StorageFull.into())
        }

        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
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
