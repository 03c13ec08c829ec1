//! What was worked out lately.

use std::hash::{BuildHasher, BuildHasherDefault, DefaultHasher, Hash};
use std::sync::RwLock;

/// A table of so many places, one for each remainder of a key's hash: what is put in takes the place of what was there.
///
/// Many threads may ask at once. A lock is held for a copy and never waited for: who finds one taken works the value out.
pub(super) struct Cache<K, V> {
    places: Vec<RwLock<Option<(K, V)>>>,
}

impl<K: Copy + Eq + Hash, V: Copy> Cache<K, V> {
    /// An empty one with room for so many, one at least.
    pub fn of_places(count: usize) -> Self {
        Self {
            places: (0..count.max(1)).map(|_| RwLock::new(None)).collect(),
        }
    }

    /// The value of a key, by a function that always makes the same of it. What could not be made is not kept.
    pub fn value(&self, key: K, make: impl FnOnce() -> Option<V>) -> Option<V> {
        // The same hash on every run.
        let hash = BuildHasherDefault::<DefaultHasher>::default().hash_one(key);
        let place = self.places.get(hash as usize % self.places.len())?;
        let known = place.try_read().ok().and_then(|held| *held);
        if let Some((_, value)) = known.filter(|(held, _)| *held == key) {
            return Some(value);
        }
        let made = make()?;
        if let Ok(mut held) = place.try_write() {
            *held = Some((key, made));
        }
        Some(made)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_kept_until_their_place_is_taken_and_are_right_in_any_case() {
        let cache = Cache::of_places(4);
        let made = std::cell::Cell::new(0);
        let ask = |key: u32| {
            cache.value(key, || {
                made.set(made.get() + 1);
                (key != 9).then_some(key * key)
            })
        };
        assert_eq!([ask(7), ask(7), ask(7)], [Some(49); 3]);
        assert_eq!(made.get(), 1);
        assert_eq!([ask(9), ask(9)], [None; 2]);
        assert_eq!(made.get(), 3);
        for key in (20..90).chain(20..90) {
            assert_eq!(ask(key), Some(key * key));
        }
    }

    #[test]
    fn threads_do_not_mix_values_up() {
        let cache = Cache::of_places(3);
        std::thread::scope(|scope| {
            for thread in 0..4_u64 {
                let cache = &cache;
                scope.spawn(move || {
                    for key in 0..20_000_u64 {
                        let key = (key * 7 + thread) % 11;
                        let value = cache.value(key, || Some([key, key + 1, key * key]));
                        assert_eq!(value, Some([key, key + 1, key * key]));
                    }
                });
            }
        });
    }
}
