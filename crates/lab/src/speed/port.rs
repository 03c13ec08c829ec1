//! What a port of one vertex costs and how true it is, in each map: the game's series, the library's functions,
//! doubles, a port that is boosted afterwards, and one frame for a whole object.

use antipode_geometry::kernel::horizon::HorizonMap;
use antipode_geometry::kernel::raised::RaisedMap;
use antipode_geometry::kernel::{exponential, sphere};
use antipode_geometry::{ChartPoint, Eye, Geometry, Projection, strategy};
use glam::{DVec3, Vec3};

use crate::random::Numbers;
use crate::speed::columns::{Columns, affine, rigid};
use crate::speed::inputs::ground;
use crate::speed::library;
use crate::speed::pareto::{Contest, Group};
use crate::{Effort, naive};

/// Vertices of a batch.
pub const BATCH: usize = 4096;
/// Vertices of an object.
const OBJECT: usize = 8;
/// Edge of an object in metres.
const EDGE_M: f64 = 0.5;
/// Farthest vertex, metres: what a view distance of six chunks shows.
const FAR_M: f64 = 184.0;
const RADIUS_M: f64 = 20.0;
const SPHERE_RADIUS_M: f64 = 32.0;
/// Offset of the raised map, metres.
const OFFSET_M: f64 = 10.0;
/// Notches of the horizon map's dial, and its eye's height in metres.
const HORIZON: (f64, f64) = (10.0, 1.65);
/// The horizon map's curvature is its notches over this, per metre.
const NOTCHES_RADIUS_M: f64 = 80.0;
/// Where the game computes in single and in double precision.
const SHADER: &str = "shaders";
const PROCESSOR: &str = "processor";

/// What the error is, and its unit.
const ERROR: (&str, &str) = ("worst angle at the eye", "rad");

/// Ways to port a vertex.
type Rivals<'a, E> = Contest<'a, Vertex, [f32; 4], E>;

/// A vertex and the object it belongs to.
#[derive(Clone, Copy, Debug)]
pub struct Vertex {
    /// Metres from the eye or the pole.
    pub at: [f32; 3],
    /// Metres from the object's middle.
    pub within: [f32; 3],
    /// Index of the object.
    pub object: usize,
}

/// The angle between two sight lines, radians, without cancellation.
pub fn angle(got: [f64; 3], true_one: [f64; 3]) -> f64 {
    let (a, b) = (DVec3::from(got), DVec3::from(true_one));
    a.cross(b).length().atan2(a.dot(b))
}

fn wide<const N: usize>(v: [f32; N]) -> [f64; N] {
    v.map(f64::from)
}

fn cast(v: [f64; 4]) -> [f32; 4] {
    v.map(|x| x as f32)
}

fn sight_error(got: [f32; 4], true_one: [f64; 4]) -> f64 {
    let [x, y, z, _] = wide(got);
    let [a, b, c, _] = true_one;
    if got.iter().all(|v| v.is_finite()) {
        angle([x, y, z], [a, b, c])
    } else {
        f64::NAN
    }
}

/// Objects over land, and their vertices.
pub fn objects(seed: u64, far_m: f64, height_m: f64, edge_m: f64) -> (Vec<[f64; 3]>, Vec<Vertex>) {
    let mut numbers = Numbers::new(seed);
    let middles: Vec<[f64; 3]> = (0..BATCH / OBJECT)
        .map(|_| wide(ground(&mut numbers, 0.5, far_m, height_m)))
        .collect();
    let mut vertices = Vec::with_capacity(BATCH);
    for (object, middle) in middles.iter().enumerate() {
        for _ in 0..OBJECT {
            let within = [0; 3].map(|_| numbers.between(-0.5 * edge_m, 0.5 * edge_m) as f32);
            let at = [0, 1, 2].map(|i| (middle[i] + f64::from(within[i])) as f32);
            vertices.push(Vertex { at, within, object });
        }
    }
    (middles, vertices)
}

