//! The shaders' sources, embedded, and how they are put together.

use antipode_geometry::WGSL as GEOMETRY;

const COMMON: &str = include_str!("../../../shaders/common.wgsl");
const LIGHTS: &str = include_str!("../../../shaders/lights.wgsl");
const SHADOW: &str = include_str!("../../../shaders/shadow.wgsl");

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
/// Outlines of hit shapes.
pub const OUTLINES: Shader = Shader {
    name: "outlines",
    own: include_str!("../../../shaders/outlines.wgsl"),
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
            [GEOMETRY, COMMON, LIGHTS, SHADOW, self.own].join("\n")
        } else {
            self.own.to_owned()
        }
    }
}

/// What the shaders are compiled from: the embedded texts, but for one that may be another's.
#[derive(Clone, Copy, Debug, Default)]
pub struct Shaders {
    instead: Option<(&'static str, &'static str)>,
}

impl Shaders {
    /// The embedded ones, but for the shader of that name (its file's without the ending), which is compiled from
    /// this text: to see what becomes of one that an adapter will not take.
    pub fn with(name: &'static str, text: &'static str) -> Self {
        Self {
            instead: Some((name, text)),
        }
    }

    /// Compiles a shader on a device.
    pub(crate) fn compile(&self, device: &wgpu::Device, shader: Shader) -> wgpu::ShaderModule {
        let source = match self.instead {
            Some((name, text)) if name == shader.name => text.to_owned(),
            _ => shader.source(),
        };
        device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(shader.name),
            source: wgpu::ShaderSource::Wgsl(source.into()),
        })
    }
}

/// Makes something on a device.
///
/// # Errors
/// The first thing that the device has to say against it, in its own words, of one line or many.
pub fn accepted<T>(device: &wgpu::Device, make: impl FnOnce() -> T) -> Result<T, String> {
    use wgpu::ErrorFilter::{Internal, OutOfMemory, Validation};
    let scopes = [Internal, OutOfMemory, Validation].map(|filter| device.push_error_scope(filter));
    let made = make();
    // The last one pushed is the first to go.
    let [internal, memory, validation] = scopes;
    let refused: Vec<_> = [validation, memory, internal]
        .into_iter()
        .filter_map(|scope| pollster::block_on(scope.pop()))
        .collect();
    match refused.first() {
        Some(error) => Err(error.to_string()),
        None => Ok(made),
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
        for shader in [TERRAIN, FIGURE, MARKER, OUTLINES, SKY, CELESTIAL, TONEMAP] {
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
            "lights",
            "shadow",
            TERRAIN.name,
            FIGURE.name,
            MARKER.name,
            OUTLINES.name,
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
