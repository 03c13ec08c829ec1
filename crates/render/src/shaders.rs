//! The shaders' sources, embedded, and how they are put together.

use antipode_geometry::WGSL as GEOMETRY;

const COMMON: &str = include_str!("../../../shaders/common.wgsl");

/// The land.
pub const TERRAIN: Shader = Shader {
    name: "terrain",
    own: include_str!("../../../shaders/terrain.wgsl"),
    space: true,
};
/// Figures.
pub const FIGURE: Shader = Shader {
    name: "figure",
    own: include_str!("../../../shaders/figure.wgsl"),
    space: true,
};
/// The brush marker.
pub const MARKER: Shader = Shader {
    name: "marker",
    own: include_str!("../../../shaders/marker.wgsl"),
    space: true,
};
/// The sky.
pub const SKY: Shader = Shader {
    name: "sky",
    own: include_str!("../../../shaders/sky.wgsl"),
    space: true,
};
/// Sun, moon and stars.
pub const CELESTIAL: Shader = Shader {
    name: "celestial",
    own: include_str!("../../../shaders/celestial.wgsl"),
    space: true,
};
/// From light to display.
pub const TONEMAP: Shader = Shader {
    name: "tonemap",
    own: include_str!("../../../shaders/tonemap.wgsl"),
    space: false,
};

/// One shader of the game.
#[derive(Clone, Copy, Debug)]
pub struct Shader {
    /// Its file's name without the ending; also its label.
    pub name: &'static str,
    own: &'static str,
    /// Whether it stands in the space and so needs the shared files before it.
    space: bool,
}

impl Shader {
    /// The whole text, shared files first.
    pub fn source(&self) -> String {
        if self.space {
            [GEOMETRY, COMMON, self.own].join("\n")
        } else {
            self.own.to_owned()
        }
    }

    /// Compiles it on a device.
    pub fn compile(&self, device: &wgpu::Device) -> wgpu::ShaderModule {
        device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(self.name),
            source: wgpu::ShaderSource::Wgsl(self.source().into()),
        })
    }
}

#[cfg(test)]
pub mod tests {
    #![allow(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        reason = "tests fail by panicking"
    )]
    use naga::valid::{Capabilities, ValidationFlags, Validator};

    use super::*;

    /// The parsed shader; panics with the compiler's words when it does not compile.
    pub fn parse(shader: Shader) -> naga::Module {
        let source = shader.source();
        naga::front::wgsl::parse_str(&source)
            .unwrap_or_else(|e| panic!("{}", e.emit_to_string(&source)))
    }

    #[test]
    fn every_shader_is_valid() {
        for shader in [TERRAIN, FIGURE, MARKER, SKY, CELESTIAL, TONEMAP] {
            let module = parse(shader);
            let checked =
                Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module);
            assert!(checked.is_ok(), "{}: {:?}", shader.name, checked.err());
        }
    }

    #[test]
    fn every_file_of_shaders_is_used() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shaders");
        let known = [
            "trigonometry",
            "geometry",
            "common",
            TERRAIN.name,
            FIGURE.name,
            MARKER.name,
            SKY.name,
            CELESTIAL.name,
            TONEMAP.name,
        ];
        for file in std::fs::read_dir(folder).unwrap() {
            let path = file.unwrap().path();
            let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
            assert!(
                known.contains(&name.as_str()),
                "{} is drawn by nothing",
                path.display()
            );
        }
    }

    /// Functions whose precision the standard leaves open must not decide where things stand.
    #[test]
    fn the_geometry_uses_no_imprecise_builtin() {
        for line in GEOMETRY
            .lines()
            .map(|line| line.split("//").next().unwrap_or_default())
        {
            for name in [
                "sinh(", "cosh(", "asinh(", "acosh(", "acos(", "atan2(", "tan(", " sin(", " cos(",
            ] {
                assert!(
                    !line.contains(&format!(" {name}")) && !line.contains(&format!("({name}")),
                    "{line}"
                );
            }
        }
    }
}
