//! Against `tests/reference/geometry.json`, made in 80-digit arithmetic by another route.

use antipode_geometry::{ChartPoint, Eye, Geometry, Hemisphere, Projection, scalar, strategy};
use glam::{DVec3, DVec4};
use serde::Deserialize;

#[derive(Deserialize)]
struct Golden {
    projection: Camera,
    scalars: Vec<Scalars>,
    ports: Vec<Port>,
    pairs: Vec<Pair>,
}

#[derive(Deserialize)]
struct Camera {
    fov_y: f64,
    aspect: f64,
    near: f64,
}

#[derive(Deserialize)]
struct Scalars {
    t: f64,
    sinc: f64,
    sinhc: f64,
    cos_bend: f64,
    cosh_bend: f64,
    sinc_bend: f64,
    sinhc_bend: f64,
}

#[derive(Deserialize)]
struct EyeRow {
    hemisphere: Hemisphere,
    pos: DVec3,
    dial: f64,
    yaw: f64,
    pitch: f64,
}

#[derive(Deserialize)]
struct Port {
    geometry: Geometry,
    radius: f64,
    eye: EyeRow,
    point: ChartPoint,
    normal: DVec3,
    view: DVec4,
    distance: f64,
    clip: DVec4,
    frame_normal: DVec3,
}

#[derive(Deserialize)]
struct Pair {
    geometry: Geometry,
    radius: f64,
    eye: EyeRow,
    a: ChartPoint,
    b: ChartPoint,
    distance: f64,
}

impl EyeRow {
    fn eye(&self) -> Eye {
        Eye {
            point: ChartPoint::new(self.hemisphere, self.pos),
            yaw: self.yaw,
            pitch: self.pitch,
            dial: self.dial,
            lift_m: 1.62,
        }
    }
}

fn golden() -> Golden {
    serde_json::from_str(include_str!("../../../../tests/reference/geometry.json")).unwrap()
}

/// The rounding that the inputs themselves carry: an f64 position times the port's growth.
fn slack(geometry: Geometry, radius_m: f64, pos: DVec3, eye: DVec3) -> f64 {
    let input = 1e-15 * (pos.length() + eye.length());
    match geometry {
        Geometry::Hyperbolic => {
            let d = ((pos - eye).length() + 20.0) / radius_m;
            (input + 1e-15 * radius_m) * d.sinh().max(1.0) * d.max(4.0)
        }
        Geometry::Euclidean => 4.0 * input,
        Geometry::Spherical => 1e-14 * radius_m,
    }
}

#[test]
fn scalars_match_to_the_last_digits() {
    for row in golden().scalars {
        let t = row.t;
        let pairs = [
            (scalar::sinc(t), row.sinc),
            (scalar::sinhc(t), row.sinhc),
            (scalar::cos_minus_one_over_square(1.0, t), row.cos_bend),
            (scalar::cos_minus_one_over_square(-1.0, t), row.cosh_bend),
            (scalar::sinc_minus_one_over_square(1.0, t), row.sinc_bend),
            (scalar::sinc_minus_one_over_square(-1.0, t), row.sinhc_bend),
        ];
        for (i, (ours, exact)) in pairs.into_iter().enumerate() {
            let error = (ours / exact - 1.0).abs();
            assert!(error < 4e-15 * t.max(1.0), "{i} at {t}: {error:e}");
        }
    }
}

#[test]
fn ported_points_match() {
    for row in golden().ports {
        let (space, eye) = (strategy(row.geometry, row.radius), row.eye.eye());
        let view = space.view_point(&eye, row.point);
        let slack = slack(row.geometry, row.radius, row.point.pos, eye.point.pos);
        let error = (view - row.view).length();
        let at = (row.geometry, row.radius, row.distance, eye.dial);
        assert!(error < slack, "{at:?}: {error:e} over {slack:e}");
        let back = space.chart_point(&eye, row.view);
        let place = space.view_point(&eye, back);
        assert!((place - row.view).length() < 2.0 * slack, "{at:?}");
    }
}

#[test]
fn directions_match_to_a_ten_billionth() {
    // However large the coordinates grow, the angle at which a point is seen must hold.
    for row in golden().ports.iter().filter(|row| row.distance > 1e-4) {
        let (space, eye) = (strategy(row.geometry, row.radius), row.eye.eye());
        let view = space.view_point(&eye, row.point).truncate().normalize();
        let error = (view - row.view.truncate().normalize()).length();
        assert!(
            error < 1e-10,
            "{:?} {}: {error:e}",
            row.geometry,
            row.distance
        );
    }
}

#[test]
fn eye_distances_and_clip_coordinates_match() {
    let golden = golden();
    let camera = &golden.projection;
    let projection = Projection::new(camera.fov_y, camera.aspect, camera.near);
    for row in golden.ports {
        let (space, eye) = (strategy(row.geometry, row.radius), row.eye.eye());
        let slack = slack(row.geometry, row.radius, row.point.pos, eye.point.pos);
        let view = space.view_point(&eye, row.point);
        let distance = space.eye_distance_m(&eye, view);
        let error = (distance - row.distance).abs();
        let input = 1e-14 * (row.radius + eye.point.pos.length() + row.distance);
        assert!(
            error < input,
            "{:?} {}: {error:e}",
            row.geometry,
            row.distance
        );
        let clip = space.clip_from_view(&eye, &projection, view);
        assert!((clip - row.clip).length() < 4.0 * slack);
        assert!((clip.z / row.clip.z - 1.0).abs() < 1e-10 || (clip.z - row.clip.z).abs() < slack);
    }
}

#[test]
fn distances_between_points_match() {
    for row in golden().pairs {
        let (space, eye) = (strategy(row.geometry, row.radius), row.eye.eye());
        let distance = space.distance_m(row.a, row.b, &eye);
        let slack = slack(row.geometry, row.radius, row.a.pos, eye.point.pos);
        // Two points far off and close together part by exp(d): their inputs limit the answer.
        let error = (distance - row.distance).abs();
        let relative = 1e-11 * row.distance;
        assert!(
            error < slack + relative,
            "{:?} {}: {error:e}",
            row.geometry,
            row.distance
        );
    }
}

#[test]
fn normals_match_the_inverse_transpose() {
    for row in golden().ports {
        let (space, eye) = (strategy(row.geometry, row.radius), row.eye.eye());
        let normal = space.port_normal(&eye, row.point, row.normal);
        let error = (normal - row.frame_normal).length();
        assert!(
            error < 1e-12,
            "{:?} {}: {error:e}",
            row.geometry,
            row.distance
        );
    }
}
