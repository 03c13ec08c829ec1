//! The main thread's share of a frame with a crowd: planning and recording, without what the adapter does.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a bench fails by panicking"
)]

#[path = "../tests/it/common/mod.rs"]
mod common;

use std::cell::RefCell;

use antipode_frame::{Clip, Figure, Frame, ModelId, Posture};
use antipode_geometry::{ChartPoint, Geometry};
use antipode_items::Item;
use antipode_render::ShadowQuality;
use glam::DVec3;

use common::{Studio, frame, space};

const SIZE: (u32, u32) = (64, 36);
const CROWD: u32 = 500;

fn main() {
    divan::main();
}

/// Where a crowd is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Crowd {
    Nowhere,
    /// Out of the picture.
    Behind,
    /// The same, posed and drawn all the same: as it would be without culling.
    BehindUnculled,
    /// In the picture.
    Before,
}

const CROWDS: [Crowd; 4] = [
    Crowd::Nowhere,
    Crowd::Behind,
    Crowd::BehindUnculled,
    Crowd::Before,
];

/// An eye with a crowd two metres from each other, who hold guns.
fn scene(geometry: Geometry, crowd: Crowd) -> Frame {
    let eye = ChartPoint::a(DVec3::new(3.0, 9.7, 2.0));
    let mut scene = frame(&space(geometry), eye, 16.0 / 9.0);
    let sign = if crowd == Crowd::Before { 1.0 } else { -1.0 };
    let number = if crowd == Crowd::Nowhere { 0 } else { CROWD };
    let figure = |i: u32| {
        let (row, column) = (f64::from(i / 25), f64::from(i % 25));
        let away = DVec3::new(sign * (6.0 + 2.0 * row), -1.7, 2.0 * column - 24.0);
        Figure {
            posture: Posture::default().with(Clip::Hold, 1.0, 0.0),
            held: Some(ModelId::Item(Item::Gun)),
            ..Figure::standing(ModelId::Astronaut, eye.moved(away), 1.0)
        }
    };
    scene.content_mut().figures = (0..number).map(figure).collect();
    scene
}

fn measure(
    bencher: divan::Bencher<'_, '_>,
    geometry: Geometry,
    crowd: Crowd,
    quality: ShadowQuality,
) {
    let Some(mut studio) = Studio::shadowed(SIZE, quality) else {
        return;
    };
    if crowd == Crowd::BehindUnculled {
        studio.renderer().draw_unseen();
    }
    let frame = scene(geometry, crowd);
    studio.draw(&frame);
    let queue = studio.gpu.queue.clone();
    let studio = RefCell::new(studio);
    bencher
        .with_inputs(|| Recorded(queue.clone(), Some(studio.borrow().idle_encoder())))
        .bench_local_values(|mut recorded| {
            if let Some(encoder) = &mut recorded.1 {
                studio.borrow_mut().record(&frame, encoder);
            }
            recorded
        });
}

/// What was recorded; submitted when it is dropped, which is not measured.
struct Recorded(wgpu::Queue, Option<wgpu::CommandEncoder>);

impl Drop for Recorded {
    fn drop(&mut self) {
        self.0
            .submit(self.1.take().map(wgpu::CommandEncoder::finish));
    }
}

macro_rules! benches {
    ($($name:ident: $geometry:ident, $quality:ident;)*) => {$(
        #[divan::bench(args = CROWDS, sample_size = 1, sample_count = 60)]
        fn $name(bencher: divan::Bencher<'_, '_>, crowd: Crowd) {
            measure(bencher, Geometry::$geometry, crowd, ShadowQuality::$quality);
        }
    )*};
}

benches! {
    euclidean: Euclidean, Off;
    euclidean_with_shadows: Euclidean, High;
    hyperbolic: Hyperbolic, Off;
    hyperbolic_with_shadows: Hyperbolic, High;
    spherical: Spherical, Off;
    spherical_with_shadows: Spherical, High;
    spherical_with_few_shadows: Spherical, Low;
}
