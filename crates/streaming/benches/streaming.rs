//! How long a player waits: for an edit to show, and for the ground of a new world.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a bench fails by panicking"
)]

use std::sync::Arc;
use std::time::Duration;

use antipode_geometry::{ChartId, ChartPoint, Geometry, strategy};
use antipode_streaming::{Config, Streamer, Until, Wish};
use antipode_terrain::{Field, Stroke};
use glam::DVec3;

const LIMIT: Duration = Duration::from_mins(1);

fn main() {
    divan::main();
}

/// A world loaded one chunk around the corner of eight chunks nearest to the ground.
fn world(config: Config) -> (Streamer, DVec3) {
    let space = strategy(Geometry::Euclidean, f64::INFINITY);
    let field = Arc::new(Field::new(11, space.clone()));
    let ground_m = field.surface_height(ChartId::FIRST, 0.0, 0.0);
    let corner = DVec3::new(0.0, (ground_m / 32.0).round() * 32.0, 0.0);
    let mut streamer = Streamer::start(field, space, None, config).expect("threads");
    streamer.wish(&Wish::new(ChartPoint::a(corner), DVec3::X, 1));
    let loaded = streamer.wait(Until::Idle, LIMIT);
    assert!(!loaded.is_empty());
    (streamer, corner)
}

/// One stroke at a corner of eight chunks, from the call to the batch with its colliders.
#[divan::bench(args = [2.0, 5.0, 10.0])]
fn edit_over_eight_chunks(bencher: divan::Bencher<'_, '_>, radius_m: f64) {
    let (mut streamer, corner) = world(Config::default());
    let mut amount = 4.0;
    bencher.bench_local(|| {
        amount = -amount;
        streamer.edit(Stroke {
            centre: ChartPoint::a(corner),
            radius_m,
            amount,
            part: antipode_terrain::Part::Whole,
            kind: None,
            shape: antipode_terrain::Shape::Ball,
            power: None,
        });
        streamer.wait(Until::Edits, LIMIT)
    });
}

/// As above, of a press, which tells what is moved and can be undone.
#[divan::bench(args = [2.0, 5.0, 10.0])]
fn press_over_eight_chunks(bencher: divan::Bencher<'_, '_>, radius_m: f64) {
    let (mut streamer, corner) = world(Config::default());
    let mut amount = 4.0;
    let mut press = 0;
    bencher.bench_local(|| {
        amount = -amount;
        press += 1;
        let stroke = Stroke {
            centre: ChartPoint::a(corner),
            radius_m,
            amount,
            part: antipode_terrain::Part::Whole,
            kind: None,
            shape: antipode_terrain::Shape::Ball,
            power: None,
        };
        // A second of sixty strokes each.
        streamer.edit_in(Some(press / 60), stroke);
        streamer.wait(Until::Edits, LIMIT)
    });
}

/// The main thread's share of an edit, a wish and a poll without results.
#[divan::bench]
fn main_thread_wish_and_poll(bencher: divan::Bencher<'_, '_>) {
    let (mut streamer, corner) = world(Config::default());
    let mut turn = 0.0_f64;
    bencher.bench_local(|| {
        turn += 0.3;
        let front = DVec3::new(turn.cos(), 0.0, turn.sin());
        streamer.wish(&Wish::new(ChartPoint::a(corner), front, 1));
        streamer.poll(Duration::from_millis(1))
    });
}

/// The main thread's share when the player crosses a chunk's border at the default view distance:
/// one layer of chunks comes into range and, every other time, one goes.
#[divan::bench]
fn main_thread_walk_over_a_border(bencher: divan::Bencher<'_, '_>) {
    let (mut streamer, corner) = world(Config::default());
    let mut chunk = 0.0_f64;
    bencher.bench_local(|| {
        chunk += 1.0;
        let centre = ChartPoint::a(corner + DVec3::X * (32.0 * chunk + 16.0));
        streamer.wish(&Wish::new(centre, DVec3::X, 4));
    });
}

/// The ground within one chunk of a player, from nothing.
#[divan::bench(sample_count = 10)]
fn load_around_a_player(bencher: divan::Bencher<'_, '_>) {
    bencher.bench_local(|| world(Config::default()));
}
