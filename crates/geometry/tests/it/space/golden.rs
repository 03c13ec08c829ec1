//! Whole spaces against `tests/reference/strategies.json`, made in 80 digits by another route.

use std::sync::Arc;

use antipode_geometry::{
    ChartId, ChartPoint, Eye, Geometry, HyperbolicMap, Projection, Strategy, picture,
};
use glam::{DVec3, DVec4};
use serde::{Deserialize, Deserializer};

#[derive(Deserialize)]
struct File {
    data: Golden,
}

#[derive(Deserialize)]
struct Golden {
    projection: Camera,
    ports: Vec<Port>,
    pairs: Vec<Pair>,
}

#[derive(Deserialize)]
struct Camera {
    fov_y: f64,
    aspect: f64,
    near: f64,
}

/// A point as the tables have it.
#[derive(Deserialize)]
struct Point {
    hemisphere: char,
    pos: DVec3,
}

impl From<Point> for ChartPoint {
    fn from(row: Point) -> Self {
        let chart = match row.hemisphere {
            'B' => ChartId::SECOND,
            _ => ChartId::FIRST,
        };
        Self::new(chart, row.pos)
    }
}

fn point<'a, D: Deserializer<'a>>(from: D) -> Result<ChartPoint, D::Error> {
    Point::deserialize(from).map(ChartPoint::from)
}

#[derive(Deserialize)]
struct EyeRow {
    hemisphere: char,
    pos: DVec3,
    dial: f64,
    lift: f64,
    yaw: f64,
    pitch: f64,
}

#[derive(Deserialize)]
struct Port {
    geometry: Geometry,
    level: bool,
    radius: f64,
    eye: EyeRow,
    #[serde(deserialize_with = "point")]
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
    level: bool,
    radius: f64,
    eye: EyeRow,
    #[serde(deserialize_with = "point")]
    a: ChartPoint,
    #[serde(deserialize_with = "point")]
    b: ChartPoint,
    distance: f64,
}

impl EyeRow {
    fn eye(&self) -> Eye {
        Eye {
            point: Point {
                hemisphere: self.hemisphere,
                pos: self.pos,
            }
            .into(),
            yaw: self.yaw,
            pitch: self.pitch,
            roll: 0.0,
            dial: self.dial,
            lift_m: self.lift,
        }
    }
}

fn golden() -> Golden {
    let text = include_str!("../../../../../tests/reference/strategies.json");
    serde_json::from_str::<File>(text).unwrap().data
}

/// The horizon map and the bend where `level`, else the geometry's own map.
fn space(geometry: Geometry, level: bool, radius_m: f64) -> Arc<dyn Strategy> {
    let map = if level {
        HyperbolicMap::Horizon
    } else {
        HyperbolicMap::Raised
    };
    picture(geometry, radius_m, map, level)
}

/// The same for the horizon map and the bend, whose radius is 80 m over the dial: positions are
/// exact, and what is rounded is the step from the eye, times the map's growth.
fn level_slack(dial: f64, pos: DVec3, eye: DVec3) -> f64 {
    // Out along the sheet, then up: the chart's coordinates multiply.
    let u = pos - eye;
    let step = u.x.hypot(u.z) + u.y.abs() + 2.0;
    let d = step * dial.abs() / 80.0;
    4e-15
        * step
        * d.max(4.0)
        * if dial > 0.0 {
            (d.sinh() / d).max(1.0)
        } else {
            1.0
        }
}

/// The rounding that the inputs themselves carry: an f64 position times the port's growth.
fn slack(geometry: Geometry, radius_m: f64, pos: DVec3, eye: DVec3) -> f64 {
    let input = 1e-15 * (pos.length() + eye.length());
    match geometry {
        Geometry::Hyperbolic | Geometry::HyperbolicWorld => {
            let d = ((pos - eye).length() + 20.0) / radius_m;
            (input + 1e-15 * radius_m) * d.sinh().max(1.0) * d.max(4.0)
        }
        Geometry::Euclidean => 4.0 * input,
        Geometry::Spherical => 1e-14 * radius_m,
    }
}

#[test]
fn ported_points_match() {
    for row in golden().ports {
        let (space, eye) = (space(row.geometry, row.level, row.radius), row.eye.eye());
        let view = space.view_point(&eye, row.point);
        let slack = if row.level {
            level_slack(eye.dial, row.point.pos, eye.point.pos)
        } else {
            slack(row.geometry, row.radius, row.point.pos, eye.point.pos)
        };
        let error = (view - row.view).length();
        let at = (row.geometry, row.radius, row.distance, eye.dial);
        assert!(error < slack, "{at:?}: {error:e} over {slack:e}");
        let back = space.chart_point(&eye, row.view);
        let place = space.view_point(&eye, back);
        assert!((place - row.view).length() < 2.0 * slack, "{at:?}");
        assert_eq!(space.viewer(&eye)(row.point), view, "{at:?}");
    }
}

#[test]
fn directions_match_to_a_ten_billionth() {
    // However large the coordinates grow, the angle at which a point is seen must hold.
    for row in golden().ports.iter().filter(|row| row.distance > 1e-4) {
        let (space, eye) = (space(row.geometry, row.level, row.radius), row.eye.eye());
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
        let (space, eye) = (space(row.geometry, row.level, row.radius), row.eye.eye());
        let slack = if row.level {
            level_slack(eye.dial, row.point.pos, eye.point.pos)
        } else {
            slack(row.geometry, row.radius, row.point.pos, eye.point.pos)
        };
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
        let (space, eye) = (space(row.geometry, row.level, row.radius), row.eye.eye());
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
        let (space, eye) = (space(row.geometry, row.level, row.radius), row.eye.eye());
        let normal = space.port_normal(&eye, row.point, row.normal);
        let error = (normal - row.frame_normal).length();
        assert!(
            error < 4e-12,
            "{:?} {}: {error:e}",
            row.geometry,
            row.distance
        );
    }
}