/// A formula of the map by itself, in radii: d from 1e-4 to 3 and one point at 0.
pub fn exponential_group(effort: Effort) -> Group {
    let mut numbers = Numbers::new(1);
    let mut inputs: Vec<[f32; 3]> = (1..BATCH)
        .map(|_| {
            (numbers.direction() * numbers.magnitude(1e-4, 3.0))
                .as_vec3()
                .to_array()
        })
        .collect();
    inputs.push([0.0; 3]);
    let error = |p: &[f32; 3], got: &[f32; 4]| ulps(*got, exponential::point(-1.0, wide(*p)));
    let rivals = Contest::new(&inputs, error)
        .with("textbook: p sinh(d)/d, library, f32", "", |p| {
            naive::exponential(-1.0, Vec3::from(*p)).to_array()
        })
        .with("library, f32, guarded", "", |p| library::exponential(*p))
        .with("series, f32", SHADER, |p| exponential::point(-1.0, *p))
        .with("f64, then rounded", PROCESSOR, |p| {
            cast(exponential::point(-1.0, wide(*p)))
        });
    let title = "Port of one vertex by the exponential chart, d from 1e-4 to 3 and one at 0";
    rivals.race(
        "port-exponential",
        title,
        ("worst component", "ulp"),
        effort,
    )
}

/// The worst component's error in units of its last place.
fn ulps(got: [f32; 4], true_one: [f64; 4]) -> f64 {
    let one = |(got, true_one): (f32, f64)| {
        let near = true_one as f32;
        let step = if near == 0.0 {
            f32::MIN_POSITIVE
        } else {
            near.abs().next_up() - near.abs()
        };
        let error = (f64::from(got) - true_one).abs() / f64::from(step);
        if error.is_nan() { f64::INFINITY } else { error }
    };
    got.into_iter().zip(true_one).map(one).fold(0.0, f64::max)
}

/// The raised map at its default offset.
pub fn raised_group(effort: Effort) -> Group {
    let (single, double) = raised_maps();
    let (middles, inputs) = objects(2, FAR_M, 20.0, EDGE_M);
    let map = move |p: [f64; 3]| double.port(p);
    let error = |v: &Vertex, got: &[f32; 4]| sight_error(*got, map(wide(v.at)));
    let rivals = Contest::new(&inputs, error)
        .with("textbook: port then boost, library, f32", "", |v| {
            raised_textbook(&single, v.at)
        })
        .with("port then boost, series, f32", "", |v| {
            library::port_then_boost(&single, v.at)
        })
        .with("port then boost, f64, then rounded", "", |v| {
            cast(library::port_then_boost(&double, wide(v.at)))
        });
    let rivals = closed_forms(
        rivals,
        move |at| library::raised(&single, at),
        move |at| single.port(at),
        map,
    );
    let rivals = framed(rivals, frames(&middles, map, -1.0, double.k));
    let title =
        "Port of one vertex by the raised map, offset 10 m, objects of half a metre to 184 m away";
    rivals.race("port-raised", title, ERROR, effort)
}

/// The horizon map at its default curvature.
pub fn horizon_group(effort: Effort) -> Group {
    let (notches, lift) = HORIZON;
    let k = (notches / NOTCHES_RADIUS_M) as f32;
    let kappa = -k * k;
    let double = HorizonMap::<f64>::new(f64::from(kappa), lift);
    let curve = [kappa, lift as f32, double.sin as f32, double.cos as f32];
    let single = HorizonMap::from_uniform(curve, k, 1.0 / k);
    let (middles, inputs) = objects(3, FAR_M, 20.0, EDGE_M);
    let map = move |p: [f64; 3]| double.port(p);
    let error = |v: &Vertex, got: &[f32; 4]| sight_error(*got, map(wide(v.at)));
    let rivals = closed_forms(
        Contest::new(&inputs, error),
        move |at| library::horizon(&single, at),
        move |at| single.port(at),
        map,
    );
    let rivals = framed(rivals, frames(&middles, map, -1.0, f64::from(k)));
    let title =
        "Port of one vertex by the horizon map, dial 10, objects of half a metre to 184 m away";
    rivals.race("port-horizon", title, ERROR, effort)
}

