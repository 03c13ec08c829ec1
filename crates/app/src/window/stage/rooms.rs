//! Draws the open room into the window. What a room is drawn of is made on a thread of its own, shaders and writing
//! included; until that is done there is no picture of it.

use std::sync::Arc;
use std::time::{Duration, Instant};

use antipode_language::Texts;
use antipode_rays::Picture;
use antipode_render::{Gpu, Options};
use antipode_room_scene::RoomScene;

use crate::failure::Failure;
use crate::room_picture::{Drawable, RoomPainter, RoomView};
use crate::window::background::{Progress, Task};
use crate::window::visit::RoomId;

/// How long frames are to take where not all pixels can be traced in less.
const BEARABLE: Duration = Duration::from_millis(45);
/// Frames that take this much less or more are left as they are, as a factor.
const NEAR: f32 = 1.4;
/// A frame that took longer than this was held up by something else as well.
const LONGEST: Duration = Duration::from_secs(1);
/// Frames that are begun already when the number of pixels changes, and tell nothing of the new one.
const BEGUN: u32 = 2;
/// Frames of which one is judged, unless it is far off.
const JUDGED: u32 = 4;
/// Greatest change at once.
const STEP: (f32, f32) = (0.5, 1.2);
/// How long a figure is seen to move after it has come to stand.
const SETTLES: Duration = Duration::from_millis(700);
/// Least share of the window's pixels along each side.
const LEAST_SHARE: f32 = 0.125;

/// What a room is drawn with, or why it cannot be.
type Prepared = Result<(Arc<RoomPainter>, Drawable), Failure>;

/// What draws rooms.
#[derive(Debug, Default)]
pub struct Rooms {
    painter: Option<Arc<RoomPainter>>,
    shown: Option<(RoomId, Drawable)>,
    coming: Option<(RoomId, Task<Prepared>)>,
    pictures: Pictures,
    fineness: Fineness,
}

impl Rooms {
    /// A room is to be drawn: begins to make what for, unless that is there. Returns why it cannot be drawn, once.
    pub fn prepare(
        &mut self,
        gpu: &Gpu,
        options: &Options,
        id: RoomId,
        (room, texts): (&RoomScene, &Texts),
    ) -> Option<Failure> {
        let trouble = self.take_over();
        let is_known = |known: RoomId| known == id;
        let is_shown = self
            .shown
            .as_ref()
            .is_some_and(|(known, _)| is_known(*known));
        let is_coming = self
            .coming
            .as_ref()
            .is_some_and(|(known, _)| is_known(*known));
        if trouble.is_none() && !is_shown && !is_coming && self.coming.is_none() {
            let (gpu, options) = (gpu.clone(), *options);
            let (room, texts) = (room.clone(), texts.clone());
            let painter = self.painter.clone();
            let make = move || {
                let painter = match painter {
                    Some(painter) => painter,
                    None => Arc::new(RoomPainter::new(&gpu, &options)?),
                };
                let drawable = painter.drawable(&gpu, &room, &texts)?;
                Ok((painter, drawable))
            };
            self.coming = Some((id, Task::start("room", make)));
        }
        trouble
    }

    fn take_over(&mut self) -> Option<Failure> {
        let (id, task) = self.coming.as_ref()?;
        match task.poll() {
            Progress::Running => None,
            Progress::Done(Ok((painter, drawable))) => {
                self.painter = Some(painter);
                self.shown = Some((*id, drawable));
                self.pictures.view = None;
                self.coming = None;
                None
            }
            Progress::Done(Err(why)) => {
                self.coming = None;
                Some(why)
            }
            Progress::Died => {
                self.coming = None;
                Some(Failure::Runtime(
                    "Something failed while the room was made ready to be drawn.".to_owned(),
                ))
            }
        }
    }

    /// Whether what is drawn is about to change.
    pub fn is_busy(&self) -> bool {
        self.coming.is_some() || self.pictures.is_coming()
    }

    /// Records the picture of a room into a target of the window's size. `most`: the greatest share of the window's pixels
    /// along each side. Returns whether there is a picture, be it of the room before it was changed.
    ///
    /// # Errors
    /// When what moves is not as the room has it.
    pub fn draw(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        view: &RoomView,
        target: &wgpu::TextureView,
        (size, most): ((u32, u32), f32),
    ) -> Result<bool, Failure> {
        let (Some(painter), Some((id, drawable))) = (&self.painter, &mut self.shown) else {
            return Ok(false);
        };
        if id.0 != view.id.0 {
            return Ok(false);
        }
        let size = view.tile.map_or(size, |tile| tile.size);
        let share = self.fineness.share(most, Instant::now());
        let mut tracer = Tracer {
            gpu,
            painter,
            drawable,
            view,
        };
        if !self.pictures.trace(&mut tracer, encoder, (size, share))? {
            self.fineness.rest();
        }
        if let Some(picture) = self.pictures.best() {
            let tile = view.tile.filter(|tile| tile.size == size);
            painter.show(gpu, encoder, picture, (target, tile));
        }
        Ok(true)
    }

