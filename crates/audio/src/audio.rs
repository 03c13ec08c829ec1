//! The game's end of the sound: hands everything over to the sound thread and waits for nothing.

use std::sync::mpsc::{self, Receiver, RecvTimeoutError, SyncSender};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use crate::studio::{Cue, Heard, Message, Open, Status, Studio};
use crate::volumes::Volumes;

/// Messages under way at most; what comes on top, when the sound thread is stuck, is dropped.
const MOST_MESSAGES: usize = 256;
/// Longest time between two looks at the clock, for music.
const TICK: Duration = Duration::from_millis(50);
/// Longest wait, on quitting, for a device that does not close.
const LONGEST_GOODBYE: Duration = Duration::from_millis(500);

/// Sound, on a thread of its own. Everything returns at once; dropping it ends the thread.
#[derive(Debug)]
pub struct Audio {
    sender: Option<SyncSender<Message>>,
    news: Receiver<Status>,
    status: Status,
    thread: Option<JoinHandle<()>>,
}

impl Audio {
    /// Opens the system's sound device, or says why not in [`Audio::status`].
    pub fn start(volumes: Volumes) -> Self {
        #[cfg(feature = "device")]
        return Self::start_with(|| Box::new(crate::kira_player::open_device), volumes);
        #[cfg(not(feature = "device"))]
        {
            let _ = volumes;
            Self::silent(Status::LeftOut)
        }
    }

    /// Plays nothing.
    fn silent(status: Status) -> Self {
        Self {
            sender: None,
            news: mpsc::channel().1,
            status,
            thread: None,
        }
    }

    /// Plays on what `opener` makes, on the sound thread, to open devices with.
    #[cfg_attr(
        not(any(test, feature = "device")),
        expect(dead_code, reason = "without a device nothing is opened")
    )]
    fn start_with(opener: impl FnOnce() -> Open + Send + 'static, volumes: Volumes) -> Self {
        let (sender, messages) = mpsc::sync_channel(MOST_MESSAGES);
        let (tell, news) = mpsc::channel();
        let run = move || {
            let mut told = Status::Opening;
            let mut studio = Studio::new(opener(), volumes);
            run(&mut studio, &messages, |status| {
                if *status != told {
                    told = status.clone();
                    let _ = tell.send(status.clone());
                }
            });
        };
        match std::thread::Builder::new()
            .name("antipode-sound".to_owned())
            .spawn(run)
        {
            Ok(thread) => Self {
                sender: Some(sender),
                news,
                status: Status::Opening,
                thread: Some(thread),
            },
            Err(error) => {
                let status = Status::NoDevice(format!("no thread can be started ({error})"));
                tracing::warn!("{status}");
                Self::silent(status)
            }
        }
    }

    /// Tells what there was to hear in a frame.
    pub fn hear(&self, heard: Heard) {
        self.send(Message::Heard(heard));
    }

    /// Plays a sound of the interface.
    pub fn cue(&self, cue: Cue) {
        self.send(Message::Cue(cue));
    }

    /// Sets the volumes.
    pub fn set_volumes(&self, volumes: Volumes) {
        self.send(Message::Volumes(volumes));
    }

    /// Makes everything silent, or audible again.
    pub fn set_muted(&self, muted: bool) {
        self.send(Message::Muted(muted));
    }

    /// How it goes.
    pub fn status(&mut self) -> &Status {
        if let Some(latest) = self.news.try_iter().last() {
            self.status = latest;
        }
        &self.status
    }

    fn send(&self, message: Message) {
        if let Some(sender) = &self.sender {
            // A full queue means that nothing is heard at the moment anyway.
            let _ = sender.try_send(message);
        }
    }
}

impl Drop for Audio {
    fn drop(&mut self) {
        self.sender = None;
        let Some(thread) = self.thread.take() else {
            return;
        };
        // The end of the news is the end of the thread. Drivers may hang on closing; the game does not.
        let until = Instant::now() + LONGEST_GOODBYE;
        loop {
            let left = until.saturating_duration_since(Instant::now());
            match self.news.recv_timeout(left) {
                Ok(_) => {}
                Err(RecvTimeoutError::Timeout) => return,
                Err(RecvTimeoutError::Disconnected) => break,
            }
        }
        let _ = thread.join();
    }
}

/// The life of the sound thread: until nobody can send any more.
fn run(studio: &mut Studio, messages: &Receiver<Message>, mut tell: impl FnMut(&Status)) {
    let mut last = Instant::now();
    loop {
        let passed = last.elapsed();
        last += passed;
        let opened = studio.advance(passed.as_secs_f64());
        tell(studio.status());
        if opened {
            while let Ok(message) = messages.try_recv() {
                studio.take(message, true);
            }
        }
        match messages.recv_timeout(TICK) {
            Ok(message) => studio.take(message, false),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => return,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::player::{Player, Recorder};

    #[test]
    fn a_sound_thread_that_is_stuck_holds_up_neither_the_game_nor_its_end() {
        let (release, gate) = mpsc::channel::<()>();
        let stuck = move || -> Open {
            Box::new(move || {
                let _ = gate.recv();
                Err("too late".to_owned())
            })
        };
        let audio = Audio::start_with(stuck, Volumes::default());
        for _ in 0..10 * MOST_MESSAGES {
            audio.cue(Cue::Moved);
            audio.hear(Heard::default());
        }
        // Comes back although the thread never does.
        drop(audio);
        drop(release);
    }

    #[test]
    fn the_status_arrives_and_the_thread_ends_with_its_handle() {
        let (gone, ended) = mpsc::channel::<()>();
        let opener = move || -> Open {
            Box::new(move || {
                let _ = &gone;
                Ok(Box::new(Recorder::default()) as Box<dyn Player>)
            })
        };
        let mut audio = Audio::start_with(opener, Volumes::default());
        while audio.status() == &Status::Opening {
            std::thread::yield_now();
        }
        assert_eq!(audio.status(), &Status::Playing);
        drop(audio);
        assert!(
            ended.recv().is_err(),
            "the thread has let go of what it had"
        );
    }
}
