//! Measures the vertex stage alone. A compute pass does for a million vertices what the land's vertex shader does
//! with the space (port, clip coordinates, normal, distance), in each variant.

use std::rc::Rc;

use antipode_geometry::kernel::horizon::HorizonMap;
use antipode_geometry::kernel::raised::RaisedMap;
use antipode_geometry::kernel::sphere::port as port_sphere;
use antipode_geometry::{
    ChartPoint, Eye, Geometry, HyperbolicMap, MapShader, Projection, SpaceUniform, picture,
};
use antipode_render::Gpu;
use glam::DVec3;
use wgpu::BufferUsages as Usage;

use crate::compute::{buffer, filled, read};
use crate::random::Numbers;
use crate::speed::columns::affine;
use crate::speed::inputs::ground;
use crate::speed::library::seen;
use crate::speed::passes::{Pass, VERTICES, Watch, race};
use crate::speed::port::angle;
use crate::terrain::radius_m;
use crate::{Cell, Effort, LabError, Plot, Scale, Series, Table};

/// Vertices whose results are read back and judged.
const JUDGED: usize = 4096;
/// Height of the sphere's eye over the pole, metres, and of the horizon map's over its sheet.
const SPHERE_EYE_M: f64 = 12.0;
const LIFT_M: f64 = 1.65;

/// The game's own functions.
const GAME: &str = "
    v = port_to_view(space, p);
    extra = clip_from_view(space, v).z + dot(port_normal(space, p, n), LIGHT) + eye_distance(space, v);";
/// The game's port alone.
const PORT: &str = "
    v = port_to_view(space, p);
    extra = v.w + n.x;";
/// One matrix for all: the space's is the object's frame.
const RIGID: &str = "
    v = space.view * vec4<f32>(p, 1.0);
    extra = clip_from_view(space, v).z + dot(n, LIGHT) + eye_distance(space, v);";
/// The textbook's raised map: port by the built-in functions, boost, a four-vector's normal and acosh.
const NAIVE_RAISED: &str = "
    let q = space.k_per_m * p + vec3<f32>(0.0, space.lift, 0.0);
    let d = length(q);
    let s = sinh(d) / d;
    let c = cosh(d);
    let x = vec4<f32>(s * q.x, space.lift_cosine * s * q.y - space.lift_sine * c, s * q.z, space.lift_cosine * c - space.lift_sine * s * q.y);
    v = space.view * vec4<f32>(x.xyz * space.radius_m, x.w);
    let along = dot(n, q) / (d * d);
    let carried = normalize(vec4<f32>(n + q * ((c - 1.0) * along), s * d * d * along));
    extra = clip_from_view(space, v).z + dot(carried.xyz, LIGHT) + acosh(x.w);";
/// The textbook's sphere: the built-in functions, a normal carried like a direction and acos.
const NAIVE_SPHERE: &str = "
    let u = space.k_per_m * p;
    let r = length(u.xz);
    let s = sin(r) / r;
    v = space.view * vec4<f32>(cos(u.y) * s * p.x, sin(u.y) * space.radius_m, cos(u.y) * s * p.z, cos(u.y) * cos(r));
    extra = clip_from_view(space, v).z + dot(n, LIGHT) + acos(v.w);";

/// A map in doubles: from metres to view coordinates.
type Exact = Rc<dyn Fn([f64; 3]) -> [f64; 4]>;

#[derive(Clone)]
struct Variant {
    name: String,
    body: &'static str,
    map: &'static MapShader,
    space: SpaceUniform,
    exact: Exact,
    /// Metres added to the heights of the shared vertices.
    lift_m: f64,
}

impl Variant {
    /// The same space by another body.
    fn by(&self, what: &str, body: &'static str) -> Self {
        Self {
            name: format!("{}{what}", self.name),
            body,
            ..self.clone()
        }
    }
}

fn wide(columns: [[f32; 4]; 4]) -> [[f64; 4]; 4] {
    columns.map(|c| c.map(f64::from))
}

fn eye(dial: f64) -> Eye {
    Eye {
        point: ChartPoint::a(DVec3::new(0.0, SPHERE_EYE_M, 0.0)),
        yaw: 0.4,
        pitch: -0.2,
        roll: 0.0,
        dial,
        lift_m: LIFT_M,
    }
}

