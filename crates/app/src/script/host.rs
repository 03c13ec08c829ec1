//! Carrying orders out: one way for scripts, which wait for each, and for the console, which never waits.

use antipode_geometry::{Atlas, ChartPoint, Domain};
use antipode_room_scene::RoomScene;
use antipode_scene::tuning::VIEW_DISTANCE_CHUNKS;
use antipode_scene::{Item, Kind, Recipe, Scene};
use antipode_settings::Value;
use glam::{DVec3, Vec3Swizzles};

use super::in_room::obey_in_room;
use super::parse::{Order, Setting, Spawned};
use crate::bindings::Input;
use crate::controls::Controls;
use crate::failure::Failure;
use crate::session::Worlds;

/// How far past its rim a hemisphere's chart may still be named, in metres.
const RIM_SLACK_M: f64 = 1.0;
/// Strokes that one order undoes at most; so many are kept.
const MOST_UNDONE: u32 = 20;

/// Where orders are carried out.
pub trait Host {
    /// The open world.
    ///
    /// # Errors
    /// When none is open.
    fn scene(&mut self) -> Result<&mut Scene, Failure>;

    /// The open room, if one is.
    fn room(&mut self) -> Option<&mut RoomScene>;

    /// The saved worlds.
    fn worlds(&mut self) -> &mut Worlds;

    /// What is held and turned.
    fn controls(&mut self) -> &mut Controls;

    /// Directory of the open world's save; none where no world is open, or it is not kept.
    fn open_slug(&self) -> Option<&str>;

