//! How a store is opened while others look into it.

use std::path::Path;
use std::time::Duration;

use crate::error::StorageError;
use crate::store::Store;

/// How long a look into a store takes at most, about.
const LOOK: Duration = Duration::from_millis(10);
/// How many looks to wait before a store counts as in use.
const LOOKS_WAITED_FOR: u32 = 15;

/// How a store is opened: to be written or to be read.
pub(crate) type Opener = fn(&Path, &str) -> Result<Store, StorageError>;

/// Opens a store, waiting a moment for whoever has it: making the list of worlds
/// looks into each, which must not keep a world from being played.
pub(crate) fn open_store(path: &Path, label: &str, opener: Opener) -> Result<Store, StorageError> {
    patiently(|| opener(path, label))
}

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
