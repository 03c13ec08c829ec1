//! Seeded inputs for every target and attack, in a process with bounds: nothing panics,
//! aborts, takes five seconds of the processor, a minute or 512 MB, and no promise is broken.
//!
//! `ANTIPODE_TEST_FUZZ=1000000` is the long form for the targets (a tenth of it for
//! archives and stores), `ANTIPODE_TEST_ATTACKS=5000` that for the attacks.
#![cfg(unix)]

use std::path::Path;

use antipode_fuzzing::attacks::ATTACKS;
use antipode_fuzzing::campaign::{Report, run};
use antipode_fuzzing::watch::MOST_BYTES;
use antipode_fuzzing::{TARGETS, Target};

const SEED: u64 = 1;

fn campaign(target: &Target, count: u64) -> Report {
    let program = Path::new(env!("CARGO_BIN_EXE_antipode-fuzzing"));
    let report = run(program, target, count, SEED).unwrap();
    println!("{}: {report}", target.name);
    assert!(
        report.finds.is_empty(),
        "{}: {report}\n`antipode-fuzzing input {} {SEED} NUMBER FILE` writes one of them; cure it and put it into fuzz/finds/{}",
        target.name,
        target.name,
        target.name
    );
    assert_eq!(report.inputs, count);
    assert!(report.peak_bytes <= MOST_BYTES);
    report
}

fn asked_for(variable: &str, usual: u64) -> u64 {
    std::env::var(variable).map_or(usual, |count| count.parse().unwrap())
}

#[test]
fn no_input_breaks_a_reader_and_half_get_past_the_checksums() {
    for target in TARGETS {
        let with_files = ["archive", "store", "room_archive"].contains(&target.name);
        let count = asked_for("ANTIPODE_TEST_FUZZ", 3000);
        let report = campaign(target, if with_files { count / 10 } else { count });
        assert!(
            2 * report.past_checksums >= report.inputs,
            "{}: {report}",
            target.name
        );
        assert!(
            report.taken > 0 && report.taken < report.inputs,
            "{}: {report}",
            target.name
        );
    }
}

#[test]
fn no_attack_on_a_store_costs_what_was_committed() {
    for attack in ATTACKS {
        campaign(attack, asked_for("ANTIPODE_TEST_ATTACKS", 60));
    }
}

#[test]
fn an_input_follows_from_seed_and_number() {
    use antipode_fuzzing::campaign::input;
    for target in TARGETS {
        let seeds = (target.seeds)();
        let some = |seed, number| input(target, &seeds, seed, number);
        assert!(
            (100..140).all(|number| some(1, number) == some(1, number)),
            "{}",
            target.name
        );
        assert!(
            (100..140).any(|number| some(1, number) != some(2, number)),
            "{}",
            target.name
        );
    }
}
