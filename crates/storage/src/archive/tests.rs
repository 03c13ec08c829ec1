//! Archives of worlds, whole and broken.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

use super::*;
use std::fs;

fn made(world: &[u8]) -> (tempfile::TempDir, Vec<u8>) {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join(WORLD_FILE), world).unwrap();
    fs::write(dir.path().join(THUMBNAIL_FILE), b"picture").unwrap();
    fs::write(dir.path().join("other"), b"stays").unwrap();
    let archive = dir.path().join("a.antipode-world");
    pack(&WORLDS, dir.path(), &WORLD_FILES, &archive).unwrap();
    let bytes = fs::read(&archive).unwrap();
    (dir, bytes)
}

fn unpacked(bytes: &[u8]) -> Result<(Vec<u8>, usize), String> {
    let dir = tempfile::tempdir().unwrap();
    let archive = dir.path().join("archive");
    let target = dir.path().join("target");
    fs::create_dir(&target).unwrap();
    fs::write(&archive, bytes).unwrap();
    unpack(&WORLDS, &archive, &target).map_err(|e| e.to_string())?;
    Ok((
        fs::read(target.join(WORLD_FILE)).unwrap(),
        fs::read_dir(target).unwrap().count(),
    ))
}

#[test]
fn worlds_of_several_blocks_come_back_and_zeros_shrink() {
    let world: Vec<u8> = (0..2 * BLOCK_BYTES + 77)
        .map(|i| u8::from(i % 5000 == 3))
        .collect();
    let (_dir, bytes) = made(&world);
    assert!(bytes.len() < 30_000, "{} bytes", bytes.len());
    assert_eq!(unpacked(&bytes), Ok((world, 2)));
}

#[test]
fn cut_flipped_or_lengthened_archives_are_refused() {
    let (_dir, bytes) = made(b"a small world with some text in it");
    for cut in 0..bytes.len() {
        assert!(unpacked(&bytes[..cut]).is_err(), "cut at {cut}");
    }
    for bit in 0..bytes.len() * 8 {
        let mut flipped = bytes.clone();
        flipped[bit / 8] ^= 1 << (bit % 8);
        assert!(unpacked(&flipped).is_err(), "bit {bit}");
    }
    assert!(unpacked(&[bytes, vec![0]].concat()).is_err());
    assert!(
        unpacked(b"not an archive at all")
            .unwrap_err()
            .contains("no exported world")
    );
}

#[test]
fn paths_that_lead_out_are_refused() {
    for name in [
        "../evil",
        "/etc/evil",
        "a/b",
        "world.redb/..",
        "summary.bin",
        "",
    ] {
        let mut bytes = [
            WORLDS.magic.as_slice(),
            &CONTAINER_VERSION.to_le_bytes(),
            &[1],
        ]
        .concat();
        pack_file(&mut bytes, name, 4, b"evil".as_slice()).unwrap();
        bytes.extend(END);
        let refusal = unpacked(&bytes).unwrap_err();
        assert!(refusal.contains("which no world has"), "{refusal}");
    }
}

fn archive_of(version: u16, files: &[(&str, &[u8])]) -> Vec<u8> {
    let count = [files.len() as u8];
    let mut bytes = [WORLDS.magic.as_slice(), &version.to_le_bytes(), &count].concat();
    for (name, contents) in files {
        pack_file(&mut bytes, name, contents.len() as u64, *contents).unwrap();
    }
    bytes.extend(END);
    bytes
}

#[test]
fn other_formats_are_told_apart() {
    let file = (WORLD_FILE, b"x".as_slice());
    assert!(unpacked(&archive_of(1, &[file])).is_ok());
    let never = unpacked(&archive_of(0, &[file])).unwrap_err();
    assert!(never.contains("format 0 was never used"), "{never}");
    let newer = unpacked(&archive_of(2, &[file])).unwrap_err();
    assert!(newer.contains("newer version"), "{newer}");
}

#[test]
fn a_file_twice_is_refused_by_the_name_in_the_archive() {
    let file = (WORLD_FILE, b"x".as_slice());
    let refusal = unpacked(&archive_of(1, &[file, file])).unwrap_err();
    assert!(
        refusal.contains("\"world.redb\" twice") && !refusal.contains("exists already"),
        "{refusal}"
    );
}

#[test]
fn lengths_beyond_all_sense_are_refused_before_anything_is_unpacked() {
    for (name, most) in FILES {
        let mut bytes = archive_of(1, &[(name, b"x")]);
        let at = 11 + 1 + name.len();
        bytes[at..at + 8].copy_from_slice(&(most + 1).to_le_bytes());
        let refusal = unpacked(&bytes).unwrap_err();
        assert!(refusal.contains("at most"), "{refusal}");
    }
}

#[test]
fn a_bomb_is_refused_before_anything_is_unpacked() {
    // 1 GiB of zeros in 4 MB, as far as LZ4 shrinks them.
    let zeros = io::repeat(0).take(1 << 30);
    let mut bytes = [
        WORLDS.magic.as_slice(),
        &CONTAINER_VERSION.to_le_bytes(),
        &[1],
    ]
    .concat();
    pack_file(&mut bytes, WORLD_FILE, 1 << 30, zeros).unwrap();
    bytes.extend(END);
    let dir = tempfile::tempdir().unwrap();
    let archive = dir.path().join("bomb");
    fs::write(&archive, &bytes).unwrap();
    let refusal = unpack(&WORLDS, &archive, dir.path())
        .unwrap_err()
        .to_string();
    assert!(
        refusal.contains("which no world of this game does"),
        "{refusal}"
    );
    let unpacked = fs::metadata(dir.path().join(WORLD_FILE)).map_or(0, |file| file.len());
    assert_eq!(unpacked, 0);
}

#[test]
fn a_file_that_shrinks_while_it_is_packed_is_no_archive() {
    let mut bytes = Vec::new();
    let error = pack_file(&mut bytes, WORLD_FILE, 9, b"short".as_slice()).unwrap_err();
    assert_eq!(error.kind(), io::ErrorKind::UnexpectedEof);
}

#[test]
fn an_existing_file_is_not_overwritten() {
    let (dir, bytes) = made(b"world");
    let archive = dir.path().join("a.antipode-world");
    assert!(matches!(
        pack(&WORLDS, dir.path(), &WORLD_FILES, &archive),
        Err(StorageError::Exists { .. })
    ));
    assert_eq!(fs::read(archive).unwrap(), bytes);
}
