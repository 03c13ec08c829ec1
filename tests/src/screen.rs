//! Pictures of windows of an X server, without a program between: a look costs milliseconds, so tests may look often.
#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::missing_panics_doc,
    reason = "a helper of tests fails by panicking"
)]

use image::RgbImage;
use x11rb::errors::ReplyError;
use x11rb::protocol::xproto::{
    AutoRepeatMode, ChangeKeyboardControlAux, ConnectionExt, ImageFormat,
};
use x11rb::rust_connection::RustConnection;

/// A display that can be looked at.
#[derive(Debug)]
pub struct Screen {
    connection: RustConnection,
}

impl Screen {
    /// Connects, and keeps held keys from repeating themselves: on a busy machine half a second may pass before the
    /// program that lets go of a key has begun.
    ///
    /// # Panics
    /// When there is no such display.
    pub fn connect(display: &str) -> Self {
        let (connection, _) = RustConnection::connect(Some(display)).expect("a display");
        let once = ChangeKeyboardControlAux::new().auto_repeat_mode(AutoRepeatMode::OFF);
        let asked = connection.change_keyboard_control(&once);
        let taken = asked.ok().and_then(|cookie| cookie.check().ok());
        taken.expect("keys that do not repeat themselves");
        Self { connection }
    }

    /// What a window shows.
    ///
    /// # Errors
    /// When the window is gone or just then changes its size, or lies partly beside the screen.
    ///
    /// # Panics
    /// When its pixels are not of 24 bits in 32.
    pub fn picture(&self, window: u32) -> Result<RgbImage, ReplyError> {
        let size = self.connection.get_geometry(window)?.reply()?;
        let (width, height) = (size.width, size.height);
        let asked = self.connection.get_image(
            ImageFormat::Z_PIXMAP,
            window,
            0,
            0,
            width,
            height,
            u32::MAX,
        )?;
        let data = asked.reply()?.data;
        let (width, height) = (u32::from(width), u32::from(height));
        assert_eq!(
            data.len(),
            (4 * width * height) as usize,
            "pixels of 32 bits"
        );
        // Little-endian words of 0x00RRGGBB, as every server that runs beside us has them.
        let rgb = data
            .chunks_exact(4)
            .flat_map(|pixel| [pixel[2], pixel[1], pixel[0]]);
        Ok(RgbImage::from_raw(width, height, rgb.collect()).expect("as many pixels as there are"))
    }
}
