//! Sine, cosine and their kin: our polynomials, and the built-in functions of WGSL beside them.
//!
//! The reference is the system's library in `f64`, good to one `f64` ulp.

use antipode_geometry::Real;
use antipode_geometry::shader::FLAT;
use bytemuck::{Pod, Zeroable};

use super::errors::{off, ulp};
use super::row::{Curve, note_all, plot};
use super::{Arithmetic, Bench, Findings, Row, Worst};
use crate::compute;
use crate::error::LabError;
use crate::random::Numbers;

/// How the suite measures and how to read it, in paragraphs.
pub const METHOD: &[&str] = &[
    "Each function over its range, in ulp of the exact result; a cosine is in ulp of 1 where it is less. The textbook column is the system's own function in f32 on the processor, and the built-in function of WGSL on the adapter: WGSL allows sin and cos an absolute error of 2^-11 and atan2 4096 ulp, and defines sinh, cosh, asinh and acosh by formulas that cancel.",
    "Built-in functions that have no counterpart of ours are listed for what they are; they have no bar.",
];

/// A function of one number: ours, the library's, and exact.
struct Function {
    quantity: &'static str,
    low: f64,
    high: f64,
    /// On the processor in f32; nothing where we have none of our own.
    ours: Option<fn(f32) -> f32>,
    library: fn(f32) -> f32,
    exact: fn(f64) -> f64,
    /// Which of the shader's outputs: ours and the built-in.
    slots: (Option<usize>, usize),
    /// Whether errors are in ulp of 1 at least.
    absolute: bool,
}

const fn built_in(
    quantity: &'static str,
    [low, high]: [f64; 2],
    library: fn(f32) -> f32,
    exact: fn(f64) -> f64,
    slot: usize,
) -> Function {
    Function {
        quantity,
        low,
        high,
        ours: None,
        library,
        exact,
        slots: (None, slot),
        absolute: false,
    }
}

const HALF_PI: f64 = std::f64::consts::FRAC_PI_2;

