//! Opens a graphics adapter, with or without a window, and notices when it fails or is lost.

use std::fmt::Debug;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use wgpu::rwh::HasDisplayHandle;
use wgpu::{Adapter, Backends, Device, DeviceType, Instance, Queue, Surface};

use crate::draw_list::MULTI_DRAW_FEATURES;
use crate::error::RenderError;

/// Which adapter to draw with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum AdapterChoice {
    /// The fastest there is, a software one if need be.
    #[default]
    Auto,
    /// A graphics card or none.
    Gpu,
    /// A software adapter or none.
    Software,
}

impl AdapterChoice {
    fn noun(self) -> &'static str {
        match self {
            Self::Auto => "graphics adapter",
            Self::Gpu => "graphics card",
            Self::Software => "software graphics adapter",
        }
    }

    fn advice(self) -> &'static str {
        match self {
            Self::Auto => {
                "Install a Vulkan, Metal or Direct3D 12 driver; on Linux, mesa-vulkan-drivers draws in software."
            }
            Self::Gpu => {
                "Install its Vulkan, Metal or Direct3D 12 driver, or start with --adapter auto."
            }
            Self::Software => {
                "On Linux, install mesa-vulkan-drivers; or start with --adapter auto."
            }
        }
    }

    /// Lower is better; none is refused.
    fn rank(self, kind: DeviceType) -> Option<u8> {
        let software = kind == DeviceType::Cpu;
        if (self == Self::Gpu && software) || (self == Self::Software && !software) {
            return None;
        }
        Some(match kind {
            DeviceType::DiscreteGpu => 0,
            DeviceType::IntegratedGpu => 1,
            DeviceType::VirtualGpu => 2,
            DeviceType::Other => 3,
            DeviceType::Cpu => 4,
        })
    }
}

/// What the adapter has told us behind our back.
#[derive(Debug, Default)]
struct Watch {
    lost: Option<String>,
    error: Option<String>,
}

/// An open adapter. Clones are the same one, for other threads.
#[derive(Clone, Debug)]
pub struct Gpu {
    /// The entry point that the adapter came from.
    pub instance: Instance,
    /// The adapter.
    pub adapter: Adapter,
    /// The open device.
    pub device: Device,
    /// The device's queue.
    pub queue: Queue,
    /// What the adapter says of itself.
    pub info: wgpu::AdapterInfo,
    watch: Arc<Mutex<Watch>>,
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests fail by panicking")]
impl Gpu {
    /// An adapter for a test, which says loudly when there is none.
    pub(crate) fn for_test() -> Option<Self> {
        antipode_testing::needed("a graphics adapter", Self::headless(AdapterChoice::Auto))
    }

    /// The function `kernel` of a text, to ask shaders by.
    pub(crate) fn kernel(&self, source: String) -> wgpu::ComputePipeline {
        let module = self
            .device
            .create_shader_module(wgpu::ShaderModuleDescriptor {
                label: None,
                source: wgpu::ShaderSource::Wgsl(source.into()),
            });
        self.device
            .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: None,
                layout: None,
                module: &module,
                entry_point: Some("kernel"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                cache: None,
            })
    }

    /// What a buffer of four numbers each holds.
    pub(crate) fn read_back(&self, from: &wgpu::Buffer) -> Vec<[f32; 4]> {
        let to = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: from.size(),
            usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let mut encoder = self.encoder();
        encoder.copy_buffer_to_buffer(from, 0, &to, 0, from.size());
        self.queue.submit([encoder.finish()]);
        to.slice(..).map_async(wgpu::MapMode::Read, |_| {});
        self.wait().unwrap();
        bytemuck::cast_slice(&to.slice(..).get_mapped_range().unwrap()).to_vec()
    }
}

impl Gpu {
    /// Opens an adapter that draws into memory.
    ///
    /// # Errors
    /// When there is no adapter of the kind asked for, or it will not open.
    pub fn headless(choice: AdapterChoice) -> Result<Self, RenderError> {
        first_that_works(|backends| {
            let instance = Instance::new(described(
                wgpu::InstanceDescriptor::new_without_display_handle_from_env(),
                backends,
            ));
            let adapter = pick(&instance, backends, choice, None)?;
            Self::open(instance, adapter)
        })
    }

