//! What a batch of strokes moves, told by the kinds of ground, and the way back from a press.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::sync::Arc;

use antipode_geometry::{ChartPoint, ChunkCoord, Metric};
use antipode_terrain::{Earth, Moved, Owners, Stock, changed_cells};
use glam::{DVec3, IVec3};

use crate::api::NotUndone;
use crate::edit_store::Change;
use crate::shared::Shared;

/// What these changes have dug and built.
pub(crate) fn earth(shared: &Shared, changed: &[Change], problems: &mut Vec<String>) -> Earth {
    let visible = changed.iter().filter(|change| change.visible);
    let states = visible.map(|change| (change.coord, &*change.before, &*change.edits));
    let new: BTreeMap<_, _> = changed
        .iter()
        .map(|change| (change.coord, change))
        .collect();
    let share = |at| volume_share(&*shared.strategy, at);
    let mut sum = Earth::default();
    for (coord, cells) in changed_cells(states) {
        let stored = shared.edit_store.snapshot(coord, problems);
        let owner = |n: usize| {
            let offset = IVec3::new((n & 1) as i32, (n >> 1 & 1) as i32, (n >> 2) as i32);
            ChunkCoord {
                chart: coord.chart,
                index: coord.index.saturating_add(offset),
            }
        };
        let owners = |after: bool| -> Owners {
            std::array::from_fn(|n| match new.get(&owner(n)) {
                Some(change) if after => Some(Arc::clone(&change.edits)),
                Some(change) => Some(Arc::clone(&change.before)),
                None => stored.of(owner(n)),
            })
        };
        let moved = Moved {
            field: &shared.field,
            coord,
            base: &shared.base(coord, true),
            before: owners(false),
            after: owners(true),
        };
        sum.add(&moved.earth(&cells, &share));
    }
    sum
}

/// How many cubic metres of the space a cubic metre of the chart is at a place: the box of what the chart's axes become.
fn volume_share(metric: &dyn Metric, at: ChartPoint) -> f64 {
    let [x, y, z] = DVec3::AXES.map(|axis| metric.in_frame(at, axis));
    x.dot(y.cross(z)).abs()
}

/// The changes that undo a press, what it had moved, and what of it had been gathered.
pub(crate) fn undo(
    shared: &Shared,
    press: u64,
    stock: Option<&Stock>,
    problems: &mut Vec<String>,
) -> Result<(Vec<Change>, Earth, Stock), NotUndone> {
    let mut done = shared.history.take(press).ok_or(NotUndone::NoneLeft)?;
    if stock.is_some_and(|stock| !stock.allows(&done.gathered.negative())) {
        shared.history.put_back(press, done);
        return Err(NotUndone::Spent);
    }
    let mut changes: BTreeMap<ChunkCoord, Change> = BTreeMap::new();
    let mut end = Ok(());
    for (coord, layer) in done.back() {
        let change = match changes.entry(coord) {
            Entry::Occupied(known) => known.into_mut(),
            Entry::Vacant(new) => {
                let Some(before) = shared.edit_store.edits(coord, problems) else {
                    end = Err(NotUndone::Unreadable);
                    break;
                };
                new.insert(Change::of(coord, before))
            }
        };
        change.visible = true;
        if !change.edits_mut().take_back(layer) {
            end = Err(NotUndone::Changed);
            break;
        }
    }
    match end {
        Ok(()) => Ok((changes.into_values().collect(), done.earth, done.gathered)),
        Err(why) => {
            if why == NotUndone::Unreadable {
                shared.history.put_back(press, done);
            }
            Err(why)
        }
    }
}
