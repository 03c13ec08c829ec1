//! The shader's own trigonometry on the adapter: golden rows, dense inputs, and every branch.

use antipode_geometry::kernel::library;
use antipode_lab::compute;
use bytemuck::{Pod, Zeroable};

use super::gpu::gpu;
use super::tables::{Worst, rows, ulp};

const FUNCTIONS: &str = include_str!("../../../reference/functions.json");

/// Every function at one pair of arguments; those whose domain it leaves are not looked at.
const BODY: &str = "let t = inputs[i].x;
    let trig = geo_sinc_cos(clamp(t, 0.0, 9.87));
    let hyper = geo_sinhc_cosh(clamp(t, -81.0, 81.0));
    let either = geo_sine_cosine(clamp(t, -6561.0, 9.87));
    outputs[i].values = array<f32, 12>(trig.x, trig.y, hyper.x, hyper.y, either.x, either.y,
        geo_exp(clamp(t, 0.0, 87.9)), geo_sinc_bend(t, -1.0), geo_sinc_bend(t, 1.0),
        geo_angle(max(t, 0.0), inputs[i].y), geo_asinh(max(t, 0.0)), 0.0);";

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Values([f32; 12]);

fn evaluate(inputs: &[[f32; 2]]) -> Option<Vec<Values>> {
    let row = "struct Row { values: array<f32, 12> }";
    let shader = compute::shader(row, "vec2<f32>", "Row", BODY);
    gpu().map(|gpu| gpu.compute(&shader, inputs, |_| 0))
}

/// What a function's error is a part of.
#[derive(Clone, Copy, PartialEq)]
enum Unit {
    /// The last place of the exact value.
    Own,
    /// The last place of the value, or of 1 where it is less.
    One,
}

/// A function: table, arguments, answers' columns, shader's slots, unit and bound in ulp.
struct Function {
    table: &'static str,
    arguments: usize,
    slots: &'static [usize],
    unit: Unit,
    bound: f64,
}

const fn function(
    table: &'static str,
    arguments: usize,
    slots: &'static [usize],
    unit: Unit,
    bound: f64,
) -> Function {
    Function {
        table,
        arguments,
        slots,
        unit,
        bound,
    }
}

const TABLES: &[Function] = &[
    function("sinc_cos", 1, &[0, 1], Unit::One, 1.5),
    function("sinhc_cosh", 1, &[2, 3], Unit::Own, 1.5),
    function("exp", 1, &[6], Unit::Own, 1.2),
    function("angle", 2, &[9], Unit::Own, 1.5),
    function("asinh", 1, &[10], Unit::Own, 1.5),
];

fn off(unit: Unit, ours: f32, exact: f64) -> f64 {
    let size = if unit == Unit::One {
        exact.abs().max(1.0)
    } else {
        exact
    };
    (f64::from(ours) - exact).abs() / ulp(size)
}

#[test]
fn golden_rows_hold_on_the_adapter() {
    for function in TABLES {
        let rows = rows(FUNCTIONS, function.table);
        let inputs: Vec<[f32; 2]> = rows
            .iter()
            .map(|row| [row[0] as f32, row[1] as f32])
            .collect();
        let Some(values) = evaluate(&inputs) else {
            return;
        };
        let mut worst = Worst::default();
        for (row, values) in rows.iter().zip(values) {
            for (exact, slot) in row[function.arguments..].iter().zip(function.slots) {
                worst.note(off(function.unit, values.0[*slot], *exact), row);
            }
        }
        worst.check(function.table, function.bound);
    }
}

#[test]
fn golden_bends_and_either_curvature_hold_on_the_adapter() {
    let table = rows(FUNCTIONS, "sinc_bend");
    let inputs: Vec<[f32; 2]> = table.iter().map(|row| [row[0] as f32, 0.0]).collect();
    let Some(values) = evaluate(&inputs) else {
        return;
    };
    let mut worst = Worst::default();
    for (row, values) in table.iter().zip(values) {
        let slot = if row[1] > 0.0 { 7 } else { 8 };
        worst.note(off(Unit::Own, values.0[slot], row[2]), row);
    }
    worst.check("bends", 1.5);
    let table = rows(FUNCTIONS, "sine_cosine");
    let inputs: Vec<[f32; 2]> = table.iter().map(|row| [row[0] as f32, 0.0]).collect();
    let Some(values) = evaluate(&inputs) else {
        return;
    };
    let mut worst = Worst::default();
    for (row, values) in table.iter().zip(values) {
        // The root of s is rounded, which is half its own size in ulp of an exponential.
        let condition = if row[0] < -1.0 { (-row[0]).sqrt() } else { 1.0 };
        worst.note(off(Unit::One, values.0[4], row[1]) / condition, row);
        worst.note(off(Unit::One, values.0[5], row[2]) / condition, row);
    }
    worst.check("either curvature", 1.6);
}

/// Evenly spread in the logarithm.
fn spread(low: f64, high: f64, count: u32) -> Vec<f32> {
    let step = (high / low).ln() / f64::from(count - 1);
    (0..count)
        .map(|i| (low * (f64::from(i) * step).exp()) as f32)
        .collect()
}

