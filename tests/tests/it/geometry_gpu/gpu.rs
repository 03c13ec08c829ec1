//! The adapter that every test of this file computes on, by the laboratory's compute pass.

use std::sync::LazyLock;

use antipode_lab::compute;
use antipode_render::{AdapterChoice, Gpu as Adapter};
use bytemuck::Pod;

/// A device that computes.
pub struct Gpu(Adapter);

/// One device for every test of this folder: they share a process.
static GPU: LazyLock<Result<Gpu, String>> = LazyLock::new(|| {
    let opened = Adapter::headless(AdapterChoice::Auto);
    opened.map(Gpu).map_err(|why| why.to_string())
});

/// The device, or none with a loud word.
pub fn gpu() -> Option<&'static Gpu> {
    antipode_testing::needed("a graphics adapter", GPU.as_ref())
}

impl Gpu {
    /// One `Out` for each `In`, by the shader of each input's map.
    pub fn compute<In: Pod, Out: Pod>(
        &self,
        shader: &str,
        input: &[In],
        map_of: impl Fn(&In) -> u32,
    ) -> Vec<Out> {
        compute::run_by_map(&self.0, shader, input, map_of).unwrap()
    }
}
