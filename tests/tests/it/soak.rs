//! A player who does everything that there is to do, for a long while: a minute in each space, or as many as
//! `ANTIPODE_TEST_SOAK_MINUTES` says.

use std::fmt::Write as _;

use antipode_tests::program::{field, number, run};
use serde_json::Value;

const SPACES: [&str; 3] = ["euclidean", "hyperbolic", "spherical"];
const MINUTES: &str = "ANTIPODE_TEST_SOAK_MINUTES";
/// Most that memory may grow from a third of a long run to its end, MB.
const GROWTH_MB: f64 = 60.0;
/// How fast somebody walks, and how far from a car's middle he stops, beside it.
const WALK_M_S: f64 = 4.5;
const BESIDE_M: f64 = 2.5;

fn minutes() -> usize {
    let asked = std::env::var(MINUTES).ok();
    asked.and_then(|text| text.parse().ok()).unwrap_or(1)
}

/// Where a player of a world begins, and the car that stands near.
struct Start {
    feet: [f64; 3],
    car: [f64; 3],
}

impl Start {
    fn of(world: &str) -> Self {
        let saves = tempfile::tempdir().unwrap();
        let run = run(saves.path(), &format!("{world}\nwait 1\nprobe"));
        let pos = |path: &str| [0, 1, 2].map(|n| number(run.probe(0), &format!("{path}.{n}")));
        Self {
            feet: pos("player.pos"),
            car: pos("car.pos"),
        }
    }

    /// The way to the car, up to its side.
    fn approach(&self) -> String {
        let [x, z] = [0, 2].map(|n| self.car[n] - self.feet[n]);
        let heading = z.atan2(x).to_degrees();
        let seconds = (x.hypot(z) - BESIDE_M).max(0.0) / WALK_M_S;
        format!("aim {heading} -5\nhold KeyW {seconds}\n")
    }

    /// Every fourth minute begins at the start, beside a new car.
    fn again(&self) -> String {
        let [x, y, z] = self.feet;
        let (y, beside, over) = (y + 1.0, x + 3.0, y + 2.0);
        format!("teleport {x} {y} {z} A\nspawn car {beside} {over} {z} A\nwait 2\n")
    }
}

/// About a minute of play, each another way: the car if one is near, walks, leaps, digs, builds, shots, lamps, pictures
/// and talk. Where no car is near, its keys walk.
fn minute(start: &Start, number: usize) -> String {
    let way = (number * 137) % 360;
    let mut script = String::new();
    if number % 4 == 3 {
        script += &start.again();
    }
    if number % 5 == 4 {
        script += "give bullet 40\ngive lamp 4\n";
    }
    for turn in 0..8 {
        writeln!(script, "aim {} -12\ntap KeyC", turn * 45).unwrap();
    }
    script += "wait 0.3\ntap KeyF\nwait 1.5\nprobe\nhold KeyW 6\ndown KeyD\nhold KeyW 2\nup KeyD\ntap KeyG\n\
               down ShiftLeft\nhold KeyW 4\nup ShiftLeft\nhold Space 1\ndown KeyA\nhold KeyS 2\nup KeyA\ntap KeyY\n\
               tap Tab\nwait 0.2\ntap Tab\nhold KeyW 6\nhold Space 2\ntap KeyL\nwait 0.5\n";
    write!(
        script,
        "aim {way} -8\ndown ShiftLeft\nhold KeyW 1\nhold KeyS 1\nup ShiftLeft\ntap Space\nwait 0.8\n\
         tap Digit4\naim {way} -45\nhold LEFT 1.5\nlook 300 0\nhold RIGHT 1\ntap ArrowUp\ntap ArrowDown\n\
         tap Digit1\naim {aside} 2\nclick LEFT\nwait 0.4\nclick LEFT\nwait 0.4\nlook 900 40\nclick LEFT\nwait 0.4\n\
         tap Digit6\naim {way} -30\nclick LEFT\nwait 0.3\nclick RIGHT\nwait 0.2\nlook 200 0\nclick LEFT\n\
         scroll 1\nwait 0.4\nscroll -1\ntap KeyH\nwait 0.5\ntap KeyH\nwait 0.3\n\
         tap KeyY\ntap KeyT\ntap Tab\nhold KeyA 1\ntap Tab\ntap F1\ntap F1\ntap F3\ntap F4\nwait 0.2\ntap F3\ntap F4\n\
         tap Digit2\ntap KeyQ\nwait 0.2\ntap KeyE\nwait 0.2\ntap KeyE\nwait 8\nprobe\n",
        aside = way + 60,
    )
    .unwrap();
    script
}

fn is_finite(value: &Value) -> bool {
    match value {
        Value::Number(number) => number.as_f64().is_some_and(f64::is_finite),
        Value::Array(parts) => parts.iter().all(is_finite),
        _ => false,
    }
}

/// Whatever a player may have come to, this holds.
fn is_sane(probe: &Value) {
    for path in ["player.pos", "player.vel", "camera.pos", "camera.curved"] {
        assert!(is_finite(field(probe, path)), "{path}: {probe}");
    }
    let health = number(probe, "player.health");
    assert!((0.0..=20.0).contains(&health), "{health}");
    if let Some(ground_y) = field(probe, "terrain.ground_height").as_f64() {
        let feet_y = number(probe, "player.pos.1");
        assert!(
            feet_y > ground_y - 3.0,
            "{feet_y} under {ground_y}: {probe}"
        );
    }
    for bot in field(probe, "bots").as_array().unwrap() {
        assert!(
            is_finite(&bot["pos"]) && bot["pos"][1].as_f64().unwrap() > -200.0,
            "{bot}"
        );
    }
    if let Some(car) = field(probe, "car").as_object() {
        assert!(
            is_finite(&car["pos"]) && car["pos"][1].as_f64().unwrap() > -200.0,
            "{car:?}"
        );
    }
    assert!(field(probe, "projectiles").as_array().unwrap().len() <= 500);
}

#[test]
fn a_player_who_does_everything_meets_no_error() {
    let minutes = minutes();
    for space in SPACES {
        let saves = tempfile::tempdir().unwrap();
        let start = Start::of(&format!("new {space} seed=5"));
        let played: String = (0..minutes).map(|n| minute(&start, n)).collect();
        let approach = start.approach();
        let script = format!("new {space} seed=5 name=Soak\nwait 1\n{approach}{played}save\n");
        let run = run(saves.path(), &script);
        assert_eq!((run.status, run.stderr.as_str()), (Some(0), ""), "{space}");
        assert_eq!(run.lines.len(), 2 * minutes);
        run.lines.iter().for_each(is_sane);
        assert_eq!(field(&run.lines[0], "player.in_car"), true, "{space}");
        let memory_mb = |minute: usize| number(&run.lines[2 * minute + 1], "memory_mb");
        let (early, late) = (memory_mb(minutes / 3), memory_mb(minutes - 1));
        eprintln!("{space}: {minutes} min, memory from {early} to {late} MB");
        assert!(late < early + GROWTH_MB, "{space}: {early} to {late} MB");
    }
}
