//! The shader file: valid WGSL, the promised functions, and the layout that Rust writes.

use antipode_geometry::shader::MAPS;
use antipode_geometry::{MapShader, SpaceUniform};
use naga::TypeInner;
use naga::valid::{Capabilities, ValidationFlags, Validator};

fn module(map: &MapShader, extra: &str) -> naga::Module {
    let source = map.geometry() + extra;
    let module = naga::front::wgsl::parse_str(&source)
        .map_err(|e| e.emit_to_string(&source))
        .unwrap();
    Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .unwrap();
    module
}

#[test]
fn the_shader_is_valid_and_has_its_functions() {
    for map in MAPS {
        let module = module(map, "");
        assert!(module.entry_points.is_empty() && module.global_variables.is_empty());
        for (name, arguments) in [
            ("port_to_view", 2),
            ("port_normal", 3),
            ("frame_vector", 3),
            ("clip_from_view", 2),
            ("eye_distance", 2),
            ("curvature_of", 1),
        ] {
            let function = module
                .functions
                .iter()
                .find(|(_, f)| f.name.as_deref() == Some(name))
                .map(|(_, f)| f.arguments.len());
            assert_eq!(function, Some(arguments), "{}: {name}", map.name);
        }
    }
}

#[test]
fn the_uniform_has_the_same_layout_in_rust_and_in_the_shader() {
    let module = module(MAPS[0], "@group(0) @binding(0) var<uniform> space: Space;");
    let (members, span) = module
        .types
        .iter()
        .find_map(|(_, ty)| match &ty.inner {
            TypeInner::Struct { members, span } if ty.name.as_deref() == Some("Space") => {
                Some((members.clone(), *span))
            }
            _ => None,
        })
        .unwrap();
    macro_rules! fields {
        ($($name:ident)*) => {
            [$((stringify!($name), std::mem::offset_of!(SpaceUniform, $name))),*]
        };
    }
    let ours = fields!(view focal_x focal_y near_m radius_m kappa lift lift_sine lift_cosine level_m upright_m k_per_m padding origin);
    assert_eq!(span as usize, size_of::<SpaceUniform>());
    assert_eq!(members.len(), ours.len());
    for (member, (name, offset)) in members.iter().zip(ours) {
        assert_eq!(member.name.as_deref(), Some(name));
        assert_eq!(member.offset as usize, offset, "{name}");
    }
}

#[test]
fn the_shader_trusts_no_loose_built_in() {
    let texts = MAPS.map(MapShader::geometry);
    let code: String = texts
        .iter()
        .flat_map(|text| text.lines())
        .map(|line| line.split("//").next().unwrap_or_default())
        .collect::<Vec<_>>()
        .join("\n");
    for name in [
        "sin", "cos", "tan", "sinh", "cosh", "asinh", "acosh", "acos", "asin", "atan2", "atan",
        "pow", "exp",
    ] {
        let call = format!("{name}(");
        let mut rest = code.as_str();
        while let Some(at) = rest.find(&call) {
            let before = rest[..at].chars().next_back().unwrap_or(' ');
            assert!(
                before.is_alphanumeric() || before == '_',
                "{name} is called"
            );
            rest = &rest[at + call.len()..];
        }
    }
}
