//! One compute pass over a list of inputs.

use std::io::Write;
use std::sync::LazyLock;

use antipode_geometry::WGSL;
use bytemuck::Pod;

/// A device that computes.
pub struct Gpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
}

/// One device for every test of this file: they share a process.
pub static GPU: LazyLock<Option<Gpu>> = LazyLock::new(|| {
    let gpu = open();
    if gpu.is_none() {
        let required = std::env::var("ANTIPODE_REQUIRE_GPU").is_ok_and(|v| v == "1");
        assert!(!required, "ANTIPODE_REQUIRE_GPU=1, and no adapter computes");
        // Written past the test harness, which would swallow it in a test that passes.
        let _ = writeln!(
            std::io::stderr(),
            "SKIPPED: no adapter; the shader's numbers were NOT checked"
        );
    }
    gpu
});

fn open() -> Option<Gpu> {
    let instance =
        wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
    let adapter =
        pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))
            .ok()?;
    eprintln!("adapter: {}", adapter.get_info().name);
    let wanted = wgpu::DeviceDescriptor {
        required_limits: adapter.limits(),
        ..Default::default()
    };
    let (device, queue) = pollster::block_on(adapter.request_device(&wanted)).ok()?;
    Some(Gpu { device, queue })
}

impl Gpu {
    fn buffer(&self, size: u64, usage: wgpu::BufferUsages) -> wgpu::Buffer {
        self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size,
            usage,
            mapped_at_creation: false,
        })
    }

    fn pipeline(&self, shader: &str) -> wgpu::ComputePipeline {
        let source = format!("{WGSL}\n{shader}");
        let module = self
            .device
            .create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some("geometry"),
                source: wgpu::ShaderSource::Wgsl(source.into()),
            });
        self.device
            .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some("geometry"),
                layout: None,
                module: &module,
                entry_point: Some("main"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                cache: None,
            })
    }

    /// One `Out` for each `In`.
    pub fn compute<In: Pod, Out: Pod>(&self, shader: &str, input: &[In]) -> Vec<Out> {
        use wgpu::BufferUsages as Usage;
        let bytes: &[u8] = bytemuck::cast_slice(input);
        let size = (input.len() * size_of::<Out>()) as u64;
        let source = self.buffer(bytes.len() as u64, Usage::STORAGE | Usage::COPY_DST);
        self.queue.write_buffer(&source, 0, bytes);
        let target = self.buffer(size, Usage::STORAGE | Usage::COPY_SRC);
        let mapped = self.buffer(size, Usage::MAP_READ | Usage::COPY_DST);
        let pipeline = self.pipeline(shader);
        let group = self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
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
        let mut encoder = self
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(&pipeline);
            pass.set_bind_group(0, &group, &[]);
            pass.dispatch_workgroups((input.len() as u32).div_ceil(64), 1, 1);
        }
        encoder.copy_buffer_to_buffer(&target, 0, &mapped, 0, size);
        self.queue.submit([encoder.finish()]);
        mapped.map_async(wgpu::MapMode::Read, .., |result| result.unwrap());
        self.device
            .poll(wgpu::PollType::wait_indefinitely())
            .unwrap();
        let view = mapped.get_mapped_range(..).unwrap();
        bytemuck::pod_collect_to_vec(&view[..])
    }
}
