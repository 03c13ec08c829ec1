//! The simulation: a pure function of save, seed and actions; how it is shown has no part in it. One fixed step of it:
//! what happens, in which order.

use antipode_physics::CharacterInput;

use crate::actions::Actions;
use crate::actors::Actors;
use crate::brush::{Brush, Choice};
use crate::camera::CameraMode;
use crate::car::{doors, drive};
use crate::crosshair::Crosshair;
use crate::damage::{DamageKind, fall_damage};
use crate::lens::Lens;
use crate::notice::Hint;
use crate::outbox::Outbox;
use crate::player::{self, Appearance, Body, Look, Player, Position};
use crate::situation::{Situation, is_ground_ready};
use crate::sound::{self, SoundEvent};
use crate::tuning::{BRUSH_RADIUS_M, REACH_M, STEP_S};
use crate::world::World;
use crate::{
    biome, body, circumnavigation, damage, door, drops, falling, felling, fixture, ground_changed,
    gun, npc, planting, tool,
};
use antipode_frame::motion::Doing;

/// All that a step changes: a world, its actors, the player and what is to be told of them.
pub(crate) struct Simulation {
    pub world: World,
    pub actors: Actors,
    pub player: Player,
    pub outbox: Outbox,
}

impl Simulation {
    /// Advances the world by one step of [`STEP_S`] seconds.
    ///
    /// While the ground around the player is not there yet the body is held still; everything else goes on.
    pub fn step(&mut self, actions: &Actions) {
        let Self {
            world,
            actors,
            player,
            outbox,
        } = self;
        outbox.fired = false;
        world.doors = door::pair(&*world.strategy, actors);
        let head = Situation::of(world, actors, player).head();
        world.centre_on(head.point, actors.feet());
        player.gaze.take_aim(actions.aimed);
        turn_switches(world, actors, player, outbox, actions);
        player.gaze.lens.glide(STEP_S);
        player.gaze.dip.pass(STEP_S);
        let actions = &actions.unless(player.is_dead());
        doors::step(world, actors, player, outbox, actions);
        // A body that has just been lifted waits for the next step: other ground may be near it now.
        let is_afoot = !actors.cars.is_driving();
        if is_afoot && is_ground_ready(world, actors) && !body::free(world, actors, player) {
            walk(world, actors, player, outbox, actions);
        }
        drive::step(world, actors, player, outbox, actions);
        world.physics.set_obstacles(actors.car_bodies(world));
        let (solids, physics) = (&mut world.solids, &mut world.physics);
        let changed = solids.tell(&*world.strategy, actors, physics);
        if !changed.is_empty() {
            ground_changed::tell(world, actors, &changed);
        }
        circumnavigation::notice(world, actors.feet(), &mut player.circumnavigation, outbox);
        biome::notice(world, actors.feet(), &mut player.biome, outbox);
        // Both hands are on the wheel.
        let actions = &actions.unless(actors.cars.is_driving());
        npc::step(world, actors, player, outbox);
        if damage::heal(actors, &mut player.condition) {
            damage::respawn(world, actors, player);
            let head = Situation::of(world, actors, player).head();
            world.centre_on(head.point, actors.feet());
            outbox.hints.push(Hint::BackAgain);
        }
        world.pass(STEP_S);
        work(world, actors, player, outbox, actions);
        if actions.undo {
            world.streamer.undo();
        }
        gun::use_in_hand(world, actors, player, outbox, actions);
        fixture::use_in_hand(world, actors, player, outbox, actions);
        planting::use_in_hand(world, actors, player, outbox, actions);
        gun::step_bullets(world, actors, player, outbox);
        falling::step(world, actors, player, outbox);
        planting::step(world);
        fixture::step(world, actors);
        drops::step(world, actors, player, outbox);
        player.primary_before = actions.primary;
        player.secondary_before = actions.secondary;
    }
}

/// Works with the tool in hand, on what grows or on the ground.
fn work(
    world: &mut World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    actions: &Actions,
) {
    // Who strikes what grows does not dig, nor goes on into the ground when it falls.
    let struck = felling::struck(Situation::of(world, actors, player), actions);
    let digs = Actions {
        primary: actions.primary && struck.is_none() && !player.has_felled,
        ..*actions
    };
    let now = Situation::of(world, actors, player);
    let (mark, strokes) = tool::work(now, &digs, outbox);
    player.tool = mark;
    player.has_felled &= actions.primary;
    if let Some(it) = struck {
        felling::chop(world, actors, player, outbox, it);
    }
    let press = mark.map(|mark| mark.press).filter(|press| *press > 0);
    player.presses = player.presses.max(press.unwrap_or_default());
    for stroke in strokes {
        world.streamer.edit_in(press, stroke);
    }
}

