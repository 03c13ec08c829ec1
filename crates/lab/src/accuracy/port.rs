//! The charts as they are: a point in radii from the centre becomes a point of the model.
//!
//! Exponential chart of hyperbolic space, `X = (p sinh(d)/d, cosh d)`; cylindrical charts of
//! hyperbolic space and the sphere. The references are these definitions in `f64`, and in double-double arithmetic for the
//! `f64` port.

use antipode_geometry::kernel::exponential;
use antipode_geometry::kernel::horizon::HorizonMap;
use antipode_geometry::{MapShader, charts, shader};
use glam::{DVec3, DVec4, Vec3, Vec4};

use super::errors::{off_point, off_vector, words};
use super::row::{Curve, plot};
use super::{Arithmetic, Bench, Findings, Row, Worst};
use crate::double_double::Double2;
use crate::error::LabError;
use crate::random::Numbers;
use crate::{compute, naive, single};

/// How the suite measures and how to read it, in paragraphs.
pub const METHOD: &[&str] = &[
    "A point at distance d from the centre goes through the chart; the error of its spatial part is relative to that part's length, that of w to w, or to 1 where w is less, both in parts of 2^-23 (2^-52 for f64), the ulp of 1. Beyond d = 3 the error is divided by d: one ulp of d is d to 2 d ulp of sinh d, whatever the formula. Nothing beyond d = 20 is drawn, and the shader draws points in from 79, or 38 where two hyperboloid coordinates are multiplied. Below 1e-18 the squares of f32 underflow; the fuzz covers those.",
    "The textbook column is the exponential chart with the system's own sin, cos, sinh and cosh, and no guard at 0.",
];

/// The exponential chart is the shader's sine and cosine in parts, times the point.
const EXPONENTIAL: &str = "let p = inputs[i].xyz;
    let s = dot(p, p);
    var both = vec4<f32>(1.0, geo_excess(-s), 1.0);
    if s >= 1.0 { both = geo_parts_far(p); }
    outputs[i] = vec4<f32>(p * ((both.x + both.x * both.y) / both.w), both.x + both.x * both.z);";
/// The unit sphere, seen from the pole along the axes.
const SPHERE: &str = "var space = unit();
    space.k_per_m = 1.0;
    outputs[i] = port_to_view(space, inputs[i].xyz);";
/// The horizon map at curvature -1 from the height of its own sheet.
const HORIZON: &str = "var space = unit();
    space.kappa = -1.0;
    space.k_per_m = 1.0;
    outputs[i] = port_to_view(space, inputs[i].xyz);";
const UNIT: &str = "fn unit() -> Space {
    var space: Space;
    space.view = mat4x4<f32>(vec4<f32>(1.0, 0.0, 0.0, 0.0), vec4<f32>(0.0, 1.0, 0.0, 0.0),
        vec4<f32>(0.0, 0.0, 1.0, 0.0), vec4<f32>(0.0, 0.0, 0.0, 1.0));
    space.focal_x = 1.0;
    space.focal_y = 1.0;
    space.near_m = 0.05;
    space.radius_m = 1.0;
    space.lift_cosine = 1.0;
    space.level_m = 1e18;
    space.upright_m = 1e18;
    return space;
}";

/// One chart, its three computations and its definition.
struct Chart {
    quantity: &'static str,
    id: &'static str,
    sign: f64,
    single: fn(Vec3) -> Vec4,
    double: fn(DVec3) -> DVec4,
    better: fn(DVec3) -> [Double2; 4],
    map: &'static MapShader,
    shader: &'static str,
    ranges: &'static [[f64; 2]],
}

fn exponential_single(p: Vec3) -> Vec4 {
    exponential::point(-1.0, p.to_array()).into()
}

fn horizon_single(p: Vec3) -> Vec4 {
    let unit = HorizonMap::from_uniform([-1.0, 0.0, 0.0, 1.0], 1.0, 1.0);
    unit.port(p.to_array()).into()
}