fn space(geometry: Geometry, map: HyperbolicMap, dial: f64) -> (&'static MapShader, SpaceUniform) {
    let projection = Projection::new(75_f64.to_radians(), 16.0 / 9.0, 0.02);
    let space = picture(geometry, radius_m(geometry), map, false);
    (space.shader(), space.uniform(&eye(dial), &projection))
}

/// The spaces as the game draws them: flat, raised, horizon and sphere.
fn spaces() -> [Variant; 4] {
    let (raised_map, horizon_map) = (HyperbolicMap::Raised, HyperbolicMap::Horizon);
    let flat = space(Geometry::Euclidean, raised_map, 0.0);
    let raised = space(Geometry::Hyperbolic, raised_map, 10.0);
    let horizon = space(Geometry::Hyperbolic, horizon_map, 10.0);
    let sphere = space(Geometry::Spherical, raised_map, 0.0);
    let lifted = raised_form();
    let k = 0.125;
    let level = HorizonMap::<f64>::new(-k * k, LIFT_M);
    let ball_k = f64::from(sphere.1.k_per_m);
    let one = |name: &str, (map, space): (_, SpaceUniform), lift_m, exact: Exact| Variant {
        name: name.to_owned(),
        body: GAME,
        map,
        space,
        exact: Rc::new(move |p| seen(&wide(space.view), exact(p))),
        lift_m,
    };
    [
        one("flat", flat, 0.0, Rc::new(|[x, y, z]| [x, y, z, 1.0])),
        one("raised", raised, 0.0, Rc::new(move |p| lifted.port(p))),
        one("horizon", horizon, 0.0, Rc::new(move |p| level.port(p))),
        one(
            "sphere",
            sphere,
            SPHERE_EYE_M,
            Rc::new(move |p| port_sphere(ball_k, false, p)),
        ),
    ]
}

fn raised_form() -> RaisedMap<f64> {
    RaisedMap::<f64>::new(20.0, 10.0)
}

/// About an object 20 m ahead of the raised map's eye, in whose frame the vertices are.
fn framed(raised: &Variant) -> Variant {
    let form = raised_form();
    let frame = affine(|p| form.port(p), [20.0, -2.0, 0.0]);
    let view = wide(raised.space.view);
    let columns = frame.map(|c| seen(&view, c).map(|x| x as f32));
    Variant {
        name: "one frame an object".to_owned(),
        body: RIGID,
        map: raised.map,
        space: SpaceUniform {
            view: columns,
            ..raised.space
        },
        exact: Rc::new(move |[x, y, z]| seen(&wide(columns), [x, y, z, 1.0])),
        lift_m: 0.0,
    }
}

fn variants() -> Vec<Variant> {
    let spaces = spaces();
    let all = |what: &str, body| spaces.each_ref().map(|space| space.by(what, body));
    let [_, raised, _, sphere] = &spaces;
    let mut variants = all("", GAME).to_vec();
    variants.push(framed(raised));
    variants.push(raised.by(", textbook with built-ins", NAIVE_RAISED));
    variants.push(sphere.by(", textbook with built-ins", NAIVE_SPHERE));
    variants.extend(all(", port alone", PORT));
    variants
}

/// Vertices over land up to the edge of a view distance of six chunks, or of the sphere's chart.
fn vertices(lift_m: f64) -> Vec<[f32; 4]> {
    let mut numbers = Numbers::new(71);
    let far_m = if lift_m > 0.0 { 50.0 } else { 184.0 };
    let one = |_| {
        let [x, y, z] = ground(&mut numbers, 1.0, far_m, 5.0);
        let n = numbers.direction() * 127.0;
        let [a, b, c] = n.to_array().map(|x| x as i8 as u8);
        [
            x,
            y + lift_m as f32,
            z,
            f32::from_bits(u32::from_le_bytes([a, b, c, 0])),
        ]
    };
    (0..VERTICES).map(one).collect()
}

/// Worst angle at the eye, radians, and how many results were no number.
fn judge(variant: &Variant, inputs: &[[f32; 4]], seen: &[[f32; 4]]) -> (f64, usize) {
    let mut worst = 0.0_f64;
    let mut not_numbers = 0;
    for ([x, y, z, _], [a, b, c, _]) in inputs.iter().zip(seen) {
        let [i, j, k, _] = (variant.exact)([x, y, z].map(|v| f64::from(*v)));
        let error = angle([a, b, c].map(|v| f64::from(*v)), [i, j, k]);
        if error.is_finite() {
            worst = worst.max(error);
        } else {
            not_numbers += 1;
        }
    }
    (worst, not_numbers)
}

