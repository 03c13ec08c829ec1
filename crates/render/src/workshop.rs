//! Makes pipelines before they are needed, in a thread, so that no frame of a game waits for a compiler.

#[cfg(test)]
mod tests;

use std::fmt;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, OnceLock};
use std::thread::{Builder, JoinHandle};

/// Maps that shaders are compiled for: numbers that `SpaceUniform::kind` begins with.
const MAPS: u32 = 4;
/// These, and the same for views that are cut, which nobody makes ahead.
const NUMBERS: u32 = 2 * MAPS;

/// Makes what a map needs, by the map's number; or says why it cannot.
type Make<T> = Box<dyn Fn(u32) -> Result<T, String> + Send + Sync>;

/// The pipelines of every map.
#[derive(Debug)]
pub struct Workshop<T: Send + Sync + 'static> {
    shelf: Arc<Shelf<T>>,
    /// Of another quality, to be taken instead once it has what a frame needs.
    next: Option<Arc<Shelf<T>>>,
    thread: Option<Worker<T>>,
}

/// What is made, by the map's number.
struct Shelf<T> {
    make: Make<T>,
    /// Or why they cannot be made.
    made: [OnceLock<Result<T, String>>; NUMBERS as usize],
    /// The map that frames wait for, which goes before others; [`NUMBERS`] for none.
    wanted: AtomicU32,
    /// Nothing more is to be made for it in the thread.
    closes: AtomicBool,
}

#[derive(Debug)]
struct Worker<T> {
    orders: Sender<(Arc<Shelf<T>>, u32)>,
    handle: JoinHandle<()>,
}

impl<T> fmt::Debug for Shelf<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Shelf").finish_non_exhaustive()
    }
}

impl<T> Shelf<T> {
    fn new(make: Make<T>) -> Self {
        Self {
            make,
            made: [const { OnceLock::new() }; NUMBERS as usize],
            wanted: AtomicU32::new(NUMBERS),
            closes: AtomicBool::new(false),
        }
    }

    fn slot(&self, map: u32) -> &OnceLock<Result<T, String>> {
        &self.made[(map % NUMBERS) as usize]
    }

    /// Makes what a map needs, or waits for the thread that does.
    fn finish(&self, map: u32) {
        self.slot(map).get_or_init(|| (self.make)(map % NUMBERS));
    }

    fn is_made(&self, map: u32) -> bool {
        self.slot(map).get().is_some()
    }

    fn close(&self) {
        self.closes.store(true, Ordering::Relaxed);
    }
}

impl<T: Send + Sync + 'static> Worker<T> {
    fn start() -> std::io::Result<Self> {
        let (orders, asked) = channel::<(Arc<Shelf<T>>, u32)>();
        let work = move || {
            for (shelf, ordered) in asked {
                let wanted = shelf.wanted.load(Ordering::Relaxed);
                for map in [wanted, ordered].into_iter().filter(|map| *map < NUMBERS) {
                    if !shelf.closes.load(Ordering::Relaxed) {
                        shelf.finish(map);
                    }
                }
            }
        };
        let handle = Builder::new()
            .name("antipode-pipelines".to_owned())
            .spawn(work)?;
        Ok(Self { orders, handle })
    }
}

impl<T: Send + Sync + 'static> Workshop<T> {
    /// A workshop that has made nothing.
    pub fn new(make: Make<T>) -> Self {
        Self {
            shelf: Arc::new(Shelf::new(make)),
            next: None,
            thread: None,
        }
    }

    /// The pipelines of a map by its number in `SpaceUniform::kind`, if they are made and the device does not refuse
    /// them. Never waits.
    pub fn get(&self, map: u32) -> Option<&T> {
        self.shelf.slot(map).get()?.as_ref().ok()
    }

    /// Whether the pipelines of a map are made, or refused.
    pub fn is_made(&self, map: u32) -> bool {
        self.shelf.is_made(map)
    }

    /// Whether those of all maps are made, or refused.
    pub fn are_all_made(&self) -> bool {
        (0..MAPS).all(|map| self.is_made(map))
    }

    /// Makes the pipelines of a map, or waits for the thread that does.
    pub fn finish(&self, map: u32) {
        self.shelf.finish(map);
    }

    /// Why the device refuses the pipelines of a map, if it has refused any so far.
    pub fn refused(&self) -> Option<&str> {
        let made = self.shelf.made.iter().filter_map(OnceLock::get);
        made.filter_map(|made| made.as_ref().err())
            .map(String::as_str)
            .next()
    }

    /// Begins to make what a map needs, unless it is made.
    pub fn order(&mut self, map: u32) {
        let shelf = Arc::clone(self.newest());
        if shelf.is_made(map) {
            return;
        }
        if self.thread.is_none() {
            match Worker::start() {
                Ok(worker) => self.thread = Some(worker),
                Err(e) => tracing::warn!("no thread makes pipelines ahead: {e}"),
            }
        }
        if let Some(worker) = &self.thread {
            // One that has ended leaves the making to the frame.
            let _ = worker.orders.send((shelf, map % NUMBERS));
        }
    }

    /// Begins to make what all maps need.
    pub fn order_all(&mut self) {
        for map in 0..MAPS {
            self.order(map);
        }
    }

    /// Has what a frame needs made before anything else. Where there is no thread it is made here: late is better
    /// than never.
    pub fn want(&mut self, map: u32) {
        let shelf = self.newest();
        if shelf.is_made(map) {
            return;
        }
        if shelf.wanted.swap(map % NUMBERS, Ordering::Relaxed) != map % NUMBERS {
            self.order(map);
        }
        let worker = self.thread.as_ref();
        if worker.is_none_or(|worker| worker.handle.is_finished()) {
            self.newest().finish(map);
        }
    }

    /// Makes pipelines in another way from now on. Those that are there are used on until [`Workshop::turn`].
    pub fn renew(&mut self, make: Make<T>) {
        self.newest().close();
        self.next = Some(Arc::new(Shelf::new(make)));
    }

    /// Makes pipelines no other way after all.
    pub fn keep(&mut self) {
        if let Some(next) = self.next.take() {
            next.close();
            // Orders that came meanwhile were passed over.
            self.shelf.wanted.store(NUMBERS, Ordering::Relaxed);
            self.shelf.closes.store(false, Ordering::Relaxed);
        }
    }

    /// Whether others are to come in place of those that are there.
    pub fn is_renewing(&self) -> bool {
        self.next.is_some()
    }

    /// Takes the other pipelines, if those of a map are made; whether it was so.
    pub fn turn(&mut self, map: u32) -> bool {
        match self.next.take_if(|next| next.is_made(map)) {
            Some(next) => self.shelf = next,
            None => return false,
        }
        true
    }

    fn newest(&self) -> &Arc<Shelf<T>> {
        self.next.as_ref().unwrap_or(&self.shelf)
    }
}

impl<T: Send + Sync + 'static> Drop for Workshop<T> {
    fn drop(&mut self) {
        if let Some(Worker { orders, handle }) = self.thread.take() {
            self.shelf.close();
            self.newest().close();
            drop(orders);
            let _ = handle.join();
        }
    }
}