    /// Draws another view of the room, at once, into a target of that size. Returns whether there is anything to draw.
    ///
    /// # Errors
    /// When what moves is not as the room has it.
    pub fn portray(
        &mut self,
        gpu: &Gpu,
        view: &RoomView,
        (target, size): (&wgpu::TextureView, (u32, u32)),
    ) -> Result<bool, Failure> {
        let (Some(painter), Some((id, drawable))) = (&self.painter, &mut self.shown) else {
            return Ok(false);
        };
        if id.0 != view.id.0 {
            return Ok(false);
        }
        drawable.set(gpu, &view.moment)?;
        // The window's own picture is of another moment.
        self.pictures.view = None;
        let picture = Picture::new(&gpu.device, (plain(size.0), plain(size.1)));
        let mut encoder = gpu.encoder();
        let whole = (&*drawable, &picture);
        painter.trace(gpu, &mut encoder, whole, view, 0..picture.size.1);
        painter.show(gpu, &mut encoder, &picture, (target, None));
        gpu.queue.submit([encoder.finish()]);
        Ok(true)
    }

    /// Records the same picture into another target.
    pub fn draw_again(
        &self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        target: &wgpu::TextureView,
    ) {
        if let (Some(painter), Some(picture)) = (&self.painter, self.pictures.best()) {
            let tile = self.pictures.view.as_ref().and_then(|view| view.tile);
            painter.show(gpu, encoder, picture, (target, tile));
        }
    }
}

/// What traces a view.
struct Tracer<'a> {
    gpu: &'a Gpu,
    painter: &'a RoomPainter,
    drawable: &'a mut Drawable,
    view: &'a RoomView,
}

/// The picture while something moves, and a finer one that is made bit by bit while nothing does.
#[derive(Debug, Default)]
struct Pictures {
    quick: Option<Picture>,
    fine: Option<Picture>,
    /// What they show.
    view: Option<RoomView>,
    /// Of how many pixels the window is.
    size: (u32, u32),
    /// When the view changed last, but for how a figure is held.
    since: Option<Instant>,
    progress: Made,
}

/// How a view differs from the one before.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Change {
    Nothing,
    /// In how a figure is held that is seen.
    Posture,
    /// In more.
    Place,
}

fn change(before: &RoomView, after: &RoomView) -> Change {
    if before == after {
        return Change::Nothing;
    }
    let mut held = after.clone();
    held.moment.figure.posture = before.moment.figure.posture;
    match *before == held {
        false => Change::Place,
        // The sway of a shadow tells nothing.
        true if after.moment.figure.unseen_by_eye => Change::Nothing,
        true => Change::Posture,
    }
}

/// What there is of the pictures of a view.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Made {
    /// The quick one, and nothing is to be made finer.
    #[default]
    Quick,
    /// The quick one, and so many rows of the fine one.
    Rows(u32),
    /// The fine one, too.
    Fine,
}

impl Pictures {
    /// Traces a view that has changed, or goes on with the fine picture of one that has not. Returns whether there was
    /// anything to trace.
    fn trace(
        &mut self,
        tracer: &mut Tracer<'_>,
        encoder: &mut wgpu::CommandEncoder,
        (size, share): ((u32, u32), f32),
    ) -> Result<bool, Failure> {
        let device = &tracer.gpu.device;
        let along = |pixels: u32| plain((pixels as f32 * share).round() as u32);
        let (quick, size) = (
            (along(size.0), along(size.1)),
            (plain(size.0), plain(size.1)),
        );
        let finer = |rows: u32| match rows {
            _ if quick == size => Made::Quick,
            rows if rows < size.1 => Made::Rows(rows),
            _ => Made::Fine,
        };
        let now = Instant::now();
        let change = self
            .view
            .as_ref()
            .map_or(Change::Place, |it| change(it, tracer.view));
        if change == Change::Place || self.size != size {
            self.since = Some(now);
        }
        let rests = self
            .since
            .is_some_and(|since| now.saturating_duration_since(since) > SETTLES);
        let is_new = match change {
            _ if self.size != size => true,
            Change::Place => true,
            // Who stands sways a little, and would never be seen sharply.
            Change::Posture => quick == size || !rests,
            Change::Nothing => false,
        };
        let (picture, rows) = match self.progress {
            _ if is_new => {
                tracer.drawable.set(tracer.gpu, &tracer.view.moment)?;
                self.view = Some(tracer.view.clone());
                self.size = size;
                self.progress = finer(0);
                (sized(&mut self.quick, device, quick), 0..quick.1)
            }
            Made::Rows(from) => {
                // As many pixels as the quick one has.
                let rows = (size.1 as f32 * share * share).ceil() as u32;
                let to = (from + rows.max(1)).min(size.1);
                self.progress = finer(to);
                (sized(&mut self.fine, device, size), from..to)
            }
            Made::Quick | Made::Fine => return Ok(false),
        };
        let whole = (&*tracer.drawable, &*picture);
        tracer
            .painter
            .trace(tracer.gpu, encoder, whole, tracer.view, rows);
        Ok(true)
    }

