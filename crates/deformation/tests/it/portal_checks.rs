//! Portals that are refused, and in which words.

use antipode_deformation::{MAX_PORTALS, Portal, Sides, Space};
use glam::{DQuat, DVec2, DVec3};

use crate::common::{boxed, portal, v};

fn pair() -> Vec<Portal> {
    vec![
        portal("one", DVec3::ZERO, 0.0, 1),
        portal("other", v(50.0, 0.0, 0.0), 90.0, 0),
    ]
}

fn refusal(portals: Vec<Portal>) -> String {
    Space::with_portals(Vec::new(), portals)
        .err()
        .map(|it| it.to_string())
        .unwrap_or_default()
}

fn with(change: impl Fn(&mut [Portal])) -> String {
    let mut portals = pair();
    change(&mut portals);
    refusal(portals)
}

#[test]
fn a_sound_pair_is_taken() {
    assert_eq!(refusal(pair()), "");
}

#[test]
fn polygons_have_to_be_convex() {
    let of = |corners: &[(f64, f64)]| {
        let polygon: Vec<_> = corners.iter().map(|(a, b)| DVec2::new(*a, *b)).collect();
        with(|it| it[0].polygon.clone_from(&polygon))
    };
    let arrow = [(0.0, 0.0), (2.0, -1.0), (1.0, 0.0), (2.0, 1.0)];
    assert!(
        of(&arrow).contains("\"one\" is not convex"),
        "{}",
        of(&arrow)
    );
    assert!(of(&[(0.0, 0.0), (1.0, 0.0)]).contains("fewer than three"));
    let star: Vec<_> = (0..5)
        .map(|i| (f64::from(i) * 2.0 * 72f64.to_radians()).sin_cos())
        .collect();
    assert!(of(&star).contains("crosses itself"), "{}", of(&star));
    let round: Vec<_> = (0..17)
        .map(|i| (f64::from(i) / 17.0 * std::f64::consts::TAU).sin_cos())
        .collect();
    assert!(of(&round).contains("more than sixteen"));
    assert!(of(&[(0.0, 0.0), (f64::NAN, 0.0), (0.0, 1.0)]).contains("no number"));
}

#[test]
fn partners_have_to_lead_back_and_to_be_alike() {
    assert!(with(|it| it[0].to = 5).contains("\"one\" leads to none"));
    assert!(with(|it| it[1].to = 1).contains("\"other\", which does not lead back"));
    assert!(with(|it| it[1].two_sided = true).contains("one has two sides"));
    let longer = |it: &mut [Portal]| it[1].polygon = Portal::rectangle(DVec2::new(2.0, 3.0));
    assert!(with(longer).contains("do not feel similar"));
    let skewed = vec![
        DVec2::new(0.0, 0.0),
        DVec2::new(2.0, 0.0),
        DVec2::new(2.0, 1.0),
        DVec2::new(0.0, 2.0),
    ];
    // Of one that is not its own mirror image the partner is the mirror image.
    let same = |it: &mut [Portal]| {
        it[0].polygon.clone_from(&skewed);
        it[1].polygon.clone_from(&skewed);
    };
    assert!(with(same).contains("mirror image"));
    let mirrored: Vec<_> = skewed.iter().map(|it| DVec2::new(-it.x, it.y)).collect();
    let image = |it: &mut [Portal]| {
        it[0].polygon.clone_from(&skewed);
        it[1].polygon.clone_from(&mirrored);
    };
    assert_eq!(with(image), "");
    let huge = |it: &mut [Portal]| it[1].polygon = Portal::rectangle(DVec2::splat(66.0));
    assert!(with(huge).contains("more than 32 times"));
}

#[test]
fn stretches_count_for_what_feels_similar() {
    let stretched = boxed(
        "box",
        v(50.0, 0.0, 0.0),
        DVec3::splat(5.0),
        v(1.0, 3.0, 1.0),
        Sides::Soft,
    );
    let space = |portals| Space::with_portals(vec![stretched.clone()], portals);
    assert!(space(pair()).is_err());
    let mut fitting = pair();
    fitting[0].polygon = Portal::rectangle(DVec2::new(2.0, 6.0));
    let space = space(fitting).unwrap();
    assert!((space.portals()[0].scale - 1.0).abs() < 1e-12);
}

#[test]
fn portals_keep_off_each_other_and_off_sides_of_boxes() {
    let near = |x: f64| {
        let mut four = pair();
        four.push(portal("third", v(x, 0.5, 0.0), 0.0, 3));
        four.push(portal("fourth", v(80.0, 0.0, 0.0), 0.0, 2));
        refusal(four)
    };
    assert!(near(0.0).contains("\"one\" and \"third\" touch or overlap"));
    assert_eq!(near(0.002), "");
    let boxed_at = |x: f64, sides: Sides| {
        let one = boxed(
            "box",
            v(x, 0.0, 0.0),
            DVec3::splat(3.0),
            DVec3::splat(2.0),
            sides,
        );
        let made = Space::with_portals(vec![one], pair());
        made.err().map(|it| it.to_string()).unwrap_or_default()
    };
    assert!(boxed_at(3.0, Sides::Soft).contains("overlaps a side of the aberration \"box\""));
    assert_eq!(boxed_at(3.002, Sides::Soft), "");
    let legacy = Sides::Legacy(antipode_deformation::Exit::None);
    assert!(boxed_at(0.0, legacy).contains("thesis"));
    let many = (0..=MAX_PORTALS).map(|i| portal("p", v(10.0 * i as f64, 0.0, 0.0), 0.0, i));
    assert!(refusal(many.collect()).contains("there may be 64"));
    let twisted = |it: &mut [Portal]| it[0].turn = DQuat::from_xyzw(0.0, 0.0, 0.0, 2.0);
    assert!(with(twisted).contains("turn"));
}
