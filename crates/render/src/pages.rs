//! The large buffers, pages, in which all of the land's meshes lie, so that one call draws many.

use antipode_terrain::Vertex;
use wgpu::{Buffer, BufferDescriptor, BufferUsages, Device, Queue};

use crate::page_allocator::{MeshAllocation, PageAllocator, PageSize};

/// Bytes of a page's vertices, and as many of its indices.
const HALF_PAGE_BYTES: u64 = 8 << 20;

/// One page's buffers.
#[derive(Debug)]
pub struct Page {
    /// Vertices of many meshes.
    pub vertices: Buffer,
    /// Their indices, 16 bits each, counted from each mesh's first vertex.
    pub indices: Buffer,
}

impl Page {
    fn new(device: &Device, half_bytes: u64) -> Self {
        let buffer = |label, usage| {
            device.create_buffer(&BufferDescriptor {
                label: Some(label),
                size: half_bytes,
                usage: usage | BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        };
        Self {
            vertices: buffer("land vertices", BufferUsages::VERTEX),
            indices: buffer("land indices", BufferUsages::INDEX),
        }
    }
}

/// All pages.
#[derive(Debug)]
pub struct Pages {
    device: Device,
    queue: Queue,
    half_bytes: u64,
    allocator: PageAllocator,
    buffers: Vec<Option<Page>>,
}

impl Pages {
    /// No page yet.
    pub fn new(device: &Device, queue: &Queue) -> Self {
        // Whole vertices and whole pairs of indices.
        let half_bytes = HALF_PAGE_BYTES.min(device.limits().max_buffer_size) / 16 * 16;
        Self {
            device: device.clone(),
            queue: queue.clone(),
            half_bytes,
            allocator: PageAllocator::new(PageSize {
                vertices: (half_bytes / size_of::<Vertex>() as u64) as u32,
                indices: (half_bytes / size_of::<u16>() as u64) as u32,
            }),
            buffers: Vec::new(),
        }
    }

    /// Puts a mesh into a page from where the next frame is drawn. `None` where there is nothing to put, or more
    /// than a page holds. The indices are padded to an even number.
    pub fn put(&mut self, vertices: &[Vertex], indices: &mut Vec<u16>) -> Option<MeshAllocation> {
        if vertices.is_empty() || indices.is_empty() {
            return None;
        }
        let allocation = self
            .allocator
            .allocate(vertices.len() as u32, indices.len() as u32)?;
        if indices.len() % 2 == 1 {
            indices.push(0);
        }
        if self.buffers.len() <= allocation.page {
            self.buffers.resize_with(allocation.page + 1, || None);
        }
        let page = self.buffers[allocation.page]
            .get_or_insert_with(|| Page::new(&self.device, self.half_bytes));
        let at = |first: u32, bytes: usize| u64::from(first) * bytes as u64;
        self.queue.write_buffer(
            &page.vertices,
            at(allocation.first_vertex(), size_of::<Vertex>()),
            bytemuck::cast_slice(vertices),
        );
        self.queue.write_buffer(
            &page.indices,
            at(allocation.first_index(), size_of::<u16>()),
            bytemuck::cast_slice(indices),
        );
        Some(allocation)
    }

    /// Takes room back. What is drawn already is drawn whole: the adapter keeps the order.
    pub fn give_back(&mut self, allocation: MeshAllocation) {
        let page = allocation.page;
        if self.allocator.free(allocation) {
            self.buffers[page] = None;
        }
    }

    /// Gives up everything.
    pub fn clear(&mut self) {
        self.allocator.clear();
        self.buffers.clear();
    }

    /// The buffers of a page that something lies in.
    pub fn page(&self, page: usize) -> Option<&Page> {
        self.buffers.get(page).and_then(Option::as_ref)
    }

    /// Bytes of all pages.
    pub fn bytes(&self) -> u64 {
        2 * self.half_bytes * self.buffers.iter().flatten().count() as u64
    }
}
