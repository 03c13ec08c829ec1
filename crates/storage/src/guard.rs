//! Calls into the embedded store, with its panics turned into errors.
//!
//! The store compares page checksums after a crash only, so a bit flipped in a
//! closed file may reach code that asserts. Such a panic says that the file is
//! damaged and nothing else. It is caught here, and kept from the screen.

use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe};
use std::path::Path;
use std::sync::Once;

use crate::error::StorageError;

thread_local! {
    static GUARDED: Cell<bool> = const { Cell::new(false) };
}

/// Whether this thread is inside a call whose panic becomes a [`StorageError`]. A
/// panic hook set after the first use of this crate should ask, and say nothing then.
pub fn is_guarded() -> bool {
    GUARDED.get()
}

/// Runs `work`; a panic inside means that the store at `path` is damaged. Nothing
/// that `work` touches is used again but the store, which refuses to go on by itself.
pub(crate) fn guard<T>(
    path: &Path,
    work: impl FnOnce() -> Result<T, StorageError>,
) -> Result<T, StorageError> {
    hush();
    let outer = GUARDED.replace(true);
    let result = panic::catch_unwind(AssertUnwindSafe(work));
    GUARDED.set(outer);
    result.unwrap_or_else(|_| {
        Err(StorageError::unreadable(
            path,
            "its index contradicts itself",
        ))
    })
}

/// Puts a hook before the one there is, which would print a stack where the player
/// is about to get a sentence. Once per process, as hooks belong to the process.
fn hush() {
    static HUSHED: Once = Once::new();
    HUSHED.call_once(|| {
        let loud = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            if is_guarded() {
                tracing::debug!(%info, "the embedded store gave up on a damaged file");
            } else {
                loud(info);
            }
        }));
    });
}

#[cfg(test)]
mod tests {
    #![allow(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        reason = "tests fail by panicking"
    )]

    use super::*;

    #[test]
    fn a_panic_becomes_a_sentence_and_the_guard_ends() {
        let path = Path::new("x/world.redb");
        let caught: Result<(), _> = guard(path, || {
            assert!(is_guarded());
            let inner: Result<(), _> = guard(path, || panic!("inner"));
            assert!(inner.is_err() && is_guarded());
            panic!("outer")
        });
        let sentence = caught.unwrap_err().to_string();
        assert!(
            sentence.contains("x/world.redb cannot be read"),
            "{sentence}"
        );
        assert!(!is_guarded());
        assert_eq!(guard(path, || Ok(7)).unwrap(), 7);
    }
}
