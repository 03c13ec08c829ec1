//! Passes a window's state to the interface before each pass.

use super::Stage;

impl Stage {
    /// What has happened since it was last taken. The size is that of the picture: to ask the window for its own is to
    /// wait for the window system, in each frame and however busy that is.
    pub fn take_input(&mut self) -> egui::RawInput {
        let scale = self.window.scale_factor() as f32;
        let (width, height) = self.size();
        let points = scale * self.overlay.context().zoom_factor();
        let size = egui::vec2(width as f32, height as f32) / points;
        let input = self.input.egui_input_mut();
        input.time = Some(self.began.elapsed().as_secs_f64());
        input.screen_rect = Some(egui::Rect::from_min_size(egui::Pos2::ZERO, size));
        input.viewport_id = egui::ViewportId::ROOT;
        input
            .viewports
            .entry(egui::ViewportId::ROOT)
            .or_default()
            .native_pixels_per_point = Some(scale);
        input.take()
    }
}
