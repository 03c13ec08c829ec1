//! What the examples share: an adapter, simple solids, and pictures as files.
#![allow(dead_code, reason = "each example takes what it needs")]

use antipode_rays::{Eye, Instance, Mesh, Options, Picture, RayScene, Rays, RaysError};
use glam::{Affine3A, Vec2, Vec3};

/// An open adapter.
pub struct Gpu {
    /// The device.
    pub device: wgpu::Device,
    /// Its queue.
    pub queue: wgpu::Queue,
    /// Its name.
    pub name: String,
}

impl Gpu {
    /// The first adapter that there is, with its own limits for buffers.
    ///
    /// # Errors
    /// When there is none or it will not open.
    pub fn open() -> Result<Self, Box<dyn std::error::Error>> {
        let instance =
            wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
        let adapter =
            pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))?;
        let descriptor = wgpu::DeviceDescriptor::default();
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor))?;
        let name = adapter.get_info().name;
        Ok(Self {
            device,
            queue,
            name,
        })
    }

    /// Draws a scene and waits for it.
    ///
    /// # Errors
    /// When the scene is faulty or the adapter is lost.
    pub fn draw(
        &self,
        rays: &Rays,
        scene: &RayScene,
        eye: &Eye,
        size: (u32, u32),
        options: Options,
    ) -> Result<Picture, RaysError> {
        let loaded = rays.upload(&self.device, &self.queue, scene)?;
        let picture = Picture::new(&self.device, size);
        let mut encoder = self
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let gpu = (&self.device, &self.queue);
        rays.draw(
            gpu,
            &mut encoder,
            (scene, &loaded),
            (eye, &picture),
            options,
        );
        self.queue.submit([encoder.finish()]);
        Ok(picture)
    }
}

/// A box about the origin with corners at -1 and 1, each face with its own normals and uv.
pub fn cube() -> Mesh {
    let mut mesh = Mesh::default();
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            let first = mesh.positions.len() as u32;
            for (u, v) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                let mut corner = Vec3::ZERO;
                corner[axis] = side;
                corner[(axis + 1) % 3] = u * side;
                corner[(axis + 2) % 3] = v;
                mesh.positions.push(corner);
                mesh.uvs.push(Vec2::new(0.5 + 0.5 * u, 0.5 - 0.5 * v));
            }
            mesh.triangles.push([first, first + 1, first + 2]);
            mesh.triangles.push([first, first + 2, first + 3]);
        }
    }
    mesh
}

/// A ball of radius 1 about the origin, smooth.
pub fn ball() -> Mesh {
    let (rows, columns) = (24_u32, 48_u32);
    let mut mesh = Mesh::default();
    for row in 0..=rows {
        let polar = std::f32::consts::PI * row as f32 / rows as f32;
        for column in 0..=columns {
            let around = std::f32::consts::TAU * column as f32 / columns as f32;
            let n = Vec3::new(
                polar.sin() * around.cos(),
                polar.cos(),
                polar.sin() * around.sin(),
            );
            mesh.positions.push(n);
            mesh.normals.push(n);
        }
    }
    for row in 0..rows {
        for column in 0..columns {
            let a = row * (columns + 1) + column;
            let b = a + columns + 1;
            mesh.triangles.extend([[a, a + 1, b], [b, a + 1, b + 1]]);
        }
    }
    mesh
}

/// Hills of `side` x `side` squares, 40 m wide, about the origin.
pub fn hills(side: u32) -> Mesh {
    let mut mesh = Mesh::default();
    for z in 0..=side {
        for x in 0..=side {
            let p = (Vec2::new(x as f32, z as f32) / side as f32 - 0.5) * 40.0;
            let wave = |scale: f32, height: f32| {
                height * (p.x * scale).sin() * (p.y * scale * 1.3 + 1.0).cos()
            };
            mesh.positions.push(Vec3::new(
                p.x,
                wave(0.9, 0.8) + wave(2.7, 0.35) + wave(7.0, 0.08),
                p.y,
            ));
        }
    }
    for z in 0..side {
        for x in 0..side {
            let a = z * (side + 1) + x;
            let b = a + side + 1;
            mesh.triangles.extend([[a, b, a + 1], [a + 1, b, b + 1]]);
        }
    }
    mesh
}

/// A cube or ball of half sizes `half` at a place.
pub fn placed(mesh: usize, at: Vec3, half: Vec3, object: u32, materials: usize) -> Instance {
    let pose = Affine3A::from_scale_rotation_translation(half, glam::Quat::IDENTITY, at);
    Instance {
        mesh,
        pose,
        object,
        materials,
    }
}
