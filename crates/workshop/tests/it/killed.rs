//! A process that edits and is killed at any moment: at most the last two seconds are lost, and never the room.
#![cfg(unix)]

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::time::{Duration, Instant};

use antipode_rooms::files::ROOM_FILE;
use antipode_rooms::{Object, Room, What, read, write};
use antipode_workshop::{Document, Edit, Field, Pace};
use glam::DVec3;

/// Set for the child only: the folder of the room that it edits.
const CHILD: &str = "ANTIPODE_TEST_KILLED_EDITOR";
const MOST_LOST: Duration = Duration::from_secs(2);
/// Edits are numbered by where the wall is, so many to the metre.
const TO_THE_METRE: f64 = 1000.0;

fn wall_at(number: u32) -> Edit {
    let at = DVec3::new(0.0, 1.0, -f64::from(number) / TO_THE_METRE);
    Edit::Change("wall".to_owned(), vec![Field::three("at", at)])
}

fn number_of(document: &Document) -> u32 {
    let wall = document.room().find("wall").unwrap().1;
    (-wall.at.z * TO_THE_METRE).round() as u32
}

fn open(dir: &Path) -> Document {
    let pace = Pace {
        version_after: Duration::from_millis(200),
        ..Pace::default()
    };
    Document::open_at(dir, pace).unwrap().document
}

/// Not a test of its own: what the child process does until it is killed. It tells each edit once that is made.
#[test]
fn child_edits_until_it_is_killed() {
    let Some(dir) = std::env::var_os(CHILD) else {
        return;
    };
    let mut it = open(Path::new(&dir));
    let mut number = number_of(&it);
    loop {
        number += 1;
        match number % 40 {
            0 => it.save().unwrap(),
            1 => it.begin_drag(),
            _ => {}
        }
        if it.is_dragging() {
            it.drag(&wall_at(number)).unwrap();
        } else {
            it.edit(&wall_at(number)).unwrap();
        }
        if number % 40 == 20 {
            it.end_drag();
        }
        // A mark of its own, since the test's harness writes there, too.
        println!("\nedit {number}");
        std::thread::sleep(Duration::from_millis(3));
    }
}

/// Runs the child for so long and kills it; the edits that it told, each with how long before the end.
fn run(dir: &Path, time: Duration) -> Vec<(u32, Duration)> {
    let mut child = Command::new(std::env::current_exe().unwrap())
        .args([
            "--exact",
            "killed::child_edits_until_it_is_killed",
            "--nocapture",
        ])
        .env(CHILD, dir)
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let lines = BufReader::new(child.stdout.take().unwrap()).lines();
    let (tell, told) = mpsc::channel();
    let reader = std::thread::spawn(move || {
        for line in lines.map_while(Result::ok) {
            if let Some(number) = line.strip_prefix("edit ") {
                tell.send((number.parse::<u32>().unwrap(), Instant::now()))
                    .unwrap();
            }
        }
    });
    let first = told.recv().unwrap();
    std::thread::sleep(time);
    child.kill().unwrap();
    let killed = Instant::now();
    child.wait().unwrap();
    reader.join().unwrap();
    let all = std::iter::once(first).chain(told.try_iter());
    all.map(|(number, at)| (number, killed.saturating_duration_since(at)))
        .collect()
}

/// Kills it once after each of these times; the longest time that was lost.
fn kill_after(times: impl Iterator<Item = Duration>) -> Duration {
    let dir = tempfile::tempdir().unwrap();
    let dir = dir.path();
    let mut room = Room::new("Hut");
    room.push(Object::new("wall", DVec3::Y, What::Ball { radius: 1.0 }));
    fs::write(dir.join(ROOM_FILE), write(&room).unwrap()).unwrap();
    let mut longest = Duration::ZERO;
    for time in times {
        let told = run(dir, time);
        let file = fs::read(dir.join(ROOM_FILE)).unwrap();
        read(ROOM_FILE, &file).expect("the file is whole");
        let it = open(dir);
        let number = number_of(&it);
        let last = told.last().unwrap().0;
        assert!(number <= last + 1, "{number} {last}");
        let lost = told.iter().find(|(told, _)| *told > number).map(|it| it.1);
        longest = longest.max(lost.unwrap_or_default());
        assert!(longest <= MOST_LOST, "{longest:?} after {time:?}");
        assert_eq!(it.room().objects.len(), 2);
        let mut it = it;
        it.undo(1).unwrap();
        it.redo(1).unwrap();
        assert_eq!(number_of(&it), number);
    }
    let left: Vec<_> = fs::read_dir(dir)
        .unwrap()
        .flatten()
        .map(|it| it.file_name())
        .collect();
    assert_eq!(left.len(), 2, "nothing unfinished is left: {left:?}");
    longest
}

#[test]
fn killed_at_ten_moments_at_most_two_seconds_are_lost() {
    let early = (0..8).map(|round| Duration::from_millis(17 + round * 61));
    let late = [2300, 2700].map(Duration::from_millis);
    kill_after(early.chain(late));
}

/// Takes four minutes; `cargo test --release -p antipode-workshop killed -- --ignored --nocapture`.
#[test]
#[ignore = "four minutes"]
fn killed_at_a_hundred_moments_at_most_two_seconds_are_lost() {
    let mut random = fastrand::Rng::with_seed(100);
    let longest = kill_after((0..100).map(|_| Duration::from_millis(random.u64(0..4500))));
    println!("at most {longest:?} of edits were lost in 100 kills");
}