    /// Opens an adapter that can draw into a window, and the window's surface.
    ///
    /// # Errors
    /// When the window gives no surface, no adapter of the kind asked for can draw into it, or it will not open.
    #[expect(
        clippy::needless_pass_by_value,
        reason = "the handles are shared ones, and callers make them for this"
    )]
    pub fn for_window<D, W>(
        display: Box<D>,
        window: W,
        choice: AdapterChoice,
    ) -> Result<(Self, Surface<'static>), RenderError>
    where
        D: HasDisplayHandle + Debug + Clone + Send + Sync + 'static,
        W: Into<wgpu::SurfaceTarget<'static>> + Clone,
    {
        first_that_works(|backends| {
            let instance = Instance::new(described(
                wgpu::InstanceDescriptor::new_with_display_handle_from_env(display.clone()),
                backends,
            ));
            let surface = instance.create_surface(window.clone()).map_err(|e| {
                // Without any driver there is no surface either, and the driver is what is missing.
                none_at_all(&instance, backends, choice)
                    .unwrap_or_else(|| RenderError::NoSurface(e.to_string()))
            })?;
            let gpu = Self::for_surface(instance, &surface, choice)?;
            Ok((gpu, surface))
        })
    }

    /// Opens an adapter of the instance that can draw into its surface.
    ///
    /// # Errors
    /// When no adapter of the kind asked for can draw into the surface, or it will not open.
    pub fn for_surface(
        instance: Instance,
        surface: &Surface<'_>,
        choice: AdapterChoice,
    ) -> Result<Self, RenderError> {
        let adapter = pick(&instance, Backends::all(), choice, Some(surface))?;
        Self::open(instance, adapter)
    }

    fn open(instance: Instance, adapter: Adapter) -> Result<Self, RenderError> {
        let info = adapter.get_info();
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("antipode"),
            required_features: adapter.features()
                & (wgpu::Features::TIMESTAMP_QUERY | MULTI_DRAW_FEATURES),
            required_limits: limits(&adapter),
            ..Default::default()
        };
        let (device, queue) =
            pollster::block_on(adapter.request_device(&descriptor)).map_err(|e| {
                RenderError::NoDevice {
                    adapter: info.name.clone(),
                    why: e.to_string(),
                }
            })?;
        let watch = Arc::new(Mutex::new(Watch::default()));
        let seen = Arc::clone(&watch);
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            tracing::error!("graphics adapter: {error}");
            lock(&seen).error = Some(error.to_string());
        }));
        let seen = Arc::clone(&watch);
        device.set_device_lost_callback(move |reason, words| {
            // Dropping the device at the end is reported as well; then nobody asks any more.
            if reason != wgpu::DeviceLostReason::Destroyed {
                tracing::error!("graphics adapter lost: {words}");
            }
            lock(&seen).lost = Some(if words.is_empty() {
                "it gave no reason".to_owned()
            } else {
                words
            });
        });
        tracing::info!(
            "drawing with {} ({:?}, {:?})",
            info.name,
            info.device_type,
            info.backend
        );
        Ok(Self {
            instance,
            adapter,
            device,
            queue,
            info,
            watch,
        })
    }

    /// The adapter's name.
    pub fn name(&self) -> &str {
        &self.info.name
    }

    /// Whether the adapter draws on the processor.
    pub fn is_software(&self) -> bool {
        self.info.device_type == DeviceType::Cpu
    }

    /// Why the adapter was lost, if it was.
    pub fn lost(&self) -> Option<String> {
        lock(&self.watch).lost.clone()
    }

    /// Loses the adapter on purpose, as a driver that starts anew would, to see what becomes of it.
    pub fn lose(&self) {
        self.device.destroy();
        // Until somebody asks, nobody is told.
        let _ = self.device.poll(wgpu::PollType::wait_indefinitely());
    }

    /// The last error that nobody waited for, if any; asking clears it.
    pub fn take_error(&self) -> Option<String> {
        lock(&self.watch).error.take()
    }

    /// What commands are written into before they are submitted.
    pub fn encoder(&self) -> wgpu::CommandEncoder {
        self.device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default())
    }

    /// Waits until everything submitted has been done.
    ///
    /// # Errors
    /// When the adapter is lost or stops answering.
    pub fn wait(&self) -> Result<(), RenderError> {
        let waited = self.device.poll(wgpu::PollType::wait_indefinitely());
        match (self.lost(), waited) {
            (Some(why), _) => Err(RenderError::Lost(why)),
            (None, Err(e)) => Err(RenderError::Lost(e.to_string())),
            (None, Ok(_)) => Ok(()),
        }
    }
}

