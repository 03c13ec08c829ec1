//! Makes pipelines before they are needed, in a thread, so that no frame of a game waits for a compiler.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, OnceLock};
use std::thread::{Builder, JoinHandle};

use wgpu::{BindGroupLayout, Device};

use crate::pipelines::Pipelines;
use crate::shaders::Shaders;
use crate::shadow::ShadowQuality;

/// Maps that shaders are compiled for: numbers that `SpaceUniform::kind` begins with.
const MAPS: u32 = 4;

/// The pipelines of every map.
#[derive(Debug)]
pub struct Workshop {
    shelf: Arc<Shelf>,
    thread: Option<Worker>,
}

/// What is made, by the map's number, and what it is made with.
#[derive(Debug)]
struct Shelf {
    device: Device,
    shaders: Shaders,
    layout: BindGroupLayout,
    /// Samples a pixel, and the shadows' quality.
    quality: (u32, ShadowQuality),
    /// Or why they cannot be made.
    made: [OnceLock<Result<Pipelines, String>>; MAPS as usize],
    closes: AtomicBool,
}

#[derive(Debug)]
struct Worker {
    orders: Sender<u32>,
    handle: JoinHandle<()>,
}

impl Shelf {
    /// The pipelines of a map; makes them, or waits for the thread that does.
    fn get(&self, map: u32) -> Option<&Pipelines> {
        let map = map % MAPS;
        let make = || Pipelines::new(&self.device, self.shaders, &self.layout, map, self.quality);
        self.made[map as usize].get_or_init(make).as_ref().ok()
    }
}

impl Worker {
    fn start(shelf: Arc<Shelf>) -> std::io::Result<Self> {
        let (orders, asked) = channel();
        let work = move || {
            for map in asked {
                if shelf.closes.load(Ordering::Relaxed) {
                    return;
                }
                shelf.get(map);
            }
        };
        let handle = Builder::new()
            .name("antipode-pipelines".to_owned())
            .spawn(work)?;
        Ok(Self { orders, handle })
    }
}

impl Workshop {
    /// A workshop that has made nothing.
    pub fn new(
        device: &Device,
        shaders: Shaders,
        layout: &BindGroupLayout,
        quality: (u32, ShadowQuality),
    ) -> Self {
        Self {
            shelf: Arc::new(Shelf {
                device: device.clone(),
                shaders,
                layout: layout.clone(),
                quality,
                made: [const { OnceLock::new() }; MAPS as usize],
                closes: AtomicBool::new(false),
            }),
            thread: None,
        }
    }

    /// The pipelines of a map by its number in `SpaceUniform::kind`. Waits for them where they are not made yet; none
    /// where the device refuses them.
    pub fn get(&self, map: u32) -> Option<&Pipelines> {
        self.shelf.get(map)
    }

    /// Why the device refuses the pipelines of a map, if it has refused any so far.
    pub fn refused(&self) -> Option<&str> {
        let made = self.shelf.made.iter().filter_map(OnceLock::get);
        made.filter_map(|made| made.as_ref().err())
            .map(String::as_str)
            .next()
    }

    /// Begins to make what a map needs, unless it is made. Where there is no thread to be had, the frame that needs
    /// it will.
    pub fn order(&mut self, map: u32) {
        if self.shelf.made[(map % MAPS) as usize].get().is_some() {
            return;
        }
        if self.thread.is_none() {
            match Worker::start(Arc::clone(&self.shelf)) {
                Ok(worker) => self.thread = Some(worker),
                Err(e) => tracing::warn!("no thread makes pipelines ahead: {e}"),
            }
        }
        if let Some(worker) = &self.thread {
            // One that has ended leaves the making to the frame.
            let _ = worker.orders.send(map);
        }
    }

    /// Begins to make what all maps need.
    pub fn order_all(&mut self) {
        for map in 0..MAPS {
            self.order(map);
        }
    }
}

impl Drop for Workshop {
    fn drop(&mut self) {
        if let Some(Worker { orders, handle }) = self.thread.take() {
            self.shelf.closes.store(true, Ordering::Relaxed);
            drop(orders);
            let _ = handle.join();
        }
    }
}
