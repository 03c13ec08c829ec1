//! The tools that dig and build: where they work, what they do to the ground, and what they may not do.

use antipode_geometry::ChartPoint;
use antipode_terrain::{Kind, Part, Stroke};
use glam::DVec3;

use crate::actions::Actions;
use crate::brush::LEAST_BUILT_M3;
use crate::crosshair::Crosshair;
use crate::door;
use crate::notice::Hint;
use crate::outbox::Outbox;
use crate::particles::Effect;
use crate::pick::Pick;
use crate::player::Player;
use crate::situation::Situation;
use crate::sound::SoundEvent;
use crate::tuning::{REACH_M, STEP_S};
use crate::world::World;
use antipode_items::Item;

/// What is built may not come nearer to the player's body than this below a roof, in metres.
const BODY_SLACK_M: f64 = 0.5;
/// Apart from each other, places above the head at which a roof is looked for, in metres.
const ROOF_STEP_M: f64 = 0.5;

/// Where a tool works.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ToolMark {
    pub point: ChartPoint,
    /// Whether there is ground within reach; else the place hangs in the air.
    pub hits: bool,
    /// Whether it is being used.
    pub active: bool,
    /// The height where the stroke began, metres.
    pub level_m: f64,
    /// The number of the press, from its beginning to the release.
    pub press: u64,
    /// Which way the press works.
    pub digs: bool,
    /// What the press builds of.
    pub kind: Option<Kind>,
}

/// Where the tool in hand would work: along the geodesic through the crosshair. An empty hand works nowhere.
pub(crate) fn mark(now: Situation<'_>) -> Option<ToolMark> {
    strength_in_hand(now)?;
    let Pick { point, hit, .. } = Crosshair::aimed(now).ground(REACH_M);
    let stroke = now.player.tool.filter(|before| before.active);
    Some(ToolMark {
        point,
        hits: hit,
        active: false,
        level_m: stroke.map_or(point.pos.y, |before| before.level_m),
        press: stroke.map_or(0, |before| before.press),
        digs: stroke.is_some_and(|before| before.digs),
        kind: built_kind(now, stroke.and_then(|before| before.kind)),
    })
}

/// What would be built of. In gathering worlds that is what is chosen; where nothing is, what there was most of when the press
/// began, and when that is used up what there is most of then.
fn built_kind(now: Situation<'_>, before: Option<Kind>) -> Option<Kind> {
    let chosen = now.player.brush.kind;
    let Some(stock) = now.world.streamer.stock() else {
        return chosen;
    };
    let goes_on = before.filter(|kind| has(now, *kind));
    let most = || stock.most().filter(|kind| has(now, *kind));
    chosen.or(goes_on).or_else(most)
}

/// Whether there is enough of a kind to build with.
fn has(now: Situation<'_>, kind: Kind) -> bool {
    let stock = now.world.streamer.stock();
    stock.is_some_and(|stock| stock.of(kind) >= LEAST_BUILT_M3)
}

/// Why a tool does nothing or little there, to be told when it is pressed, or when what is built has run out.
fn hindrance(now: Situation<'_>, mark: &ToolMark, digs: bool) -> Option<Hint> {
    let player = now.player;
    let is_new = !player.primary_before;
    if digs && is_new && !mark.hits {
        return Some(Hint::OutOfReach);
    }
    now.world.streamer.stock()?;
    if digs {
        let power = player.inventory.held().and_then(Item::power)?;
        let kind = is_new.then(|| now.world.ground.kind(mark.point))?;
        return (kind.hardness() > power).then_some(Hint::TooHard(kind));
    }
    let is_there = mark.kind.is_some_and(|kind| has(now, kind));
    let is_used_up = !is_there && !player.brush.shape.is_for_both();
    is_used_up.then_some(Hint::UsedUp(mark.kind))
}

/// What the tool in a free hand digs, per second.
pub(crate) fn strength_in_hand(now: Situation<'_>) -> Option<f32> {
    let held = now.player.inventory.held();
    let held = held.filter(|_| !now.actors.cars.is_driving());
    held.and_then(Item::brush_strength_per_s)
}

