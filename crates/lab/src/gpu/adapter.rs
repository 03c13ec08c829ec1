//! What the adapter is, for the head of a report, and what is to be told loudly of it.

use antipode_render::Gpu;
use wgpu::DeviceType;

use super::clock::Clock;
use crate::{Effort, made_on};

/// Name and value of everything that a report's head says.
pub fn head(effort: Effort, gpu: Option<&Gpu>) -> Vec<(String, String)> {
    let mut head = made_on(effort, gpu);
    let os = [std::env::consts::OS, std::env::consts::ARCH].join(", ");
    let mut more = vec![("System", os)];
    if let Some(gpu) = gpu {
        let driver = [&gpu.info.driver, &gpu.info.driver_info];
        let told = driver.into_iter().filter(|it| !it.is_empty());
        let driver = told.map(String::as_str).collect::<Vec<_>>().join(", ");
        more.push(("Kind", kind(gpu.info.device_type).to_owned()));
        more.push((
            "Driver",
            if driver.is_empty() {
                "not told".to_owned()
            } else {
                driver
            },
        ));
        more.push(("Frames timed by", Clock::of_frames(gpu).words().to_owned()));
        more.push(("Costs timed by", Clock::of_costs(gpu).words().to_owned()));
    }
    head.extend(
        more.into_iter()
            .map(|(name, value)| (name.to_owned(), value)),
    );
    head
}

fn kind(kind: DeviceType) -> &'static str {
    match kind {
        DeviceType::DiscreteGpu => "a graphics card",
        DeviceType::IntegratedGpu => "graphics in the processor",
        DeviceType::VirtualGpu => "a virtual graphics card",
        DeviceType::Cpu => "SOFTWARE: it draws on the processor",
        DeviceType::Other => "not told",
    }
}

/// What a reader of the figures must know of the adapter, in sentences.
pub fn warnings(gpu: &Gpu) -> Vec<String> {
    let name = gpu.name();
    if gpu.is_software() {
        return vec![format!(
            "SOFTWARE: {name} draws on the processor. No figure here says anything about a graphics card."
        )];
    }
    if Clock::of_frames(gpu) == Clock::Timestamps {
        return Vec::new();
    }
    vec![format!(
        "{name} has no timestamps. Its times are those of {}, with what the system does meanwhile.",
        Clock::Wall.words()
    )]
}