    /// The finest picture of the view that there is.
    fn best(&self) -> Option<&Picture> {
        match self.progress {
            Made::Fine => self.fine.as_ref(),
            Made::Quick | Made::Rows(_) => self.quick.as_ref(),
        }
    }

    /// Whether the next frame of the same view would show more.
    fn is_coming(&self) -> bool {
        matches!(self.progress, Made::Rows(_))
    }
}

/// A number of pixels near that one which is no power of two. Adapters that compile a shader anew for textures whose sides are
/// powers of two would do so whenever the number changes to one, and back, which takes seconds.
fn plain(pixels: u32) -> u32 {
    let pixels = pixels.max(3);
    pixels + u32::from(pixels.is_power_of_two())
}

/// A picture of that size, the one that is there if it has it.
fn sized<'a>(
    picture: &'a mut Option<Picture>,
    device: &wgpu::Device,
    size: (u32, u32),
) -> &'a mut Picture {
    let fits = picture.take().filter(|it| it.size == size);
    picture.insert(fits.unwrap_or_else(|| Picture::new(device, size)))
}

/// How many of the window's pixels are traced: as many as frames of a bearable length allow.
#[derive(Debug)]
struct Fineness {
    share: f32,
    last: Option<Instant>,
    /// Frames since the last change.
    frames: u32,
    /// What those took that count.
    spent: Duration,
}

impl Default for Fineness {
    fn default() -> Self {
        Self {
            share: 0.25,
            last: None,
            frames: 0,
            spent: Duration::ZERO,
        }
    }
}

impl Fineness {
    /// The share of the window's pixels along each side, at most `most`, for a frame that begins now.
    fn share(&mut self, most: f32, now: Instant) -> f32 {
        if let Some(last) = self.last.replace(now) {
            self.note(now.saturating_duration_since(last), most);
        }
        self.share.min(most)
    }

    /// Nothing is traced in this frame, which tells nothing.
    fn rest(&mut self) {
        (self.last, self.frames, self.spent) = (None, 0, Duration::ZERO);
    }

    fn note(&mut self, passed: Duration, most: f32) {
        self.frames += 1;
        if self.frames <= BEGUN {
            return;
        }
        self.spent += passed.min(LONGEST);
        let each = self.spent / (self.frames - BEGUN);
        // Time goes by the number of pixels, which is the share squared.
        let change = (BEARABLE.as_secs_f32() / each.as_secs_f32().max(1e-3)).sqrt();
        let is_near = (1.0 / NEAR..NEAR).contains(&(change * change));
        if self.frames < BEGUN + JUDGED && change > STEP.0 {
            return;
        }
        (self.frames, self.spent) = (BEGUN, Duration::ZERO);
        let wanted = self.share.min(most) * change.clamp(STEP.0, STEP.1);
        let wanted = wanted.clamp(LEAST_SHARE.min(most), most);
        if !is_near && wanted != self.share {
            (self.share, self.frames) = (wanted, 0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The share after a while of frames that take so long for each whole window of pixels.
    fn settled(whole: Duration, most: f32) -> f32 {
        let (mut fineness, mut now) = (Fineness::default(), Instant::now());
        for _ in 0..300 {
            let share = fineness.share(most, now);
            now += whole.mul_f32(share * share) + Duration::from_millis(5);
        }
        fineness.share(most, now)
    }

    #[test]
    fn a_slow_adapter_traces_fewer_pixels_and_a_fast_one_all() {
        assert_eq!(settled(Duration::from_millis(10), 1.0), 1.0);
        assert_eq!(settled(Duration::from_millis(10), 0.5), 0.5);
        let share = settled(Duration::from_secs(1), 1.0);
        assert!((0.17..0.26).contains(&share), "{share}");
        assert_eq!(settled(Duration::from_mins(1), 1.0), LEAST_SHARE);
    }

    #[test]
    fn a_frame_that_was_held_up_is_soon_forgotten() {
        let (mut fineness, mut now) = (Fineness::default(), Instant::now());
        let mut shares = Vec::new();
        for frame in 0..120 {
            shares.push(fineness.share(1.0, now));
            let held_up = u64::from(frame == 60) * 3600;
            now += Duration::from_secs(held_up) + Duration::from_millis(10);
        }
        assert_eq!(shares[60], 1.0);
        assert!(shares[61..].iter().all(|share| *share >= 0.5));
        assert_eq!(shares[119], 1.0);
    }
}
