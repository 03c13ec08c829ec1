//! The section of the processor's figures.

use crate::speed::pareto::Group;
use crate::speed::{columns, culling, distance, moves, normals, port, view};
use crate::{Effort, Section};

/// Every group of variants, timed.
pub fn groups(effort: Effort) -> Vec<Group> {
    let mut groups = vec![
        port::exponential_group(effort),
        port::raised_group(effort),
        port::horizon_group(effort),
        port::sphere_group(effort),
        normals::hyperbolic_group(effort),
        normals::sphere_group(effort),
        view::group(effort),
        distance::hyperbolic_group(effort),
        distance::sphere_group(effort),
    ];
    groups.extend(moves::translation_groups(effort));
    groups.extend(moves::walk_groups(effort));
    groups
}

/// Nanoseconds per vertex and per instance on the processor beside the errors.
pub fn cpu_section(effort: Effort) -> Section {
    let mut groups = groups(effort);
    let (culling, wrong) = culling::groups(effort);
    groups.extend(culling);
    let (by_size, frames_plot) = columns::by_size();
    Section::new(
        "speed-cpu",
        "What accuracy costs on the processor",
        METHOD,
        groups.iter().map(Group::table).chain([wrong, by_size]),
    )
    .with(
        groups
            .iter()
            .map(Group::plot)
            .chain([frames_plot, view::by_distance()]),
    )
}

const METHOD: [&str; 2] = [
    "Each table's rivals handle the same batch in turns, interleaved in one run; a round's figure is the median of its turns, the one shown the least of several rounds. One input is worked on at a time: results are hidden from the optimiser, so nothing is computed four at once. Times compare with each other, not between machines.",
    "Errors are the worst over the same inputs against doubles or a closed form. A variant is on the frontier if no other is both as quick and as true and in one of the two better; times within five per cent count as equal, and a variant that answers with something that is no number counts as infinitely wrong.",
];
