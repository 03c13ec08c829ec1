//! Pictures that a raster begins and rays finish.

use std::f64::consts::FRAC_PI_2;
use std::ops::Range;

use bytemuck::bytes_of;
use glam::DVec2;
use wgpu::{CommandEncoder, ComputePipeline, Device, Queue};

use crate::frame::{Part, corners, frame, lamps};
use crate::kinds::Kinds;
use crate::loaded::Loaded;
use crate::options::{Options, Outlines};
use crate::packed::Rule;
use crate::picture::Picture;
use crate::raster::{Limits, MOST_VIEWS, Plan, Region, Sight, Way};
use crate::rays::{GROUP, Rays, scene_group};
use crate::scene::{Eye, RayScene};

/// Doors in a row that a raster sees through, and one.
const LEVELS: usize = 5;
/// Samples beside the middle of a pixel: the turn of the first and how far off they are, pixels; as in picture.wgsl.
const SAMPLES: (f64, f64) = (0.4636, 0.3953);

/// What the choice between a raster and rays depends on.
pub fn sight<'a>(
    scene: &RayScene,
    loaded: &'a Loaded,
    eye: &'a Eye,
    options: Options,
) -> Sight<'a> {
    let has_outlines = match options.outlines {
        Outlines::Hidden => false,
        Outlines::Chosen => scene.outlined.contains(&true),
        Outlines::All => !loaded.aberrations().placed().is_empty(),
    };
    Sight {
        view: options.view,
        outlines: has_outlines && scene.outline.strength > 0.0,
        space: loaded.aberrations(),
        tidy: &loaded.tidy,
        eye,
    }
}

impl Rays {
    /// The pass that goes on where a raster has seen something.
    pub(crate) fn rastered(
        &self,
        device: &Device,
        kinds: Kinds,
        sees_all: bool,
    ) -> &ComputePipeline {
        let layouts = [&self.scene_layout, &self.picture_layout];
        self.raster.rays(device, layouts, kinds, sees_all)
    }

    /// Records the passes of a picture that a raster begins.
    pub(crate) fn draw_rastered(
        &self,
        (device, queue): (&Device, &Queue),
        encoder: &mut CommandEncoder,
        (scene, loaded, way): (&RayScene, &Loaded, Way),
        (eye, picture): (&Eye, &Picture),
        options: Options,
        rows: Range<u32>,
    ) {
        let size = picture.size;
        let (rule, plan) = planned(loaded, way, eye, size);
        let region = Region {
            size,
            rows: rows.clone(),
            samples: samples(options.samples),
        };
        let visible = picture.visible(device, region.samples.len() as u32, plan.levels());
        let what = (loaded, &plan);
        let into = (&*visible, &region);
        self.raster.draw((device, queue), encoder, what, into, rule);

        let ways = (loaded.host_ways)
            .with_corners(&corners(eye, size))
            .with_outlines(options.outlines);
        queue.write_buffer(&loaded.ways, 0, bytes_of(&ways));
        queue.write_buffer(&self.lamps, 0, bytes_of(&lamps(scene)));
        let part = Part {
            columns: 0..size.0,
            rows: rows.clone(),
            line: u32::MAX,
        };
        let packed = frame(scene, eye, size, options, &part);
        let [buffer, _] = &self.frames;
        queue.write_buffer(buffer, 0, bytes_of(&packed));
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: Some("rays of a raster"),
            timestamp_writes: None,
        });
        let kinds = loaded.kinds(rule);
        let [others, alone] = [false, true].map(|it| self.raster.has_rays(kinds, it));
        let is_missing = options.as_compiled && others && !alone;
        let sees_all = plan.sees_all() && options.bounces == 0 && !is_missing;
        pass.set_pipeline(self.rastered(device, kinds, sees_all));
        let scene = scene_group(device, &self.scene_layout, loaded, rule);
        pass.set_bind_group(0, &scene, &[]);
        let pixels = self.picture_group(device, loaded, picture, buffer);
        pass.set_bind_group(1, &pixels, &[]);
        let seen = self.raster.visible_group(device, &visible);
        pass.set_bind_group(2, &seen, &[]);
        let lines = rows.end.saturating_sub(rows.start).div_ceil(GROUP);
        pass.dispatch_workgroups(size.0.div_ceil(GROUP), lines, 1);
    }
}

/// By which rule light goes, and the views that the eye has.
fn planned(loaded: &Loaded, way: Way, eye: &Eye, size: (u32, u32)) -> (Rule, Plan) {
    let aspect = f64::from(size.0) / f64::from(size.1);
    let space = loaded.aberrations();
    if way == Way::Plain {
        return (Rule::Plain, Plan::plain(space, eye, aspect));
    }
    let limits = Limits {
        levels: LEVELS,
        views: MOST_VIEWS,
    };
    let plan = Plan::doors(space, &loaded.tidy, eye, aspect, limits);
    (Rule::Exact, plan)
}

/// Where in a pixel its samples are, pixels from its middle.
fn samples(count: u32) -> Vec<DVec2> {
    let (turn, off) = SAMPLES;
    match count.clamp(1, 4) {
        1 => vec![DVec2::ZERO],
        count => (0..count)
            .map(|number| off * DVec2::from_angle(turn + FRAC_PI_2 * f64::from(number)))
            .collect(),
    }
}