/// The sphere, with the eye a little off the pole.
pub fn sphere_group(effort: Effort) -> Group {
    let eye = Eye {
        point: ChartPoint::a(DVec3::new(3.0, 12.0, -5.0)),
        yaw: 0.4,
        pitch: -0.2,
        ..Eye::default()
    };
    let uniform = strategy(Geometry::Spherical, SPHERE_RADIUS_M)
        .uniform(&eye, &Projection::new(1.3, 1.6, 0.02));
    let k = uniform.k_per_m;
    let view = uniform.view;
    let columns = view.map(wide);
    let map = move |p: [f64; 3]| library::seen(&columns, sphere::port(f64::from(k), false, p));
    let rim = std::f64::consts::FRAC_PI_2 * SPHERE_RADIUS_M;
    let (middles, mut inputs) = objects(4, rim, 3.0, EDGE_M);
    let lift = 0.3 * SPHERE_RADIUS_M;
    for vertex in &mut inputs {
        vertex.at[1] += lift as f32;
    }
    let middles: Vec<_> = middles.iter().map(|m| [m[0], m[1] + lift, m[2]]).collect();
    let error = |v: &Vertex, got: &[f32; 4]| sight_error(*got, map(wide(v.at)));
    let rivals = closed_forms(
        Contest::new(&inputs, error),
        move |at| library::seen(&view, library::sphere(k, at)),
        move |at| library::seen(&view, sphere::port(k, false, at)),
        map,
    );
    let rivals = framed(rivals, frames(&middles, map, 1.0, f64::from(k)));
    let title = "Port of one vertex by the sphere's chart, radius 32 m, objects of half a metre to the equator";
    rivals.race("port-sphere", title, ERROR, effort)
}

/// With a map's closed form by the library's functions, by the shader's series and in doubles.
fn closed_forms<'a, E: Fn(&Vertex, &[f32; 4]) -> f64>(
    rivals: Rivals<'a, E>,
    library: impl Fn([f32; 3]) -> [f32; 4] + 'a,
    series: impl Fn([f32; 3]) -> [f32; 4] + 'a,
    double: impl Fn([f64; 3]) -> [f64; 4] + 'a,
) -> Rivals<'a, E> {
    rivals
        .with("closed form, library, f32", "", move |v| library(v.at))
        .with("closed form, series, f32", SHADER, move |v| series(v.at))
        .with("closed form, f64, then rounded", PROCESSOR, move |v| {
            cast(double(wide(v.at)))
        })
}

/// The raised map in both precisions.
fn raised_maps() -> (RaisedMap<f32>, RaisedMap<f64>) {
    let double = RaisedMap::<f64>::new(RADIUS_M, OFFSET_M);
    let (k, radius_m) = (double.k as f32, RADIUS_M as f32);
    let curve = [
        k,
        double.offset as f32,
        double.sinh as f32,
        double.cosh as f32,
    ];
    let single = RaisedMap::from_uniform(curve, radius_m);
    // The curvature that single precision can write is the one all are judged by.
    let double = RaisedMap {
        k: f64::from(k),
        ..double
    };
    (single, double)
}

/// The textbook's port and boost, in radii, brought to metres.
fn raised_textbook(map: &RaisedMap<f32>, at: [f32; 3]) -> [f32; 4] {
    let x = naive::port_then_boost(map.offset, Vec3::from(at) * map.k);
    (x.truncate() * map.radius_m).extend(x.w).to_array()
}

fn frames(
    middles: &[[f64; 3]],
    map: impl Fn([f64; 3]) -> [f64; 4] + Copy,
    sign: f64,
    k: f64,
) -> (Vec<Columns>, Vec<Columns>) {
    let affine: Vec<_> = middles.iter().map(|m| affine(map, *m)).collect();
    let rigid = affine.iter().map(|frame| rigid(frame, sign, k)).collect();
    let rounded = affine.iter().map(|frame| frame.map(cast)).collect();
    (rounded, rigid)
}

/// With one frame an object, of both kinds.
fn framed<E: Fn(&Vertex, &[f32; 4]) -> f64>(
    rivals: Rivals<'_, E>,
    (affine, rigid): (Vec<Columns>, Vec<Columns>),
) -> Rivals<'_, E> {
    let differential = "one frame an object, the map's differential";
    rivals
        .with(differential, "", move |v| by_frame(&affine, v))
        .with("one rigid frame an object", "", move |v| {
            by_frame(&rigid, v)
        })
}

fn by_frame(frames: &[Columns], v: &Vertex) -> [f32; 4] {
    let [x, y, z] = v.within;
    library::seen(&frames[v.object], [x, y, z, 1.0])
}
