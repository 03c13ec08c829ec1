//! Measures the adapter's own time of a frame by timestamps, which are read some frames later without waiting.

use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};

use wgpu::{
    Buffer, BufferUsages, CommandEncoder, Device, Features, QuerySet, Queue,
    RenderPassTimestampWrites,
};

/// Frames that may be under way before one is skipped.
const DEPTH: usize = 4;
const STAMPS: u32 = 2;
const BYTES: u64 = STAMPS as u64 * size_of::<u64>() as u64;

const FREE: u8 = 0;
const RECORDED: u8 = 1;
const MAPPING: u8 = 2;
const MAPPED: u8 = 3;
const FAILED: u8 = 4;

#[derive(Debug)]
struct Slot {
    buffer: Buffer,
    state: Arc<AtomicU8>,
}

/// Timestamps around a frame.
#[derive(Debug)]
pub struct Timing {
    queries: QuerySet,
    resolved: Buffer,
    slots: [Slot; DEPTH],
    nanoseconds_per_tick: f32,
    latest_ms: Option<f32>,
}

impl Timing {
    /// None where the device cannot tell.
    pub fn new(device: &Device, queue: &Queue) -> Option<Self> {
        if !device.features().contains(Features::TIMESTAMP_QUERY) {
            return None;
        }
        let queries = device.create_query_set(&wgpu::QuerySetDescriptor {
            label: Some("frame"),
            ty: wgpu::QueryType::Timestamp,
            count: STAMPS,
        });
        let buffer = |usage| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("frame times"),
                size: BYTES,
                usage,
                mapped_at_creation: false,
            })
        };
        let slot = |_| Slot {
            buffer: buffer(BufferUsages::COPY_DST | BufferUsages::MAP_READ),
            state: Arc::new(AtomicU8::new(FREE)),
        };
        Some(Self {
            resolved: buffer(BufferUsages::QUERY_RESOLVE | BufferUsages::COPY_SRC),
            queries,
            slots: std::array::from_fn(slot),
            nanoseconds_per_tick: queue.get_timestamp_period(),
            latest_ms: None,
        })
    }

    /// Writes of the first pass.
    pub fn begin(&self) -> RenderPassTimestampWrites<'_> {
        RenderPassTimestampWrites {
            query_set: &self.queries,
            beginning_of_pass_write_index: Some(0),
            end_of_pass_write_index: None,
        }
    }

    /// Writes of the last pass.
    pub fn end(&self) -> RenderPassTimestampWrites<'_> {
        RenderPassTimestampWrites {
            query_set: &self.queries,
            beginning_of_pass_write_index: None,
            end_of_pass_write_index: Some(1),
        }
    }

    /// Records the copy of this frame's stamps, where a slot is free.
    pub fn record(&self, encoder: &mut CommandEncoder) {
        if let Some(slot) = self
            .slots
            .iter()
            .find(|slot| slot.state.load(Ordering::Acquire) == FREE)
        {
            encoder.resolve_query_set(&self.queries, 0..STAMPS, &self.resolved, 0);
            encoder.copy_buffer_to_buffer(&self.resolved, 0, &slot.buffer, 0, BYTES);
            slot.state.store(RECORDED, Ordering::Release);
        }
    }

    /// Collects what has come back; to be called before a frame, when the last one has been submitted.
    /// Milliseconds of the latest frame known.
    pub fn collect(&mut self, device: &Device) -> Option<f32> {
        for slot in &self.slots {
            if slot.state.load(Ordering::Acquire) == RECORDED {
                slot.state.store(MAPPING, Ordering::Release);
                let state = Arc::clone(&slot.state);
                slot.buffer.map_async(wgpu::MapMode::Read, .., move |done| {
                    state.store(
                        if done.is_ok() { MAPPED } else { FAILED },
                        Ordering::Release,
                    );
                });
            }
        }
        // A lost device is told of by its own callback.
        let _ = device.poll(wgpu::PollType::Poll);
        for slot in &self.slots {
            match slot.state.load(Ordering::Acquire) {
                MAPPED => {
                    if let Some(ticks) = read(&slot.buffer) {
                        self.latest_ms = Some(ticks as f32 * self.nanoseconds_per_tick * 1e-6);
                    }
                    slot.buffer.unmap();
                    slot.state.store(FREE, Ordering::Release);
                }
                FAILED => slot.state.store(FREE, Ordering::Release),
                _ => (),
            }
        }
        self.latest_ms
    }
}

/// Ticks between the stamps; none when they were never written.
fn read(buffer: &Buffer) -> Option<u64> {
    let bytes = buffer.get_mapped_range(..).ok()?;
    let stamps: [u64; STAMPS as usize] = bytemuck::try_pod_read_unaligned(&bytes).ok()?;
    stamps[1].checked_sub(stamps[0]).filter(|ticks| *ticks > 0)
}
