//! The shaders' sources, embedded, and how they are put together.

use antipode_geometry::{MapShader, WGSL as GEOMETRY};
use antipode_terrain::Kind;

const COMMON: &str = include_str!("../../../shaders/common.wgsl");
const LIGHTS: &str = include_str!("../../../shaders/lights.wgsl");
const SHADOW: &str = include_str!("../../../shaders/shadow.wgsl");

/// What kinds of ground look like: a part of the land's shader.
const SURFACES: [&str; 2] = [
    include_str!("../../../shaders/surface_kinds.wgsl"),
    include_str!("../../../shaders/surfaces.wgsl"),
];

/// What grows on the land: the other part of the land's shader.
const PLANTS: &str = include_str!("../../../shaders/plants.wgsl");

/// The land, and what grows on it.
pub const TERRAIN: Shader = Shader {
    name: "terrain",
    own: include_str!("../../../shaders/terrain.wgsl"),
};
/// Figures.
pub const FIGURE: Shader = Shader {
    name: "figure",
    own: include_str!("../../../shaders/figure.wgsl"),
};
/// The brush marker.
pub const MARKER: Shader = Shader {
    name: "marker",
    own: include_str!("../../../shaders/marker.wgsl"),
};
/// Openings of doors.
pub const OPENING: Shader = Shader {
    name: "opening",
    own: include_str!("../../../shaders/opening.wgsl"),
};
/// Outlines of hit shapes.
pub const OUTLINES: Shader = Shader {
    name: "outlines",
    own: include_str!("../../../shaders/outlines.wgsl"),
};
/// Dust and chips, and marks on the ground.
pub const DUST: Shader = Shader {
    name: "dust",
    own: include_str!("../../../shaders/dust.wgsl"),
};
/// The sky.
pub const SKY: Shader = Shader {
    name: "sky",
    own: include_str!("../../../shaders/sky.wgsl"),
};
/// Sun, moon and stars.
pub const CELESTIAL: Shader = Shader {
    name: "celestial",
    own: include_str!("../../../shaders/celestial.wgsl"),
};
/// From light to display.
pub const TONEMAP: Shader = Shader {
    name: "tonemap",
    own: include_str!("../../../shaders/tonemap.wgsl"),
};

/// One shader of the game.
#[derive(Clone, Copy, Debug)]
pub struct Shader {
    /// Its file's name without the ending; also its label.
    pub name: &'static str,
    /// Its file's text.
    pub own: &'static str,
}

impl Shader {
    /// The whole text. What stands in a space has before its own what all share, that of a map, and how the light falls in
    /// the map's worlds.
    pub fn source(&self, map: Option<&MapShader>) -> String {
        match map {
            Some(map) => {
                let light = map.daylight.text;
                let mut parts = vec![GEOMETRY, map.text, COMMON, LIGHTS, SHADOW, light];
                let tints = tints();
                if self.name == TERRAIN.name {
                    parts.extend(SURFACES);
                    parts.push(&tints);
                }
                parts.push(self.own);
                if self.name == TERRAIN.name {
                    parts.push(PLANTS);
                }
                parts.join("\n")
            }
            None => self.own.to_owned(),
        }
    }
}

/// The function by which the land's shader knows the tint of a kind of ground.
fn tints() -> String {
    let row = |kind: Kind| {
        let [r, g, b, share] = kind.tint();
        let number = kind.byte();
        format!("case {number}u: {{ return vec4<f32>({r:?}, {g:?}, {b:?}, {share:?}); }}\n")
    };
    let rows: String = Kind::ALL.into_iter().map(row).collect();
    format!(
        "fn tint_of(kind: u32) -> vec4<f32> {{\nswitch kind {{\n{rows}default: {{ return vec4<f32>(0.0); }}\n}}\n}}"
    )
}

/// What the shaders are compiled from: the embedded texts, but for one that may be another's.
#[derive(Clone, Copy, Debug, Default)]
pub struct Shaders {
    instead: Option<(&'static str, &'static str)>,
}

impl Shaders {
    /// The embedded ones, but for the shader of that name (its file's without the ending), whose own text is this one: to
    /// see what becomes of one that an adapter will not take.
    pub fn with(name: &'static str, text: &'static str) -> Self {
        Self {
            instead: Some((name, text)),
        }
    }

