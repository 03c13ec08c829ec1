//! `shaders/geometry.wgsl` on a real adapter, against 80-digit numbers and the f64 port.
//!
//! Without an adapter the test says so and passes, unless `ANTIPODE_REQUIRE_GPU=1`.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::print_stderr,
    reason = "tests fail by panicking, and say which adapter they ran on"
)]

use std::sync::LazyLock;

use antipode_geometry::{
    ChartPoint, Eye, FAR_LIMIT_RADII, Geometry, Hemisphere, Projection, SpaceUniform, Strategy,
    WGSL, strategy,
};
use bytemuck::{Pod, Zeroable};
use glam::{DVec3, DVec4, Vec3, Vec4, Vec4Swizzles};
use serde_json::Value;

/// Runs each of the four functions once per case.
const PORT_SHADER: &str = "
struct Case { space: Space, p: vec3<f32>, hemisphere: u32, n: vec3<f32>, pad: u32 }
struct Answer { view: vec4<f32>, clip: vec4<f32>, normal: vec3<f32>, distance: f32 }
@group(0) @binding(0) var<storage, read> cases: array<Case>;
@group(0) @binding(1) var<storage, read_write> answers: array<Answer>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x;
    if i >= arrayLength(&cases) { return; }
    let space = cases[i].space;
    let view = port_to_view(space, cases[i].p, cases[i].hemisphere);
    answers[i].view = view;
    answers[i].clip = clip_from_view(space, view);
    answers[i].normal = port_normal(space, cases[i].p, cases[i].n, cases[i].hemisphere);
    answers[i].distance = eye_distance(space, view);
}";

/// Runs the shader's own trigonometry.
const SCALAR_SHADER: &str = "
struct Row { trig: vec2<f32>, hyper: vec2<f32>, angle: f32, asinh: f32, bends: vec2<f32> }
@group(0) @binding(0) var<storage, read> ts: array<f32>;
@group(0) @binding(1) var<storage, read_write> rows: array<Row>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x;
    if i >= arrayLength(&ts) { return; }
    let t = ts[i];
    rows[i].trig = geo_sinc_cos(t * t);
    rows[i].hyper = geo_sinhc_cosh(t);
    rows[i].angle = geo_angle(t, 1.0);
    rows[i].asinh = geo_asinh(t);
    rows[i].bends = vec2<f32>(geo_sinc_bend(t * t, -1.0), geo_sinc_bend(t * t, 1.0));
}";

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Case {
    space: SpaceUniform,
    p: Vec3,
    hemisphere: u32,
    n: Vec3,
    pad: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Answer {
    view: Vec4,
    clip: Vec4,
    normal: Vec3,
    distance: f32,
}

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Row {
    trig: [f32; 2],
    hyper: [f32; 2],
    angle: f32,
    asinh: f32,
    bends: [f32; 2],
}

struct Gpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
}

/// One device for every test of this file: they share a process.
static GPU: LazyLock<Option<Gpu>> = LazyLock::new(|| {
    let gpu = open();
    if gpu.is_none() {
        let required = std::env::var("ANTIPODE_REQUIRE_GPU").is_ok_and(|v| v == "1");
        assert!(!required, "ANTIPODE_REQUIRE_GPU=1, and no adapter computes");
        eprintln!("SKIPPED: no adapter; the shader's numbers were NOT checked");
    }
    gpu
});

fn open() -> Option<Gpu> {
    let instance =
        wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
    let adapter =
        pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))
            .ok()?;
    eprintln!("adapter: {}", adapter.get_info().name);
    let wanted = wgpu::DeviceDescriptor {
        required_limits: adapter.limits(),
        ..Default::default()
    };
    let (device, queue) = pollster::block_on(adapter.request_device(&wanted)).ok()?;
    Some(Gpu { device, queue })
}

