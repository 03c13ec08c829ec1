//! Waiting for others who look into a store: making the list of worlds looks into each, which must not keep a world
//! from being played.

use std::time::Duration;

use crate::error::StorageError;

/// How long a look into a store takes at most, about.
const LOOK: Duration = Duration::from_millis(10);
/// How many looks to wait before a store counts as in use.
const LOOKS_WAITED_FOR: u32 = 15;

/// Does what needs a store's file, as often as it takes others to look into it.
pub(crate) fn patiently<T>(work: impl Fn() -> Result<T, StorageError>) -> Result<T, StorageError> {
    for _ in 0..LOOKS_WAITED_FOR {
        match work() {
            Err(StorageError::InUse { .. }) => std::thread::sleep(LOOK),
            result => return result,
        }
    }
    work()
}
