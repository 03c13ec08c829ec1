//! Changes that a host makes to a scene from outside of a step, for commands, scripts and menus.

use antipode_geometry::{ChartPoint, Eye, HyperbolicMap};
use antipode_items::Item;
use antipode_terrain::Kind;
use glam::DVec3;

use crate::actors::ActorId;
use crate::bot::{self, Bot};
use crate::brush::BrushShape;
use crate::fixture::{self, Fixture};
use crate::flag::tidy_name;
use crate::frame::Quality;
use crate::inventory::{Inventory, Stack};
use crate::lens::Lens;
use crate::notice::{Hint, Notice};
use crate::npc::{self, NpcMode};
use crate::player::Look;
use crate::scene::Scene;
use crate::sound::SoundEvent;
use crate::tuning::{BOT_HEALTH, VIEW_DISTANCE_CHUNKS};
use crate::viewing::Viewing;
use crate::{body, car, drops, projectile, start, step, tool};

/// The world.
impl Scene {
    /// Sets the time of day in seconds; it wraps at a day's length.
    pub fn set_time_of_day_s(&mut self, time_s: f64) {
        self.sim.world.set_time_of_day_s(time_s);
        self.kept.changed = true;
    }

    /// Marks the world as one in which a command that cheats was used, for ever.
    pub fn mark_cheated(&mut self) {
        self.kept.cheated = true;
        self.kept.changed = true;
    }

    /// Sets how far chunks are loaded, within the allowed range.
    pub fn set_view_distance(&mut self, chunks: u32) {
        let (least, most, _) = VIEW_DISTANCE_CHUNKS;
        self.sim.world.setup.view_distance = chunks.clamp(least, most);
        self.kept.changed = true;
        self.request_ground();
    }

    /// Has a new world begin with a view, in place of its middle: the player, a car and somebody are put there.
    pub fn begin_with_a_view(&mut self) {
        let eye_m = self.sim.actors.tuning.eye_height_m();
        let lens = &self.sim.player.gaze.lens;
        let field = self.sim.world.ground.field();
        let Some(start) = start::with_a_view(field, lens, eye_m) else {
            return;
        };
        self.sim.player.start = Some(start.feet);
        self.put_player(start.feet);
        if let Ok(mut look) = self.sim.actors.ecs.get::<&mut Look>(self.sim.actors.player) {
            *look = start.look;
        }
        if let Some((place, yaw)) = start.car {
            self.sim.actors.cars.given = self.spawn_car(place, yaw);
        }
        if let Some((place, yaw)) = start.figure {
            let head = self.head().point;
            npc::let_somebody_wait(&self.sim.world, &mut self.sim.actors, head, place, yaw);
        }
        self.request_ground();
        self.refresh_marker();
    }
}

/// The player.
impl Scene {
    /// Moves the player's feet to a point, out of a car, and stops it; a point outside the world is brought to its border, and
    /// one in rock leads to the free ground above as soon as that is loaded. Ground there is asked for at once.
    pub fn teleport(&mut self, point: ChartPoint) {
        self.get_out();
        self.put_player(point);
        self.request_ground();
    }

    fn put_player(&mut self, point: ChartPoint) {
        let (world, actors) = (&self.sim.world, &mut self.sim.actors);
        body::place(
            world,
            actors,
            &mut self.sim.player,
            point,
            DVec3::ZERO,
            false,
        );
        self.sim.world.centre_on_body(self.sim.actors.feet());
        self.kept.changed = true;
    }

    fn get_out(&mut self) {
        car::doors::get_out(&mut self.sim.actors, &mut self.sim.player.gaze);
    }

    /// Points the view, in radians.
    pub fn aim(&mut self, yaw_rad: f64, pitch_rad: f64) {
        self.sim.actors.set_look(yaw_rad, pitch_rad);
        if let Some(driving) = &mut self.sim.actors.cars.driving {
            driving.chase.aim(yaw_rad, pitch_rad);
        }
        self.kept.changed = true;
        self.refresh_marker();
    }

    /// Lets the player fly as a spectator, out of a car, through everything and without weight, or walk again. Whose
    /// flight ends inside the ground is lifted out of it in the next step.
    pub fn set_flying(&mut self, flying: bool) {
        if flying {
            self.get_out();
        }
        let player = &mut self.sim.player;
        player.body_unchecked |= player.flying && !flying;
        player.flying = flying;
        self.kept.changed = true;
    }