    /// Gives one of the player's own settings a value that it takes.
    fn set_own(&mut self, id: &'static str, value: Value);

    /// Presses an input, and does what it asks of the game around the world.
    fn press(&mut self, input: Input);

    /// Lets what was pressed or turned act, where time does not pass by itself.
    ///
    /// # Errors
    /// When the world cannot go on.
    fn step(&mut self) -> Result<(), Failure>;

    /// Waits for the land around a player who was moved, where that does not come by itself.
    ///
    /// # Errors
    /// When it does not come.
    fn arrive(&mut self) -> Result<(), Failure>;

    /// Orders that are each host's own: those about worlds, time, pictures and what is printed.
    ///
    /// # Errors
    /// When the order cannot be carried out.
    fn own(&mut self, order: &Order) -> Result<(), Failure>;
}

/// Carries an order out, and marks the world if it cheats.
///
/// # Errors
/// When it asks for what is not there, in words, or something fails on the way.
pub fn obey<H: Host + ?Sized>(host: &mut H, order: &Order) -> Result<(), Failure> {
    if let Some(done) = host.room().and_then(|room| obey_in_room(room, order)) {
        return done;
    }
    match order {
        Order::Delete(name) => delete(host, name),
        Order::Press(input, is_down) => {
            press(host, *input, *is_down);
            Ok(())
        }
        Order::Tap(input) => tap(host, *input),
        Order::Look(dx, dy) => {
            host.controls().motion(*dx, *dy);
            host.step()
        }
        Order::Aim(yaw, pitch) => {
            host.scene()?.aim(yaw.to_radians(), pitch.to_radians());
            Ok(())
        }
        Order::Scroll(notches) => {
            let has_dial = host.scene()?.lens().range().is_some();
            host.controls().wheel(*notches, has_dial);
            host.step()
        }
        Order::Set(setting) => set(host, *setting),
        Order::Give(item, count) => {
            let left = host.scene()?.inventory_mut().give(*item, *count);
            possible(left == 0, "there is no room for all of them")
        }
        Order::GiveGround(kind, m3) => give_ground(host.scene()?, *kind, *m3),
        Order::Make(item) => make(host.scene()?, *item),
        Order::NameFlag(name) => name_nearest_flag(host, name),
        Order::Teleport(place, chart) => {
            teleport(host, ChartPoint::new(*chart, DVec3::from_array(*place)))
        }
        Order::Spawn(spawned, place, chart) => spawn(
            host,
            *spawned,
            ChartPoint::new(*chart, DVec3::from_array(*place)),
        ),
        Order::Edit(words) if undoes(words) && host.room().is_none() => undo(host, words),
        Order::New(_)
        | Order::Load(_)
        | Order::Save
        | Order::List
        | Order::Quit
        | Order::Hold(..)
        | Order::Wait(_)
        | Order::Settle(_)
        | Order::Probe
        | Order::Shot(_)
        | Order::Perf(_)
        | Order::Room(_)
        | Order::Edit(_) => host.own(order),
    }?;
    if order.cheats() {
        host.scene()?.mark_cheated();
    }
    Ok(())
}

/// Whether the words of an order take back what was done last.
fn give_ground(scene: &mut Scene, kind: Kind, m3: f64) -> Result<(), Failure> {
    let is_given = scene.give_ground(kind, m3);
    possible(is_given, "nothing is gathered in a creative world")
}

fn make(scene: &mut Scene, item: Item) -> Result<(), Failure> {
    let gathers = scene.stock().is_some();
    possible(gathers, "nothing is made in a creative world")?;
    let is_made = Recipe::of(item).iter().any(|recipe| scene.make(recipe));
    possible(
        is_made,
        "there is not enough ground of the kinds that it takes",
    )
}

fn undoes(words: &[String]) -> bool {
    words.first().is_some_and(|name| name == "undo")
}

/// Takes back the last strokes of a world, as many as the words say.
fn undo<H: Host + ?Sized>(host: &mut H, words: &[String]) -> Result<(), Failure> {
    let count = words.get(1).map_or(Ok(1), |it| it.parse::<u32>());
    let count =
        count.map_err(|_| Failure::Usage(format!("\"{}\" is no number of strokes", words[1])))?;
    for _ in 0..count.min(MOST_UNDONE) {
        host.scene()?.undo_stroke();
        host.step()?;
    }
    Ok(())
}

fn press<H: Host + ?Sized>(host: &mut H, input: Input, is_down: bool) {
    if is_down {
        host.press(input);
    } else {
        host.controls().input(input, false);
    }
}

fn name_nearest_flag<H: Host + ?Sized>(host: &mut H, name: &str) -> Result<(), Failure> {
    let scene = host.scene()?;
    let flags = scene.flag_ways().into_iter();
    let nearest = flags.min_by(|a, b| a.distance_m.total_cmp(&b.distance_m));
    let is_named = nearest.is_some_and(|flag| scene.name_flag(flag.id, name));
    possible(is_named, "there is no flag")
}

fn tap<H: Host + ?Sized>(host: &mut H, input: Input) -> Result<(), Failure> {
    host.press(input);
    host.step()?;
    host.controls().input(input, false);
    Ok(())
}

fn delete<H: Host + ?Sized>(host: &mut H, name: &str) -> Result<(), Failure> {
    let slug = host.worlds().saves().find(name)?.slug;
    if host.open_slug() == Some(&slug) {
        return Err(Failure::Usage(format!(
            "\"{name}\" is open and cannot be deleted"
        )));
    }
    Ok(host.worlds().saves().delete(&slug)?)
}

fn set<H: Host + ?Sized>(host: &mut H, setting: Setting) -> Result<(), Failure> {
    if let Setting::Own(id, value) = setting {
        host.set_own(id, value);
        return Ok(());
    }
    if let (Setting::Quality(quality), true) = (setting, host.room().is_some()) {
        host.worlds().set_quality(quality);
        return Ok(());
    }
    let scene = host.scene()?;
    match setting {
        Setting::Time(time_s) => scene.set_time_of_day_s(time_s),
        Setting::Curvature(value) => possible(
            scene.set_curvature(value),
            "this space has no curvature dial",
        )?,
        Setting::Map(map) => possible(scene.set_map(map), "this space has no other map")?,
        Setting::Bend(value) => possible(scene.set_bend(value), "only a flat world can be bent")?,
        Setting::Quality(quality) => {
            scene.set_quality(quality);
            host.worlds().set_quality(quality);
        }
        // A script sees the same on every machine.
        Setting::ViewDistance(0) => scene.set_view_distance(VIEW_DISTANCE_CHUNKS.2),
        Setting::ViewDistance(chunks) => scene.set_view_distance(chunks),
        Setting::Health(health) => scene.set_health(health),
        Setting::Fly(on) => scene.set_flying(on),
        Setting::Npcs(mode) => scene.set_npcs(mode),
        Setting::Brush(shape) => scene.set_brush_shape(shape),
        Setting::Ground(kind) => scene.set_built_kind(kind),
        Setting::Own(..) => {}
    }
    Ok(())
}

fn teleport<H: Host + ?Sized>(host: &mut H, point: ChartPoint) -> Result<(), Failure> {
    let scene = host.scene()?;
    check_place(&**scene.strategy(), point).map_err(Failure::Usage)?;
    scene.teleport(point);
    host.arrive()?;
    host.scene()?.refresh_marker();
    Ok(())
}

fn spawn<H: Host + ?Sized>(
    host: &mut H,
    spawned: Spawned,
    point: ChartPoint,
) -> Result<(), Failure> {
    let scene = host.scene()?;
    check_place(&**scene.strategy(), point).map_err(Failure::Usage)?;
    match spawned {
        Spawned::Standing(item) => {
            let stands = scene.put_up(item, point, 0.0, "");
            possible(stands, &format!("there are too many {}s", item.id()))?;
        }
        Spawned::Car => possible(scene.spawn_car(point, 0.0), "there are too many cars")?,
        Spawned::Bot | Spawned::Hostile => {
            possible(scene.has_room_for_bot(), "there are too many figures")?;
            scene.spawn_bot(point, 0.0, spawned == Spawned::Hostile);
        }
    }
    Ok(())
}

/// Whether a player can stand there; a sentence when not.
fn check_place(atlas: &dyn Atlas, point: ChartPoint) -> Result<(), String> {
    if !atlas.has_chart(point.chart) {
        return Err("this space has no such hemisphere or square".to_owned());
    }
    let domain = atlas.domain(point.chart);
    let outside_m = domain.outside_m(point.pos.xz());
    if outside_m > RIM_SLACK_M {
        let rim = match domain {
            Domain::Rectangle { .. } => "edge of its square",
            _ => "rim of its hemisphere",
        };
        let half_m = domain.half_width_m();
        return Err(format!(
            "that point lies {outside_m:.1} m beyond the {rim}, {half_m:.1} m from the middle"
        ));
    }
    match atlas.limits() {
        Some(limits) if !(limits.bedrock_m..=limits.ceiling_m).contains(&point.pos.y) => {
            Err(format!(
                "the height {} m is out of this world's range ({:.1} to {:.1} m)",
                point.pos.y, limits.bedrock_m, limits.ceiling_m
            ))
        }
        _ => Ok(()),
    }
}

/// What an order came to: a mistake of whoever gave it where the world has no such thing.
fn possible(done: bool, otherwise: &str) -> Result<(), Failure> {
    if done {
        Ok(())
    } else {
        Err(Failure::Usage(otherwise.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{ChartId, Geometry, strategy};

    use super::*;

    #[test]
    fn nobody_is_sent_out_of_the_world() {
        let sphere = strategy(Geometry::Spherical, 32.0);
        let at = |x: f64, y: f64, chart| {
            check_place(&*sphere, ChartPoint::new(chart, DVec3::new(x, y, 0.0)))
        };
        assert_eq!(at(0.0, 20.0, ChartId::SECOND), Ok(()));
        assert_eq!(at(50.0, 20.0, ChartId::FIRST), Ok(()));
        assert!(at(60.0, 20.0, ChartId::FIRST).is_err_and(|said| said.contains("rim")));
        for y in [0.0, 60.0, 1e8] {
            assert!(at(0.0, y, ChartId::FIRST).is_err_and(|said| said.contains("height")));
        }
        let squares = strategy(Geometry::HyperbolicWorld, 60.0);
        let past = ChartPoint::a(DVec3::new(40.0, 20.0, 40.0));
        assert!(check_place(&*squares, past).is_err_and(|said| said.contains("square")));
        let flat = strategy(Geometry::Euclidean, f64::INFINITY);
        let far = DVec3::new(1e8, 1e8, -1e8);
        assert_eq!(check_place(&*flat, ChartPoint::a(far)), Ok(()));
        assert!(check_place(&*flat, ChartPoint::new(ChartId::SECOND, far)).is_err());
    }
}
