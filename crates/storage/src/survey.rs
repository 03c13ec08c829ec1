//! Reads every record of a world when it is opened, and notes which are there, damaged or unknown.

use std::collections::BTreeMap;

use crate::codec::{self, Kind, Record};
use crate::error::StorageError;
use crate::record::{KeyParts, Record as Thing, RecordKey};
use crate::schema::{
    self, ChunkBody, ChunkKey, SCHEMA_VERSION, SchemaFault, WorldMeta, WorldState,
};
use crate::store::{META_KEY, Raw, Store};

/// What the state of worlds up to version 6, and the player's record of later ones, is called.
pub(crate) const PLAYERS_STATE: &str = "the player's state";
/// Where faults of the index are told: a world whose own record is damaged does not open.
const INDEX: (Kind, Vec<u8>) = (Kind::Meta, Vec::new());

/// What is kept in memory of an open world.
pub(crate) struct Known {
    /// What the world is, as last committed.
    pub meta: WorldMeta,
    /// The schema version that it was written by.
    pub version: u16,
    /// What cannot be believed, with the reason; without a key what is not to be written over.
    pub faults: BTreeMap<(Kind, Vec<u8>), String>,
}

/// Looks at every record: is it whole, of a known version, and found by its key?
pub(crate) fn survey(store: &Store, label: &str) -> Result<(Known, u64), StorageError> {
    let meta_bytes = store.value(META_KEY)?;
    let Some(meta_bytes) = meta_bytes else {
        return Err(fault_in(
            label,
            "what the world is",
            SchemaFault::Damaged("it is missing".to_owned()),
        ));
    };
    let meta: WorldMeta = schema::read(&meta_bytes, META_KEY.as_bytes())
        .map_err(|fault| fault_in(label, "what the world is", fault))?;
    let version = codec::unseal(&meta_bytes).map_or(SCHEMA_VERSION, |record| record.version);
    let mut known = Known::of(meta, version);
    let mut last = 0;
    let mut newer = None;
    let scanned = store.scan(|raw| match record_fault(&raw) {
        Ok(sequence) => last = last.max(sequence),
        Err(SchemaFault::Newer(version)) => newer = Some(version),
        Err(SchemaFault::Damaged(reason)) => {
            known.faults.insert((raw.kind, raw.key), reason);
        }
    });
    if let Some(found) = newer {
        return Err(StorageError::Newer {
            world: known.meta.name,
            found,
        });
    }
    scanned?;
    // Not to be passed over: after a crash the store would take it for a commit cut short.
    if store.torn_leaves() > 0 && known.faults.is_empty() {
        let reason = "a page of it is not as it was written, though every value is whole";
        known.faults.insert(INDEX, reason.to_owned());
    }
    Ok((known, last))
}

impl Known {
    /// A sound world.
    pub(crate) fn of(meta: WorldMeta, version: u16) -> Self {
        Self {
            meta,
            version,
            faults: BTreeMap::new(),
        }
    }

    /// The error for what is damaged there, if it is.
    pub(crate) fn fault(&self, kind: Kind, key: &[u8]) -> Option<StorageError> {
        let reason = self.faults.get(&(kind, key.to_vec()))?;
        let what = what_at(kind, key);
        Some(fault_in(
            &self.meta.name,
            &what,
            SchemaFault::Damaged(reason.clone()),
        ))
    }
}

/// Checks a stored record; its commit number if it is whole. Of what there is much of, the body is not decoded.
fn record_fault(raw: &Raw) -> Result<u64, SchemaFault> {
    let record = codec::unseal(&raw.bytes)?;
    match raw.kind {
        Kind::Meta => schema::check::<WorldMeta>(&record, &raw.key)?,
        Kind::State => drop(schema::read::<WorldState>(&raw.bytes, &raw.key)?),
        Kind::Chunk => schema::check::<ChunkBody>(&record, &raw.key)?,
        Kind::Record => check_record(&record, &raw.key)?,
    }
    Ok(record.sequence)
}

/// Checks a record of a thing. One of a kind or a version that only a later game knows is whole; but without the
/// player, the time or the view nobody can play.
pub(crate) fn check_record(record: &Record<'_>, key: &[u8]) -> Result<(), SchemaFault> {
    let strange = || SchemaFault::Damaged("it belongs somewhere else".to_owned());
    if record.kind != Kind::Record || record.key != key {
        return Err(strange());
    }
    let known = KeyParts::of(key).ok_or_else(strange)?.known();
    let damaged = |reason: &str| Err(SchemaFault::Damaged(reason.to_owned()));
    if record.version == 0 {
        return damaged("its version 0 was never used");
    }
    match known.filter(|key| key.is_needed()) {
        Some(RecordKey { kind, .. }) if record.version > kind.version() => {
            Err(SchemaFault::Newer(SCHEMA_VERSION + 1))
        }
        Some(RecordKey { kind, .. })
            if Thing::decoded(kind, record.version, record.body).is_none() =>
        {
            damaged("its contents make no sense")
        }
        _ => Ok(()),
    }
}