type Single = fn(f32) -> f32;
type Exact = fn(f64) -> f64;
/// Name, range, ours and the library's in f32, and exact.
type Ours = (&'static str, (f64, f64), Single, Single, Exact);

/// In the order of the shader's outputs.
const OURS: [Ours; 8] = [
    (
        "sin(t)/t",
        (1e-6, HALF_PI),
        |t| f32::sinc_cos(t * t)[0],
        |t| t.sin() / t,
        sinc,
    ),
    (
        COSINE,
        (1e-6, HALF_PI),
        |t| f32::sinc_cos(t * t)[1],
        f32::cos,
        f64::cos,
    ),
    (
        "sinh(t)/t",
        (1e-6, 80.0),
        |t| f32::sinhc_cosh(t)[0],
        |t| t.sinh() / t,
        |t| t.sinh() / t,
    ),
    (
        "cosh t",
        (1e-6, 80.0),
        |t| f32::sinhc_cosh(t)[1],
        f32::cosh,
        f64::cosh,
    ),
    (
        "exp t",
        (1e-6, 80.0),
        <f32 as Real>::exp,
        f32::exp,
        f64::exp,
    ),
    (
        "atan2(t, 1)",
        (1e-6, 1e6),
        |t| f32::angle(t, 1.0),
        |t| t.atan2(1.0),
        f64::atan,
    ),
    (
        "asinh t",
        (1e-8, 1e30),
        <f32 as Real>::asinh,
        f32::asinh,
        f64::asinh,
    ),
    (
        "(sinh(t)/t - 1)/t^2",
        (1e-6, 1.0),
        |t| f32::sinc_bend(t * t, -1.0),
        |t| (t.sinh() / t - 1.0) / (t * t),
        bend,
    ),
];
/// Near its zero a cosine is judged in ulp of 1.
const COSINE: &str = "cos t";

/// Our own, with the built-in function that each takes the place of.
fn our_functions() -> Vec<Function> {
    let one = |(slot, (quantity, (low, high), ours, library, exact))| Function {
        quantity,
        low,
        high,
        ours: Some(ours),
        library,
        exact,
        slots: (Some(slot), slot + 8),
        absolute: quantity == COSINE,
    };
    OURS.into_iter().enumerate().map(one).collect()
}

/// What else a shader could use.
fn built_in_functions() -> Vec<Function> {
    vec![
        built_in("sin t", [1e-6, 1.5], f32::sin, f64::sin, 16),
        built_in("sinh t", [1e-6, 80.0], f32::sinh, f64::sinh, 17),
        built_in("tanh t", [1e-6, 20.0], f32::tanh, f64::tanh, 18),
        built_in(
            "acosh(1 + t)",
            [1e-6, 1e3],
            |t| (1.0 + t).acosh(),
            acosh_one_plus,
            19,
        ),
        built_in("log t", [1e-6, 0.9], f32::ln, f64::ln, 20),
        built_in("sqrt t", [1e-30, 1e30], f32::sqrt, f64::sqrt, 21),
        built_in(
            "1/sqrt t",
            [1e-30, 1e30],
            |t| 1.0 / t.sqrt(),
            |t| 1.0 / t.sqrt(),
            22,
        ),
    ]
}

fn sinc(t: f64) -> f64 {
    t.sin() / t
}

fn bend(t: f64) -> f64 {
    antipode_geometry::scalar::sinc_minus_one_over_square(-1.0, t)
}

/// The argument is rounded to single before the function sees it.
fn acosh_one_plus(t: f64) -> f64 {
    f64::from(1.0 + t as f32).acosh()
}

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Outputs([f32; 24]);

const BODY: &str = "let t = inputs[i];
    let trig = geo_sinc_cos(t * t);
    let hyper = geo_sinhc_cosh(t);
    outputs[i].ours = array<f32, 8>(trig.x, trig.y, hyper.x, hyper.y, geo_exp(t), geo_angle(t, 1.0),
        geo_asinh(t), geo_sinc_bend(t * t, 1.0));
    outputs[i].same = array<f32, 8>(sin(t) / t, cos(t), sinh(t) / t, cosh(t), exp(t), atan2(t, 1.0),
        asinh(t), (sinh(t) / t - 1.0) / (t * t));
    outputs[i].rest = array<f32, 8>(sin(t), sinh(t), tanh(t), acosh(1.0 + t), log(t), sqrt(t),
        inverseSqrt(t), 0.0);";

/// Runs every function.
pub fn run(bench: &Bench) -> Result<Findings, LabError> {
    let mut found = Findings::default();
    let shader = compute::shader(
        "struct Row { ours: array<f32, 8>, same: array<f32, 8>, rest: array<f32, 8> }",
        "f32",
        "Row",
        BODY,
    );
    let functions = our_functions().into_iter().chain(built_in_functions());
    for (i, function) in functions.enumerate() {
        let mut rng = Numbers::new(100 + i as u64);
        let inputs: Vec<f32> = (0..bench.effort.count(100_000))
            .map(|_| rng.magnitude(function.low, function.high) as f32)
            .filter(|t| f64::from(*t) <= function.high)
            .collect();
        let outputs = match &bench.gpu {
            Some(gpu) => Some(compute::run::<f32, Outputs>(gpu, &FLAT, &shader, &inputs)?),
            None => None,
        };
        measure(&function, i, &inputs, outputs.as_deref(), &mut found);
    }
    Ok(found)
}

fn measure(
    function: &Function,
    i: usize,
    inputs: &[f32],
    outputs: Option<&[Outputs]>,
    found: &mut Findings,
) {
    let mut worst = [(); 4].map(|()| Worst::default());
    let mut curves = [
        "ours, CPU f32",
        "library, CPU f32",
        "ours, GPU",
        "built-in, GPU",
    ]
    .map(|name| Curve::new(name, function.low, function.high));
    for (n, &t) in inputs.iter().enumerate() {
        let exact = (function.exact)(f64::from(t));
        let error = |value: f32| {
            if function.absolute {
                (f64::from(value) - exact).abs() / ulp(1.0)
            } else {
                off(value, exact)
            }
        };
        let output = outputs.map(|outputs| outputs[n].0);
        let errors = [
            function.ours.map(|ours| error(ours(t))),
            Some(error((function.library)(t))),
            output.zip(function.slots.0).map(|(o, slot)| error(o[slot])),
            output.map(|o| error(o[function.slots.1])),
        ];
        let at = || format!("t = {t:e}");
        note_all(errors, &mut worst, &mut curves, f64::from(t), at);
    }
    rows(function, worst, outputs.is_some(), found);
    if function.ours.is_some() {
        found.plots.push(plot(
            &format!("function-{i}"),
            &format!("{}: error against the argument", function.quantity),
            "t",
            "worst error, ulp",
            &curves,
        ));
    }
}

fn rows(function: &Function, worst: [Worst; 4], ran: bool, found: &mut Findings) {
    let [single, library, gpu, built_in] = worst;
    let row = |arithmetic, ours, bar, naive| Row {
        quantity: function.quantity,
        range: format!(
            "t from {:e} to {}",
            function.low,
            crate::figure::number(function.high)
        ),
        arithmetic,
        unit: "ulp",
        ours,
        bar,
        naive,
    };
    if function.ours.is_some() {
        let bar = Some(1.5);
        found
            .rows
            .push(row(Arithmetic::Single, Some(single), bar, Some(library)));
        let built_in = ran.then_some(built_in);
        found
            .rows
            .push(row(Arithmetic::Gpu, ran.then_some(gpu), bar, built_in));
    } else {
        found.rows.push(row(
            Arithmetic::BuiltIn,
            ran.then_some(built_in),
            None,
            Some(library),
        ));
    }
}
