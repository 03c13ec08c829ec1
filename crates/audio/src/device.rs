//! The system's sound device as a backend for kira: kira's own gives up on a device that went away, and says so by
//! a panic of a thread; this one only notes it, and whoever sees that opens another.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use cpal::traits::{DeviceTrait, HostTrait, StreamTrait};
use cpal::{
    BufferSize, Error, ErrorKind, FromSample, SampleFormat, SizedSample, StreamConfig,
    SupportedBufferSize,
};
use kira::backend::{Backend, Renderer};
use thiserror::Error;

/// Why no device plays.
#[derive(Debug, Error)]
pub(crate) enum DeviceError {
    #[error("there is no sound device")]
    None,
    #[error("the sound device wants samples as {0}, which the game does not make")]
    Format(SampleFormat),
    #[error("the sound device does not work ({0})")]
    Cpal(Error),
}

impl From<Error> for DeviceError {
    fn from(error: Error) -> Self {
        match error.kind() {
            ErrorKind::DeviceNotAvailable | ErrorKind::HostUnavailable => Self::None,
            _ => Self::Cpal(error),
        }
    }
}

/// Errors in a row, without a single sample asked for between them, after which a stream is given up. One that is
/// late on a busy machine has one or two.
const MOST_FAILURES: u32 = 20;

/// Frames that are made at a time, where the device lets us choose: late by 43 ms at 48 kHz, which no step shows,
/// and enough not to run dry where the processor draws the picture, too.
const BUFFER_FRAMES: u32 = 2048;

/// How a stream is doing; shared with the driver's thread.
#[derive(Debug, Default)]
pub(crate) struct Health {
    /// Errors since samples were last asked for.
    failures: AtomicU32,
}

impl Health {
    /// Whether the stream is over.
    pub fn is_lost(&self) -> bool {
        self.failures.load(Ordering::Relaxed) >= MOST_FAILURES
    }

    fn is_well(&self) {
        if !self.is_lost() {
            self.failures.store(0, Ordering::Relaxed);
        }
    }

    fn fails(&self, kind: ErrorKind) {
        use ErrorKind::{DeviceNotAvailable, HostUnavailable, StreamInvalidated};
        match kind {
            DeviceNotAvailable | HostUnavailable | StreamInvalidated => {
                self.failures.store(MOST_FAILURES, Ordering::Relaxed);
            }
            ErrorKind::DeviceChanged | ErrorKind::RealtimeDenied => {}
            _ if self.is_lost() => {}
            _ => {
                self.failures.fetch_add(1, Ordering::Relaxed);
            }
        }
    }
}

/// An output of the default device.
pub(crate) struct Device {
    output: cpal::Device,
    config: StreamConfig,
    format: SampleFormat,
    health: Arc<Health>,
    /// Plays until it is dropped.
    stream: Option<cpal::Stream>,
}

impl Backend for Device {
    /// To tell how it is doing.
    type Settings = Arc<Health>;
    type Error = DeviceError;

    fn setup(health: Arc<Health>, _: usize) -> Result<(Self, u32), DeviceError> {
        hush();
        let output = cpal::default_host()
            .default_output_device()
            .ok_or(DeviceError::None)?;
        let supported = output.default_output_config()?;
        let mut config = supported.config();
        if let SupportedBufferSize::Range { min, max } = supported.buffer_size() {
            config.buffer_size = BufferSize::Fixed(BUFFER_FRAMES.clamp(*min, *max));
        }
        let backend = Self {
            output,
            config,
            format: supported.sample_format(),
            health,
            stream: None,
        };
        Ok((backend, config.sample_rate))
    }

    fn start(&mut self, renderer: Renderer) -> Result<(), DeviceError> {
        let stream = match self.format {
            SampleFormat::F32 => self.stream::<f32>(renderer),
            SampleFormat::I16 => self.stream::<i16>(renderer),
            SampleFormat::I32 => self.stream::<i32>(renderer),
            SampleFormat::U16 => self.stream::<u16>(renderer),
            other => return Err(DeviceError::Format(other)),
        }?;
        stream.play()?;
        self.stream = Some(stream);
        Ok(())
    }
}

impl Device {
    fn stream<T: SizedSample + FromSample<f32>>(
        &self,
        mut renderer: Renderer,
    ) -> Result<cpal::Stream, Error> {
        let channels = self.config.channels;
        let (playing, failing) = (Arc::clone(&self.health), Arc::clone(&self.health));
        let mut mixed = Vec::new();
        let fill = move |out: &mut [T], _: &cpal::OutputCallbackInfo| {
            playing.is_well();
            mixed.resize(out.len(), 0.0);
            renderer.on_start_processing();
            renderer.process(&mut mixed, channels);
            for (sample, mixed) in out.iter_mut().zip(&mixed) {
                *sample = T::from_sample(*mixed);
            }
        };
        let fail = move |error: Error| {
            // Drivers repeat themselves thousands of times.
            if failing.failures.load(Ordering::Relaxed) == 0 {
                tracing::debug!("sound: {error}");
            }
            failing.fails(error.kind());
        };
        self.output
            .build_output_stream(self.config, fill, fail, None)
    }
}

/// Keeps to itself, on this thread from now on, what the library of Linux's sound system would write on standard
/// error where there is no device. Called anew it drops what it kept.
#[cfg(target_os = "linux")]
fn hush() {
    // Where that fails the library writes.
    let _ = alsa::Output::local_error_handler();
}

#[cfg(not(target_os = "linux"))]
fn hush() {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_device_that_has_gone_is_lost_at_once_and_for_good() {
        for kind in [
            ErrorKind::DeviceNotAvailable,
            ErrorKind::StreamInvalidated,
            ErrorKind::HostUnavailable,
        ] {
            let health = Health::default();
            health.fails(kind);
            health.is_well();
            assert!(health.is_lost(), "{kind:?}");
        }
    }

    #[test]
    fn a_stream_that_stumbles_is_kept_and_one_that_only_fails_is_given_up() {
        let health = Health::default();
        for _ in 0..100 {
            health.fails(ErrorKind::Xrun);
            health.fails(ErrorKind::BackendError);
            health.is_well();
        }
        assert!(!health.is_lost());
        for _ in 0..100 {
            health.fails(ErrorKind::DeviceChanged);
        }
        assert!(!health.is_lost());
        for _ in 0..MOST_FAILURES {
            health.fails(ErrorKind::BackendError);
        }
        assert!(health.is_lost());
    }
}
