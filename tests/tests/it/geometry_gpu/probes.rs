//! Cases for the shader and their exact answers.

use std::sync::Arc;

use antipode_geometry::{
    ChartId, ChartPoint, Eye, Geometry, HyperbolicMap, Projection, SpaceUniform, Strategy, picture,
    scalar, strategy,
};
use antipode_lab::compute;
use bytemuck::{Pod, Zeroable};
use glam::{DVec3, DVec4, Vec3};
use serde_json::Value;

/// What the port shader is given.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub struct Case {
    pub space: SpaceUniform,
    pub p: Vec3,
    /// The place of its map among [`antipode_geometry::shader::MAPS`].
    pub map: u32,
    pub n: Vec3,
    pub pad: u32,
}

/// A case, what it should give in exact arithmetic, and where it came from.
pub struct Probe {
    pub space: Arc<dyn Strategy>,
    pub case: Case,
    pub view: DVec4,
    pub clip: DVec4,
    pub normal: DVec3,
    pub distance: f64,
}

impl Probe {
    /// What a rounding of the inputs is multiplied by in the normal, inverted. Far off in
    /// hyperbolic space, the part of a normal across the ray shrinks by sinh d / d, so that a
    /// normal nearly across it turns by that much more than its inputs do.
    pub fn normal_condition(&self) -> f64 {
        if self.space.geometry() != Geometry::Hyperbolic {
            return 1.0;
        }
        let space = &self.case.space;
        let q =
            self.case.p.as_dvec3() * f64::from(space.k_per_m) + DVec3::Y * f64::from(space.lift);
        let along = self.case.n.as_dvec3().dot(q.normalize_or_zero());
        along.hypot(1.0 / scalar::sinhc(q.length()))
    }
}

fn vec3(value: &Value) -> DVec3 {
    let at = |i: usize| value[i].as_f64().unwrap();
    DVec3::new(at(0), at(1), at(2))
}

fn vec4(value: &Value) -> DVec4 {
    vec3(value).extend(value[3].as_f64().unwrap())
}

fn chart_point(value: &Value) -> ChartPoint {
    let b = value["hemisphere"].as_str() == Some("B");
    ChartPoint::new(
        if b { ChartId::SECOND } else { ChartId::FIRST },
        vec3(&value["pos"]),
    )
}

fn eye(value: &Value) -> Eye {
    let number = |name: &str| value[name].as_f64().unwrap();
    Eye {
        point: chart_point(value),
        yaw: number("yaw"),
        pitch: number("pitch"),
        roll: 0.0,
        dial: number("dial"),
        lift_m: number("lift"),
    }
}

/// A case as a renderer would send it: relative to the reference, cast once.
pub fn case(
    space: &dyn Strategy,
    eye: &Eye,
    projection: &Projection,
    point: ChartPoint,
    n: DVec3,
) -> Case {
    let reference = space.reference(eye, point.chart);
    Case {
        space: SpaceUniform {
            view: space
                .chart_matrix(eye, point.chart)
                .as_mat4()
                .to_cols_array_2d(),
            ..space.uniform(eye, projection)
        },
        p: (point.pos - reference).as_vec3(),
        map: compute::number_of(space.shader()),
        n: n.as_vec3(),
        pad: 0,
    }
}

/// The committed cases with their 80-digit answers.
pub fn golden() -> Vec<Probe> {
    let text = include_str!("../../../reference/strategies.json");
    let file: Value = serde_json::from_str(text).unwrap();
    let golden = &file["data"];
    let camera = |name: &str| golden["projection"][name].as_f64().unwrap();
    let projection = Projection::new(camera("fov_y"), camera("aspect"), camera("near"));
    let rows = golden["ports"].as_array().unwrap();
    rows.iter()
        .map(|row| {
            let geometry: Geometry = row["geometry"].as_str().unwrap().parse().unwrap();
            let level = row["level"].as_bool().unwrap();
            let map = if level {
                HyperbolicMap::Horizon
            } else {
                HyperbolicMap::Raised
            };
            let space = picture(geometry, row["radius"].as_f64().unwrap(), map, level);
            let (eye, point) = (eye(&row["eye"]), chart_point(&row["point"]));
            Probe {
                case: case(
                    space.as_ref(),
                    &eye,
                    &projection,
                    point,
                    vec3(&row["normal"]),
                ),
                view: vec4(&row["view"]),
                clip: vec4(&row["clip"]),
                normal: vec3(&row["frame_normal"]),
                distance: row["distance"].as_f64().unwrap(),
                space,
            }
        })
        .collect()
}

/// A small generator: the same numbers on every run.
pub struct Numbers(pub u64);

impl Numbers {
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }

    pub fn direction(&mut self) -> DVec3 {
        loop {
            let v = DVec3::from_array([0; 3].map(|_| self.between(-1.0, 1.0)));
            if (0.1..1.0).contains(&v.length()) {
                return v.normalize();
            }
        }
    }

    pub fn eye(&mut self, pos: DVec3) -> Eye {
        Eye {
            point: ChartPoint::a(pos),
            yaw: self.between(-3.0, 3.0),
            pitch: self.between(-1.5, 1.5),
            roll: 0.0,
            dial: self.between(0.0, 20.0),
            lift_m: 1.62,
        }
    }
}

/// Many cases with answers from the f64 port at the f32 inputs.
pub fn dense(count: u32) -> Vec<Probe> {
    let mut rng = Numbers(7);
    let projection = Projection::new(1.2, 1.6, 0.05);
    let mut probes = Vec::new();
    for i in 0..count {
        let geometry = Geometry::ALL[(i % 3) as usize];
        let space = strategy(geometry, if i % 2 == 0 { 20.0 } else { 48.0 });
        let r = space.radius_m();
        let (eye, point) = if geometry == Geometry::Spherical {
            let spot = |rng: &mut Numbers| {
                let (angle, level) = (rng.between(-3.2, 3.2), rng.between(0.0, 1.7) * r);
                let height = rng.between(0.1, 1.2) * r;
                DVec3::new(level * angle.cos(), height, level * angle.sin())
            };
            let (at, to) = (spot(&mut rng), spot(&mut rng));
            let b = if i % 4 < 2 {
                ChartId::SECOND
            } else {
                ChartId::FIRST
            };
            (rng.eye(at), ChartPoint::new(b, to.as_vec3().as_dvec3()))
        } else {
            let eye = rng.eye(DVec3::ZERO);
            let distance = 10.0_f64.powf(rng.between(-3.0, 2.5));
            (
                eye,
                ChartPoint::a((rng.direction() * distance).as_vec3().as_dvec3()),
            )
        };
        let normal = rng.direction().as_vec3().as_dvec3();
        let view = space.view_point(&eye, point);
        probes.push(Probe {
            case: case(space.as_ref(), &eye, &projection, point, normal),
            view,
            clip: space.clip_from_view(&eye, &projection, view),
            normal: space.port_normal(&eye, point, normal),
            distance: space.eye_distance_m(&eye, view),
            space,
        });
    }
    probes
}
