//! The maps on the adapter against golden rows: directions, normals, distances, and no step at zero.

use antipode_geometry::kernel::horizon::HorizonMap;
use antipode_geometry::kernel::raised::RaisedMap;
use antipode_geometry::shader::{HORIZON, RAISED};
use antipode_geometry::{
    Eye, Geometry, Horizon, HyperbolicMap, MapShader, Projection, SpaceUniform, picture,
};
use antipode_lab::compute::number_of;
use glam::{DVec3, DVec4};

use super::answers::answers;
use super::probes::Case;
use super::tables::{Worst, rows};

const KERNELS: &str = include_str!("../../../reference/kernels.json");

/// A uniform whose view is the identity: the map alone.
fn bare(radius_m: f64, kappa: f64, lift: [f64; 3]) -> SpaceUniform {
    let eye = Eye::default();
    let projection = Projection::new(1.2, 1.6, 0.05);
    let space = picture(Geometry::Euclidean, 1.0, HyperbolicMap::Raised, false);
    let [lift, lift_sine, lift_cosine] = lift.map(|x| x as f32);
    SpaceUniform {
        view: glam::Mat4::IDENTITY.to_cols_array_2d(),
        radius_m: radius_m as f32,
        kappa: kappa as f32,
        k_per_m: kappa.abs().sqrt() as f32,
        lift,
        lift_sine,
        lift_cosine,
        ..space.uniform(&eye, &projection)
    }
}

/// A map and its uniform.
type Mapped = (&'static MapShader, SpaceUniform);

fn raised(radius_m: f64, offset_m: f64) -> Mapped {
    let map = RaisedMap::new(radius_m, offset_m);
    let lift = [map.offset, map.sinh, map.cosh];
    (&RAISED, bare(radius_m, -map.k * map.k, lift))
}

fn horizon(kappa: f64, lift_m: f64) -> Mapped {
    let map = HorizonMap::new(kappa, lift_m);
    let lift = [lift_m, map.sin, map.cos];
    (&HORIZON, bare(map.radius_m, kappa, lift))
}

fn vector(row: &[f64]) -> DVec3 {
    DVec3::new(row[0], row[1], row[2])
}

fn case((map, space): Mapped, row: &[f64], n: DVec3) -> Case {
    Case {
        space,
        p: vector(row).as_vec3(),
        map: number_of(map),
        n: n.as_vec3(),
        pad: 0,
    }
}

/// The sight angle between two points, exact for small ones and any size.
fn angle(a: DVec3, b: DVec3) -> f64 {
    let unit = |v: DVec3| (v / v.abs().max_element()).normalize();
    let (a, b) = (unit(a), unit(b));
    2.0 * (a - b).length().atan2((a + b).length())
}

/// The directions of a map's golden rows within twenty radii, in radians.
fn directions(table: &str, space: fn(f64, f64) -> Mapped, radii: fn(&[f64]) -> f64, bar: f64) {
    let rows: Vec<_> = rows(KERNELS, table)
        .into_iter()
        .filter(|row| radii(row) <= 20.0)
        .collect();
    let cases: Vec<Case> = rows
        .iter()
        .map(|row| case(space(row[0], row[1]), &row[2..], DVec3::Y))
        .collect();
    let Some(answers) = answers(&cases) else {
        return;
    };
    let mut worst = Worst::default();
    for (row, answer) in rows.iter().zip(answers) {
        assert!(
            answer.view.is_finite() && answer.normal.is_finite(),
            "{row:?}"
        );
        let exact = vector(&row[5..]);
        if exact.length() < 1e-30 {
            continue;
        }
        // Rounding the offset centre's height moves what is near the eye by a part of the offset.
        worst.note(angle(answer.view.as_dvec4().truncate(), exact), row);
    }
    worst.check(&format!("{table}, rad"), bar);
}

fn raised_radii(row: &[f64]) -> f64 {
    vector(&row[2..]).length() / row[0]
}

fn horizon_radii(row: &[f64]) -> f64 {
    vector(&row[2..]).length() * row[0].abs().sqrt()
}

#[test]
fn sight_angles_of_golden_rows_hold_on_the_adapter() {
    directions("raised_port", raised, raised_radii, 5e-7);
    directions("horizon_port", horizon, horizon_radii, 5e-7);
}

#[test]
fn normals_of_golden_rows_hold_on_the_adapter() {
    for (table, space, radii) in [
        (
            "raised_normal",
            raised as fn(f64, f64) -> Mapped,
            raised_radii as fn(&[f64]) -> f64,
        ),
        ("horizon_normal", horizon, horizon_radii),
    ] {
        let rows = rows(KERNELS, table);
        let cases: Vec<Case> = rows
            .iter()
            .map(|row| case(space(row[0], row[1]), &row[2..], vector(&row[5..])))
            .collect();
        let Some(answers) = answers(&cases) else {
            return;
        };
        let mut worst = Worst::default();
        for (row, answer) in rows.iter().zip(answers) {
            // Across the ray a rounding is multiplied by sinh d / d.
            let d = radii(row) + row[1] / row[0].abs().max(1.0);
            let growth = if d > 1e-3 {
                (d.sinh() / d).min(1e12)
            } else {
                1.0
            };
            let off = (answer.normal.as_dvec3() - vector(&row[8..])).length() / growth;
            worst.note(off, row);
        }
        worst.check(&format!("{table}, rad over sinh d / d"), 3e-7);
    }
}

/// Points to twenty radii in every direction, with the map in f64 at the same inputs.
#[test]
fn the_horizon_maps_directions_hold_to_twenty_radii() {
    let mut cases = Vec::new();
    let mut exact = Vec::new();
    let mut state = 1_u64;
    let mut between = |low: f64, high: f64| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((state >> 11) as f64 / (1_u64 << 53) as f64)
    };
    for _ in 0..200_000 {
        let k = between(0.01, 0.25);
        let kappa = f64::from((-k * k) as f32);
        let v = DVec3::new(between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0))
            .normalize_or(DVec3::X);
        let p = (v * (10.0_f64.powf(between(-2.0, 20.0_f64.log10())) / k)).as_vec3();
        let row: Vec<f64> = p.to_array().map(f64::from).to_vec();
        let map = HorizonMap::new(kappa, 1.625);
        exact.push(DVec4::from_array(map.port([row[0], row[1], row[2]])));
        cases.push(case(horizon(kappa, 1.625), &row, DVec3::Y));
    }
    let Some(answers) = answers(&cases) else {
        return;
    };
    let mut worst = Worst::default();
    for ((answer, exact), case) in answers.iter().zip(exact).zip(&cases) {
        let at = case.p.as_dvec3().to_array();
        worst.note(
            angle(answer.view.as_dvec4().truncate(), exact.truncate()),
            &at,
        );
    }
    worst.check("horizon map's directions, rad", 5e-7);
}