/// A name, a column, its unit, the arguments, the bound and the function itself.
type Dense = (&'static str, usize, Unit, (f64, f64), f64, fn(f64) -> f64);

const RIGHT_ANGLE_SQUARE: f64 = std::f64::consts::FRAC_PI_2 * std::f64::consts::FRAC_PI_2;

fn sinc(s: f64) -> f64 {
    library::sinc_cos(s)[0]
}

fn cosine(s: f64) -> f64 {
    library::sinc_cos(s)[1]
}

fn sinhc(t: f64) -> f64 {
    library::sinhc_cosh(t)[0]
}

fn cosh(t: f64) -> f64 {
    library::sinhc_cosh(t)[1]
}

fn sine_bend(s: f64) -> f64 {
    library::sinc_bend(s, 1.0)
}

fn sinh_bend(s: f64) -> f64 {
    library::sinc_bend(s, -1.0)
}

const DENSE: &[Dense] = &[
    (
        "sin t / t to a right angle",
        0,
        Unit::Own,
        (1e-8, RIGHT_ANGLE_SQUARE),
        1.5,
        sinc,
    ),
    ("sin t / t", 0, Unit::One, (0.1, 9.8696), 1.5, sinc),
    ("cos t", 1, Unit::One, (1e-8, 9.8696), 1.5, cosine),
    ("sinh t / t", 2, Unit::Own, (1e-4, 80.0), 1.5, sinhc),
    ("sinh t / t, 1 to 8", 2, Unit::Own, (0.99, 8.0), 1.5, sinhc),
    ("cosh t", 3, Unit::Own, (1e-4, 80.0), 1.5, cosh),
    ("cosh t, 1 to 8", 3, Unit::Own, (0.99, 8.0), 1.5, cosh),
    ("exp t", 6, Unit::Own, (1e-4, 87.0), 1.2, f64::exp),
    ("sine's bend", 7, Unit::Own, (1e-8, 9.8), 1.5, sine_bend),
    ("sinh's bend", 8, Unit::Own, (1e-8, 3.99), 1.5, sinh_bend),
    ("atan2(t, 1)", 9, Unit::Own, (1e-8, 1e8), 1.5, f64::atan),
    (
        "atan2(t, 1), 1/4 to 4",
        9,
        Unit::Own,
        (0.25, 4.0),
        1.5,
        f64::atan,
    ),
    ("asinh t", 10, Unit::Own, (1e-8, 1e30), 1.5, f64::asinh),
    (
        "asinh t, 1/4 to 8",
        10,
        Unit::Own,
        (0.25, 8.0),
        1.5,
        f64::asinh,
    ),
];

/// Dense inputs against the library in f64, which is exact to one f64 ulp.
#[test]
fn dense_inputs_hold_on_the_adapter() {
    for (name, slot, unit, range, bound, exact) in DENSE {
        let inputs = spread(range.0, range.1, 1_000_000);
        let pairs: Vec<[f32; 2]> = inputs.iter().map(|t| [*t, 1.0]).collect();
        let Some(values) = evaluate(&pairs) else {
            return;
        };
        let mut worst = Worst::default();
        for (t, values) in inputs.iter().zip(values) {
            let t = f64::from(*t);
            worst.note(off(*unit, values.0[*slot], exact(t)), &[t]);
        }
        worst.check(name, *bound);
    }
}

/// A column, where it changes branches, its bound there, and the function itself.
type Turn = (usize, f32, f64, fn(f64) -> f64);

/// On both sides of every branch the values stay within the bounds of their own side, so they part
/// by no more than the bounds together.
#[test]
fn neighbours_of_every_branch_hold_on_the_adapter() {
    let around =
        |x: f32| (-40..=40).map(move |i| f32::from_bits(x.to_bits().wrapping_add_signed(i)));
    let points: &[Turn] = &[
        (0, 3.2, 1.5, sinc),
        (1, 3.2, 1.5, cosine),
        (2, 1.0, 1.5, sinhc),
        (3, 1.0, 1.5, cosh),
        (5, -1.0, 1.6, |s| library::sine_cosine(s)[1]),
        (9, 0.5, 1.5, f64::atan),
        (9, 1.0, 1.5, f64::atan),
        (9, 2.0, 1.5, f64::atan),
        (10, 0.75, 1.5, f64::asinh),
        (10, 1e4, 1.5, f64::asinh),
    ];
    for (slot, at, bound, exact) in points {
        let inputs: Vec<[f32; 2]> = around(*at).map(|x| [x, 1.0]).collect();
        let Some(values) = evaluate(&inputs) else {
            return;
        };
        let mut worst = Worst::default();
        for (input, values) in inputs.iter().zip(values) {
            let t = f64::from(input[0]);
            worst.note(off(Unit::One, values.0[*slot], exact(t)), &[t]);
        }
        worst.check(&format!("slot {slot} about {at}"), *bound);
    }
}