fn cylindrical_single(p: Vec3) -> Vec4 {
    single::sphere(1.0, p)
}

fn exponential_better(p: DVec3) -> [Double2; 4] {
    let [x, y, z] = p.to_array().map(Double2::from);
    let d = (x * x + y * y + z * z).sqrt();
    let (sinh, cosh) = d.sinh_cosh();
    let across = if p == DVec3::ZERO {
        Double2::from(1.0)
    } else {
        sinh / d
    };
    [x * across, y * across, z * across, cosh]
}

fn cylindrical_better(sign: f64, p: DVec3) -> [Double2; 4] {
    let [x, y, z] = p.to_array().map(Double2::from);
    let r = (x * x + z * z).sqrt();
    let both = |t: Double2| {
        if sign > 0.0 {
            t.sin_cos()
        } else {
            t.sinh_cosh()
        }
    };
    let ((sin_r, cos_r), (sin_y, cos_y)) = (both(r), both(y));
    let across = if r.to_f64() == 0.0 {
        cos_y
    } else {
        cos_y * sin_r / r
    };
    [across * x, sin_y, across * z, cos_y * cos_r]
}

static CHARTS: [Chart; 3] = [
    Chart {
        quantity: "port, hyperbolic (exponential chart)",
        id: "port-hyperbolic",
        sign: -1.0,
        single: exponential_single,
        double: |p| charts::exponential(-1.0, p),
        better: exponential_better,
        map: &shader::FLAT,
        shader: EXPONENTIAL,
        ranges: &[[1e-18, 1e-4], [1e-4, 3.0], [3.0, 79.0]],
    },
    Chart {
        quantity: "port, hyperbolic (cylindrical chart)",
        id: "port-horizon",
        sign: -1.0,
        single: horizon_single,
        double: |p| charts::cylindrical(-1.0, p),
        better: |p| cylindrical_better(-1.0, p),
        map: &shader::HORIZON,
        shader: HORIZON,
        ranges: &[[1e-18, 1e-4], [1e-4, 3.0], [3.0, 38.0]],
    },
    Chart {
        quantity: "port, spherical (cylindrical chart)",
        id: "port-spherical",
        sign: 1.0,
        single: cylindrical_single,
        double: |p| charts::cylindrical(1.0, p),
        better: |p| cylindrical_better(1.0, p),
        map: &shader::SPHERE,
        shader: SPHERE,
        ranges: &[[1e-18, 1e-4], [1e-4, 2.0]],
    },
];

/// Runs both charts over their ranges.
pub fn run(bench: &Bench) -> Result<Findings, LabError> {
    let mut found = Findings::default();
    for chart in &CHARTS {
        let mut curves = ["CPU f32", "CPU f64, then f32", "GPU", "textbook f32"]
            .map(|name| Curve::new(name, 1e-6, 79.0));
        for range in chart.ranges {
            found
                .rows
                .extend(measure(bench, chart, *range, &mut curves)?);
        }
        let title = format!("{}: error against distance", chart.quantity);
        found.plots.push(plot(
            chart.id,
            &title,
            "distance from the centre, radii",
            "worst error, ulp (divided by d beyond 3)",
            &curves,
        ));
    }
    Ok(found)
}

/// The rim of a hemisphere's chart and the height of the world's ceiling, in radii.
const HEMISPHERE: f32 = std::f32::consts::FRAC_PI_2;
const CEILING: f32 = 1.2;

fn inputs(bench: &Bench, chart: &Chart, [low, high]: [f64; 2]) -> Vec<Vec3> {
    let mut rng = Numbers::new(1);
    let mut points = vec![Vec3::ZERO];
    while points.len() < bench.effort.count(200_000) {
        let p = (rng.direction() * rng.magnitude(low, high)).as_vec3();
        let level = p.x.hypot(p.z);
        let charted = chart.sign < 0.0 || (level <= HEMISPHERE && p.y.abs() <= CEILING);
        if charted && p.as_dvec3().length() <= high {
            points.push(p);
        }
    }
    points
}

