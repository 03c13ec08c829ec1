//! The numbers of many beginnings, printed.

use std::time::Instant;

use super::*;

fn sorted(mut all: Vec<f64>) -> Vec<f64> {
    all.sort_by(f64::total_cmp);
    all
}

#[test]
#[ignore = "prints the numbers of many beginnings; takes minutes"]
fn print_many_beginnings() {
    for (geometry, radius_m) in [
        (Geometry::Euclidean, f64::INFINITY),
        (Geometry::Hyperbolic, 20.0),
        (Geometry::Spherical, 32.0),
        (Geometry::Spherical, 256.0),
    ] {
        for generator in Generator::ALL {
            let (mut columns, mut far, mut high, mut ms) = (vec![], vec![], vec![], vec![]);
            let mut lacks = vec![];
            for seed in 0..SEEDS {
                let world = World::made_by(generator, geometry, radius_m, seed);
                let begun = Instant::now();
                let start = world.start();
                ms.push(begun.elapsed().as_secs_f64() * 1e3);
                columns.push(far_columns(&world, &start) as f64);
                let of_columns = [-0.8, -0.4, 0.0, 0.4, 0.8].map(|x| {
                    let rows = (-6..=8).map(|y| 0.1 * f64::from(y));
                    let met = rows.filter_map(|y| met_m(&world, &start, DVec2::new(x, y)));
                    met.fold(0.0, f64::max)
                });
                let of_columns = sorted(of_columns.to_vec());
                far.push(of_columns[2]);
                high.push(higher_m(&world, &start));
                lacks.extend(start.car.is_none().then_some((seed, "car")));
                lacks.extend(start.figure.is_none().then_some((seed, "figure")));
            }
            println!("== {geometry} {radius_m} generator {}", generator.number());
            for (what, all) in [
                ("columns", columns),
                ("far m", far),
                ("higher m", high),
                ("ms", ms),
            ] {
                let all = sorted(all);
                let at = |share: f64| all[((all.len() - 1) as f64 * share) as usize];
                let mean = all.iter().sum::<f64>() / all.len() as f64;
                println!(
                    "{what}: least {:.1} 10% {:.1} median {:.1} most {:.1} mean {mean:.1}",
                    at(0.0),
                    at(0.1),
                    at(0.5),
                    at(1.0),
                );
            }
            println!("lacks {lacks:?}");
        }
    }
}