impl Gpu {
    fn buffer(&self, size: u64, usage: wgpu::BufferUsages) -> wgpu::Buffer {
        self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size,
            usage,
            mapped_at_creation: false,
        })
    }

    fn pipeline(&self, shader: &str) -> wgpu::ComputePipeline {
        let source = format!("{WGSL}\n{shader}");
        let module = self
            .device
            .create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some("geometry"),
                source: wgpu::ShaderSource::Wgsl(source.into()),
            });
        self.device
            .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some("geometry"),
                layout: None,
                module: &module,
                entry_point: Some("main"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                cache: None,
            })
    }

    /// One `Out` for each `In`.
    fn compute<In: Pod, Out: Pod>(&self, shader: &str, input: &[In]) -> Vec<Out> {
        use wgpu::BufferUsages as Usage;
        let bytes: &[u8] = bytemuck::cast_slice(input);
        let size = (input.len() * size_of::<Out>()) as u64;
        let source = self.buffer(bytes.len() as u64, Usage::STORAGE | Usage::COPY_DST);
        self.queue.write_buffer(&source, 0, bytes);
        let target = self.buffer(size, Usage::STORAGE | Usage::COPY_SRC);
        let mapped = self.buffer(size, Usage::MAP_READ | Usage::COPY_DST);
        let pipeline = self.pipeline(shader);
        let group = self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &pipeline.get_bind_group_layout(0),
            entries: &[
                wgpu::BindGroupEntry {
                    binding: 0,
                    resource: source.as_entire_binding(),
                },
                wgpu::BindGroupEntry {
                    binding: 1,
                    resource: target.as_entire_binding(),
                },
            ],
        });
        let mut encoder = self
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(&pipeline);
            pass.set_bind_group(0, &group, &[]);
            pass.dispatch_workgroups((input.len() as u32).div_ceil(64), 1, 1);
        }
        encoder.copy_buffer_to_buffer(&target, 0, &mapped, 0, size);
        self.queue.submit([encoder.finish()]);
        mapped.map_async(wgpu::MapMode::Read, .., |result| result.unwrap());
        self.device
            .poll(wgpu::PollType::wait_indefinitely())
            .unwrap();
        let view = mapped.get_mapped_range(..).unwrap();
        bytemuck::pod_collect_to_vec(&view[..])
    }
}

/// A case, what it should give in exact arithmetic, and where it came from.
struct Probe {
    space: std::sync::Arc<dyn Strategy>,
    case: Case,
    view: DVec4,
    clip: DVec4,
    normal: DVec3,
    distance: f64,
}

impl Probe {
    /// What a rounding of the inputs is multiplied by in the normal, inverted. Far off in
    /// hyperbolic space, the part of a normal across the ray shrinks by sinh d / d, so that a
    /// normal nearly across it turns by that much more than its inputs do.
    fn normal_condition(&self) -> f64 {
        if self.space.geometry() != Geometry::Hyperbolic {
            return 1.0;
        }
        let curve = self.case.space.curve.map(f64::from);
        let q = self.case.p.as_dvec3() * curve[0] + DVec3::Y * curve[1];
        let along = self.case.n.as_dvec3().dot(q.normalize_or_zero());
        along.hypot(1.0 / antipode_geometry::scalar::sinhc(q.length()))
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
        if b { Hemisphere::B } else { Hemisphere::A },
        vec3(&value["pos"]),
    )
}

fn eye(value: &Value) -> Eye {
    let number = |name: &str| value[name].as_f64().unwrap();
    Eye {
        point: chart_point(value),
        yaw: number("yaw"),
        pitch: number("pitch"),
        dial: number("dial"),
    }
}

/// A case as a renderer would send it: relative to the reference, cast once.
fn case(
    space: &dyn Strategy,
    eye: &Eye,
    projection: &Projection,
    point: ChartPoint,
    n: DVec3,
) -> Case {
    let reference = space.reference(eye, point.hemisphere);
    Case {
        space: space.uniform(eye, projection),
        p: (point.pos - reference).as_vec3(),
        hemisphere: point.hemisphere.index(),
        n: n.as_vec3(),
        pad: 0,
    }
}

