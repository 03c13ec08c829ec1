//! Who has which part of the large buffers, their pages: books of free and taken places, without any buffer.

use std::fmt;

use offset_allocator::{Allocation, Allocator};

/// Indices are handed out in pairs, since buffers are filled in whole 32-bit words.
const INDICES_PER_WORD: u32 = 2;
/// Meshes and gaps that a page tells apart at most.
const MOST_NODES: u32 = 8192;

/// How much a page holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PageSize {
    /// Vertices.
    pub vertices: u32,
    /// Indices; a whole number of pairs.
    pub indices: u32,
}

/// A place in one page for the vertices and the indices of one mesh. It goes back by [`PageBooks::give_back`].
pub struct Place {
    /// Which page.
    pub page: usize,
    vertices: Allocation,
    words: Allocation,
}

impl Place {
    /// Its first vertex, counted from the page's.
    pub fn first_vertex(&self) -> u32 {
        self.vertices.offset
    }

    /// Its first index, counted from the page's; even.
    pub fn first_index(&self) -> u32 {
        self.words.offset * INDICES_PER_WORD
    }
}

impl fmt::Debug for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Place")
            .field("page", &self.page)
            .field("first_vertex", &self.first_vertex())
            .field("first_index", &self.first_index())
            .finish_non_exhaustive()
    }
}

/// The book of one page.
#[derive(Debug)]
struct Book {
    vertices: Allocator,
    words: Allocator,
    places: usize,
}

impl Book {
    fn new(size: PageSize) -> Self {
        let allocator = |units| Allocator::with_max_allocs(units, MOST_NODES);
        Self {
            vertices: allocator(size.vertices),
            words: allocator(size.indices / INDICES_PER_WORD),
            places: 0,
        }
    }

    fn take(&mut self, page: usize, vertices: u32, words: u32) -> Option<Place> {
        let vertices = self.vertices.allocate(vertices)?;
        let Some(words) = self.words.allocate(words) else {
            self.vertices.free(vertices);
            return None;
        };
        self.places += 1;
        Some(Place {
            page,
            vertices,
            words,
        })
    }
}

/// The books of all pages.
#[derive(Debug)]
pub struct PageBooks {
    size: PageSize,
    /// A page that is not needed leaves a gap, so that the others keep their numbers.
    books: Vec<Option<Book>>,
}

impl PageBooks {
    /// No page yet.
    pub fn new(size: PageSize) -> Self {
        Self {
            size,
            books: Vec::new(),
        }
    }

    /// A place for a mesh of one vertex and one index at least, in the first page with room, a new one if need be;
    /// `None` for a mesh that fits no page.
    pub fn take(&mut self, vertices: u32, indices: u32) -> Option<Place> {
        let words = indices.div_ceil(INDICES_PER_WORD);
        for (page, book) in self.books.iter_mut().enumerate() {
            let place = book.as_mut().and_then(|b| b.take(page, vertices, words));
            if place.is_some() {
                return place;
            }
        }
        if vertices > self.size.vertices || indices > self.size.indices {
            return None;
        }
        let mut book = Book::new(self.size);
        let gap = self.books.iter().position(Option::is_none);
        let page = gap.unwrap_or(self.books.len());
        let place = book.take(page, vertices, words);
        match gap {
            Some(gap) => self.books[gap] = Some(book),
            None => self.books.push(Some(book)),
        }
        place
    }

    /// Takes a place back; true if that leaves its page empty and it was given up, since there are others.
    #[expect(
        clippy::needless_pass_by_value,
        reason = "a place that went back is nobody's any more"
    )]
    pub fn give_back(&mut self, place: Place) -> bool {
        let Place {
            page,
            vertices,
            words,
        } = place;
        let others = self.books.iter().flatten().count() > 1;
        let Some(slot) = self.books.get_mut(page) else {
            return false;
        };
        let Some(book) = slot else {
            return false;
        };
        book.vertices.free(vertices);
        book.words.free(words);
        book.places -= 1;
        let gone = book.places == 0 && others;
        if gone {
            *slot = None;
        }
        gone
    }

    /// Gives up every page at once.
    pub fn clear(&mut self) {
        self.books.clear();
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use proptest::prelude::*;

    use super::*;

    const SIZE: PageSize = PageSize {
        vertices: 4096,
        indices: 24_576,
    };

    /// A mesh by how much of the page its place takes, and the place.
    struct Taken {
        vertices: u32,
        indices: u32,
        place: Place,
    }

    fn overlap(a: (u32, u32), b: (u32, u32)) -> bool {
        a.0 < b.0 + b.1 && b.0 < a.0 + a.1
    }

    fn assert_apart(taken: &[Taken]) {
        for (i, a) in taken.iter().enumerate() {
            let vertices = |t: &Taken| (t.place.first_vertex(), t.vertices);
            let indices = |t: &Taken| (t.place.first_index(), t.indices);
            assert!(a.place.first_vertex() + a.vertices <= SIZE.vertices);
            assert!(a.place.first_index() + a.indices <= SIZE.indices);
            assert_eq!(a.place.first_index() % 2, 0);
            for b in taken[..i].iter().filter(|b| b.place.page == a.place.page) {
                assert!(!overlap(vertices(a), vertices(b)));
                assert!(!overlap(indices(a), indices(b)));
            }
        }
    }

    proptest! {
        #[test]
        fn places_never_overlap_and_all_go_back(
            steps in prop::collection::vec((0_u8..3, 1_u32..1500, 1_u32..9000, any::<prop::sample::Index>()), 1..200)
        ) {
            let mut books = PageBooks::new(SIZE);
            let mut taken: Vec<Taken> = Vec::new();
            for (what, vertices, indices, which) in steps {
                // Put, replace or remove.
                if what > 0 && !taken.is_empty() {
                    let gone = taken.swap_remove(which.index(taken.len()));
                    books.give_back(gone.place);
                }
                if what < 2 {
                    let place = books.take(vertices, indices).unwrap();
                    taken.push(Taken { vertices, indices, place });
                }
                assert_apart(&taken);
            }
            for gone in taken {
                books.give_back(gone.place);
            }
            // Only one page is left, and it is whole again.
            prop_assert!(books.books.iter().flatten().count() <= 1);
            let whole = books.take(SIZE.vertices, SIZE.indices).unwrap();
            prop_assert_eq!((whole.first_vertex(), whole.first_index()), (0, 0));
        }
    }

    #[test]
    fn a_mesh_that_fits_no_page_has_no_place_and_pages_are_added_and_given_up() {
        let mut books = PageBooks::new(SIZE);
        assert!(books.take(4097, 3).is_none() && books.take(3, 24_577).is_none());
        let places: Vec<_> = (0..3).map(|_| books.take(3000, 3).unwrap()).collect();
        assert_eq!(places.iter().map(|p| p.page).collect::<Vec<_>>(), [0, 1, 2]);
        let mut places = places.into_iter();
        assert!(books.give_back(places.next().unwrap()));
        assert_eq!(books.take(3500, 3).unwrap().page, 0);
        assert!(places.next().is_some_and(|place| books.give_back(place)));
    }
}
