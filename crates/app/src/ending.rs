//! The end from outside: the system or the terminal asks the program to stop, and what is open is saved first.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

use crate::failure::Failure;

/// The signals that ask for an end. `SIGHUP` says that the terminal has gone, which Windows has no signal for.
#[cfg(unix)]
const SIGNALS: [i32; 3] = [SIGTERM, SIGINT, signal_hook::consts::SIGHUP];
#[cfg(not(unix))]
const SIGNALS: [i32; 2] = [SIGTERM, SIGINT];

/// A file that grows past the system's limit is a failed write, told as such, and not the end of the program, which
/// is what the system makes of it unless somebody listens to its signal.
pub fn outlive_file_limits() {
    #[cfg(unix)]
    {
        let heard = Arc::new(AtomicBool::new(false));
        if let Err(error) = flag::register(signal_hook::consts::SIGXFSZ, heard) {
            tracing::warn!("a limit on the size of files will end the program: {error}");
        }
    }
}

/// Whether the program was asked to end.
#[derive(Clone, Debug, Default)]
pub struct Ending {
    signal: Arc<AtomicUsize>,
}

impl Ending {
    /// Listens from now on. The first signal is taken as a wish, the next one of its kind ends the program as it
    /// always did: somebody who asks twice does not want to wait.
    pub fn listen() -> Self {
        let ending = Self::default();
        for signal in SIGNALS {
            let asked = Arc::new(AtomicBool::new(false));
            // In this order, or the first signal would be taken for the second.
            let registered = flag::register_conditional_default(signal, Arc::clone(&asked))
                .and_then(|_| flag::register(signal, asked))
                .and_then(|_| {
                    flag::register_usize(signal, Arc::clone(&ending.signal), signal as usize)
                });
            if let Err(error) = registered {
                tracing::warn!("signal {signal} will not be heard: {error}");
            }
        }
        ending
    }

    /// The signal that asked for the end, if one did.
    pub fn asked(&self) -> Option<i32> {
        match self.signal.load(Ordering::Relaxed) {
            0 => None,
            signal => i32::try_from(signal).ok(),
        }
    }

    /// Goes on only if nothing asked for the end.
    ///
    /// # Errors
    /// [`Failure::Stopped`] with the signal.
    pub fn check(&self) -> Result<(), Failure> {
        match self.asked() {
            Some(signal) => Err(Failure::Stopped(signal)),
            None => Ok(()),
        }
    }
}

#[cfg(all(test, unix))]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use super::*;

    #[test]
    fn the_first_signal_is_a_wish() {
        let ending = Ending::listen();
        assert_eq!(ending.asked(), None);
        assert!(ending.check().is_ok());
        // Of the three the one that no test runner sends.
        let hangup = signal_hook::consts::SIGHUP;
        signal_hook::low_level::raise(hangup).unwrap();
        assert_eq!(ending.asked(), Some(hangup));
        let stopped = ending.check().unwrap_err();
        assert_eq!(stopped.exit_status(), 129);
        assert!(stopped.to_string().contains("saved"), "{stopped}");
    }
}