/// The committed cases with their 80-digit answers.
fn golden() -> Vec<Probe> {
    let text = include_str!("../reference/geometry.json");
    let golden: Value = serde_json::from_str(text).unwrap();
    let camera = |name: &str| golden["projection"][name].as_f64().unwrap();
    let projection = Projection::new(camera("fov_y"), camera("aspect"), camera("near"));
    let rows = golden["ports"].as_array().unwrap();
    rows.iter()
        .map(|row| {
            let geometry: Geometry = row["geometry"].as_str().unwrap().parse().unwrap();
            let space = strategy(geometry, row["radius"].as_f64().unwrap());
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
struct Numbers(u64);

impl Numbers {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }

    fn direction(&mut self) -> DVec3 {
        loop {
            let v = DVec3::from_array([0; 3].map(|_| self.between(-1.0, 1.0)));
            if (0.1..1.0).contains(&v.length()) {
                return v.normalize();
            }
        }
    }

    fn eye(&mut self, pos: DVec3) -> Eye {
        Eye {
            point: ChartPoint::a(pos),
            yaw: self.between(-3.0, 3.0),
            pitch: self.between(-1.5, 1.5),
            dial: self.between(0.0, 20.0),
        }
    }
}

/// Many cases with answers from the f64 port at the f32 inputs.
fn dense(count: u32) -> Vec<Probe> {
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
                Hemisphere::B
            } else {
                Hemisphere::A
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
            clip: space.clip_from_view(&projection, view),
            normal: space.port_normal(&eye, point, normal),
            distance: space.eye_distance_m(view),
            space,
        });
    }
    probes
}

/// The greatest errors of a run.
#[derive(Default, Debug)]
struct Worst {
    angle_rad: f64,
    distance: f64,
    depth: f64,
    normal_rad: f64,
}

/// Compares within the bounds that f32 inputs allow: the angle of sight everywhere, distances
/// relative to the distance, and on the sphere both relative to the radius.
fn compare(probes: &[Probe], answers: &[Answer]) -> [Worst; 3] {
    let mut worst = [Worst::default(), Worst::default(), Worst::default()];
    for (probe, answer) in probes.iter().zip(answers) {
        let geometry = probe.space.geometry();
        let ours = answer.view.as_dvec4();
        assert!(ours.is_finite() && answer.normal.is_finite() && answer.distance.is_finite());
        let worst = &mut worst[geometry as usize];
        let (a, b) = (ours.xyz(), probe.view.truncate());
        // A direction on the sphere has the error of the point, which is a part of the radius.
        let sphere = geometry == Geometry::Spherical;
        let scale = if sphere {
            probe.space.radius_m()
        } else {
            b.length()
        };
        let angle = if sphere {
            (a - b).length() / scale
        } else {
            (a.normalize() - b.normalize()).length()
        };
        worst.angle_rad = worst.angle_rad.max(angle);
        let span = if sphere { scale } else { probe.distance };
        let distance = (f64::from(answer.distance) - probe.distance).abs() / span;
        worst.distance = worst.distance.max(distance);
        let depth_scale = if sphere { scale } else { probe.clip.z };
        worst.depth = worst
            .depth
            .max((f64::from(answer.clip.z) - probe.clip.z).abs() / depth_scale);
        let normal = answer.normal.as_dvec3();
        assert!((normal.length() - 1.0).abs() < 1e-6);
        let turned = (normal - probe.normal).length() * probe.normal_condition();
        worst.normal_rad = worst.normal_rad.max(turned);
        let w = f64::from(answer.clip.w);
        assert_eq!(w, -ours.z, "clip w is the distance ahead");
    }
    worst
}

fn check(probes: &[Probe]) {
    let Some(gpu) = GPU.as_ref() else { return };
    let cases: Vec<Case> = probes.iter().map(|probe| probe.case).collect();
    let worst = compare(probes, &gpu.compute(PORT_SHADER, &cases));
    for (geometry, worst) in Geometry::ALL.into_iter().zip(worst) {
        eprintln!("{geometry}: {worst:?}");
        assert!(worst.angle_rad < 2e-6, "{geometry}: {worst:?}");
        assert!(worst.distance < 2e-6, "{geometry}: {worst:?}");
        assert!(worst.depth < 1e-5, "{geometry}: {worst:?}");
        assert!(worst.normal_rad < 1e-6, "{geometry}: {worst:?}");
    }
}

