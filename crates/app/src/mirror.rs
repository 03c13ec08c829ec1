//! The rear mirror: what is drawn in it, and where in a picture.

use antipode_render::{FurtherView, ViewTarget};
use antipode_scene::frame::{Frame, View};

/// A mirror that fits its place in a picture.
#[derive(Clone, Debug)]
pub struct Mirror {
    view: View,
    corner: (u32, u32),
    size: (u32, u32),
}

impl Mirror {
    /// That of a frame, if it has one, in a picture `drawn` pixels wide and high.
    pub fn of(frame: &Frame, drawn: (u32, u32)) -> Option<Self> {
        let (width, height) = drawn;
        let mut view = frame.mirror.clone()?;
        let place = antipode_ui::mirror_place(width as f32, height as f32);
        let (corner, size) = (place.min.round(), place.size().round());
        let size = (size.x as u32, size.y as u32);
        if size.0 == 0 || size.1 == 0 {
            return None;
        }
        view.projection.sx = view.projection.sy * f64::from(size.1) / f64::from(size.0);
        Some(Self {
            view,
            corner: (corner.x as u32, corner.y as u32),
            size,
        })
    }

    /// What the renderer is to draw.
    pub fn further(&self) -> FurtherView<'_> {
        FurtherView {
            view: &self.view,
            size: self.size,
            target: ViewTarget::Mirror(self.corner),
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use antipode_geometry::Geometry;
    use antipode_scene::{Scene, WorldSetup};
    use antipode_settings::{Given, Settings};

    use super::*;
    use crate::options::fit_mirror;

    fn mirrored() -> Frame {
        let setup = WorldSetup {
            name: "Mirror".to_owned(),
            seed: 1,
            geometry: Geometry::Euclidean,
            radius_m: 32.0,
            generator: antipode_scene::Generator::OneBiome,
            mode: antipode_scene::Mode::default(),
            view_distance: 1,
        };
        let mut frame = Scene::open(setup, None).unwrap().frame(1.2, 1.5, 1);
        assert!(frame.mirror.is_none(), "nobody drives");
        frame.mirror = Some(frame.view.clone());
        frame
    }

    #[test]
    fn it_lies_in_the_picture_and_is_as_wide_as_its_place_at_any_size() {
        let frame = mirrored();
        for (width, height) in [(1280, 720), (97, 61), (3440, 1440), (400, 900)] {
            let mirror = Mirror::of(&frame, (width, height)).unwrap();
            assert!(mirror.corner.0 + mirror.size.0 <= width);
            assert!(mirror.corner.1 + mirror.size.1 <= height);
            let projection = &mirror.view.projection;
            let aspect = f64::from(mirror.size.0) / f64::from(mirror.size.1);
            assert!((projection.sy / projection.sx - aspect).abs() < 1e-9);
        }
        assert!(Mirror::of(&frame, (3, 2)).is_none());
    }

    #[test]
    fn it_is_there_with_a_graphics_card_and_in_software_if_asked_for() {
        let mut settings = Settings::default();
        let mut has_mirror = |word: &str, software: bool| {
            settings.set("rear-mirror", Given::Word(word)).unwrap();
            let mut frame = mirrored();
            fit_mirror(&mut frame, &settings, software);
            frame.mirror.is_some()
        };
        assert!(has_mirror("auto", false) && !has_mirror("auto", true));
        assert!(has_mirror("on", false) && has_mirror("on", true));
        assert!(!has_mirror("off", false) && !has_mirror("off", true));
    }
}
