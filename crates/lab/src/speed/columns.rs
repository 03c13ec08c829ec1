//! One matrix for a whole object instead of a port for each of its vertices: the map's differential at the
//! object's middle, or the rigid frame made of it; and how wrong they are by the object's size and distance.

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::speed::library::seen;
use antipode_geometry::kernel::horizon::HorizonMap;
use antipode_geometry::kernel::raised::RaisedMap;
use antipode_geometry::kernel::sphere;

use crate::random::Numbers;
use crate::speed::port::angle;
use crate::{Cell, Plot, Scale, Series, Table};

/// Columns applied to (x, y, z, 1), metres from the object's middle: three directions and the middle.
pub type Columns<T = f32> = [[T; 4]; 4];
/// Half the step of the central differences, metres: rounding and curvature both leave 1e-10.
const STEP_M: f64 = 1e-3;
/// Height of the picture that pixels are counted in, and its field of view, radians.
const PIXELS: (f64, f64) = (720.0, 75.0 * std::f64::consts::PI / 180.0);
/// Edges of objects and distances of the table, metres.
const EDGES_M: [f64; 6] = [0.25, 1.0, 2.0, 4.0, 8.0, 32.0];
const DISTANCES_M: [f64; 6] = [3.0, 10.0, 20.0, 40.0, 80.0, 160.0];

/// The differential of `map` at `middle`: true to first order in the object's size.
pub fn affine(map: impl Fn([f64; 3]) -> [f64; 4], middle: [f64; 3]) -> Columns<f64> {
    let column = |axis: usize| {
        let at = |step: f64| {
            let mut p = middle;
            p[axis] += step;
            map(p)
        };
        let (ahead, behind) = (at(STEP_M), at(-STEP_M));
        [0, 1, 2, 3].map(|i| (ahead[i] - behind[i]) / (2.0 * STEP_M))
    };
    [column(0), column(1), column(2), map(middle)]
}

/// The frame with its directions made orthonormal, upright first: the object keeps its own shape. `k` is the
/// curvature per metre.
pub fn rigid(frame: &Columns<f64>, sign: f64, k: f64) -> Columns {
    let inner = |a: [f64; 4], b: [f64; 4]| {
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + sign * a[3] * b[3] / (k * k)
    };
    let mut own = *frame;
    let order = [1, 0, 2];
    for (done, &axis) in order.iter().enumerate() {
        for &earlier in &order[..done] {
            let share = inner(own[axis], own[earlier]);
            own[axis] = [0, 1, 2, 3].map(|i| own[axis][i] - share * own[earlier][i]);
        }
        let length = inner(own[axis], own[axis]).sqrt();
        own[axis] = own[axis].map(|x| x / length);
    }
    own.map(|column| column.map(|x| x as f32))
}

/// Worst errors, in pixels, of both kinds of frame over objects of some size and distance in one map.
fn worst_px(
    map: impl Fn([f64; 3]) -> [f64; 4],
    sign: f64,
    k: f64,
    edge_m: f64,
    away_m: f64,
) -> [f64; 2] {
    let mut numbers = Numbers::new(11);
    let pixel = 2.0 * (0.5 * PIXELS.1).tan() / PIXELS.0;
    let mut worst = [0.0_f64; 2];
    for _ in 0..60 {
        let turn = numbers.between(0.0, TAU);
        let middle = [
            away_m * turn.cos(),
            numbers.between(-3.0, 3.0),
            away_m * turn.sin(),
        ];
        let exact = affine(&map, middle);
        let rounded = exact.map(|c| c.map(|x| x as f32));
        let frames = [rounded, rigid(&exact, sign, k)];
        for corner in 0..8 {
            let within = [0, 1, 2].map(|i| {
                if corner >> i & 1 == 1 {
                    0.5 * edge_m
                } else {
                    -0.5 * edge_m
                }
            });
            let [x, y, z, _] = map([0, 1, 2].map(|i| middle[i] + within[i]));
            for (worst, frame) in worst.iter_mut().zip(&frames) {
                let wide = frame.map(|column| column.map(f64::from));
                let [a, b, c, _] = seen(&wide, [within[0], within[1], within[2], 1.0]);
                let px = angle([a, b, c], [x, y, z]) / pixel;
                *worst = if px > *worst || px.is_nan() {
                    px
                } else {
                    *worst
                };
            }
        }
    }
    worst
}

/// Map's name, the map, curvature's sign and size, and the farthest distance it is asked for.
type Map<'a> = (&'a str, Box<dyn Fn([f64; 3]) -> [f64; 4]>, f64, f64, f64);

fn maps() -> Vec<Map<'static>> {
    let raised = RaisedMap::<f64>::new(20.0, 10.0);
    let k: f64 = 0.125;
    let horizon = HorizonMap::<f64>::new(-k * k, 1.65);
    let radius_m = 32.0;
    // The eye 11 m over the pole, looking level: X, height and Z turn over into view coordinates.
    let (sin, cos) = (11.0_f64 / radius_m).sin_cos();
    let columns = [
        [1.0, 0.0, 0.0, 0.0],
        [0.0, cos, 0.0, sin / radius_m],
        [0.0, 0.0, 1.0, 0.0],
        [0.0, -sin * radius_m, 0.0, cos],
    ];
    vec![
        (
            "raised",
            Box::new(move |p| raised.port(p)),
            -1.0,
            0.05,
            f64::INFINITY,
        ),
        (
            "horizon",
            Box::new(move |p| horizon.port(p)),
            -1.0,
            k,
            f64::INFINITY,
        ),
        (
            "sphere",
            Box::new(move |[x, y, z]| {
                seen(
                    &columns,
                    sphere::port(1.0 / radius_m, false, [x, y + 11.0, z]),
                )
            }),
            1.0,
            1.0 / radius_m,
            FRAC_PI_2 * radius_m,
        ),
    ]
}

/// The figure, or nothing where doubles cannot tell: 20 radii off, the frame's lengths are below their last place.
fn known(px: f64) -> Cell {
    if px.is_finite() {
        Cell::figure(px, "px")
    } else {
        Cell::Empty
    }
}

/// A row for each map, size and distance, and the curves of the differential's error.
pub fn by_size() -> (Table, Plot) {
    let mut rows = Vec::new();
    let mut series = Vec::new();
    for (name, map, sign, k, farthest_m) in maps() {
        for edge_m in EDGES_M {
            let mut curve = Vec::new();
            for away_m in DISTANCES_M
                .into_iter()
                .filter(|d| *d > edge_m && *d <= farthest_m)
            {
                let [affine_px, rigid_px] = worst_px(&map, sign, k, edge_m, away_m);
                curve.push((away_m, affine_px));
                rows.push(vec![
                    Cell::text(name),
                    Cell::figure(edge_m, "m"),
                    Cell::figure(away_m, "m"),
                    Cell::figure(affine_px, "px"),
                    known(rigid_px),
                    Cell::Text(if affine_px < 0.5 { "yes" } else { "no" }.to_owned()),
                ]);
            }
            series.push(Series::line(format!("{name}, {edge_m} m"), curve));
        }
    }
    let columns = [
        "map",
        "edge",
        "distance",
        "differential",
        "rigid frame",
        "differential within half a pixel",
    ];
    let table = Table::new(
        "One frame for an object instead of a port for each vertex: worst error on a picture 720 pixels high",
        columns,
        rows,
    );
    let plot = Plot::new(
        "speed-frames",
        "Error of the map's differential by distance, for objects of several sizes",
        Scale::Logarithmic.axes("distance, m", "error, px"),
        series,
    );
    (table, plot)
}
