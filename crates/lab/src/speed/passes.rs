//! Compute passes over a million vertices, and how long they take.

use std::time::Instant;

use antipode_geometry::{MapShader, SpaceUniform};
use antipode_render::Gpu;
use wgpu::BufferUsages as Usage;

use crate::compute::{bound, buffer, filled, pipeline, read};
use crate::speed::clock::{median, worked_s};
use crate::{Effort, LabError};

/// Vertices of a pass.
pub const VERTICES: usize = 1_000_000;
const WORKGROUP: u32 = 64;

/// What is around every variant's body, which sees `p`, `n` and `space`, and sets `v`, `extra`.
const FRAME: &str = "
@group(0) @binding(0) var<uniform> space: Space;
@group(0) @binding(1) var<storage, read> vertices: array<vec4<f32>>;
@group(0) @binding(2) var<storage, read_write> seen: array<vec4<f32>>;
const LIGHT = vec3<f32>(0.48, 0.8, 0.36);
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&vertices) { return; }
    let packed = vertices[id.x];
    let p = packed.xyz;
    let n = normalize(unpack4x8snorm(bitcast<u32>(packed.w)).xyz);
    var v: vec4<f32>;
    var extra: f32;
    BODY
    seen[id.x] = vec4<f32>(v.xyz, extra);
}
";

/// A variant ready to run.
pub struct Pass {
    pipeline: wgpu::ComputePipeline,
    bindings: wgpu::BindGroup,
    /// What it writes: view coordinates and what else it computed.
    pub seen: wgpu::Buffer,
}

impl Pass {
    /// The pass of a body in a space, from vertices (xyz and packed normal) to what they are seen as.
    pub fn new(
        gpu: &Gpu,
        body: &str,
        (map, uniform): (&MapShader, &SpaceUniform),
        inputs: &wgpu::Buffer,
        seen: &wgpu::Buffer,
    ) -> Self {
        let body = FRAME.replace("BODY", body);
        let pipeline = pipeline(gpu, map, &body);
        let space = filled(gpu, bytemuck::bytes_of(uniform), Usage::UNIFORM);
        let bindings = bound(gpu, &pipeline, &[&space, inputs, seen]);
        Self {
            pipeline,
            bindings,
            seen: seen.clone(),
        }
    }

    fn record(&self, encoder: &mut wgpu::CommandEncoder, stamps: Option<&wgpu::QuerySet>) {
        let timestamp_writes = stamps.map(|query_set| wgpu::ComputePassTimestampWrites {
            query_set,
            beginning_of_pass_write_index: Some(0),
            end_of_pass_write_index: Some(1),
        });
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: None,
            timestamp_writes,
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.bindings, &[]);
        pass.dispatch_workgroups((VERTICES as u32).div_ceil(WORKGROUP), 1, 1);
    }
}

/// Times passes: by a graphics card's timestamps, by the threads' time of a software adapter, or where neither can
/// be told by the wall clock.
pub struct Watch<'g> {
    gpu: &'g Gpu,
    stamps: Option<(wgpu::QuerySet, wgpu::Buffer)>,
}

impl<'g> Watch<'g> {
    /// A watch over passes on that adapter.
    pub fn new(gpu: &'g Gpu) -> Self {
        // A software adapter stamps a pass when it is queued, not when its threads are done.
        let has = !gpu.is_software()
            && gpu
                .device
                .features()
                .contains(wgpu::Features::TIMESTAMP_QUERY);
        let stamps = has.then(|| {
            let queries = gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("vertex stage"),
                ty: wgpu::QueryType::Timestamp,
                count: 2,
            });
            (
                queries,
                buffer(gpu, 16, Usage::QUERY_RESOLVE | Usage::COPY_SRC),
            )
        });
        Self { gpu, stamps }
    }

    /// Seconds that a pass takes.
    ///
    /// # Errors
    /// When the adapter fails.
    pub fn time(&self, pass: &Pass) -> Result<f64, LabError> {
        let gpu = self.gpu;
        let mut encoder = gpu.encoder();
        pass.record(&mut encoder, self.stamps.as_ref().map(|s| &s.0));
        if let Some((queries, resolved)) = &self.stamps {
            encoder.resolve_query_set(queries, 0..2, resolved, 0);
        }
        let before_s = worked_s();
        let began = Instant::now();
        gpu.queue.submit([encoder.finish()]);
        gpu.wait()?;
        let wall_s = began.elapsed().as_secs_f64();
        let Some((_, resolved)) = &self.stamps else {
            let worked = worked_s().zip(before_s).filter(|_| gpu.is_software());
            return Ok(worked.map_or(wall_s, |(after, before)| after - before));
        };
        let ticks: Vec<u64> = read(gpu, resolved, 16)?;
        let period_s = f64::from(gpu.queue.get_timestamp_period()) * 1e-9;
        Ok(match ticks[..] {
            [begin, end] if end > begin => (end - begin) as f64 * period_s,
            _ => wall_s,
        })
    }
}

/// Nanoseconds per vertex, interleaved, least of the rounds' medians.
///
/// # Errors
/// When the adapter fails.
pub fn race(watch: &Watch<'_>, passes: &[Pass], effort: Effort) -> Result<Vec<f64>, LabError> {
    let (rounds, turns) = if effort.quick { (2, 3) } else { (5, 7) };
    let mut best = vec![f64::INFINITY; passes.len()];
    for _ in 0..rounds {
        let mut times = vec![Vec::new(); passes.len()];
        for _ in 0..turns {
            for (pass, own) in passes.iter().zip(&mut times) {
                own.push(watch.time(pass)?);
            }
        }
        for (least, own) in best.iter_mut().zip(&mut times) {
            *least = least.min(median(own) * 1e9 / VERTICES as f64);
        }
    }
    Ok(best)
}
