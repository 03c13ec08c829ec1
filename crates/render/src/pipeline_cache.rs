//! Makes pipelines before they are needed, in a thread, so that no frame of a game waits for a compiler.

#[cfg(test)]
mod tests;

use std::fmt;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::thread::{Builder, JoinHandle};

use antipode_geometry::MapShader;
use antipode_geometry::shader::MAPS;

/// What pipelines are made for: a map, known by its name.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// The map.
    pub map: &'static MapShader,
    /// Whether sheets may cut what is drawn; nobody makes those ahead.
    pub is_cut: bool,
}

impl Key {
    /// That of pictures that nothing cuts.
    pub fn whole(map: &'static MapShader) -> Self {
        Self { map, is_cut: false }
    }
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        (self.map.name, self.is_cut) == (other.map.name, other.is_cut)
    }
}

impl Eq for Key {}

/// Makes what a map needs, or says why it cannot.
type Make<T> = Box<dyn Fn(Key) -> Result<T, String> + Send + Sync>;

/// The pipelines of every map.
#[derive(Debug)]
pub struct PipelineCache<T: Send + Sync + 'static> {
    list: Arc<PipelineList<T>>,
    /// Of another quality, to be taken instead once it has what a frame needs.
    next: Option<Arc<PipelineList<T>>>,
    thread: Option<Worker<T>>,
}

/// What is made, or is to be: a list that only grows, so that what it has can be lent without a lock.
struct PipelineList<T> {
    make: Make<T>,
    first: Link<T>,
    /// What frames wait for, which goes before others.
    wanted: Mutex<Option<Key>>,
    /// Nothing more is to be made for it in the thread.
    closes: AtomicBool,
}

/// The rest of the list.
type Link<T> = OnceLock<Box<Slot<T>>>;

/// What is made for one key, or why it cannot be made.
struct Slot<T> {
    key: Key,
    made: OnceLock<Result<T, String>>,
    next: Link<T>,
}

#[derive(Debug)]
struct Worker<T> {
    orders: Sender<(Arc<PipelineList<T>>, Key)>,
    handle: JoinHandle<()>,
}

impl<T> fmt::Debug for PipelineList<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PipelineList").finish_non_exhaustive()
    }
}

impl<T> PipelineList<T> {
    fn new(make: Make<T>) -> Self {
        Self {
            make,
            first: OnceLock::new(),
            wanted: Mutex::new(None),
            closes: AtomicBool::new(false),
        }
    }

    fn slots(&self) -> impl Iterator<Item = &Slot<T>> {
        let first = self.first.get().map(Box::as_ref);
        std::iter::successors(first, |slot| slot.next.get().map(Box::as_ref))
    }

    fn made(&self, key: Key) -> Option<&Result<T, String>> {
        self.slots().find(|slot| slot.key == key)?.made.get()
    }

    /// Makes what a map needs, or waits for the thread that does.
    fn finish(&self, key: Key) {
        let mut link = &self.first;
        loop {
            let slot = link.get_or_init(|| {
                Box::new(Slot {
                    key,
                    made: OnceLock::new(),
                    next: OnceLock::new(),
                })
            });
            if slot.key == key {
                slot.made.get_or_init(|| (self.make)(key));
                return;
            }
            link = &slot.next;
        }
    }

    fn is_made(&self, key: Key) -> bool {
        self.made(key).is_some()
    }

    /// Has a key go before others from now on; returns which did before.
    fn want(&self, key: Option<Key>) -> Option<Key> {
        // A thread that broke off left a whole value there.
        let mut wanted = self.wanted.lock().unwrap_or_else(PoisonError::into_inner);
        std::mem::replace(&mut *wanted, key)
    }

    fn wanted(&self) -> Option<Key> {
        *self.wanted.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn close(&self) {
        self.closes.store(true, Ordering::Relaxed);
    }
}

impl<T: Send + Sync + 'static> Worker<T> {
    fn start() -> std::io::Result<Self> {
        let (orders, asked) = channel::<(Arc<PipelineList<T>>, Key)>();
        let work = move || {
            for (list, ordered) in asked {
                for key in list.wanted().into_iter().chain([ordered]) {
                    if !list.closes.load(Ordering::Relaxed) {
                        list.finish(key);
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

impl<T: Send + Sync + 'static> PipelineCache<T> {
    /// A pipeline cache that has made nothing.
    pub fn new(make: Make<T>) -> Self {
        Self {
            list: Arc::new(PipelineList::new(make)),
            next: None,
            thread: None,
        }
    }

    /// The pipelines of a map, if they are made and the device does not refuse them. Never waits.
    pub fn get(&self, key: Key) -> Option<&T> {
        self.list.made(key)?.as_ref().ok()
    }

    /// Whether the pipelines of a map are made, or refused.
    pub fn is_made(&self, key: Key) -> bool {
        self.list.is_made(key)
    }

    /// Whether those of all maps are made, or refused.
    pub fn are_all_made(&self) -> bool {
        MAPS.into_iter().all(|map| self.is_made(Key::whole(map)))
    }

    /// Makes the pipelines of a map, or waits for the thread that does.
    pub fn finish(&self, key: Key) {
        self.list.finish(key);
    }

    /// Why the device refuses the pipelines of a map, if it has refused any so far.
    pub fn refused(&self) -> Option<&str> {
        let made = self.list.slots().filter_map(|slot| slot.made.get());
        made.filter_map(|made| made.as_ref().err())
            .map(String::as_str)
            .next()
    }

    /// Begins to make what a map needs, unless it is made.
    pub fn order(&mut self, key: Key) {
        let list = Arc::clone(self.newest());
        if list.is_made(key) {
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
            let _ = worker.orders.send((list, key));
        }
    }

    /// Begins to make what all maps need.
    pub fn order_all(&mut self) {
        for map in MAPS {
            self.order(Key::whole(map));
        }
    }

    /// Has what a frame needs made before anything else. Where there is no thread it is made here: late is better
    /// than never.
    pub fn want(&mut self, key: Key) {
        let list = self.newest();
        if list.is_made(key) {
            return;
        }
        if list.want(Some(key)) != Some(key) {
            self.order(key);
        }
        let worker = self.thread.as_ref();
        if worker.is_none_or(|worker| worker.handle.is_finished()) {
            self.newest().finish(key);
        }
    }

    /// Makes pipelines in another way from now on. Those that are there are used on until [`PipelineCache::turn`].
    pub fn renew(&mut self, make: Make<T>) {
        self.newest().close();
        self.next = Some(Arc::new(PipelineList::new(make)));
    }

    /// Makes pipelines no other way after all.
    pub fn keep(&mut self) {
        if let Some(next) = self.next.take() {
            next.close();
            // Orders that came meanwhile were passed over.
            self.list.want(None);
            self.list.closes.store(false, Ordering::Relaxed);
        }
    }

    /// Whether others are to come in place of those that are there.
    pub fn is_renewing(&self) -> bool {
        self.next.is_some()
    }

    /// Takes the other pipelines, if those of a map are made; whether it was so.
    pub fn turn(&mut self, key: Key) -> bool {
        match self.next.take_if(|next| next.is_made(key)) {
            Some(next) => self.list = next,
            None => return false,
        }
        true
    }

    fn newest(&self) -> &Arc<PipelineList<T>> {
        self.next.as_ref().unwrap_or(&self.list)
    }
}

impl<T: Send + Sync + 'static> Drop for PipelineCache<T> {
    fn drop(&mut self) {
        if let Some(Worker { orders, handle }) = self.thread.take() {
            self.list.close();
            self.newest().close();
            drop(orders);
            let _ = handle.join();
        }
    }
}
