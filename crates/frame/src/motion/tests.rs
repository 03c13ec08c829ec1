//! Which clip a body is in, and how one goes over into the next.
use super::*;

const DT_S: f64 = 1.0 / 60.0;

fn going(ahead: f64, right: f64) -> Doing {
    Doing {
        way: DVec2::new(ahead, right),
        grounded: true,
        ..Doing::default()
    }
}

/// Lets steps pass; returns how often a foot came down.
fn passed(motion: &mut Motion, doing: &Doing, seconds: f64) -> usize {
    let steps = (seconds / DT_S).round() as usize;
    (0..steps).filter(|_| motion.pass(doing, DT_S)).count()
}

fn leading(motion: &Motion) -> Clip {
    let posture = motion.posture();
    let by_share = |a: &Clip, b: &Clip| posture.share(*a).total_cmp(&posture.share(*b));
    Clip::WHOLE
        .into_iter()
        .max_by(by_share)
        .unwrap_or(Clip::Idle)
}

#[test]
fn what_a_body_does_chooses_its_clip() {
    let cases = [
        (going(0.0, 0.0), Clip::Idle),
        (going(1.4, 0.0), Clip::Walk),
        (going(4.5, 0.0), Clip::Run),
        (going(0.0, 7.6), Clip::Run),
        (
            Doing {
                grounded: false,
                ..going(1.0, 0.0)
            },
            Clip::Jump,
        ),
        (
            Doing {
                grounded: false,
                rise_m_s: -12.0,
                ..going(0.0, 0.0)
            },
            Clip::Fall,
        ),
        (
            Doing {
                flying: true,
                ..going(8.0, 0.0)
            },
            Clip::Jump,
        ),
        (
            Doing {
                dead: true,
                ..going(0.0, 0.0)
            },
            Clip::Die,
        ),
    ];
    for (doing, clip) in cases {
        let mut motion = Motion::default();
        passed(&mut motion, &doing, 1.0);
        assert_eq!(leading(&motion), clip, "{doing:?}");
        assert!(
            (motion.posture().share(clip) - 1.0).abs() < 1e-6,
            "{doing:?}"
        );
        passed(&mut motion, &going(0.0, 0.0), 1.0);
        assert_eq!(leading(&motion), Clip::Idle, "back from {doing:?}");
    }
}

#[test]
fn the_feet_go_by_the_ground_covered_and_each_comes_down_once_a_cycle() {
    for (speed_m_s, stride_m) in [
        (1.4, WALK_STRIDE_M),
        (4.5, RUN_STRIDE_M),
        (7.65, RUN_STRIDE_M),
    ] {
        let mut motion = Motion::default();
        let feet = passed(&mut motion, &going(speed_m_s, 0.0), 10.0);
        let cycles = 10.0 * speed_m_s / stride_m;
        assert!(
            (motion.cycles() - cycles).abs() < 1e-6,
            "{speed_m_s}: {}",
            motion.cycles()
        );
        assert_eq!(feet, (2.0 * cycles).floor() as usize, "{speed_m_s}");
        let cycle = f64::from(motion.posture().moment(Clip::Run));
        assert!((cycle - motion.cycles().fract()).abs() < 1e-5);
    }
    let mut motion = Motion::default();
    let in_air = Doing {
        grounded: false,
        ..going(4.0, 0.0)
    };
    assert_eq!(passed(&mut motion, &in_air, 2.0), 0);
    assert_eq!(passed(&mut motion, &going(0.1, 0.0), 2.0), 0);
}

#[test]
fn backwards_the_feet_go_back_and_aside_the_legs_turn() {
    let mut motion = Motion::default();
    passed(&mut motion, &going(-4.5, 0.0), 1.0);
    assert!(motion.cycles() < -1.5 && motion.posture().twist_rad.abs() < 1e-6);
    let mut motion = Motion::default();
    passed(&mut motion, &going(4.5, 4.5), 1.0);
    let eighth = std::f32::consts::FRAC_PI_4;
    assert!((motion.posture().twist_rad - eighth).abs() < 1e-3);
    passed(&mut motion, &going(-4.5, 4.5), 1.0);
    assert!(
        (motion.posture().twist_rad + eighth).abs() < 1e-3,
        "and back to the right"
    );
}

#[test]
fn clips_fade_into_each_other_without_a_jump() {
    let mut motion = Motion::default();
    let mut doing = going(4.5, 0.0);
    let mut last = motion.posture();
    for step in 0..240 {
        match step {
            60 => {
                doing = Doing {
                    grounded: false,
                    rise_m_s: 4.8,
                    ..doing
                }
            }
            120 => {
                doing = Doing {
                    impact_m_s: 4.8,
                    ..going(4.5, 0.0)
                }
            }
            121 => doing = going(0.0, 0.0),
            180 => {
                doing = Doing {
                    dead: true,
                    ..doing
                }
            }
            _ => {}
        }
        motion.pass(&doing, DT_S);
        let now = motion.posture();
        for clip in Clip::ALL {
            let change = (now.share(clip) - last.share(clip)).abs();
            assert!(change < 0.3, "{step} {clip:?}: {change}");
            let moved = (now.moment(clip) - last.moment(clip)).abs();
            let is_seen = last.share(clip) > 0.0 && now.share(clip) > 0.0;
            let wraps = moved > 0.9 && matches!(clip, Clip::Walk | Clip::Run);
            assert!(!is_seen || wraps || moved < 0.05, "{step} {clip:?} {moved}");
        }
        let whole: f32 = Clip::WHOLE.into_iter().map(|clip| now.share(clip)).sum();
        assert!(whole > 0.3, "{step}: something always moves the body");
        last = now;
    }
    assert_eq!(leading(&motion), Clip::Die);
}

#[test]
fn a_landing_bends_the_knees_for_a_moment() {
    let mut motion = Motion::default();
    let landed = Doing {
        impact_m_s: 6.0,
        ..going(0.0, 0.0)
    };
    motion.pass(&landed, DT_S);
    passed(&mut motion, &going(0.0, 0.0), 0.1);
    assert!(motion.posture().share(Clip::Land) > 0.4);
    passed(&mut motion, &going(0.0, 0.0), 0.5);
    assert_eq!(motion.posture().share(Clip::Land), 0.0);
}

#[test]
fn a_hit_comes_and_goes_and_what_is_held_is_held() {
    let mut motion = Motion::default();
    let stands = Doing {
        holds: true,
        ..going(0.0, 0.0)
    };
    passed(&mut motion, &stands, 0.5);
    assert_eq!(motion.posture().share(Clip::Hold), 1.0);
    assert_eq!(motion.posture().share(Clip::Hit), 0.0, "nobody was hit yet");
    motion.strike();
    passed(&mut motion, &stands, 0.15);
    assert_eq!(motion.posture().share(Clip::Hit), 1.0);
    passed(&mut motion, &stands, 0.5);
    assert_eq!(motion.posture().share(Clip::Hit), 0.0);
    passed(&mut motion, &going(0.0, 0.0), 0.5);
    assert_eq!(motion.posture().share(Clip::Hold), 0.0);
}