/// What is done at once by a press or a turn of the wheel.
fn turn_switches(
    world: &World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    actions: &Actions,
) {
    if let Ok(mut look) = actors.ecs.get::<&mut Look>(actors.player) {
        look.turn(actions.look_yaw, actions.look_pitch);
    }
    let in_hand = player.inventory.selected();
    if let Some(slot) = actions.slot {
        player.inventory.select(slot);
    }
    player.inventory.step(actions.slot_step);
    if player.inventory.selected() != in_hand {
        outbox.sounds.push(SoundEvent::SlotChanged);
    }
    if actions.toggle_light {
        match actors.cars.driven() {
            Some(id) => doors::toggle_lights(actors, id),
            None => player.flashlight = !player.flashlight,
        }
    }
    if (actions.drop_one || actions.drop_all)
        && let Some(stack) = player.inventory.take_held(actions.drop_all)
    {
        let head = Situation::of(world, actors, player).head();
        drops::throw_away(actors, &mut player.inventory, outbox, &head, stack);
    }
    if actions.talk {
        npc::talk(world, actors, player, outbox);
    }
    if actions.turn_map {
        turn_map(&mut player.gaze.lens, outbox);
    }
    player.gaze.lens.turn(actions.dial);
    let (least, most, _) = BRUSH_RADIUS_M;
    player.brush_radius_m =
        (player.brush_radius_m + f64::from(actions.brush_step)).clamp(least, most);
    choose_brush(world, actors, player, actions);
    if actions.toggle_camera {
        player.gaze.camera = match player.gaze.camera {
            CameraMode::First => CameraMode::Third,
            CameraMode::Third => CameraMode::First,
        };
    }
}

/// Goes through shapes and kinds of ground, or takes the kind ahead.
fn choose_brush(world: &World, actors: &Actors, player: &mut Player, actions: &Actions) {
    let (shapes, kinds) = (actions.shape_step, actions.kind_step);
    if (shapes, kinds) != (0, 0) {
        let offered = Brush::kinds(world.streamer.stock());
        player.brush.step(shapes, (kinds, &offered));
    }
    if actions.take_kind {
        take_kind(world, actors, player);
    }
    if kinds != 0 || actions.take_kind {
        player.chosen = Some((Choice::Kind, world.simulated_s));
    } else if shapes != 0 {
        player.chosen = Some((Choice::Shape, world.simulated_s));
    }
}

/// Builds of what is under the crosshair from now on; of what is found at each place where nothing is.
fn take_kind(world: &World, actors: &Actors, player: &mut Player) {
    let now = Situation::of(world, actors, player);
    let ahead = Crosshair::aimed(now).ground(REACH_M);
    player.brush.kind = ahead.hit.then(|| world.ground.kind(ahead.point));
}

/// Asks for the space's other picture: it comes gliding, and the player is told its name.
pub(crate) fn turn_map(lens: &mut Lens, outbox: &mut Outbox) {
    outbox.hints.push(if !lens.turn_map() {
        Hint::NoOtherMap
    } else if let Some(map) = lens.map() {
        Hint::Map(map)
    } else if lens.bend().is_some() {
        Hint::Bent
    } else {
        Hint::Unbent
    });
}

/// Moves the player's body on its own feet, or flying.
fn walk(
    world: &World,
    actors: &mut Actors,
    player: &mut Player,
    outbox: &mut Outbox,
    actions: &Actions,
) {
    let Ok((position, look, body, appearance)) =
        actors
            .ecs
            .query_one_mut::<(&mut Position, &mut Look, &mut Body, &mut Appearance)>(actors.player)
    else {
        return;
    };
    let input = CharacterInput {
        wish: player::wish(actions, look),
        sprint: actions.sprint,
        jump: actions.jump,
        fly: player.flying,
        rise: actions.jump,
        sink: actions.sink,
    };
    let strategy = &*world.strategy;
    let before = position.0;
    body.0.feet = position.0.pos;
    let ground = world.physics.for_bodies(strategy, position.0.chart);
    let turn_rad = ground.move_character(&mut body.0, &actors.tuning, &input, STEP_S);
    position.0.pos = body.0.feet;
    look.follow(turn_rad);
    if let Some(limits) = strategy.limits() {
        let y = position.0.pos.y.clamp(limits.bedrock_m, limits.ceiling_m);
        if y != position.0.pos.y {
            position.0.pos.y = y;
            body.0.velocity.y = 0.0;
        }
    }
    if let Some(lifted_m) = door::pass(world, before, position, look, body) {
        player.body_unchecked = true;
        player.gaze.dip.lift(lifted_m);
    }
    player::cross(strategy, position, look, body);
    let damage = fall_damage(body.0.hardest_m_s(), actors.tuning.gravity_m_s2);
    player.gaze.dip.land(body.0.impact_m_s);
    let doing = Doing {
        flying: player.flying,
        dead: player.is_dead(),
        holds: player.inventory.held().is_some(),
        ..player::doing(look, body)
    };
    let foot_down = appearance.motion.pass(&doing, STEP_S);
    sound::hear_body(&world.ground, position.0, &body.0, foot_down, outbox);
    damage::hurt_player(actors, player, outbox, damage, DamageKind::Fall, None);
}
