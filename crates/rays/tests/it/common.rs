//! What tests share: an adapter, and scenes.

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use antipode_deformation::{Place, Triangle};
use antipode_rays::{
    Eye, Instance, Loaded, Material, Mesh, Mover, Options, Picture, Pixel, RayScene, Rays,
};
use glam::{Affine3A, DVec3, Vec3};

/// An open adapter with compiled shaders.
pub struct Gpu {
    pub device: wgpu::Device,
    pub queue: wgpu::Queue,
    pub rays: Rays,
    /// Whoever draws holds it: pictures share a uniform.
    pub drawing: Mutex<()>,
}

impl Gpu {
    /// The adapter of all tests, since software takes seconds to compile the shaders; or none and a loud word.
    pub fn shared() -> Option<&'static Self> {
        static SHARED: OnceLock<Result<Gpu, String>> = OnceLock::new();
        let opened = SHARED.get_or_init(open);
        antipode_testing::needed("a graphics adapter", opened.as_ref())
    }

    /// The same adapter, as if nothing was compiled or drawn yet.
    pub fn anew(&self) -> Self {
        Self::of(self.device.clone(), self.queue.clone()).unwrap()
    }

    fn of(device: wgpu::Device, queue: wgpu::Queue) -> Result<Self, String> {
        Ok(Self {
            rays: Rays::new(&device).map_err(|e| e.to_string())?,
            drawing: Mutex::new(()),
            device,
            queue,
        })
    }
}

fn open() -> Result<Gpu, String> {
    let instance =
        wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
    let wanted = wgpu::RequestAdapterOptions::default();
    let adapter =
        pollster::block_on(instance.request_adapter(&wanted)).map_err(|e| e.to_string())?;
    let descriptor = wgpu::DeviceDescriptor::default();
    let (device, queue) =
        pollster::block_on(adapter.request_device(&descriptor)).map_err(|e| e.to_string())?;
    Gpu::of(device, queue)
}

/// A mesh of triangles, all of one material.
pub fn mesh(triangles: &[Triangle]) -> Mesh {
    let corners = triangles.iter().flat_map(|triangle| triangle.corners);
    Mesh {
        positions: corners.map(DVec3::as_vec3).collect(),
        triangles: (0..triangles.len() as u32)
            .map(|n| [3 * n, 3 * n + 1, 3 * n + 2])
            .collect(),
        ..Mesh::default()
    }
}

/// A mesh that stands where its own coordinates say.
pub fn standing(mesh: usize, object: u32, materials: usize) -> Instance {
    Instance {
        mesh,
        pose: Affine3A::IDENTITY,
        object,
        materials,
    }
}

/// A scene with an instance for each object of a list of triangles.
pub fn scene_of(triangles: &[Triangle]) -> RayScene {
    let most = triangles
        .iter()
        .map(|triangle| triangle.object)
        .max()
        .unwrap_or(0);
    let mut scene = RayScene {
        materials: vec![Material {
            colour: Vec3::splat(0.6),
            ..Material::default()
        }],
        fog_m: 200.0,
        ..RayScene::default()
    };
    for object in 0..=most {
        let own: Vec<_> = triangles
            .iter()
            .filter(|t| t.object == object)
            .copied()
            .collect();
        scene
            .instances
            .push(standing(scene.meshes.len(), object, 0));
        scene.meshes.push(Arc::new(mesh(&own)));
    }
    scene
}

pub const SIZE: (u32, u32) = (64, 36);

pub type Light = Vec<[f32; 3]>;

pub fn draw(gpu: &Gpu, scene: &RayScene, eye: &Eye, options: Options) -> (Light, Vec<Pixel>) {
    let mut loaded = gpu.rays.upload(&gpu.device, &gpu.queue, scene).unwrap();
    draw_with(gpu, (scene, &mut loaded), &[], eye, options)
}

/// The same with movers.
pub fn draw_with(
    gpu: &Gpu,
    (scene, loaded): (&RayScene, &mut Loaded),
    movers: &[Mover],
    eye: &Eye,
    options: Options,
) -> (Light, Vec<Pixel>) {
    let _held = gpu.drawing.lock().unwrap_or_else(PoisonError::into_inner);
    loaded.show(&gpu.queue, movers).unwrap();
    let picture = Picture::new(&gpu.device, SIZE);
    let mut encoder = gpu
        .device
        .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    gpu.rays.draw(
        (&gpu.device, &gpu.queue),
        &mut encoder,
        (scene, loaded),
        (eye, &picture),
        options,
    );
    gpu.queue.submit([encoder.finish()]);
    (
        picture.read_light(&gpu.device, &gpu.queue).unwrap(),
        picture.read_seen(&gpu.device, &gpu.queue).unwrap(),
    )
}

pub fn shown(gpu: &Gpu, scene: &RayScene, eye: &Eye) -> (Light, Vec<Pixel>) {
    draw(gpu, scene, eye, Options::default())
}

pub fn looking(scene: &RayScene, from: DVec3, to: DVec3) -> Eye {
    Eye::looking(
        Place::at(&scene.aberrations, from),
        to - from,
        DVec3::Y,
        1.0,
    )
}

pub fn middle<T: Copy>(pixels: &[T]) -> T {
    pixels[(SIZE.1 / 2 * SIZE.0 + SIZE.0 / 2) as usize]
}