    /// Sets the player's health, kept within 0 and full.
    pub fn set_health(&mut self, health: f64) {
        self.sim.actors.set_health(health);
        self.kept.changed = true;
    }

    /// The player's hotbar, to change it.
    pub fn inventory_mut(&mut self) -> &mut Inventory {
        self.kept.changed = true;
        &mut self.sim.player.inventory
    }

    /// Throws a stack away, ahead of the player. When too many things lie about it goes back into the slots; what
    /// finds no room there is thrown all the same.
    pub fn throw_away(&mut self, stack: Stack) {
        self.kept.changed = true;
        let head = self.head();
        let sim = &mut self.sim;
        let slots = &mut sim.player.inventory;
        drops::throw_away(&mut sim.actors, slots, &mut sim.outbox, &head, stack);
    }

    /// Whether bullets follow the space's geodesics instead of falling in its chart.
    pub fn set_straight_shots(&mut self, straight: bool) {
        self.sim.player.gaze.straight_shots = straight;
    }
}

/// Everyone and everything else.
impl Scene {
    /// Says what other figures may do. Off in a scene that was just opened.
    pub fn set_npcs(&mut self, mode: NpcMode) {
        self.sim.actors.npcs.mode = mode;
    }

    /// Frightens everyone peaceful within `radius_m` metres of a place: they run from it for some seconds.
    pub fn scare(&mut self, from: ChartPoint, radius_m: f64) {
        npc::scare(&mut self.sim.actors, from, radius_m);
    }

    /// Puts a bot with its feet at a point; returns its number.
    pub fn spawn_bot(&mut self, point: ChartPoint, yaw: f64, hostile: bool) -> u32 {
        self.kept.changed = true;
        let (world, actors) = (&self.sim.world, &mut self.sim.actors);
        let id = actors.next::<Bot>();
        bot::spawn(world, actors, point, yaw, hostile, BOT_HEALTH, false);
        id.0
    }

    /// Puts a car at a point of the ground, facing along `yaw` radians; as high up as it takes to be free, once the
    /// ground is there. Returns whether there was room for one more.
    pub fn spawn_car(&mut self, point: ChartPoint, yaw: f64) -> bool {
        let (world, actors) = (&self.sim.world, &mut self.sim.actors);
        let has_room = car::spawn(world, actors, point, yaw);
        self.kept.changed |= has_room;
        has_room
    }

    /// Gives the world its first car, near the start, if it has had none yet.
    pub fn give_first_car(&mut self) {
        let start = self.now().start();
        let (world, actors) = (&self.sim.world, &mut self.sim.actors);
        self.kept.changed |= car::give_first(world, actors, start);
    }

    /// Puts a lamp with its foot at a point. Returns whether there was room for one more.
    pub fn spawn_lamp(&mut self, point: ChartPoint) -> bool {
        self.put_up(Item::Lamp, point, 0.0, "")
    }

    /// Plants a flag of that name at a point, its cloth along `yaw`, radians. Returns whether
    /// there was room for one more.
    pub fn spawn_flag(&mut self, point: ChartPoint, yaw: f64, name: &str) -> bool {
        self.put_up(Item::Flag, point, yaw, name)
    }

    /// Puts an item that stands with its foot at a point; where not all of its kind look the same way, it looks along
    /// `yaw`, radians. Returns whether it stands there: it is one that does, and there was room for one more.
    pub fn put_up(&mut self, item: Item, point: ChartPoint, yaw: f64, name: &str) -> bool {
        let turned = item.stands().and_then(|stands| stands.turned_deg);
        let yaw_rad = turned.map(|_| yaw);
        let it = Fixture::standing(&self.sim.world, item, point, yaw_rad);
        let it = it.map(|it| it.named(name));
        let id = it.and_then(|it| fixture::enter(&mut self.sim.actors, it));
        self.kept.changed |= id.is_some();
        id.is_some()
    }

    /// The flag that the player wants to name, asked for once.
    pub fn take_flag_to_name(&mut self) -> Option<ActorId> {
        self.sim.outbox.names_flag.take()
    }