#[test]
fn the_bend_through_zero_has_no_step_and_no_nan_on_the_adapter() {
    let points = [
        DVec3::new(3.0, -1.5, 0.5),
        DVec3::new(60.0, 9.0, 20.0),
        DVec3::ZERO,
        DVec3::new(0.0, 30.0, 0.0),
    ];
    let mut cases = Vec::new();
    for p in points {
        for exponent in -30..=-3 {
            for sign in [1.0, -1.0, 0.0] {
                let kappa = sign * 10.0_f64.powi(exponent).min(4e-4);
                cases.push(case(
                    horizon(kappa, 1.625),
                    &p.to_array(),
                    DVec3::new(0.6, 0.8, 0.0),
                ));
            }
        }
    }
    let Some(answers) = answers(&cases) else {
        return;
    };
    for (answer, case) in answers.iter().zip(&cases) {
        let kappa = f64::from(case.space.kappa).abs();
        assert!(
            answer.view.is_finite() && answer.normal.is_finite() && answer.distance.is_finite()
        );
        let size = case.p.as_dvec3().length();
        let moved = 3.0 * kappa * size * size * (size + 2.0) * (kappa.sqrt() * (size + 2.0)).exp();
        let gap = (answer.view.as_dvec4().truncate() - case.p.as_dvec3()).length();
        assert!(gap <= moved + 4e-7 * size, "{kappa} {}: {gap}", case.p);
        let away = (f64::from(answer.distance) - size).abs();
        assert!(away <= moved + 6e-7 * size, "{kappa} {}: {away}", case.p);
    }
    const { assert!(Horizon::BEND_DIAL.min < 0.0 && Horizon::BEND_DIAL.max > 0.0) };
}
