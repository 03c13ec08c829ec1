//! Compiles the shaders of rooms on a thread of its own: what is waited for first, and all others while nothing is.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use antipode_rays::Shader;
use antipode_render::Gpu;

use crate::failure::Failure;
use crate::room_picture::{Drawable, RoomPainter};
use crate::window::background::{Progress, Task};

/// What is being compiled.
#[derive(Debug, Default)]
pub struct Shaders {
    task: Option<Task<Result<(), Failure>>>,
    /// Ends what nobody waits for, after the shader that it is at.
    leaves_off: Arc<AtomicBool>,
}

impl Shaders {
    /// Why one was refused, once.
    pub fn poll(&mut self) -> Option<Failure> {
        let progress = self.task.as_ref()?.poll();
        if matches!(progress, Progress::Running) {
            return None;
        }
        self.task = None;
        match progress {
            Progress::Running | Progress::Done(Ok(())) => None,
            Progress::Done(Err(why)) => Some(why),
            Progress::Died => Some(Failure::Runtime(
                "Something failed while the shaders of the room were compiled.".to_owned(),
            )),
        }
    }

    /// A picture waits for this one.
    pub fn want(&mut self, gpu: &Gpu, painter: &Arc<RoomPainter>, shader: Shader) {
        self.leaves_off.store(true, Ordering::Relaxed);
        if self.task.is_none() {
            let (gpu, painter) = (gpu.clone(), painter.clone());
            let compile = move || painter.compile(&gpu, shader);
            self.task = Some(Task::start("shaders", compile));
        }
    }

    /// Whatever else a room may be drawn with is compiled, so that nothing has to wait for it later.
    pub fn compile_rest(&mut self, gpu: &Gpu, painter: &Arc<RoomPainter>, drawable: &Drawable) {
        if self.task.is_some() {
            return;
        }
        let rest = painter.uncompiled(drawable);
        if rest.is_empty() {
            return;
        }
        let leaves_off = Arc::new(AtomicBool::new(false));
        self.leaves_off = leaves_off.clone();
        let (gpu, painter) = (gpu.clone(), painter.clone());
        let compile = move || {
            let goes_on = |_: &Shader| !leaves_off.load(Ordering::Relaxed);
            let mut rest = rest.into_iter().take_while(goes_on);
            rest.try_for_each(|it| painter.compile(&gpu, it))
        };
        self.task = Some(Task::start("shaders", compile));
    }
}