#[test]
fn the_shader_agrees_with_eighty_digits() {
    check(&golden());
}

#[test]
fn the_shader_agrees_with_the_f64_port() {
    check(&dense(30_000));
}

#[test]
fn the_shader_is_finite_at_every_magnitude() {
    let Some(gpu) = GPU.as_ref() else { return };
    let mut rng = Numbers(11);
    let projection = Projection::new(1.2, 1.6, 0.05);
    let mut cases = Vec::new();
    let mut far = Vec::new();
    for i in 0..4000 {
        let space = strategy(Geometry::Hyperbolic, if i % 2 == 0 { 20.0 } else { 1024.0 });
        let mut eye = rng.eye(DVec3::ZERO);
        if i % 5 == 0 {
            eye.dial = 0.0;
        }
        let p = rng.direction() * 10.0_f64.powf(rng.between(-37.0, 37.0));
        let p = if i % 7 == 0 { DVec3::ZERO } else { p };
        far.push(p.length() > (FAR_LIMIT_RADII + 2.0) * space.radius_m());
        cases.push(case(
            space.as_ref(),
            &eye,
            &projection,
            ChartPoint::a(p),
            rng.direction(),
        ));
    }
    let answers: Vec<Answer> = gpu.compute(PORT_SHADER, &cases);
    for ((answer, case), far) in answers.iter().zip(&cases).zip(far) {
        let finite = answer.view.is_finite() && answer.clip.is_finite();
        assert!(finite, "{} {} {}", case.p, answer.view, answer.clip);
        assert!(
            answer.normal.is_finite() && answer.distance.is_finite(),
            "{}",
            case.p
        );
        assert!((answer.normal.length() - 1.0).abs() < 1e-5, "{}", case.p);
        assert!(!far || answer.clip.z < 1e-8, "{} {}", case.p, answer.clip);
    }
}

#[test]
fn the_shaders_own_trigonometry_is_exact_to_a_few_ulp() {
    let Some(gpu) = GPU.as_ref() else { return };
    let ts: Vec<f32> = (0..20_000)
        .map(|i| (1e-6_f64 * (8e7_f64).powf(f64::from(i) / 19_999.0)) as f32)
        .collect();
    let rows: Vec<Row> = gpu.compute(SCALAR_SHADER, &ts);
    let ulp = f64::from(f32::EPSILON);
    let mut worst = [0.0_f64; 6];
    for (t, row) in ts.iter().zip(rows) {
        let t = f64::from(*t);
        let relative = |ours: f32, exact: f64| (f64::from(ours) / exact - 1.0).abs() / ulp;
        let absolute = |ours: f32, exact: f64| (f64::from(ours) - exact).abs() / ulp;
        let mut note = |i: usize, error: f64| worst[i] = worst[i].max(error);
        if t < std::f64::consts::PI {
            // The argument is t^2 rounded, which moves t by half an ulp.
            note(0, absolute(row.trig[0], t.sin() / t));
            note(1, absolute(row.trig[1], t.cos()));
        }
        // exp's own condition number is t: half an ulp of t is t/2 ulp of the result.
        note(
            2,
            relative(row.hyper[0], t.sinh() / t).max(relative(row.hyper[1], t.cosh())) / t.max(1.0),
        );
        note(3, relative(row.angle, t.atan()));
        note(4, relative(row.asinh, t.asinh()));
        if t < 1.0 {
            let bend = |sign| antipode_geometry::scalar::sinc_minus_one_over_square(sign, t);
            note(
                5,
                relative(row.bends[0], bend(1.0)).max(relative(row.bends[1], bend(-1.0))),
            );
        }
    }
    eprintln!("ulp: sinc, cos, sinh and cosh / t, atan, asinh, bends: {worst:?}");
    for (error, most) in worst.into_iter().zip([4.0, 4.0, 3.0, 6.0, 12.0, 3.0]) {
        assert!(error < most, "{worst:?}");
    }
}
