//! Draws the open room into the window. What a room is drawn of is made on a thread of its own, writing included, and shaders are
//! compiled on another; until that is done the picture is that of the room before, or there is none.

mod fineness;
mod shaders;

use std::borrow::Cow;
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
use fineness::Fineness;
use shaders::Shaders;

/// How long a figure is seen to move after it has come to stand.
const SETTLES: Duration = Duration::from_millis(700);
/// What is shown is told to be late after this.
const LATE: Duration = Duration::from_millis(500);

/// What a room is drawn with, or why it cannot be.
type Prepared = Result<(Arc<RoomPainter>, Drawable), Failure>;

/// Something made of a room as it was at some time.
#[derive(Debug)]
struct Dated<T> {
    id: RoomId,
    /// When the room was another first.
    outdated: Option<Instant>,
    it: T,
}

impl<T> Dated<T> {
    fn new(id: RoomId, it: T) -> Self {
        Self {
            id,
            outdated: None,
            it,
        }
    }

    /// The room is this one now. Returns whether this was made of it.
    fn compare(&mut self, id: RoomId, now: Instant) -> bool {
        if self.id != id {
            self.outdated.get_or_insert(now);
        }
        self.id == id
    }
}

impl Dated<Drawable> {
    /// A view in the space of what is drawn, which a room has no more that has been changed since.
    fn seen<'v>(&self, view: &'v RoomView) -> Cow<'v, RoomView> {
        if self.id == view.id {
            return Cow::Borrowed(view);
        }
        Cow::Owned(self.it.placed_anew(view))
    }
}

/// What draws rooms.
#[derive(Debug, Default)]
pub struct Rooms {
    painter: Option<Arc<RoomPainter>>,
    shown: Option<Dated<Drawable>>,
    /// What is shown as soon as its shaders are there.
    next: Option<Dated<Drawable>>,
    coming: Option<Dated<Task<Prepared>>>,
    shaders: Shaders,
    pictures: Pictures,
    fineness: Fineness,
    /// Since when the view cannot be drawn, since shaders for it are missing.
    waits: Option<Instant>,
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
        let trouble = self.take_over().or_else(|| self.shaders.poll());
        let now = Instant::now();
        let is_shown = self.shown.as_mut().is_some_and(|it| it.compare(id, now));
        let is_next = self.next.as_mut().is_some_and(|it| it.compare(id, now));
        if let Some(coming) = &mut self.coming {
            coming.compare(id, now);
        } else if trouble.is_none() && !is_shown && !is_next {
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
            self.coming = Some(Dated::new(id, Task::start("room", make)));
        }
        trouble
    }

    fn take_over(&mut self) -> Option<Failure> {
        let progress = self.coming.as_ref()?.it.poll();
        if matches!(progress, Progress::Running) {
            return None;
        }
        let Dated { id, outdated, .. } = self.coming.take()?;
        match progress {
            Progress::Running => None,
            Progress::Done(Ok((painter, it))) => {
                self.painter = Some(painter);
                self.next = Some(Dated { id, outdated, it });
                None
            }
            Progress::Done(Err(why)) => Some(why),
            Progress::Died => Some(Failure::Runtime(
                "Something failed while the room was made ready to be drawn.".to_owned(),
            )),
        }
    }

    /// Shows what was made last if its shaders are there, and has those compiled that the view wants first, then all others.
    /// Returns whether the view can be drawn.
    fn settle(&mut self, gpu: &Gpu, painter: &Arc<RoomPainter>, view: &RoomView) -> bool {
        let missing = |it: &Dated<Drawable>| painter.missing(&it.it, &it.seen(view));
        let of_next = self.next.as_ref().and_then(missing);
        if of_next.is_none() && self.next.is_some() {
            self.shown = self.next.take();
            self.pictures.view = None;
        }
        let of_shown = self.shown.as_ref().and_then(missing);
        match (of_next.or(of_shown), &self.shown) {
            (Some(wanted), _) => self.shaders.want(gpu, painter, wanted),
            (None, Some(shown)) => self.shaders.compile_rest(gpu, painter, &shown.it),
            (None, None) => {}
        }
        of_shown.is_none()
    }

    /// Whether what is drawn is about to change.
    pub fn is_busy(&self) -> bool {
        let is_made = self.coming.is_some() || self.next.is_some() || self.waits.is_some();
        is_made || self.pictures.is_coming()
    }

    /// Whether what is shown is of the room, or of the view, as it was a while ago.
    pub fn is_late(&self) -> bool {
        let outdated = self.shown.as_ref().and_then(|it| it.outdated);
        let since = outdated.into_iter().chain(self.waits).min();
        since.is_some_and(|since| since.elapsed() > LATE)
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
        let Some(painter) = self.painter.clone() else {
            return Ok(false);
        };
        let can_draw = self.settle(gpu, &painter, view);
        let Some(shown) = &mut self.shown else {
            return Ok(false);
        };
        if shown.id.0 != view.id.0 {
            return Ok(false);
        }
        let view = &*shown.seen(view);
        let now = Instant::now();
        let size = view.tile.map_or(size, |tile| tile.size);
        let share = self.fineness.share(most, now);
        let mut tracer = Tracer {
            gpu,
            painter: &painter,
            drawable: &mut shown.it,
            view,
        };
        let traced = if can_draw {
            self.waits = None;
            match self.pictures.trace(&mut tracer, encoder, (size, share)) {
                // What moves now need not be in the room as it was.
                Err(_) if shown.id != view.id => false,
                traced => traced?,
            }
        } else {
            self.waits.get_or_insert(now);
            false
        };
        if !traced {
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
        let (Some(painter), Some(shown)) = (&self.painter, &mut self.shown) else {
            return Ok(false);
        };
        if shown.id.0 != view.id.0 {
            return Ok(false);
        }
        let view = &*shown.seen(view);
        let drawable = &mut shown.it;
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
        let share = picture.size.1 as f32 / size.1 as f32;
        tracer.drawable.is_drawn_at(share);
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
