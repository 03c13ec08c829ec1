//! Allocates parts of the large buffers, their pages, to meshes. It has no buffer itself.

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

/// What one mesh has of a page: room for its vertices and its indices. It goes back by [`PageAllocator::free`].
pub struct MeshAllocation {
    /// Which page.
    pub page: usize,
    vertices: Allocation,
    words: Allocation,
}

impl MeshAllocation {
    /// Its first vertex, counted from the page's.
    pub fn first_vertex(&self) -> u32 {
        self.vertices.offset
    }

    /// Its first index, counted from the page's; even.
    pub fn first_index(&self) -> u32 {
        self.words.offset * INDICES_PER_WORD
    }
}

impl fmt::Debug for MeshAllocation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("MeshAllocation")
            .field("page", &self.page)
            .field("first_vertex", &self.first_vertex())
            .field("first_index", &self.first_index())
            .finish_non_exhaustive()
    }
}

/// What is free in one page.
#[derive(Debug)]
struct FreeSpace {
    vertices: Allocator,
    words: Allocator,
    meshes: usize,
}

impl FreeSpace {
    fn new(size: PageSize) -> Self {
        let allocator = |units| Allocator::with_max_allocs(units, MOST_NODES);
        Self {
            vertices: allocator(size.vertices),
            words: allocator(size.indices / INDICES_PER_WORD),
            meshes: 0,
        }
    }

    fn allocate(&mut self, page: usize, vertices: u32, words: u32) -> Option<MeshAllocation> {
        let vertices = self.vertices.allocate(vertices)?;
        let Some(words) = self.words.allocate(words) else {
            self.vertices.free(vertices);
            return None;
        };
        self.meshes += 1;
        Some(MeshAllocation {
            page,
            vertices,
            words,
        })
    }
}

/// What is free in all pages.
#[derive(Debug)]
pub struct PageAllocator {
    size: PageSize,
    /// A page that is not needed leaves a gap, so that the others keep their numbers.
    pages: Vec<Option<FreeSpace>>,
}

impl PageAllocator {
    /// No page yet.
    pub fn new(size: PageSize) -> Self {
        Self {
            size,
            pages: Vec::new(),
        }
    }

    /// Room for a mesh of one vertex and one index at least, in the first page with room, a new one if need be;
    /// `None` for a mesh that fits no page.
    pub fn allocate(&mut self, vertices: u32, indices: u32) -> Option<MeshAllocation> {
        let words = indices.div_ceil(INDICES_PER_WORD);
        for (number, page) in self.pages.iter_mut().enumerate() {
            let found = page
                .as_mut()
                .and_then(|page| page.allocate(number, vertices, words));
            if found.is_some() {
                return found;
            }
        }
        if vertices > self.size.vertices || indices > self.size.indices {
            return None;
        }
        let mut page = FreeSpace::new(self.size);
        let gap = self.pages.iter().position(Option::is_none);
        let number = gap.unwrap_or(self.pages.len());
        let allocation = page.allocate(number, vertices, words);
        match gap {
            Some(gap) => self.pages[gap] = Some(page),
            None => self.pages.push(Some(page)),
        }
        allocation
    }

    /// Takes room back; true if that leaves its page empty and it was given up, since there are others.
    #[expect(
        clippy::needless_pass_by_value,
        reason = "what went back is nobody's any more"
    )]
    pub fn free(&mut self, allocation: MeshAllocation) -> bool {
        let MeshAllocation {
            page,
            vertices,
            words,
        } = allocation;
        let others = self.pages.iter().flatten().count() > 1;
        let Some(slot) = self.pages.get_mut(page) else {
            return false;
        };
        let Some(space) = slot else {
            return false;
        };
        space.vertices.free(vertices);
        space.words.free(words);
        space.meshes -= 1;
        let gone = space.meshes == 0 && others;
        if gone {
            *slot = None;
        }
        gone
    }

    /// Gives up every page at once.
    pub fn clear(&mut self) {
        self.pages.clear();
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

    /// A mesh by how much of the page it takes, and what it was given.
    struct Taken {
        vertices: u32,
        indices: u32,
        allocation: MeshAllocation,
    }

    fn overlap(a: (u32, u32), b: (u32, u32)) -> bool {
        a.0 < b.0 + b.1 && b.0 < a.0 + a.1
    }

    fn assert_apart(taken: &[Taken]) {
        for (i, a) in taken.iter().enumerate() {
            let vertices = |t: &Taken| (t.allocation.first_vertex(), t.vertices);
            let indices = |t: &Taken| (t.allocation.first_index(), t.indices);
            assert!(a.allocation.first_vertex() + a.vertices <= SIZE.vertices);
            assert!(a.allocation.first_index() + a.indices <= SIZE.indices);
            assert_eq!(a.allocation.first_index() % 2, 0);
            for b in taken[..i]
                .iter()
                .filter(|b| b.allocation.page == a.allocation.page)
            {
                assert!(!overlap(vertices(a), vertices(b)));
                assert!(!overlap(indices(a), indices(b)));
            }
        }
    }

    proptest! {
        #[test]
        fn allocations_never_overlap_and_all_go_back(
            steps in prop::collection::vec((0_u8..3, 1_u32..1500, 1_u32..9000, any::<prop::sample::Index>()), 1..200)
        ) {
            let mut allocator = PageAllocator::new(SIZE);
            let mut taken: Vec<Taken> = Vec::new();
            for (what, vertices, indices, which) in steps {
                // Put, replace or remove.
                if what > 0 && !taken.is_empty() {
                    let gone = taken.swap_remove(which.index(taken.len()));
                    allocator.free(gone.allocation);
                }
                if what < 2 {
                    let allocation = allocator.allocate(vertices, indices).unwrap();
                    taken.push(Taken { vertices, indices, allocation });
                }
                assert_apart(&taken);
            }
            for gone in taken {
                allocator.free(gone.allocation);
            }
            // Only one page is left, and it is whole again.
            prop_assert!(allocator.pages.iter().flatten().count() <= 1);
            let whole = allocator.allocate(SIZE.vertices, SIZE.indices).unwrap();
            prop_assert_eq!((whole.first_vertex(), whole.first_index()), (0, 0));
        }
    }

    #[test]
    fn a_mesh_that_fits_no_page_is_refused_and_pages_are_added_and_given_up() {
        let mut allocator = PageAllocator::new(SIZE);
        assert!(allocator.allocate(4097, 3).is_none() && allocator.allocate(3, 24_577).is_none());
        let taken: Vec<_> = (0..3)
            .map(|_| allocator.allocate(3000, 3).unwrap())
            .collect();
        assert_eq!(taken.iter().map(|p| p.page).collect::<Vec<_>>(), [0, 1, 2]);
        let mut taken = taken.into_iter();
        assert!(allocator.free(taken.next().unwrap()));
        assert_eq!(allocator.allocate(3500, 3).unwrap().page, 0);
        assert!(
            taken
                .next()
                .is_some_and(|allocation| allocator.free(allocation))
        );
    }
}
