//! Where the camera's position is taken off: before the port, in the flat chart, or after it, by a view matrix on
//! hyperboloid coordinates, which grow with the distance walked.

use antipode_geometry::charts::{exponential, exponential_direction};
use antipode_geometry::kernel::exponential::point;
use glam::{DMat4, DVec3, DVec4, Mat4, Vec3, Vec4};

use crate::random::Numbers;
use crate::speed::pareto::{Contest, Group};
use crate::speed::port::{BATCH, angle};
use crate::{Effort, Plot, Scale, Series};

/// How far the camera of the timed group is from the origin, in radii.
const WALKED: f64 = 5.0;
/// How far vertices are from the camera, in radii.
const NEAR: f64 = 0.05;
const FAR: f64 = 2.0;
/// Distances walked of the plot, in radii.
const WALKS: [f64; 12] = [0.01, 0.1, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0];

/// A vertex as the rivals keep it.
#[derive(Clone, Copy, Debug)]
struct Vertex {
    /// On the hyperboloid, about the world's origin.
    absolute: DVec4,
    rounded: Vec4,
    /// The chunk's corner from the camera and the vertex from the corner, radii.
    corner: Vec3,
    local: Vec3,
    /// Where it is seen, exactly.
    seen: DVec3,
}

struct Walk {
    view: DMat4,
    vertices: Vec<Vertex>,
}

/// A camera `walked` radii from the origin and vertices around it.
fn walk(walked: f64) -> Walk {
    let mut numbers = Numbers::new(41);
    let place = DVec3::new(0.6, 0.0, 0.8) * walked;
    let eye = exponential(-1.0, place);
    let axes = [DVec3::X, DVec3::Y, DVec3::Z].map(|v| exponential_direction(-1.0, place, v));
    let row = |v: DVec4| DVec4::new(v.x, v.y, v.z, -v.w);
    let last = DVec4::new(-eye.x, -eye.y, -eye.z, eye.w);
    let view = DMat4::from_cols(row(axes[0]), row(axes[1]), row(axes[2]), last).transpose();
    let vertices = (0..BATCH)
        .map(|_| {
            let seen = numbers.direction();
            let away = numbers.magnitude(NEAR, FAR);
            let local = (DVec3::splat(0.8) + numbers.direction() * 0.4).as_vec3();
            let corner = (seen * away - local.as_dvec3()).as_vec3();
            // What the two rounded parts add up to: rounding a position is no error of the view.
            let seen = corner.as_dvec3() + local.as_dvec3();
            let away = seen.length();
            let direction = (axes[0] * seen.x + axes[1] * seen.y + axes[2] * seen.z) / away;
            let absolute = eye * away.cosh() + direction * away.sinh();
            Vertex {
                absolute,
                rounded: absolute.as_vec4(),
                corner,
                local,
                seen,
            }
        })
        .collect();
    Walk { view, vertices }
}

fn error(vertex: &Vertex, got: &[f64; 3]) -> f64 {
    angle(*got, vertex.seen.to_array())
}

fn absolute_f32(view: &Mat4, v: &Vertex) -> [f64; 3] {
    (*view * v.rounded).truncate().as_dvec3().to_array()
}

fn relative_f32(v: &Vertex) -> [f64; 3] {
    let [x, y, z, _] = point(-1.0, (v.corner + v.local).to_array());
    [x, y, z].map(f64::from)
}

/// Times at five radii from the origin.
pub fn group(effort: Effort) -> Group {
    let Walk { view, vertices } = walk(WALKED);
    let rounded = view.as_mat4();
    let ported = |v: &Vertex| {
        // The port that the absolute rival needs as well, about the origin.
        let [x, y, z, w] = point(-1.0, (v.corner + v.local).to_array());
        std::hint::black_box([x, y, z, w]);
        absolute_f32(&rounded, v)
    };
    let rivals = Contest::new(&vertices, error)
        .with("hyperboloid coordinates kept, view matrix, f32", "", |v| {
            absolute_f32(&rounded, v)
        })
        .with("port about the origin, then view matrix, f32", "", ported)
        .with("hyperboloid coordinates kept, view matrix, f64", "", |v| {
            (view * v.absolute).truncate().to_array()
        })
        .with(
            "camera taken off first, then port, f32",
            "shaders",
            relative_f32,
        )
        .with("camera taken off first, then port, f64", "processor", |v| {
            let p = v.corner.as_dvec3() + v.local.as_dvec3();
            let [x, y, z, _] = point(-1.0, p.to_array());
            [x, y, z]
        });
    let title = "View of one vertex by a camera 5 radii from the origin of hyperbolic space";
    rivals.race("view", title, ("worst angle at the eye", "rad"), effort)
}

/// Worst angles by the distance walked.
pub fn by_distance() -> Plot {
    let mut curves = [Vec::new(), Vec::new(), Vec::new()];
    for walked in WALKS {
        let Walk { view, vertices } = walk(walked);
        let rounded = view.as_mat4();
        let worst = |see: &dyn Fn(&Vertex) -> [f64; 3]| {
            vertices
                .iter()
                .map(|v| error(v, &see(v)))
                .fold(0.0, f64::max)
        };
        curves[0].push((walked, worst(&|v| absolute_f32(&rounded, v))));
        curves[1].push((
            walked,
            worst(&|v| (view * v.absolute).truncate().to_array()),
        ));
        curves[2].push((walked, worst(&relative_f32)));
    }
    let names = [
        "hyperboloid coordinates, f32",
        "hyperboloid coordinates, f64",
        "camera taken off first, f32 (the game)",
    ];
    Plot::new(
        "speed-view-walked",
        "Error of the picture by the distance walked from the origin",
        Scale::Logarithmic.axes("distance walked, radii", "worst angle at the eye, rad"),
        names
            .into_iter()
            .zip(curves)
            .map(|(name, points)| Series::line(name, points)),
    )
}
