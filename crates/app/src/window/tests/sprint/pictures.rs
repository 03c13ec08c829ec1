//! Its pictures, against the same frames drawn exactly, and what the frame figures say of them, while chunk workers and
//! the refining thread are slow on purpose.

use antipode_geometry::ChartPoint;
use antipode_render::Delivery;
use antipode_testing::pictures::{MOST_OFF, apart, strays_px};
use image::RgbaImage;

use super::*;

const SIZE: (u32, u32) = (1280, 720);
const FRAMES: usize = 20;
/// Frames of the run before those that are looked at: with the others farther than what the land is refined for to begin
/// with is of use.
const RUN_UP: usize = 6;
/// Land may lie so far from where it truly is, pixels.
const MOST_PX: usize = 2;
/// So far off it may be said to lie, pixels: the figures allow for more than there is.
const MOST_SAID_PX: f64 = 8.0;

impl Easel {
    fn draw_exactly(&mut self, frame: &mut Frame) -> RgbaImage {
        frame.view.quality = Quality::Exact;
        self.renderer.complete_next();
        self.submit(|renderer, encoder, target| {
            renderer.draw(frame, encoder, target);
        });
        self.offscreen.read(&self.gpu).unwrap()
    }
}

impl Run {
    /// Lets the workers and the refining thread seem to be at their work still, or done with all of it.
    fn hold(&mut self, held: bool) {
        self.scene().hold_land(held);
        assert!(held || self.scene().settle(LIMIT));
        self.easel.renderer.deliver_refined(if held {
            Delivery::Held
        } else {
            Delivery::Awaited
        });
    }

    /// What the frame figures say that the last picture is off by at most, pixels.
    fn said_px(&mut self) -> f64 {
        let (drawn, _) = self.pictured.told().unwrap();
        let said = words_of(&mut self.game, drawn);
        let figure = said.split("at most ").nth(1);
        let figure = figure.and_then(|rest| rest.split(" px").next());
        figure.unwrap().parse().unwrap()
    }
}

/// Runs where threads take so many frames for what they are given.
fn is_drawn_true(slow: usize) {
    let (Some(mut run), Some(mut exact)) = (Run::begin(SIZE), Easel::new(SIZE)) else {
        return;
    };
    run.hold(false);
    run.pass();
    let mut first = run.frame();
    run.easel.renderer.complete_next();
    run.paint(&first);
    exact.draw_exactly(&mut first);
    run.sprint();
    let mut truth = RgbaImage::new(SIZE.0, SIZE.1);
    let mut start = ChartPoint::default();
    for number in 1..=RUN_UP + FRAMES {
        run.hold(number % slow != 0);
        run.pass();
        let mut frame = run.frame();
        run.paint(&frame);
        if number <= RUN_UP {
            start = frame.view.eye.point;
            continue;
        }
        let seen = run.easel.offscreen.read(&run.easel.gpu).unwrap();
        truth = exact.draw_exactly(&mut frame);
        let said_px = run.said_px();
        let found_px = strays_px(&seen, &truth, MOST_PX);
        let at = format!("slow by {slow}, frame {number}: {found_px:?} px, and {said_px} are told");
        let least_px = found_px.map_or(MOST_PX, |px| px.saturating_sub(1));
        assert!(said_px >= least_px as f64, "{at}");
        assert!(said_px <= MOST_SAID_PX, "{at}");
        assert!(found_px.is_some(), "{at}");
    }
    let way_m = (run.scene().feet().pos - start.pos).length();
    assert!(way_m > 10.0, "{way_m} m");
    let lower = |x: u32, y: u32| *truth.get_pixel(x, (y + 3).min(SIZE.1 - 1));
    let off = apart(&RgbaImage::from_fn(SIZE.0, SIZE.1, lower), &truth, MOST_PX);
    assert!(off > 100 * MOST_OFF, "three pixels go unnoticed: {off}");
}

#[test]
fn a_sprint_is_drawn_as_it_truly_is_and_said_to_be_where_threads_are_slow() {
    is_drawn_true(3);
}

#[test]
fn a_sprint_is_drawn_as_it_truly_is_and_said_to_be_where_threads_bring_nothing() {
    is_drawn_true(usize::MAX);
}
