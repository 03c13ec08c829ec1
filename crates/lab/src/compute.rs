//! One compute pass over a list of inputs, on the adapter in use.
//!
//! The shared shader text stands in front of every shader given here, so what is measured is the
//! code the game draws with. A shader has its inputs at binding 0, its outputs at binding 1, and
//! an entry point `main` of 64 invocations.

use antipode_geometry::WGSL;
use antipode_render::Gpu;
use bytemuck::Pod;
use wgpu::BufferUsages as Usage;

use crate::error::LabError;

/// The loop around a measurement: one entry per input, `BODY` sees `i`, `inputs` and `outputs`.
pub fn shader(declarations: &str, input: &str, output: &str, body: &str) -> String {
    format!(
        "{declarations}
@group(0) @binding(0) var<storage, read> inputs: array<{input}>;
@group(0) @binding(1) var<storage, read_write> outputs: array<{output}>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {{
    let i = id.x;
    if i >= arrayLength(&inputs) {{ return; }}
    {body}
}}"
    )
}

/// Inputs in one pass at most: a pass has at most 65535 groups of 64, and buffers have limits.
const MOST_AT_ONCE: usize = 1 << 18;

/// One `Out` for each `In`.
///
/// # Errors
/// [`LabError::Compute`] when the shader is refused or its results cannot be read.
pub fn run<In: Pod, Out: Pod>(
    gpu: &Gpu,
    shader: &str,
    inputs: &[In],
) -> Result<Vec<Out>, LabError> {
    let pipeline = pipeline(gpu, shader);
    let mut outputs = Vec::with_capacity(inputs.len());
    for some in inputs.chunks(MOST_AT_ONCE) {
        outputs.extend(pass::<In, Out>(gpu, &pipeline, some)?);
    }
    Ok(outputs)
}

fn failed(gpu: &Gpu, why: &impl ToString) -> LabError {
    LabError::Compute {
        adapter: gpu.name().to_owned(),
        why: why.to_string(),
    }
}

fn pipeline(gpu: &Gpu, shader: &str) -> wgpu::ComputePipeline {
    let source = format!("{WGSL}\n{shader}");
    let module = gpu
        .device
        .create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("laboratory"),
            source: wgpu::ShaderSource::Wgsl(source.into()),
        });
    gpu.device
        .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some("laboratory"),
            layout: None,
            module: &module,
            entry_point: Some("main"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        })
}

fn buffer(gpu: &Gpu, size: usize, usage: Usage) -> wgpu::Buffer {
    gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("laboratory"),
        size: size as u64,
        usage,
        mapped_at_creation: false,
    })
}

fn pass<In: Pod, Out: Pod>(
    gpu: &Gpu,
    pipeline: &wgpu::ComputePipeline,
    inputs: &[In],
) -> Result<Vec<Out>, LabError> {
    let size = size_of_val(inputs) / size_of::<In>() * size_of::<Out>();
    let source = buffer(gpu, size_of_val(inputs), Usage::STORAGE | Usage::COPY_DST);
    gpu.queue
        .write_buffer(&source, 0, bytemuck::cast_slice(inputs));
    let target = buffer(gpu, size, Usage::STORAGE | Usage::COPY_SRC);
    let mapped = buffer(gpu, size, Usage::MAP_READ | Usage::COPY_DST);
    let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("laboratory"),
        layout: &pipeline.get_bind_group_layout(0),
        entries: &[
            wgpu::BindGroupEntry {
                binding: 0,
                resource: source.as_entire_binding(),
            },
            wgpu::BindGroupEntry {
                binding: 1,
                resource: target.as_entire_binding(),
            },
        ],
    });
    let mut encoder = gpu
        .device
        .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    {
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.dispatch_workgroups(inputs.len().div_ceil(64) as u32, 1, 1);
    }
    encoder.copy_buffer_to_buffer(&target, 0, &mapped, 0, size as u64);
    gpu.queue.submit([encoder.finish()]);
    read(gpu, &mapped)
}

fn read<Out: Pod>(gpu: &Gpu, mapped: &wgpu::Buffer) -> Result<Vec<Out>, LabError> {
    let (tell, told) = std::sync::mpsc::channel();
    mapped.map_async(wgpu::MapMode::Read, .., move |result| {
        // The receiver is gone only when this function has returned already.
        let _ = tell.send(result);
    });
    gpu.wait()?;
    if let Some(error) = gpu.take_error() {
        return Err(failed(gpu, &error));
    }
    match told.recv() {
        Ok(Ok(())) => {}
        Ok(Err(error)) => return Err(failed(gpu, &error)),
        Err(error) => return Err(failed(gpu, &error)),
    }
    let view = mapped
        .get_mapped_range(..)
        .map_err(|error| failed(gpu, &error))?;
    Ok(bytemuck::pod_collect_to_vec(&view[..]))
}