    /// Compiles a shader on a device, for a map if it stands in a space.
    pub(crate) fn compile(
        &self,
        device: &wgpu::Device,
        mut shader: Shader,
        map: Option<&MapShader>,
    ) -> wgpu::ShaderModule {
        if let Some((name, text)) = self.instead
            && name == shader.name
        {
            shader.own = text;
        }
        let source = shader.source(map);
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
mod kinds;
#[cfg(test)]
pub mod tests {
    #![allow(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        reason = "tests fail by panicking"
    )]
    use antipode_geometry::shader::{DAYLIGHT_FUNCTIONS, MAP_FUNCTIONS, MAPS};
    use naga::valid::{Capabilities, ValidationFlags, Validator};

    use super::*;

    /// The parsed shader; panics with the compiler's words when it does not compile.
    pub fn parse(shader: Shader, map: &MapShader) -> naga::Module {
        let source = shader.source(Some(map));
        naga::front::wgsl::parse_str(&source)
            .unwrap_or_else(|e| panic!("{}", e.emit_to_string(&source)))
    }

    #[test]
    fn every_shader_is_valid() {
        for map in MAPS {
            for shader in [
                TERRAIN, FIGURE, MARKER, OPENING, OUTLINES, DUST, SKY, CELESTIAL, TONEMAP,
            ] {
                let module = parse(shader, map);
                let checked =
                    Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module);
                let names = (shader.name, map.name);
                assert!(checked.is_ok(), "{names:?}: {:?}", checked.err());
            }
        }
    }

    /// The functions that a text defines, but for those that are only its own.
    fn defined(text: &str, helpers: &[&str]) -> Vec<String> {
        let names = text.lines().filter_map(|line| {
            let name = line.strip_prefix("fn ")?.split('(').next()?;
            let is_own = name.starts_with("geo_") || helpers.contains(&name);
            (!is_own).then(|| name.to_owned())
        });
        let mut names: Vec<_> = names.collect();
        names.sort();
        names
    }

    #[test]
    fn every_map_and_every_daylight_defines_just_the_functions_of_its_list() {
        let sorted = |list: &[&str]| {
            let mut list: Vec<_> = list.iter().map(|name| (*name).to_owned()).collect();
            list.sort();
            list
        };
        for map in MAPS {
            assert_eq!(map.lacks(), None);
            assert_eq!(
                defined(map.text, &[]),
                sorted(&MAP_FUNCTIONS),
                "{}",
                map.name
            );
            let helpers = [
                "model_of",
                "grain_place",
                "fifths",
                "ragged",
                "daylight_at",
                "key_body",
                "orbs_on",
                "shadow_face",
            ];
            let light = map.daylight;
            let found = defined(light.text, &helpers);
            assert_eq!(found, sorted(&DAYLIGHT_FUNCTIONS), "{}", light.name);
        }
    }

    #[test]
    fn files_that_all_maps_share_name_none_of_them() {
        for text in [GEOMETRY, COMMON, LIGHTS, SHADOW, TERRAIN.own, FIGURE.own] {
            for word in ["GEO_KIND", "kind.x", "hemisphere", "geo_port_"] {
                assert!(!text.contains(word), "{word}");
            }
        }
    }

    #[test]
    fn every_file_of_shaders_is_used() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shaders");
        let files = |folder: &str| std::fs::read_dir(folder).unwrap();
        let spaces = files(&folder.join("spaces").to_string_lossy());
        let worlds = files(&folder.join("worlds").to_string_lossy());
        let whole = files(&folder.to_string_lossy());
        let known = [
            "trigonometry",
            "geometry",
            "under_sky",
            "common",
            "lights",
            "shadow",
            "surfaces",
            "surface_kinds",
            "plants",
            TERRAIN.name,
            FIGURE.name,
            MARKER.name,
            OPENING.name,
            OUTLINES.name,
            DUST.name,
            SKY.name,
            CELESTIAL.name,
            TONEMAP.name,
        ];
        let of_maps = MAPS.map(|map| [map.name, map.daylight.name]);
        for file in whole.chain(spaces).chain(worlds) {
            let path = file.unwrap().path();
            if path.is_dir() {
                continue;
            }
            let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
            assert!(
                known.contains(&name.as_str()) || of_maps.as_flattened().contains(&&*name),
                "{} is drawn by nothing",
                path.display()
            );
        }
    }

    /// Functions whose precision the standard leaves open must not decide where things stand.
    #[test]
    fn the_geometry_uses_no_imprecise_builtin() {
        let texts = MAPS.map(MapShader::geometry);
        for line in texts
            .iter()
            .flat_map(|text| text.lines())
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
