//! The pass that draws a picture.

use std::ops::Range;
use std::sync::OnceLock;

use wgpu::{
    BindGroup, BindGroupLayout, BindingType, Buffer, BufferBindingType, CommandEncoder,
    ComputePipeline, Device, Queue, ShaderStages,
};

use crate::error::RaysError;
use crate::frame::{Frame, Lamps, Part, corners, frame, lamps};
use crate::kinds::Kinds;
use crate::loaded::Loaded;
use crate::options::{Options, View};
use crate::packed::Rule;
use crate::picture::{LIGHT_FORMAT, Picture, SEEN_FORMAT};
use crate::raster::{Raster, way};
use crate::rastered::sight;
use crate::scene::{Eye, RayScene};
use crate::shaders::{PICTURE, compile};
use crate::textures::Uploads;
use crate::trees::Trees;

/// Pixels of a group along each side.
pub const GROUP: u32 = 8;

/// What draws pictures of scenes.
#[derive(Debug)]
pub struct Rays {
    /// By the number of what is told beforehand; compiled when they are asked for.
    pipelines: [OnceLock<ComputePipeline>; Kinds::COUNT],
    pub(crate) raster: Raster,
    pub(crate) scene_layout: BindGroupLayout,
    pub(crate) picture_layout: BindGroupLayout,
    /// One for each part of a picture.
    pub(crate) frames: [Buffer; 2],
    pub(crate) lamps: Buffer,
    sampler: wgpu::Sampler,
    uploads: Uploads,
    trees: Trees,
}

