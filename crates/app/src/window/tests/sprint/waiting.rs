//! How long its frames wait besides drawing, by the system's word, while the chunk workers are busy.

use super::super::super::waits::{LONGEST_WAIT, Part};
use super::*;

const SIZE: (u32, u32) = (320, 180);
const FRAMES: usize = 60;

impl Run {
    /// One turn of the window's loop, with what it calls and in its order, on account.
    fn turn(&mut self, context: &egui::Context) {
        self.game.waits.keep_account();
        self.pass();
        self.game.waits.spent_on(Part::Input);
        let frame = self.frame();
        self.game.waits.spent_on(Part::Scene);
        let (game, drawn) = (&mut self.game, self.pictured.told());
        let _ = context.run_pass(egui::RawInput::default(), |context| {
            game.interface(context, drawn);
        });
        self.game.waits.spent_on(Part::Interface);
        let (pictured, waits) = (&mut self.pictured, &mut self.game.waits);
        self.easel.submit(|renderer, encoder, target| {
            let stats = renderer.draw(&frame, encoder, target);
            assert!(pictured.note(&stats, frame.view.quality));
            waits.spent_on(Part::Record);
        });
        let is_whole = !self.easel.renderer.is_land_coming();
        self.game.play.drawn(is_whole);
        self.game.waits.spent_on(Part::Drawing);
        self.game.waits.shown();
        self.game.waits.rest();
    }
}

/// Sprints until none of its frames waits. A machine that is shared, or not let run for a while, halts a frame now and
/// then and puts it down as a wait; a mistake waits in every sprint.
const SPRINTS: usize = 3;

#[test]
#[cfg(target_os = "linux")]
fn no_frame_of_a_sprint_waits_for_more_than_the_adapter_while_workers_are_busy() {
    let mut longest = Vec::new();
    for _ in 0..SPRINTS {
        let Some((wait, told)) = longest_wait_of_a_sprint() else {
            return;
        };
        if wait <= LONGEST_WAIT {
            return;
        }
        longest.push(told);
    }
    panic!("a frame waited in each sprint: {}", longest.join("; "));
}

/// The longest that a frame waits besides drawing, and that frame in words; none without an adapter.
fn longest_wait_of_a_sprint() -> Option<(Duration, String)> {
    let mut run = Run::begin(SIZE)?;
    let context = egui::Context::default();
    antipode_ui::apply_theme(&context);
    // The first frame has its shaders made.
    let first = run.frame();
    run.paint(&first);
    run.sprint();
    let mut busy = 0;
    for _ in 0..FRAMES {
        run.turn(&context);
        busy += usize::from(run.scene().pending() > 0);
    }
    let waited = &run.game.waits.waited;
    assert_eq!(waited.len(), FRAMES);
    assert!(2 * busy > FRAMES, "workers had to do in {busy} frames");
    waited.iter().max().cloned()
}
