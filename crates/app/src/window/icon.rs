//! The window's icon, where the system takes one from the window; others know it by the desktop file.

use image::ImageFormat;
use winit::window::Icon;

const PNG: &[u8] = include_bytes!("../../../../assets/icon/antipode.png");

/// The icon; none where it cannot be read, which is no reason to have no window.
pub fn icon() -> Option<Icon> {
    let picture = image::load_from_memory_with_format(PNG, ImageFormat::Png).ok()?;
    let (width, height) = (picture.width(), picture.height());
    Icon::from_rgba(picture.into_rgba8().into_raw(), width, height).ok()
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_icon_can_be_read() {
        assert!(super::icon().is_some());
    }
}
