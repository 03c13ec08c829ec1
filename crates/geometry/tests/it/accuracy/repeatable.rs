//! The same bits on every run and thread.

use antipode_geometry::Real;
use antipode_geometry::kernel::horizon::HorizonMap;
use antipode_geometry::kernel::raised::RaisedMap;
use antipode_geometry::kernel::{cylindrical, exponential, sphere};

const PORTS: u32 = 100_000;
const THREADS: usize = 8;

/// FNV-1a over the bits of every coordinate, for 1e5 points of a fixed spiral.
fn fingerprint<T: Real>(port: impl Fn([T; 3]) -> [T; 4]) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for i in 0..PORTS {
        let (turn, out) = (f64::from(i) * 2.399_963, f64::from(i) * 2.5e-4);
        let (z, x) = (turn % 2.0 - 1.0, turn % 1.0 - 0.5);
        let p = [x * out, z * out * 0.25, (1.0 - x) * out].map(T::of);
        for coordinate in port(p) {
            hash = (hash ^ coordinate.to_f64().to_bits()).wrapping_mul(0x100_0000_01b3);
        }
    }
    hash
}

/// The spiral is in metres, at a radius of 16 where a map has one.
fn fingerprints() -> Vec<u64> {
    let raised = RaisedMap::new(16.0, 10.0);
    let bent = [-0.015_625, 0.0, 1e-4].map(|kappa| HorizonMap::new(kappa, 1.625));
    let single = RaisedMap::<f32>::from_uniform(
        [0.0625, 0.625, raised.sinh as f32, raised.cosh as f32],
        16.0,
    );
    let quarter = |p: [f64; 3]| p.map(|x| x * 0.0625);
    let quarter_f32 = |p: [f32; 3]| p.map(|x| x * 0.0625);
    let mut out = vec![
        fingerprint(|p| raised.port(p)),
        fingerprint(|p| single.port(p)),
        fingerprint(|p| exponential::point(-1.0, quarter(p))),
        fingerprint(|p| exponential::point(-1.0_f32, quarter_f32(p))),
        fingerprint(|p| cylindrical::point(1.0, quarter(p))),
        fingerprint(|p| sphere::port(0.0625_f32, true, p)),
    ];
    out.extend(bent.iter().map(|map| fingerprint(|p| map.port(p))));
    out
}

#[test]
fn every_thread_and_every_run_gives_the_same_bits() {
    let alone = fingerprints();
    assert_eq!(alone, fingerprints());
    let threads: Vec<_> = (0..THREADS)
        .map(|_| std::thread::spawn(fingerprints))
        .collect();
    for thread in threads {
        assert_eq!(thread.join().unwrap(), alone);
    }
    // A kernel that ignored its input would agree with itself too.
    for (i, one) in alone.iter().enumerate() {
        assert!(alone[..i].iter().all(|other| other != one), "{i}");
    }
}

/// The single-precision kernels use + - * /, roots and shifts only, which every system rounds alike:
/// this number holds on all of them.
#[test]
fn the_single_precision_kernels_give_these_bits_on_every_system() {
    let hash = fingerprint(|p: [f32; 3]| exponential::point(-1.0, p.map(|x| x * 0.0625)))
        ^ fingerprint(|p: [f32; 3]| sphere::port(0.0625, false, p));
    assert_eq!(hash, SINGLE, "{hash:#018x}");
}

const SINGLE: u64 = 0x1c43_dc38_c000_0000;
