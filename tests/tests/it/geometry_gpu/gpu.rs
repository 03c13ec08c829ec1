//! The adapter that every test of this file computes on, by the laboratory's compute pass.

use std::io::Write;
use std::sync::LazyLock;

use antipode_lab::compute;
use antipode_render::{AdapterChoice, Gpu as Adapter};
use bytemuck::Pod;

/// A device that computes.
pub struct Gpu(Adapter);

/// One device for every test of this file: they share a process.
pub static GPU: LazyLock<Option<Gpu>> =
    LazyLock::new(|| match Adapter::headless(AdapterChoice::Auto) {
        Ok(adapter) => {
            eprintln!("adapter: {}", adapter.name());
            Some(Gpu(adapter))
        }
        Err(why) => {
            let required = std::env::var("ANTIPODE_REQUIRE_GPU").is_ok_and(|v| v == "1");
            assert!(
                !required,
                "ANTIPODE_REQUIRE_GPU=1, and no adapter computes: {why}"
            );
            // Written past the test harness, which would swallow it in a test that passes.
            let _ = writeln!(
                std::io::stderr(),
                "SKIPPED: no adapter; the shader's numbers were NOT checked"
            );
            None
        }
    });

impl Gpu {
    /// One `Out` for each `In`.
    pub fn compute<In: Pod, Out: Pod>(&self, shader: &str, input: &[In]) -> Vec<Out> {
        compute::run(&self.0, shader, input).unwrap()
    }
}