/// What a value is of, by where it is.
pub(crate) fn what_at(kind: Kind, key: &[u8]) -> String {
    match kind {
        Kind::Meta => "the index".to_owned(),
        Kind::State => PLAYERS_STATE.to_owned(),
        Kind::Chunk => ChunkKey::from_bytes(key).map_or_else(
            || "a chunk of a chart that this version does not know".to_owned(),
            |key| key.to_string(),
        ),
        Kind::Record => match KeyParts::of(key) {
            None => "a record without a kind".to_owned(),
            Some(parts) => match parts.known() {
                Some(key) => key.to_string(),
                None => format!("{} {}", parts.name, parts.id),
            },
        },
    }
}

/// The error for a value that could not be read.
pub(crate) fn fault_in(world: &str, what: &str, fault: SchemaFault) -> StorageError {
    let world = world.to_owned();
    match fault {
        SchemaFault::Newer(found) => StorageError::Newer { world, found },
        SchemaFault::Damaged(reason) => StorageError::Damaged {
            world,
            what: what.to_owned(),
            reason,
        },
    }
}

#[cfg(test)]
mod tests {
    #![allow(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        reason = "tests fail by panicking"
    )]

    use super::*;
    use crate::SavesDir;
    use crate::batch::sealed_meta;
    use crate::record::{Record, RecordKind};
    use crate::store::Put;
    use crate::{WORLD_FILE, pack_chunk, summary};
    use std::fs;
    use std::path::{Path, PathBuf};

    /// The version of a player's record.
    const PLAYER: u16 = 1;
    /// What this build writes.
    const NOW: [u16; 3] = [SCHEMA_VERSION, PLAYER, SCHEMA_VERSION];

    /// A world whose meta, player and one chunk are stored with these schema versions.
    fn planted(versions: [u16; 3]) -> (tempfile::TempDir, SavesDir) {
        planted_at(versions, 1)
    }

    /// The same, written by the commit of this number.
    fn planted_at(versions: [u16; 3], sequence: u64) -> (tempfile::TempDir, SavesDir) {
        let root = tempfile::tempdir().unwrap();
        let dir = root.path().join("future");
        fs::create_dir(&dir).unwrap();
        let meta = WorldMeta {
            name: "Future".to_owned(),
            ..WorldMeta::default()
        };
        let body = codec::encode(&meta).unwrap();
        let player = RecordKind::Player.numbered(0);
        let state = Record::Player(Box::default()).encoded().unwrap();
        let chunk = pack_chunk(&vec![3; crate::CHUNK_SAMPLES]).unwrap();
        let put = |version, kind, key: &[u8], body: &[u8]| Put {
            kind,
            key: key.to_vec(),
            bytes: Some(codec::seal(version, kind, key, sequence, body)),
        };
        let puts = [
            put(versions[0], Kind::Meta, META_KEY.as_bytes(), &body),
            put(versions[1], Kind::Record, &player.to_bytes(), &state),
            put(
                versions[2],
                Kind::Chunk,
                &ChunkKey::default().to_bytes(),
                &chunk,
            ),
        ];
        Store::create(&dir.join(WORLD_FILE), "Future")
            .unwrap()
            .write(&puts)
            .unwrap();
        let saves = SavesDir::new(root.path());
        (root, saves)
    }

    #[test]
    fn a_newer_world_is_refused_by_name_and_left_alone() {
        let (now, next) = (SCHEMA_VERSION, SCHEMA_VERSION + 1);
        for versions in [
            [next, PLAYER, now],
            [now, PLAYER + 1, now],
            [now, PLAYER, next],
            [900, 900, 900],
        ] {
            let (root, saves) = planted(versions);
            let path = root.path().join("future").join(WORLD_FILE);
            let refusals = [
                saves.open("future").map(drop),
                saves.repair("future").map(drop),
                saves.verify("future").map(drop),
            ];
            for refusal in refusals.map(Result::unwrap_err) {
                assert!(
                    matches!(refusal, StorageError::Newer { .. }),
                    "{versions:?}: {refusal}"
                );
                let sentence = refusal.to_string().to_lowercase();
                assert!(
                    sentence.contains("\"future\"") && sentence.contains("update the game"),
                    "{sentence}"
                );
            }
            assert!(path.is_file());
            assert_eq!(fs::read_dir(root.path().join("future")).unwrap().count(), 1);
            let problem = saves.list().unwrap().remove(0).problem;
            assert_eq!(problem.is_some(), versions[0] > now, "{problem:?}");
        }
    }

    #[test]
    fn values_of_an_unknown_version_are_damage() {
        let (_root, saves) = planted([0, PLAYER, 1]);
        assert!(matches!(
            saves.open("future"),
            Err(StorageError::Damaged { .. })
        ));
        let (_root, saves) = planted([SCHEMA_VERSION, 0, 0]);
        let world = saves.open("future").unwrap();
        assert!(matches!(world.state(), Err(StorageError::Damaged { .. })));
        assert!(matches!(
            world.chunk(&ChunkKey::default()),
            Err(StorageError::Damaged { .. })
        ));
        assert_eq!(world.problems().len(), 2);
    }

    /// The world packed as it is, which `export` would refuse to do.
    fn packed(root: &Path) -> PathBuf {
        let file = root.join("w.antipode-world");
        crate::archive::pack(
            &crate::archive::WORLDS,
            &root.join("future"),
            &crate::archive::WORLD_FILES,
            &file,
        )
        .unwrap();
        file
    }

    #[test]
    fn a_world_saved_a_number_of_times_that_nobody_can_is_damaged() {
        for sequence in [u64::MAX, u64::MAX - 4, codec::MAX_COMMIT + 1] {
            let (root, saves) = planted_at(NOW, sequence);
            assert!(!saves.verify("future").unwrap().is_sound());
            let damaged = saves.open("future").map(drop).unwrap_err();
            assert!(matches!(damaged, StorageError::Damaged { .. }), "{damaged}");
            let refusal = saves.import(&packed(root.path())).unwrap_err().to_string();
            assert!(
                refusal.contains("a number of times that nobody can"),
                "{refusal}"
            );
            let lost = saves.repair("future").unwrap_err();
            assert!(matches!(lost, StorageError::Unsalvageable { .. }), "{lost}");
        }
    }

    #[test]
    fn a_world_near_the_largest_number_of_commits_goes_on_saving() {
        let (root, saves) = planted_at(NOW, codec::MAX_COMMIT - 2);
        let slug = saves.import(&packed(root.path())).unwrap();
        for round in 0..6 {
            let world = saves.open(&slug).unwrap();
            for step in 0..3 {
                let state = WorldState {
                    simulated_s: f64::from(10 * round + step),
                    ..WorldState::default()
                };
                let chunks = vec![(ChunkKey::default(), vec![step as i16; crate::CHUNK_SAMPLES])];
                let batch = crate::Batch {
                    meta: None,
                    records: (&state).into(),
                    chunks,
                    kinds: BTreeMap::new(),
                };
                world.commit(&batch).unwrap();
            }
            drop(world);
            let world = saves.open(&slug).unwrap();
            let state = world.state().unwrap().unwrap();
            assert_eq!(state.simulated_s, f64::from(10 * round + 2));
            drop(world);
            assert!(saves.verify(&slug).unwrap().is_sound());
        }
        fs::write(saves.path().join(&slug).join(WORLD_FILE), b"gone").unwrap();
        assert_eq!(saves.repair(&slug).unwrap().world, "Future 2");
    }

    #[test]
    fn a_copied_record_does_not_pass_for_another_chunk() {
        let (root, saves) = planted(NOW);
        let elsewhere = ChunkKey {
            x: 5,
            ..ChunkKey::default()
        };
        let store = Store::open(&root.path().join("future").join(WORLD_FILE), "Future").unwrap();
        let bytes = store.chunk(&ChunkKey::default().to_bytes()).unwrap();
        let put = Put {
            kind: Kind::Chunk,
            key: elsewhere.to_bytes(),
            bytes,
        };
        store.write(&[put]).unwrap();
        drop(store);
        let world = saves.open("future").unwrap();
        assert_eq!(
            world.chunk(&ChunkKey::default()).unwrap(),
            Some(vec![3; crate::CHUNK_SAMPLES])
        );
        assert!(matches!(
            world.chunk(&elsewhere),
            Err(StorageError::Damaged { .. })
        ));
    }

    #[test]
    fn a_world_without_its_meta_is_repaired_from_its_summary() {
        let (root, saves) = planted(NOW);
        let dir = root.path().join("future");
        let meta = saves.open("future").unwrap().meta();
        let sealed = sealed_meta(&meta, 1, "Future").unwrap();
        summary::write(&dir, &sealed.bytes.unwrap());
        fs::write(dir.join(WORLD_FILE), b"nothing of it is left").unwrap();
        let listed = saves.find("FUTURE").unwrap();
        assert!(listed.problem.is_some());
        let report = saves.repair("future").unwrap();
        assert_eq!(
            (report.chunks, report.has_state, report.losses.len()),
            (0, false, 1)
        );
        assert_eq!(saves.open("future").unwrap().meta(), meta);
    }
}
