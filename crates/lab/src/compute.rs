//! One compute pass over a list of inputs, on the adapter in use.
//!
//! The shared shader text and that of a map stand in front of every shader given here, so what is measured is the
//! code the game draws with. A shader has its inputs at binding 0, its outputs at binding 1, and
//! an entry point `main` of 64 invocations.

use antipode_geometry::MapShader;
use antipode_geometry::shader::MAPS;
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

/// One `Out` for each `In`, by the shader of each input's map, by its place in [`MAPS`].
///
/// # Errors
/// As [`run`].
pub fn run_by_map<In: Pod, Out: Pod>(
    gpu: &Gpu,
    shader: &str,
    inputs: &[In],
    map_of: impl Fn(&In) -> u32,
) -> Result<Vec<Out>, LabError> {
    let mut outputs = vec![Out::zeroed(); inputs.len()];
    for (number, map) in (0..).zip(MAPS) {
        let places: Vec<usize> = (0..inputs.len())
            .filter(|i| map_of(&inputs[*i]) == number)
            .collect();
        if places.is_empty() {
            continue;
        }
        let own: Vec<In> = places.iter().map(|i| inputs[*i]).collect();
        for (i, output) in places.into_iter().zip(run(gpu, map, shader, &own)?) {
            outputs[i] = output;
        }
    }
    Ok(outputs)
}

/// The place of a map in [`MAPS`].
pub fn number_of(map: &MapShader) -> u32 {
    let place = MAPS.iter().position(|it| it.name == map.name);
    place.map_or(u32::MAX, |place| place as u32)
}

/// One `Out` for each `In`, by the shader of a map.
///
/// # Errors
/// [`LabError::Compute`] when the shader is refused or its results cannot be read.
pub fn run<In: Pod, Out: Pod>(
    gpu: &Gpu,
    map: &MapShader,
    shader: &str,
    inputs: &[In],
) -> Result<Vec<Out>, LabError> {
    let pipeline = pipeline(gpu, map, shader);
    let mut outputs = Vec::with_capacity(inputs.len());
    for some in inputs.chunks(MOST_AT_ONCE) {
        outputs.extend(pass::<In, Out>(gpu, &pipeline, some)?);
    }
    Ok(outputs)
}

pub(crate) fn failed(gpu: &Gpu, why: &impl ToString) -> LabError {
    LabError::Compute {
        adapter: gpu.name().to_owned(),
        why: why.to_string(),
    }
}

/// The pass of a shader, behind the shared text and a map's.
pub(crate) fn pipeline(gpu: &Gpu, map: &MapShader, shader: &str) -> wgpu::ComputePipeline {
    let source = map.geometry() + shader;
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

/// An empty buffer of so many bytes.
pub(crate) fn buffer(gpu: &Gpu, size: usize, usage: Usage) -> wgpu::Buffer {
    gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("laboratory"),
        size: size as u64,
        usage,
        mapped_at_creation: false,
    })
}

/// A buffer with those bytes in it.
pub(crate) fn filled(gpu: &Gpu, bytes: &[u8], usage: Usage) -> wgpu::Buffer {
    let buffer = buffer(gpu, bytes.len(), usage | Usage::COPY_DST);
    gpu.queue.write_buffer(&buffer, 0, bytes);
    buffer
}

/// Those buffers at the bindings from 0 on.
pub(crate) fn bound(
    gpu: &Gpu,
    pipeline: &wgpu::ComputePipeline,
    buffers: &[&wgpu::Buffer],
) -> wgpu::BindGroup {
    let entries: Vec<_> = (0..)
        .zip(buffers)
        .map(|(binding, buffer)| wgpu::BindGroupEntry {
            binding,
            resource: buffer.as_entire_binding(),
        })
        .collect();
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("laboratory"),
        layout: &pipeline.get_bind_group_layout(0),
        entries: &entries,
    })
}

fn pass<In: Pod, Out: Pod>(
    gpu: &Gpu,
    pipeline: &wgpu::ComputePipeline,
    inputs: &[In],
) -> Result<Vec<Out>, LabError> {
    let size = size_of_val(inputs) / size_of::<In>() * size_of::<Out>();
    let source = filled(gpu, bytemuck::cast_slice(inputs), Usage::STORAGE);
    let target = buffer(gpu, size, Usage::STORAGE | Usage::COPY_SRC);
    let group = bound(gpu, pipeline, &[&source, &target]);
    let mut encoder = gpu.encoder();
    {
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.dispatch_workgroups(inputs.len().div_ceil(64) as u32, 1, 1);
    }
    gpu.queue.submit([encoder.finish()]);
    read(gpu, &target, size)
}

/// The first `size` bytes of a buffer.
///
/// # Errors
/// When the adapter fails.
pub(crate) fn read<Out: Pod>(
    gpu: &Gpu,
    source: &wgpu::Buffer,
    size: usize,
) -> Result<Vec<Out>, LabError> {
    let mapped = buffer(gpu, size, Usage::MAP_READ | Usage::COPY_DST);
    let mut encoder = gpu.encoder();
    encoder.copy_buffer_to_buffer(source, 0, &mapped, 0, size as u64);
    gpu.queue.submit([encoder.finish()]);
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