impl Rays {
    /// Compiles the shaders.
    ///
    /// # Errors
    /// When the adapter lacks compute shaders, storage buffers or textures that they write into, or refuses them.
    pub fn new(device: &Device) -> Result<Self, RaysError> {
        accepted(device, || {
            let scene_layout = scene_layout(device);
            let picture_layout = picture_layout(device);
            let written = |label, size, usage| {
                device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some(label),
                    size: size as u64,
                    usage: usage | wgpu::BufferUsages::COPY_DST,
                    mapped_at_creation: false,
                })
            };
            let rays = Self {
                pipelines: std::array::from_fn(|_| OnceLock::new()),
                raster: Raster::new(device),
                scene_layout,
                picture_layout,
                frames: [(); 2].map(|()| {
                    written(
                        "frame of rays",
                        size_of::<Frame>(),
                        wgpu::BufferUsages::STORAGE,
                    )
                }),
                lamps: written(
                    "lamps of rays",
                    size_of::<Lamps>(),
                    wgpu::BufferUsages::UNIFORM,
                ),
                uploads: Uploads::default(),
                trees: Trees::default(),
                sampler: device.create_sampler(&wgpu::SamplerDescriptor {
                    label: Some("room textures"),
                    address_mode_u: wgpu::AddressMode::Repeat,
                    address_mode_v: wgpu::AddressMode::Repeat,
                    mag_filter: wgpu::FilterMode::Linear,
                    min_filter: wgpu::FilterMode::Linear,
                    mipmap_filter: wgpu::MipmapFilterMode::Linear,
                    ..Default::default()
                }),
            };
            rays.pipeline(device, Kinds::default());
            rays
        })
    }

    pub(crate) fn has_pipeline(&self, kinds: Kinds) -> bool {
        self.pipelines[kinds.number()].get().is_some()
    }

    pub(crate) fn pipeline(&self, device: &Device, kinds: Kinds) -> &ComputePipeline {
        self.pipelines[kinds.number()].get_or_init(|| {
            let layouts = [&self.scene_layout, &self.picture_layout];
            pipeline(device, ("rays", &PICTURE, "draw"), &layouts, kinds)
        })
    }

    /// Puts a scene into the adapter's memory. What pictures of it are drawn with is compiled when the first one asks for it, or
    /// before ([`Self::compile`]).
    ///
    /// # Errors
    /// When the scene is faulty or too large for the adapter.
    pub fn upload(
        &self,
        device: &Device,
        queue: &Queue,
        scene: &RayScene,
    ) -> Result<Loaded, RaysError> {
        let textures = self.uploads.put(device, queue, &scene.textures)?;
        Loaded::new(device, queue, (scene, textures), (&self.trees, true))
    }

    /// The same without a hierarchy in the meshes: a ray asks every triangle of a mesh whose box it meets, as that of the
    /// thesis does. To be measured beside.
    ///
    /// # Errors
    /// As [`Self::upload`].
    pub fn upload_unsorted(
        &self,
        device: &Device,
        queue: &Queue,
        scene: &RayScene,
    ) -> Result<Loaded, RaysError> {
        let textures = self.uploads.put(device, queue, &scene.textures)?;
        Loaded::new(device, queue, (scene, textures), (&self.trees, false))
    }

    /// Records the pass for a whole picture, as [`Self::draw_rows`] does.
    pub fn draw(
        &self,
        gpu: (&Device, &Queue),
        encoder: &mut CommandEncoder,
        what: (&RayScene, &Loaded),
        (eye, picture): (&Eye, &Picture),
        options: Options,
    ) {
        let rows = 0..picture.size.1;
        self.draw_rows(gpu, encoder, what, (eye, picture), options, rows);
    }

    /// Records the pass for some rows of a picture, so that one which takes long can be made bit by bit. Of `scene`, light, sky, fog and the look of outlines are those of this moment; the rest is as it was
    /// loaded and moved since. One picture a submission, since all share a buffer.
    pub fn draw_rows(
        &self,
        (device, queue): (&Device, &Queue),
        encoder: &mut CommandEncoder,
        (scene, loaded): (&RayScene, &Loaded),
        (eye, picture): (&Eye, &Picture),
        options: Options,
        rows: Range<u32>,
    ) {
        let options = Options {
            bounces: options.bounces.min(4),
            ..options
        };
        let sight = sight(scene, loaded, eye, options);
        let way = way(&sight);
        if self.begins_by_raster(loaded, way, options) {
            let gpu = (device, queue);
            let what = (scene, loaded, way);
            self.draw_rastered(gpu, encoder, what, (eye, picture), options, rows);
            return;
        }
        let width = picture.size.0;
        let lines = rows.end.saturating_sub(rows.start).div_ceil(GROUP);
        let ways = (loaded.host_ways)
            .with_corners(&corners(eye, picture.size))
            .with_outlines(options.outlines);
        queue.write_buffer(&loaded.ways, 0, bytemuck::bytes_of(&ways));
        queue.write_buffer(&self.lamps, 0, bytemuck::bytes_of(&lamps(scene)));
        let (parts, line) = parts(options.view, width);
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: Some("rays"),
            timestamp_writes: None,
        });
        for ((rule, columns), buffer) in parts.into_iter().zip(&self.frames) {
            let kinds = loaded.kinds(rule).with_outlines(sight.outlines);
            pass.set_pipeline(self.pipeline(device, kinds));
            let groups = (columns.end - columns.start).div_ceil(GROUP);
            let part = Part {
                columns,
                rows: rows.clone(),
                line,
            };
            let packed = frame(scene, eye, picture.size, options, &part);
            queue.write_buffer(buffer, 0, bytemuck::bytes_of(&packed));
            let scene = scene_group(device, &self.scene_layout, loaded, rule);
            pass.set_bind_group(0, &scene, &[]);
            let picture = self.picture_group(device, loaded, picture, buffer);
            pass.set_bind_group(1, &picture, &[]);
            pass.dispatch_workgroups(groups, lines, 1);
        }
    }

    pub(crate) fn picture_group(
        &self,
        device: &Device,
        loaded: &Loaded,
        picture: &Picture,
        frame: &Buffer,
    ) -> BindGroup {
        use wgpu::BindingResource::{Sampler, TextureView};
        let resources = [
            frame.as_entire_binding(),
            loaded.materials.as_entire_binding(),
            loaded.attributes.as_entire_binding(),
            TextureView(&loaded.textures),
            Sampler(&self.sampler),
            TextureView(&picture.light),
            TextureView(&picture.seen),
            self.lamps.as_entire_binding(),
        ];
        group(device, "picture of rays", &self.picture_layout, resources)
    }
}

/// Columns of a picture by their rules, and the column of the line between them.
fn parts(view: View, width: u32) -> (Vec<(Rule, Range<u32>)>, u32) {
    let whole = |rule| (vec![(rule, 0..width)], u32::MAX);
    let middle = width / 2;
    match view {
        View::Exact => whole(Rule::Exact),
        View::Thesis => whole(Rule::Thesis),
        View::Plain => whole(Rule::Plain),
        View::Split => (
            vec![(Rule::Thesis, 0..middle), (Rule::Exact, middle..width)],
            middle,
        ),
    }
}

/// Makes something on a device, or says in the device's words why it will not.
pub fn accepted<T>(device: &Device, make: impl FnOnce() -> T) -> Result<T, RaysError> {
    use wgpu::ErrorFilter::{Internal, OutOfMemory, Validation};
    let scopes = [Internal, OutOfMemory, Validation].map(|filter| device.push_error_scope(filter));
    let made = make();
    let [internal, memory, validation] = scopes;
    let refused = [validation, memory, internal]
        .into_iter()
        .filter_map(|scope| pollster::block_on(scope.pop()))
        .collect::<Vec<_>>();
    match refused.first() {
        Some(error) => Err(RaysError::Adapter(error.to_string())),
        None => Ok(made),
    }
}

