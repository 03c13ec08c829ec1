//! A frame of the window: the world or the room, the interface over it, and the pictures that are taken with it.

use antipode_render::{FurtherView, Offscreen, Picture, ViewTarget};
use antipode_scene::frame::{Frame, View};

use super::Stage;
use super::pictures::THUMBNAIL;
use crate::failure::Failure;
use crate::mirror::Mirror;
use crate::room_picture::RoomView;
use crate::window::portrait::PortraitView;
use crate::window::waits::{Part, Waits};

/// Colour behind the menu when no world is open, linear light.
const BACKDROP: wgpu::Color = wgpu::Color {
    r: 0.012,
    g: 0.018,
    b: 0.035,
    a: 1.0,
};

/// What a frame of the window shows, and what is kept of it.
pub struct Showing<'a> {
    /// The world or the room.
    pub scene: SceneShown<'a>,
    /// The interface over it.
    pub interface: egui::FullOutput,
    /// Whether what is shown is read back, too.
    pub keeps: bool,
    /// The view of the menu's picture that is to be taken with it, and what the picture is to come back with.
    pub thumbnail: Option<(u64, PortraitView)>,
}

/// What is behind the interface.
#[derive(Clone, Copy)]
pub enum SceneShown<'a> {
    /// Nothing.
    Nothing,
    /// A world.
    World(&'a Frame),
    /// A room.
    Room(&'a RoomView),
}

/// What a frame of the window is drawn into.
struct Sheets<'a> {
    target: &'a wgpu::TextureView,
    /// What is read back of it.
    copy: Option<&'a wgpu::TextureView>,
    thumbnail: Option<(&'a View, &'a Offscreen)>,
}

impl Stage {
    /// Draws the world or the room, if there is one, and the interface, and shows them. Returns whether there is a picture of
    /// a room.
    ///
    /// # Errors
    /// When the adapter refuses to draw the world.
    pub fn show(
        &mut self,
        texture: wgpu::SurfaceTexture,
        showing: Showing<'_>,
        waits: &mut Waits,
    ) -> Result<bool, Failure> {
        let target = texture
            .texture
            .create_view(&wgpu::TextureViewDescriptor::default());
        let kept = (showing.keeps && self.can_keep()).then(|| self.offscreen(self.size()));
        let thumbnail = showing.thumbnail.filter(|_| self.can_keep());
        let thumbnail = thumbnail.map(|(world, view)| (world, view, self.offscreen(THUMBNAIL)));
        let sheets = Sheets {
            target: &target,
            copy: kept.as_ref().map(Offscreen::view),
            thumbnail: thumbnail.as_ref().and_then(|(_, view, sheet)| match view {
                PortraitView::World(view) => Some((view, sheet)),
                PortraitView::Room(_) => None,
            }),
        };
        let is_of_room = thumbnail
            .as_ref()
            .is_some_and(|(_, view, sheet)| match view {
                PortraitView::World(_) => false,
                PortraitView::Room(view) => self.portray_room(view, sheet),
            });
        let (painted, shown) = self.paint(showing.scene, showing.interface, &sheets);
        waits.spent_on(Part::Record);
        if let Some(painted) = painted {
            self.gpu.queue.submit([painted]);
        }
        if let Some(kept) = kept {
            self.screenshots.push_back(kept.begin_read(&self.gpu));
        }
        if let Some((world, _, sheet)) = thumbnail.filter(|_| shown.for_menu || is_of_room) {
            self.thumbnail = Some((world, sheet.begin_read(&self.gpu)));
        }
        self.window.pre_present_notify();
        self.gpu.queue.present(texture);
        self.renderer
            .fault()
            .map_or(Ok(shown.room), |fault| Err(fault.into()))
    }

    fn paint(
        &mut self,
        scene: SceneShown<'_>,
        interface: egui::FullOutput,
        sheets: &Sheets<'_>,
    ) -> (Option<wgpu::CommandBuffer>, Painted) {
        let mut encoder = self.gpu.encoder();
        let shown = match scene {
            SceneShown::World(frame) => self.paint_world(frame, sheets, &mut encoder),
            SceneShown::Room(view) => self.paint_room(view, sheets, &mut encoder),
            SceneShown::Nothing => Painted::default(),
        };
        if !shown.world && !shown.room {
            clear(&mut encoder, sheets.target);
        }
        match sheets.copy {
            Some(copy) if shown.world => self.renderer.show_again(&mut encoder, copy),
            Some(copy) if shown.room => self.rooms.draw_again(&self.gpu, &mut encoder, copy),
            Some(copy) => clear(&mut encoder, copy),
            None => {}
        }
        if self.gpu.lost().is_some() {
            // The interface's painter breaks on an adapter that takes nothing any more.
            self.overlay.skip(&interface.textures_delta);
            return (None, Painted::default());
        }
        let targets: Vec<_> = [sheets.target].into_iter().chain(sheets.copy).collect();
        let size = self.size();
        self.overlay
            .paint(&self.gpu, &mut encoder, &targets, size, interface);
        (Some(encoder.finish()), shown)
    }

    /// Draws the menu's picture of a room. Returns whether there is one.
    fn portray_room(&mut self, view: &RoomView, sheet: &Offscreen) -> bool {
        let drawn = self
            .rooms
            .portray(&self.gpu, view, (sheet.view(), THUMBNAIL));
        drawn.unwrap_or_else(|why| {
            tracing::error!("the menu's picture of the room could not be drawn: {why}");
            false
        })
    }

    fn paint_room(
        &mut self,
        view: &RoomView,
        sheets: &Sheets<'_>,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Painted {
        let size = (self.size(), self.options.scale);
        let view = view.within(size.0);
        let drawn = self
            .rooms
            .draw(&self.gpu, encoder, &view, sheets.target, size);
        Painted {
            room: drawn.unwrap_or_else(|why| {
                tracing::error!("the room could not be drawn: {why}");
                false
            }),
            ..Painted::default()
        }
    }

    fn paint_world(
        &mut self,
        frame: &Frame,
        sheets: &Sheets<'_>,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Painted {
        let mirror = Mirror::of(frame, self.size());
        let thumbnail = sheets.thumbnail.map(|(view, sheet)| FurtherView {
            view,
            size: THUMBNAIL,
            target: ViewTarget::Texture(sheet.view()),
        });
        let further = mirror.as_ref().map(Mirror::further);
        let further: Vec<_> = further.into_iter().chain(thumbnail).collect();
        let (stats, others) = self
            .renderer
            .draw_views(frame, &further, encoder, sheets.target);
        let is_drawn = others.last().is_some_and(|it| it.picture == Picture::New);
        Painted {
            world: self.pictured.note(&stats, frame.view.quality),
            room: false,
            for_menu: thumbnail.is_some() && is_drawn,
        }
    }
}

/// What there is a picture of in a frame.
#[derive(Clone, Copy, Default)]
struct Painted {
    world: bool,
    room: bool,
    /// Of a world for the menu.
    for_menu: bool,
}

fn clear(encoder: &mut wgpu::CommandEncoder, target: &wgpu::TextureView) {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("backdrop"),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: target,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations {
                load: wgpu::LoadOp::Clear(BACKDROP),
                store: wgpu::StoreOp::Store,
            },
        })],
        ..Default::default()
    });
}
