//! The contents of the about screen: the machine, and the parts that are built in.

use antipode_ui::AboutModel;

/// Name, version and licence of everything that is built in and not ours; `cargo xtask licences` makes it.
const COMPONENTS: &str = include_str!("../../../../assets/licences/components.txt");
/// The libraries named before the rest: they carry the game.
const CARRIERS: [&str; 6] = ["wgpu", "egui", "winit", "rapier3d", "kira", "redb"];

/// What there is to tell with this adapter.
pub fn about(adapter: &wgpu::AdapterInfo) -> AboutModel {
    let driver = [adapter.driver.trim(), adapter.driver_info.trim()];
    let driver: Vec<_> = driver
        .into_iter()
        .filter(|words| !words.is_empty())
        .collect();
    AboutModel {
        adapter: format!("{} ({})", adapter.name.trim(), backend(adapter.backend)),
        driver: driver.join(", "),
        system: format!("{}, {}", std::env::consts::OS, std::env::consts::ARCH),
        built_with: built_with(),
        components: COMPONENTS,
    }
}

fn backend(backend: wgpu::Backend) -> &'static str {
    match backend {
        wgpu::Backend::Vulkan => "Vulkan",
        wgpu::Backend::Metal => "Metal",
        wgpu::Backend::Dx12 => "Direct3D 12",
        wgpu::Backend::Gl => "OpenGL",
        other => other.to_str(),
    }
}

fn built_with() -> String {
    let versions = CARRIERS.iter().filter_map(|name| {
        let rest = COMPONENTS
            .lines()
            .find_map(|line| line.strip_prefix(name)?.strip_prefix(' '))?;
        Some(format!("{name} {}", rest.split(' ').next()?))
    });
    let all: Vec<_> = [String::from("Rust")].into_iter().chain(versions).collect();
    all.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_carriers_are_named_with_their_versions() {
        let words = built_with();
        for name in CARRIERS {
            assert!(words.contains(&format!("{name} ")), "{words}");
        }
        assert_eq!(words.split(", ").count(), CARRIERS.len() + 1);
    }
}