/// A compute pipeline of one entry, for scenes of which this is told beforehand.
pub fn pipeline(
    device: &Device,
    (label, files, entry): (&str, &[&str], &str),
    layouts: &[&BindGroupLayout],
    kinds: Kinds,
) -> ComputePipeline {
    pipeline_with(device, (label, files, entry), layouts, kinds, &[])
}

/// The same with more constants.
pub fn pipeline_with(
    device: &Device,
    (label, files, entry): (&str, &[&str], &str),
    layouts: &[&BindGroupLayout],
    kinds: Kinds,
    more: &[(&str, f64)],
) -> ComputePipeline {
    let of_kinds = kinds.constants();
    let of_kinds = of_kinds.map(|(name, it)| (name, f64::from(u8::from(it))));
    let constants = [&of_kinds[..], more].concat();
    let module = compile(device, label, files);
    let groups: Vec<_> = layouts.iter().map(|layout| Some(*layout)).collect();
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some(label),
        bind_group_layouts: &groups,
        immediate_size: 0,
    });
    device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(label),
        layout: Some(&layout),
        module: &module,
        entry_point: Some(entry),
        compilation_options: wgpu::PipelineCompilationOptions {
            constants: &constants,
            ..Default::default()
        },
        cache: None,
    })
}

/// A layout of things that a compute shader is bound to, in their order.
pub fn layout(device: &Device, label: &str, kinds: &[BindingType]) -> BindGroupLayout {
    let entries: Vec<_> = kinds
        .iter()
        .enumerate()
        .map(|(binding, ty)| wgpu::BindGroupLayoutEntry {
            binding: binding as u32,
            visibility: ShaderStages::COMPUTE,
            ty: *ty,
            count: None,
        })
        .collect();
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some(label),
        entries: &entries,
    })
}

/// Binds resources in their order.
pub fn group<const N: usize>(
    device: &Device,
    label: &str,
    layout: &BindGroupLayout,
    resources: [wgpu::BindingResource<'_>; N],
) -> BindGroup {
    let mut binding = 0;
    let entries = resources.map(|resource| {
        let entry = wgpu::BindGroupEntry { binding, resource };
        binding += 1;
        entry
    });
    device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some(label),
        layout,
        entries: &entries,
    })
}

/// A binding of a buffer.
pub fn buffer(ty: BufferBindingType) -> BindingType {
    BindingType::Buffer {
        ty,
        has_dynamic_offset: false,
        min_binding_size: None,
    }
}

/// Storage that is only read.
pub const READ: BufferBindingType = BufferBindingType::Storage { read_only: true };

/// What every pass knows of a scene.
pub fn scene_layout(device: &Device) -> BindGroupLayout {
    let uniform = buffer(BufferBindingType::Uniform);
    let texels = BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Uint,
        view_dimension: wgpu::TextureViewDimension::D2,
        multisampled: false,
    };
    layout(
        device,
        "scene of rays",
        &[
            uniform,
            buffer(READ),
            texels,
            texels,
            texels,
            buffer(READ),
            uniform,
        ],
    )
}

/// Binds a scene whose aberrations go by a rule.
pub fn scene_group(
    device: &Device,
    layout: &BindGroupLayout,
    loaded: &Loaded,
    rule: Rule,
) -> BindGroup {
    use wgpu::BindingResource::TextureView;
    let resources = [
        loaded.space(rule).as_entire_binding(),
        loaded.neighbours.as_entire_binding(),
        TextureView(&loaded.nodes.view),
        TextureView(&loaded.triangles.view),
        TextureView(&loaded.instances.view),
        loaded.ways.as_entire_binding(),
        loaded.portals.as_entire_binding(),
    ];
    group(device, "scene of rays", layout, resources)
}

fn picture_layout(device: &Device) -> BindGroupLayout {
    let written = |format| BindingType::StorageTexture {
        access: wgpu::StorageTextureAccess::WriteOnly,
        format,
        view_dimension: wgpu::TextureViewDimension::D2,
    };
    let pictures = BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Float { filterable: true },
        view_dimension: wgpu::TextureViewDimension::D2Array,
        multisampled: false,
    };
    let kinds = [
        buffer(READ),
        buffer(READ),
        buffer(READ),
        pictures,
        BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
        written(LIGHT_FORMAT),
        written(SEEN_FORMAT),
        buffer(BufferBindingType::Uniform),
    ];
    layout(device, "picture of rays", &kinds)
}