    /// Names a flag, as far as a text can be a name. Returns whether there is such a flag.
    pub fn name_flag(&mut self, id: ActorId, name: &str) -> bool {
        let flag = fixture::one_mut(&mut self.sim.actors, Item::Flag, id);
        let is_there = flag.map(|flag| flag.name = tidy_name(name)).is_some();
        self.kept.changed |= is_there;
        is_there
    }

    /// Puts a bullet in flight that nobody's gun has fired: it harms everyone but the player, as the player's own do at
    /// first. `point` is its middle, `velocity` in metres of the space a second, along the
    /// axes of the chart's frame.
    pub fn throw_bullet(&mut self, point: ChartPoint, velocity: DVec3) {
        let by = self.sim.actors.player;
        projectile::fire(&mut self.sim.actors, point, velocity, by);
    }
}

/// Pictures.
impl Scene {
    /// Asks for the space's other picture, as the key does: it comes gliding, and the player is told its name.
    pub fn turn_map(&mut self) {
        step::turn_map(&mut self.sim.player.gaze.lens, &mut self.sim.outbox);
        self.kept.changed = true;
    }

    /// Shows a hyperbolic world through a map at once. Returns false where the space has no other map.
    pub fn set_map(&mut self, map: HyperbolicMap) -> bool {
        self.repicture(|lens| lens.set_map(map))
    }

    /// Sets the dial of a hyperbolic world at once, 0 to 20. Returns false when out of range or there is none.
    pub fn set_curvature(&mut self, value: f64) -> bool {
        self.repicture(|lens| lens.set_curvature(value))
    }

    /// Bends the picture of a flat world at once, -20 to 20; 0 unbends it. Returns false when out of range or the
    /// world is not flat.
    pub fn set_bend(&mut self, value: f64) -> bool {
        self.repicture(|lens| lens.set_bend(value))
    }

    /// Takes a brush of another shape, until the world is left.
    pub fn set_brush_shape(&mut self, shape: BrushShape) {
        self.sim.player.brush.shape = shape;
    }

    /// Builds of a kind of ground, until the world is left; of none, what untouched land has at each place.
    pub fn set_built_kind(&mut self, kind: Option<Kind>) {
        self.sim.player.brush.kind = kind;
    }

    /// Undoes the last stroke of the brush, after all that were made before; a hint tells the end.
    pub fn undo_stroke(&mut self) {
        self.sim.world.streamer.undo();
        self.kept.changed = true;
    }

    fn repicture(&mut self, set: impl FnOnce(&mut Lens) -> bool) -> bool {
        let fits = set(&mut self.sim.player.gaze.lens);
        self.kept.changed |= fits;
        self.sim.player.gaze.forget_aim();
        self.renew_picture();
        self.refresh_marker();
        fits
    }

    /// Sets how the player wants to see the world, from the next frame on.
    pub fn set_viewing(&mut self, viewing: Viewing) {
        self.shown.viewing = viewing;
        self.renew_picture();
    }

    /// Sets how much exactness pictures trade for speed; no part of the world, so nothing of it is saved.
    pub fn set_quality(&mut self, quality: Quality) {
        self.shown.quality = quality;
    }

    /// Says how many lines pictures have, which decides how fine far land must be; at least 1.
    pub fn set_picture_height_px(&mut self, lines: u32) {
        self.shown.picture_height_px = lines.max(1);
    }

    /// Has land made around a camera that is elsewhere than the player, or around the player again.
    pub fn watch_from(&mut self, eye: Option<Eye>) {
        self.shown.watched = eye;
    }

    /// Points the marker anew, as after the view was set from outside a step.
    pub fn refresh_marker(&mut self) {
        self.sim.player.tool = tool::mark(self.now());
    }
}

/// What a step has to tell.
impl Scene {
    /// What has gone wrong since they were last taken.
    pub fn take_notices(&mut self) -> Vec<Notice> {
        std::mem::take(&mut self.sim.outbox.notices)
    }

    /// Short answers to what the player did that have come up since they were last taken.
    pub fn take_hints(&mut self) -> Vec<Hint> {
        std::mem::take(&mut self.sim.outbox.hints)
    }

    /// What made a sound since it was last asked, in order.
    pub fn take_sounds(&mut self) -> Vec<SoundEvent> {
        self.sim.outbox.sounds.take()
    }
}
