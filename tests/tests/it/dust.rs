//! What tools and wheels do to the ground is seen: told by the probe of a script.

use std::fmt::Write;

use antipode_tests::program::{Run, number, run_with};

const SIZE: [&str; 4] = ["--size", "64x64", "--view-distance", "2"];
const WORLDS: [&str; 3] = [
    "new euclidean seed=11 generator=1",
    "new hyperbolic seed=12 generator=1",
    "new spherical seed=13 radius=48 generator=1",
];

fn played(script: &str) -> Run {
    let saves = tempfile::tempdir().unwrap();
    run_with(saves.path(), script, &SIZE)
}

#[test]
fn snow_flies_in_soft_puffs_and_rock_in_hard_chips_in_every_space() {
    for world in WORLDS {
        let mut script = format!("{world}\nset npcs off\nsettle\nwait 1\ntap Digit4\nprobe\n");
        for (kind, yaw) in [("snow", 40), ("rock", 160)] {
            let _ = write!(
                script,
                "set ground {kind}\naim {yaw} -35\npress RIGHT\nwait 1.2\nrelease RIGHT\nwait 6\n\
                 press LEFT\nwait 0.2\nrelease LEFT\nprobe\n"
            );
        }
        script += "wait 6\nprobe";
        let run = played(&script);
        let told = |n, what: &str| number(run.probe(n), &format!("particles.{what}"));
        assert_eq!(told(0, "alive"), 0.0, "{world}");
        // The ground beside what was built flies, too.
        let (clods, chips) = (told(1, "spray"), told(1, "chips"));
        assert!(clods > 4.0 && clods > 4.0 * chips, "{world}: {clods}");
        assert!(told(1, "dust") > 0.0, "{world}");
        let (clods, chips) = (told(2, "spray"), told(2, "chips"));
        assert!(chips > 8.0 && chips > 4.0 * clods, "{world}: {chips}");
        assert_eq!(told(3, "alive"), 0.0, "{world}: all is gone in the end");
    }
}

#[test]
fn a_car_leaves_prints_and_dust_on_sand_and_who_jumps_down_a_puff() {
    let begin = "new euclidean seed=6 generator=1\nset npcs off\nwait 2\n";
    let asked = played(&format!("{begin}probe"));
    let asked = asked.probe(0);
    let yaw = number(asked, "car.yaw").to_radians();
    let (left_x, left_z) = (yaw.sin(), -yaw.cos());
    let [x, y, z] = [0, 1, 2].map(|axis| number(asked, &format!("car.pos.{axis}")));
    let beside = format!("{} {} {}", x + 2.4 * left_x, y + 1.2, z + 2.4 * left_z);
    let [px, py, pz] = [0, 1, 2].map(|axis| number(asked, &format!("player.pos.{axis}")));
    let script = format!(
        "{begin}teleport {px} {} {pz}\nwait 1.4\nprobe\nteleport {beside}\nwait 3\nprobe\naim {} -20\n\
         tap KeyC\nwait 0.3\nhold KeyW 2\nprobe\nhold Space 3\nwait 31\nprobe",
        py + 6.0,
        (-left_z).atan2(-left_x).to_degrees()
    );
    let run = played(&script);
    let told = |n, what: &str| number(run.probe(n), what);
    assert!(told(0, "particles.dust") > 2.0, "it falls on its feet");
    assert_eq!(told(1, "particles.alive") + told(1, "marks.alive"), 0.0);
    assert!(told(2, "particles.dust") > 4.0 && told(2, "marks.alive") > 20.0);
    assert_eq!(told(3, "particles.alive") + told(3, "marks.alive"), 0.0);
}