/// The vertex stage's table and plot.
///
/// # Errors
/// When the adapter fails.
pub fn measured(gpu: &Gpu, effort: Effort) -> Result<(Table, Plot), LabError> {
    let variants = variants();
    let seen = buffer(gpu, VERTICES * 16, Usage::STORAGE | Usage::COPY_SRC);
    let over_land = vertices(0.0);
    let over_sphere = vertices(SPHERE_EYE_M);
    let land = filled(gpu, bytemuck::cast_slice(&over_land), Usage::STORAGE);
    let sphere = filled(gpu, bytemuck::cast_slice(&over_sphere), Usage::STORAGE);
    let inputs = |v: &Variant| {
        if v.lift_m > 0.0 {
            (&over_sphere, &sphere)
        } else {
            (&over_land, &land)
        }
    };
    let passes: Vec<_> = variants
        .iter()
        .map(|v| Pass::new(gpu, v.body, (v.map, &v.space), inputs(v).1, &seen))
        .collect();
    let watch = Watch::new(gpu);
    let mut errors = Vec::new();
    for (variant, pass) in variants.iter().zip(&passes) {
        watch.time(pass)?;
        let got: Vec<[f32; 4]> = read(gpu, &pass.seen, JUDGED * 16)?;
        errors.push(judge(variant, inputs(variant).0, &got));
    }
    let times = race(&watch, &passes, effort)?;
    let judged: Vec<_> = variants.iter().zip(times).zip(errors).collect();
    Ok((rows(&judged), plot(&judged)))
}

/// A variant, its nanoseconds per vertex, its worst angle, and how many results were no number.
type Judged<'a> = ((&'a Variant, f64), (f64, usize));

fn rows(judged: &[Judged<'_>]) -> Table {
    let flat = judged.first().map_or(f64::NAN, |((_, ns), _)| *ns);
    let row = |((variant, ns), (worst, not_numbers)): &Judged<'_>| {
        vec![
            Cell::text(&variant.name),
            Cell::figure(*ns, "ns"),
            Cell::figure(ns / flat, ""),
            Cell::figure(*worst, "rad"),
            Cell::figure(*not_numbers as f64, ""),
        ]
    };
    let columns = [
        "variant",
        "time per vertex",
        "to flat",
        "worst angle at the eye",
        "not a number",
    ];
    Table::new(
        "The vertex stage alone: port, clip coordinates, normal and distance of a million vertices",
        columns,
        judged.iter().map(row),
    )
}

fn plot(judged: &[Judged<'_>]) -> Plot {
    let one = |((variant, ns), (worst, _)): &Judged<'_>| {
        Series::dots(variant.name.clone(), [(*ns, *worst)])
    };
    Plot::new(
        "speed-vertex-stage",
        "The vertex stage alone, on the adapter",
        Scale::Logarithmic.axes("time per vertex, ns", "worst angle at the eye, rad"),
        judged.iter().map(one),
    )
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests fail by panicking")]
mod tests {
    use antipode_render::AdapterChoice;

    use super::*;

    #[test]
    fn every_variant_sees_its_vertices_where_doubles_do() {
        let gpu = Gpu::headless(AdapterChoice::Auto).unwrap();
        for variant in variants() {
            let inputs = &vertices(variant.lift_m)[..JUDGED];
            let source = filled(&gpu, bytemuck::cast_slice(inputs), Usage::STORAGE);
            let seen = buffer(&gpu, JUDGED * 16, Usage::STORAGE | Usage::COPY_SRC);
            let pass = Pass::new(
                &gpu,
                variant.body,
                (variant.map, &variant.space),
                &source,
                &seen,
            );
            Watch::new(&gpu).time(&pass).unwrap();
            let got = read(&gpu, &seen, JUDGED * 16).unwrap();
            let (worst, not_numbers) = judge(&variant, inputs, &got);
            let most = if variant.name.contains("built-ins") {
                1e-2
            } else {
                5e-6
            };
            assert!(
                worst < most && not_numbers == 0,
                "{}: {worst:e}, {not_numbers}",
                variant.name
            );
        }
    }
}
