//! The distance from the eye that fog is made of, as the shaders take it: from the view vector.
//!
//! The reference is `asinh` and `atan2` of the exact view vector in `f64`.

use antipode_geometry::kernel::distance;
use antipode_geometry::{Eye, MapShader, charts};
use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec4};

use super::cases::{self, RADIUS_M, Setting};
use super::distance::{ANY, name};
use super::errors::relative;
use super::row::{Curve, Subject, note_all, plot};
use super::{Arithmetic, Bench, Findings, Worst};
use crate::compute;
use crate::error::LabError;
use crate::random::Numbers;

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Seen {
    space: antipode_geometry::SpaceUniform,
    view: Vec4,
}

/// View vectors at distances from 1e-8 to `far` radii.
fn seen(bench: &Bench, sign: f64, far: f64, setting: &Setting) -> Vec<Seen> {
    let space = setting.space.uniform(&Eye::default(), &cases::projection());
    let mut rng = Numbers::new(13);
    (0..bench.effort.count(100_000))
        .map(|_| {
            let end = charts::exponential(sign, DVec3::X * rng.magnitude(1e-8, far));
            let view = (rng.direction() * end.x * RADIUS_M).extend(end.w).as_vec4();
            Seen { space, view }
        })
        .collect()
}

/// The shader's distances, where there is an adapter.
fn on_gpu(bench: &Bench, map: &MapShader, inputs: &[Seen]) -> Result<Option<Vec<f32>>, LabError> {
    let shader = compute::shader(
        "struct Seen { space: Space, view: vec4<f32> }",
        "Seen",
        "f32",
        "outputs[i] = eye_distance(inputs[i].space, inputs[i].view);",
    );
    let gpu = bench.gpu.as_ref();
    gpu.map(|gpu| compute::run(gpu, map, &shader, inputs))
        .transpose()
}

/// Notes its errors for hyperbolic or spherical space.
pub fn measure(bench: &Bench, sign: f64, found: &mut Findings) -> Result<(), LabError> {
    let setting = if sign < 0.0 {
        cases::raised(10.0)
    } else {
        cases::sphere(RADIUS_M)
    };
    let far = if sign < 0.0 {
        20.0
    } else {
        std::f64::consts::PI - 1e-3
    };
    let inputs = seen(bench, sign, far, &setting);
    let gpu = on_gpu(bench, setting.space.shader(), &inputs)?;
    let (worst, curves) = errors(sign, far, &setting, &inputs, gpu.as_deref());
    let [single, shader, textbook] = worst;
    let subject = Subject {
        quantity: "distance from the eye",
        range: format!("{}, 1e-8 to {far:.4} radii", name(sign)),
        unit: "of it",
        naive: Some(textbook),
    };
    found.rows.extend(subject.rows([
        (Arithmetic::Single, Some(single), ANY),
        (Arithmetic::Gpu, gpu.is_some().then_some(shader), ANY),
    ]));
    found.plots.push(plot(
        &format!("eye-distance-{}", name(sign)),
        &format!(
            "Distance from the eye, {}: error against distance",
            name(sign)
        ),
        "distance, radii",
        "worst relative error",
        &curves,
    ));
    Ok(())
}

/// Errors on the processor, on the adapter and of the textbook, and their curves.
fn errors(
    sign: f64,
    far: f64,
    setting: &Setting,
    inputs: &[Seen],
    gpu: Option<&[f32]>,
) -> ([Worst; 3], [Curve; 3]) {
    let mut worst = [(); 3].map(|()| Worst::default());
    let mut curves = ["CPU f32", "GPU", "textbook f32"].map(|name| Curve::new(name, 1e-8, far));
    let radius = RADIUS_M as f32;
    for (i, input) in inputs.iter().enumerate() {
        let (view, eye) = (input.view, Eye::default());
        let exact = setting.space.eye_distance_m(&eye, view.as_dvec4());
        let textbook = if sign < 0.0 {
            view.w.acosh()
        } else {
            view.w.acos()
        } * radius;
        let errors = [
            Some(distance::from_eye(
                sign as f32,
                1.0 / radius,
                radius,
                view.to_array(),
            )),
            gpu.map(|gpu| gpu[i]),
            Some(textbook),
        ]
        .map(|ours| ours.map(|ours| relative(f64::from(ours), exact)));
        let at = || format!("view {view}");
        note_all(errors, &mut worst, &mut curves, exact / RADIUS_M, at);
    }
    (worst, curves)
}