/// Marks where the tool in hand works and uses it there; returns the mark, and what that does to the ground: beyond a door on
/// the other side.
pub(crate) fn work(
    now: Situation<'_>,
    actions: &Actions,
    outbox: &mut Outbox,
) -> (Option<ToolMark>, Vec<Stroke>) {
    let sign = f32::from(i8::from(actions.primary) - i8::from(actions.secondary));
    let (mark, radius_m) = (mark(now), now.player.brush_radius_m);
    hear(now.world, mark, radius_m, sign, outbox);
    let (Some(mark), Some(strength), true) = (mark, strength_in_hand(now), sign != 0.0) else {
        return (mark, Vec::new());
    };
    let before = now.player.tool.filter(|before| before.active);
    let hint = hindrance(now, &mark, sign > 0.0);
    let is_used_up = matches!(hint, Some(Hint::UsedUp(_)));
    let was_told = is_used_up && before.is_none() && now.player.secondary_before;
    outbox.hints.extend(hint.filter(|_| !was_told));
    if is_used_up {
        return (Some(mark), Vec::new());
    }
    let digs = sign > 0.0 && !now.player.brush.shape.is_for_both();
    let amount = sign * strength * STEP_S as f32;
    let mut strokes = door::parted(now.world, stroke(now, &mark, amount));
    let all = strokes.len();
    strokes.retain(|stroke| digs || !would_immure(now, stroke.centre));
    if strokes.len() < all && !now.player.secondary_before {
        outbox.hints.push(Hint::InTheWay);
    }
    // Who digs has more and more of something, which ends no press.
    let is_same = |before: ToolMark| {
        let is_of_same = sign > 0.0 || before.kind == mark.kind;
        before.digs == (sign > 0.0) && is_of_same
    };
    let goes_on = before.is_some_and(is_same);
    let mark = ToolMark {
        active: true,
        press: if goes_on {
            mark.press
        } else {
            now.player.presses + 1
        },
        digs: sign > 0.0,
        ..mark
    };
    (Some(mark), strokes)
}

/// What a tool does where it is, by so much at its middle. In gathering worlds it is as strong as the tool in hand, and who
/// levels or smooths without any of the chosen kind moves what is there.
fn stroke(now: Situation<'_>, mark: &ToolMark, amount: f32) -> Stroke {
    let player = now.player;
    let gathers = now.world.streamer.stock().is_some();
    let builds = amount < 0.0 || player.brush.shape.is_for_both();
    let kind = mark.kind.filter(|_| builds);
    let kind = kind.filter(|kind| !gathers || has(now, *kind));
    let power = player.inventory.held().and_then(Item::power);
    Stroke {
        centre: mark.point,
        radius_m: player.brush_radius_m,
        amount,
        part: Part::Whole,
        kind,
        shape: player.brush.shape.of_stroke(mark.level_m),
        power: power.filter(|_| gathers),
    }
}

/// Tells what a tool did in a step: `sign` is 1 for digging, -1 for building and 0 for rest.
fn hear(world: &World, mark: Option<ToolMark>, radius_m: f64, sign: f32, outbox: &mut Outbox) {
    let mark = mark.filter(|_| sign != 0.0);
    if !outbox.sounds.stroke_is_due(mark.is_some(), STEP_S) {
        return;
    }
    let Some(mark) = mark else { return };
    // In the open air, and deep in rock that is built on, nothing changes that could be heard.
    if f64::from(world.ground.density(mark.point)).abs() > radius_m {
        return;
    }
    let at = mark.point;
    if sign > 0.0 {
        let cover = world.ground.cover(at);
        outbox.sounds.push(SoundEvent::Dug { cover });
        outbox.effects.push(Effect::Dug { at, radius_m });
    } else {
        outbox.sounds.push(SoundEvent::Built);
        outbox.effects.push(Effect::Built { at, radius_m });
    }
}

/// Whether building there would fill the place of the player's body under a roof. In the open it is lifted by what
/// is built; here the nearest free place is on top of the hill.
fn would_immure(now: Situation<'_>, centre: ChartPoint) -> bool {
    let Player {
        flying,
        brush_radius_m,
        ..
    } = *now.player;
    if flying || now.actors.cars.is_driving() {
        return false;
    }
    let tuning = &now.actors.tuning;
    let feet = now.feet();
    let middle = feet.moved(DVec3::Y * (0.5 * tuning.height_m));
    let reach_m = brush_radius_m + 0.5 * tuning.height_m + BODY_SLACK_M;
    if now.world.strategy.distance_m(middle, centre, &now.head()) > reach_m {
        return false;
    }
    let steps = (brush_radius_m / ROOF_STEP_M).ceil() as u32;
    let above = |step| tuning.height_m + f64::from(step) * ROOF_STEP_M;
    (0..=steps).any(|step| {
        let at = feet.moved(DVec3::Y * above(step));
        now.world.ground.is_solid(at)
    })
}
