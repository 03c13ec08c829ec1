//! Files forged to keep a repair at work for hours.

use std::fs;
use std::time::{Duration, Instant};

use crate::common::meta;
use antipode_storage::{SavesDir, WORLD_FILE};

#[test]
fn headers_that_lie_about_lengths_do_not_keep_a_repair_at_work() {
    let dir = tempfile::tempdir().unwrap();
    let saves = SavesDir::new(dir.path());
    let (slug, world) = saves.create(&meta("W")).unwrap();
    drop(world);
    let path = dir.path().join(slug).join(WORLD_FILE);
    // Heads of records eight bytes apart, each of a chunk with a body of nearly 1 MiB.
    let body = [0xff, 0xff, 0x0f, 0];
    let head = [&b"Ap\x03\x10"[..], &body].concat();
    let mut forged = head.repeat(4 << 17);
    forged.splice(..0, [0, 0]);
    fs::write(&path, forged).unwrap();
    let began = Instant::now();
    let report = saves.repair("w").unwrap();
    let took = began.elapsed();
    let said = report.losses.join("\n");
    assert!(said.contains("was not searched"), "{said}");
    // All of it would be half a terabyte to checksum.
    assert!(took < Duration::from_mins(1), "{took:?}");
    assert!(saves.verify("w").unwrap().is_sound());
}