fn measure(
    bench: &Bench,
    chart: &Chart,
    range: [f64; 2],
    curves: &mut [Curve; 4],
) -> Result<Vec<Row>, LabError> {
    let points = inputs(bench, chart, range);
    let gpu = gpu_points(bench, chart, &points)?;
    let mut worst = [(); 4].map(|()| Worst::default());
    let mut double = Worst::default();
    for (i, p) in points.iter().enumerate() {
        let exact = (chart.double)(p.as_dvec3());
        let textbook = naive::exponential(chart.sign as f32, *p);
        let definition = charts::exponential(chart.sign, p.as_dvec3());
        let d = p.as_dvec3().length();
        let scale = if d > 3.0 { d } else { 1.0 };
        let errors = [
            Some(off_point((chart.single)(*p), exact)),
            Some(off_point(exact.as_vec4(), exact)),
            gpu.as_ref().map(|gpu| off_point(gpu[i], exact)),
            Some(off_point(textbook, definition)),
        ];
        for ((error, worst), curve) in errors.into_iter().zip(&mut worst).zip(curves.iter_mut()) {
            let Some(error) = error else { continue };
            worst.note(error / scale, || words(p.as_dvec3()));
            curve.note(d, error / scale);
        }
        // Double-double is slow; a part of the points is enough.
        if i % 10 == 0 {
            double.note(off_double(chart, p.as_dvec3()) / scale, || {
                words(p.as_dvec3())
            });
        }
    }
    Ok(rows(chart, range, worst, double, gpu.is_some()))
}

fn gpu_points(
    bench: &Bench,
    chart: &Chart,
    points: &[Vec3],
) -> Result<Option<Vec<Vec4>>, LabError> {
    let Some(gpu) = &bench.gpu else {
        return Ok(None);
    };
    let shader = compute::shader(UNIT, "vec4<f32>", "vec4<f32>", chart.shader);
    let inputs: Vec<Vec4> = points.iter().map(|p| p.extend(0.0)).collect();
    compute::run(gpu, chart.map, &shader, &inputs).map(Some)
}

/// The `f64` port against double-double arithmetic, in parts of 2^-52.
fn off_double(chart: &Chart, p: DVec3) -> f64 {
    let ours = (chart.double)(p);
    let exact = (chart.better)(p);
    let gap = [0, 1, 2, 3].map(|i| (Double2::from(ours[i]) - exact[i]).to_f64());
    let exact = DVec4::from_array(exact.map(Double2::to_f64));
    off_vector(DVec4::from_array(gap), exact) / f64::EPSILON
}

fn rows(
    chart: &Chart,
    [low, high]: [f64; 2],
    [single, cast, gpu, textbook]: [Worst; 4],
    double: Worst,
    ran: bool,
) -> Vec<Row> {
    let unit = if high > 3.0 { "ulp per d" } else { "ulp" };
    let bar = if high > 3.0 { 2.0 } else { 1.5 };
    let row = |arithmetic, ours, bar| Row {
        quantity: chart.quantity,
        range: format!("d from {low:e} to {high}, and 0"),
        arithmetic,
        unit,
        ours,
        bar,
        naive: Some(textbook.clone()),
    };
    let mut rows = vec![
        row(Arithmetic::Single, Some(single), Some(bar)),
        row(Arithmetic::Cast, Some(cast), Some(0.5)),
        row(Arithmetic::Gpu, ran.then_some(gpu), Some(bar)),
    ];
    let mut double = row(Arithmetic::Double, Some(double), None);
    double.unit = if high > 3.0 {
        "ulp of f64 per d"
    } else {
        "ulp of f64"
    };
    double.naive = None;
    rows.push(double);
    rows
}
