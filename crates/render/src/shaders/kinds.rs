//! What the kinds of ground look like at any distance, asked of the adapter.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use antipode_geometry::shader::FLAT;
use antipode_terrain::Kind;
use wgpu::util::{BufferInitDescriptor, DeviceExt};

use super::TERRAIN;
use crate::gpu::Gpu;

/// What pixels span, metres: from a nose on the ground to far land, a few in every pattern's fading.
const WIDE_M: [f32; 12] = [
    0.001, 0.004, 0.01, 0.02, 0.04, 0.08, 0.15, 0.3, 0.6, 1.2, 2.5, 6.0,
];

/// The means of the kinds' tones over 8192 places strewn over a plain, for each of those widths.
const KERNEL: &str = "
@group(0) @binding(1) var<storage> wide_m: array<f32>;
@group(0) @binding(2) var<storage, read_write> means: array<vec4<f32>>;
var<workgroup> sums: array<vec3<f32>, 64>;

@compute @workgroup_size(64)
fn kernel(@builtin(workgroup_id) which: vec3<u32>, @builtin(local_invocation_index) thread: u32) {
    var sum = vec3<f32>(0.0);
    for (var n = 0u; n < 128u; n++) {
        let seed = (thread * 128u + n) * 3u + 7u;
        let place = vec3<f32>(
            mix_bits(seed * 0x9e3779b1u),
            mix_bits((seed + 1u) * 0x85ebca77u),
            mix_bits((seed + 2u) * 0xc2b2ae3du),
        );
        let spot = Spot(place * vec3<f32>(200.0, 30.0, 200.0), vec3<f32>(0.0, 1.0, 0.0), wide_m[which.y]);
        sum += detail_of(which.x + 1u, spot).tone;
    }
    sums[thread] = sum;
    workgroupBarrier();
    if thread == 0u {
        var all = vec3<f32>(0.0);
        for (var n = 0u; n < 64u; n++) {
            all += sums[n];
        }
        means[which.x * arrayLength(&wide_m) + which.y] = vec4<f32>(all / 8192.0, 0.0);
    }
}";

#[test]
fn every_kind_keeps_its_mean_colour_at_every_distance() {
    use wgpu::BufferUsages as Usage;
    let Some(gpu) = Gpu::for_test() else {
        return;
    };
    let pipeline = gpu.kernel(TERRAIN.source(Some(&FLAT)) + KERNEL);
    let asked = gpu.device.create_buffer_init(&BufferInitDescriptor {
        label: None,
        contents: bytemuck::cast_slice(&WIDE_M),
        usage: Usage::STORAGE,
    });
    let means = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: (16 * WIDE_M.len() * Kind::ALL.len()) as u64,
        usage: Usage::STORAGE | Usage::COPY_SRC,
        mapped_at_creation: false,
    });
    let entries = [(1, &asked), (2, &means)].map(|(binding, buffer)| wgpu::BindGroupEntry {
        binding,
        resource: buffer.as_entire_binding(),
    });
    let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &pipeline.get_bind_group_layout(0),
        entries: &entries,
    });
    let mut encoder = gpu.encoder();
    {
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.dispatch_workgroups(Kind::ALL.len() as u32, WIDE_M.len() as u32, 1);
    }
    gpu.queue.submit([encoder.finish()]);
    let means = gpu.read_back(&means);
    for (number, means) in (1..).zip(means.chunks(WIDE_M.len())) {
        let kind = Kind::of_byte(number).unwrap();
        for (wide_m, [r, g, b, _]) in WIDE_M.into_iter().zip(means) {
            for mean in [r, g, b] {
                assert!(
                    (mean - 1.0).abs() < 0.06,
                    "{kind:?} where pixels span {wide_m} m: {r} {g} {b} of its tint"
                );
            }
        }
    }
    assert_eq!(gpu.take_error(), None);
}