/// A watcher that panicked has still written a whole value.
fn lock(watch: &Mutex<Watch>) -> MutexGuard<'_, Watch> {
    watch.lock().unwrap_or_else(PoisonError::into_inner)
}

/// An instance's description, for some backends. In an optimised build the arguments of draws that lie in buffers are
/// not looked through by a compute pass before every frame: `draw_list` alone writes them, to ranges that its allocator
/// vouches for.
fn described(
    environment: wgpu::InstanceDescriptor,
    backends: Backends,
) -> wgpu::InstanceDescriptor {
    let mut flags = environment.flags;
    if !cfg!(debug_assertions) {
        flags.remove(wgpu::InstanceFlags::VALIDATION_INDIRECT_CALL);
    }
    wgpu::InstanceDescriptor {
        backends,
        flags,
        ..environment
    }
}

/// The richest of the standard sets of limits that the adapter meets, with its own texture sizes.
fn limits(adapter: &Adapter) -> wgpu::Limits {
    let own = adapter.limits();
    [wgpu::Limits::default(), wgpu::Limits::downlevel_defaults()]
        .into_iter()
        .find(|limits| limits.check_limits(&own))
        .unwrap_or_else(wgpu::Limits::downlevel_webgl2_defaults)
        .using_resolution(own)
}

/// Tries the modern backends and then OpenGL, which is not even started where the first do; the environment's
/// choice (`WGPU_BACKEND`) goes before ours. The first failure is the one told.
fn first_that_works<T>(
    open: impl Fn(Backends) -> Result<T, RenderError>,
) -> Result<T, RenderError> {
    match Backends::from_env() {
        Some(backends) => open(backends),
        None => {
            open(Backends::PRIMARY).or_else(|first| open(Backends::SECONDARY).map_err(|_| first))
        }
    }
}

/// That there is no adapter of any kind, if so.
fn none_at_all(
    instance: &Instance,
    backends: Backends,
    choice: AdapterChoice,
) -> Option<RenderError> {
    let adapters = pollster::block_on(instance.enumerate_adapters(backends));
    adapters.is_empty().then(|| no_adapter(choice, &[]))
}

fn no_adapter(choice: AdapterChoice, found: &[String]) -> RenderError {
    RenderError::NoAdapter {
        wanted: choice.noun(),
        found: if found.is_empty() {
            "no adapter at all".to_owned()
        } else {
            format!("only {}", found.join(", "))
        },
        advice: choice.advice(),
    }
}

/// The best adapter of the kind.
fn pick(
    instance: &Instance,
    backends: Backends,
    choice: AdapterChoice,
    surface: Option<&Surface<'_>>,
) -> Result<Adapter, RenderError> {
    let adapters = pollster::block_on(instance.enumerate_adapters(backends));
    let names: Vec<_> = adapters
        .iter()
        .map(|adapter| adapter.get_info().name)
        .collect();
    adapters
        .into_iter()
        .filter(|adapter| surface.is_none_or(|surface| adapter.is_surface_supported(surface)))
        .filter_map(|adapter| Some((choice.rank(adapter.get_info().device_type)?, adapter)))
        .min_by_key(|(rank, _)| *rank)
        .map(|(_, adapter)| adapter)
        .ok_or_else(|| no_adapter(choice, &names))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn auto_prefers_cards_to_software_and_the_others_refuse() {
        let auto = |kind| AdapterChoice::Auto.rank(kind);
        assert!(auto(DeviceType::DiscreteGpu) < auto(DeviceType::IntegratedGpu));
        assert!(auto(DeviceType::Other) < auto(DeviceType::Cpu));
        assert_eq!(AdapterChoice::Gpu.rank(DeviceType::Cpu), None);
        assert_eq!(AdapterChoice::Software.rank(DeviceType::DiscreteGpu), None);
        assert!(AdapterChoice::Software.rank(DeviceType::Cpu).is_some());
    }

    #[test]
    fn a_missing_adapter_is_told_in_a_sentence_with_advice() {
        let error = RenderError::NoAdapter {
            wanted: AdapterChoice::Gpu.noun(),
            found: "only llvmpipe".to_owned(),
            advice: AdapterChoice::Gpu.advice(),
        };
        let words = error.to_string();
        assert!(
            words.contains("No graphics card")
                && words.contains("llvmpipe")
                && words.contains("--adapter auto")
        );
    }
}
