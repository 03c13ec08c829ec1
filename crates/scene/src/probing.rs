//! Fills the probe with the state of the world at a moment.

use std::collections::BTreeMap;

use antipode_geometry::{ChartPoint, HyperbolicMap};
use antipode_physics::Character;
use antipode_storage::RecordKind;
use antipode_terrain::{Kind, Stock};
use glam::DVec3;

use crate::actors::ActorId;
use crate::bot::{self, BotView};
use crate::car::CarView;
use crate::crosshair::Crosshair;
use crate::day;
use crate::drops::Drop;
use crate::felling;
use crate::fixture::{self, Fixture};
use crate::persist::fixture_kind;
use crate::player::{Player, wrap_angle};
use crate::presentation::Presentation;
use crate::probe::{
    BotProbe, CameraProbe, CarProbe, ChunkProbe, DoorProbe, DropProbe, FixtureProbe, FlagProbe,
    LampProbe, MarkerProbe, PlayerProbe, Probe, ProjectileProbe, SlotProbe, TerrainProbe,
    WheelProbe,
};
use crate::projectile::Projectile;
use crate::situation::Situation;
use crate::tuning::REACH_M;
use antipode_items::Item;

fn stock_probe(stock: &Stock) -> BTreeMap<&'static str, f64> {
    let all = Kind::ALL.into_iter();
    let all = all.map(|kind| (kind.name(), stock.of(kind)));
    all.filter(|(_, m3)| *m3 > 0.0).collect()
}

fn chart(now: Situation<'_>, point: ChartPoint) -> String {
    now.world.strategy.chart_name(point.chart)
}

fn car_probe(now: Situation<'_>, car: &CarView) -> CarProbe {
    CarProbe {
        pos: car.point.pos.to_array(),
        vel: car.velocity.to_array(),
        yaw: car.yaw().to_degrees(),
        upright: (car.turn * DVec3::Y).y,
        speed: car.speed_m_s,
        steer: car.steer_rad.to_degrees(),
        lights: car.lights,
        brakes: car.brakes,
        wheels: car.wheels.map(|wheel| WheelProbe {
            contact: wheel.contact,
            compression: wheel.compression_m,
        }),
        hemisphere: chart(now, car.point),
    }
}

/// The state of the world for a script, and how pictures of it are taken.
pub(crate) fn probe(now: Situation<'_>, shown: &Presentation) -> Probe {
    let Situation {
        world,
        actors,
        player,
    } = now;
    let curved_radius = world.strategy.radius_m();
    let lens = &player.gaze.lens;
    let cars = actors.car_views();
    let (particles, marks) = shown.particles.probe(world.simulated_s);
    Probe {
        t: world.simulated_s,
        world: world.setup.name.clone(),
        seed: world.setup.seed,
        generator: world.setup.generator.number(),
        mode: world.setup.mode.name(),
        stock: world.streamer.stock().map(stock_probe),
        biome: world.ground.field().biome_at(now.feet()).name(),
        geometry: world.setup.geometry.to_string(),
        radius: curved_radius.is_finite().then_some(curved_radius),
        map: lens.map().map(HyperbolicMap::name),
        curvature: lens.curvature(),
        bend: lens.bend(),
        quality: shown.quality.name(),
        time_of_day: world.time_of_day_s,
        hour: world.local_time_s(now.feet()).map(day::hour),
        player: player_probe(now),
        camera: camera_probe(now),
        item: player.inventory.held().map(Item::id),
        inventory: (0..)
            .zip(player.inventory.slots())
            .filter_map(|(slot, stack)| stack.map(|stack| SlotProbe { slot, stack }))
            .collect(),
        marker: marker_probe(player),
        flashlight: player.flashlight,
        car: near_car(now, &cars).map(|it| car_probe(now, it)),
        cars: cars.iter().map(|it| car_probe(now, it)).collect(),
        bots: bot::views(actors)
            .iter()
            .map(|it| bot_probe(now, it))
            .collect(),
        projectiles: actors.map(|id, it| projectile_probe(now, id, it)),
        lamps: fixture::map_of(actors, Item::Lamp, |_, it| lamp_probe(now, it)),
        flags: fixture::map_of(actors, Item::Flag, |_, it| flag_probe(now, it)),
        doors: fixture::map_of(actors, Item::Door, |_, it| door_probe(now, it)),
        fixtures: fixture_probes(now),
        drops: actors.map(|_, it| drop_probe(now, it)),
        particles,
        marks,
        plants: felling::probe(now, shown.viewing.fov_y_rad),
        chunks: ChunkProbe {
            resident: world.ground.count(),
            pending: world.streamer.pending(),
            triangles: world.ground.triangles(),
            edited: world.streamer.edited_count(),
        },
        terrain: terrain_probe(now),
    }
}

fn marker_probe(player: &Player) -> MarkerProbe {
    MarkerProbe {
        pos: player.tool.map(|mark| mark.point.pos.to_array()),
        radius: player.brush_radius_m,
        shape: player.brush.shape.name(),
        kind: player.brush.kind.map(Kind::name),
    }
}

fn terrain_probe(now: Situation<'_>) -> TerrainProbe {
    let (world, head) = (now.world, now.head().point);
    let ground_height = world.ground_height(head);
    let below = ground_height.map(|y| ChartPoint::new(head.chart, head.pos.with_y(y)));
    let ahead = Crosshair::aimed(now).ground(REACH_M);
    let earth = now.player.earthworks.total();
    TerrainProbe {
        ground_height,
        kind: below.map(|point| world.ground.kind(point).name()),
        kind_ahead: ahead.hit.then(|| world.ground.kind(ahead.point).name()),
        cave: world.ground.field().is_cave(head),
        dug: by_kind(|kind| earth.dug_m3(kind)),
        built: by_kind(|kind| earth.built_m3(kind)),
    }
}

/// By the names of kinds what there is of each, cubic metres; nothing of those of which there is none.
fn by_kind(m3: impl Fn(Kind) -> f64) -> BTreeMap<&'static str, f64> {
    let kinds = Kind::ALL.into_iter().map(|kind| (kind.name(), m3(kind)));
    kinds.filter(|(_, m3)| *m3 > 0.0).collect()
}

fn player_probe(now: Situation<'_>) -> PlayerProbe {
    let (position, look) = now.actors.player_stance();
    let body = now.actors.player_body();
    PlayerProbe {
        pos: position.0.pos.to_array(),
        vel: body.velocity.to_array(),
        yaw: look.yaw.to_degrees(),
        pitch: look.pitch.to_degrees(),
        grounded: body.grounded,
        health: now.actors.health(),
        hemisphere: chart(now, position.0),
        in_car: now.actors.cars.is_driving(),
        animation: animation(now, &body),
    }
}

fn camera_probe(now: Situation<'_>) -> CameraProbe {
    let params = now.aiming();
    let eye = now.camera_through(&params).eye;
    CameraProbe {
        pos: eye.point.pos.to_array(),
        mode: now.player.gaze.camera.id(),
        curved: params.strategy.curved(&eye, eye.point).to_array(),
    }
}

fn animation(now: Situation<'_>, body: &Character) -> &'static str {
    let speed = body.velocity.x.hypot(body.velocity.z);
    if now.player.is_dead() {
        return "die";
    }
    if now.actors.cars.is_driving() {
        return "drive";
    }
    match (now.player.flying, body.grounded) {
        (true, _) => "fly",
        (false, false) => "jump",
        _ if speed < 0.3 => "idle",
        _ if speed > now.actors.tuning.walk_speed_m_s * 1.2 => "run",
        _ => "walk",
    }
}

/// The car that is driven, else the nearest.
fn near_car<'c>(now: Situation<'_>, cars: &'c [CarView]) -> Option<&'c CarView> {
    let (head, feet) = (now.head(), now.feet());
    let distance_m = |car: &CarView| now.world.strategy.distance_m(feet, car.point, &head);
    cars.iter().find(|car| car.driven).or_else(|| {
        cars.iter()
            .min_by(|a, b| distance_m(a).total_cmp(&distance_m(b)))
    })
}

fn bot_probe(now: Situation<'_>, view: &BotView) -> BotProbe {
    BotProbe {
        id: view.bot.id,
        pos: view.point.pos.to_array(),
        health: view.health,
        hostile: view.fights,
        hemisphere: chart(now, view.point),
        state: view.state.name(),
    }
}

fn projectile_probe(now: Situation<'_>, id: ActorId, bullet: &Projectile) -> ProjectileProbe {
    ProjectileProbe {
        id: id.0,
        pos: bullet.point.pos.to_array(),
        vel: bullet.velocity.to_array(),
        age: bullet.age_s,
        hemisphere: chart(now, bullet.point),
    }
}

fn lamp_probe(now: Situation<'_>, lamp: &Fixture) -> LampProbe {
    LampProbe {
        pos: lamp.foot.point.pos.to_array(),
        hemisphere: chart(now, lamp.foot.point),
    }
}

fn flag_probe(now: Situation<'_>, flag: &Fixture) -> FlagProbe {
    FlagProbe {
        pos: flag.foot.point.pos.to_array(),
        hemisphere: chart(now, flag.foot.point),
        name: flag.name.clone(),
    }
}

fn door_probe(now: Situation<'_>, door: &Fixture) -> DoorProbe {
    DoorProbe {
        pos: door.foot.point.pos.to_array(),
        yaw: wrap_angle(door.yaw_rad).to_degrees(),
        hemisphere: chart(now, door.foot.point),
    }
}

/// What was put down besides lamps, flags and doors.
fn fixture_probes(now: Situation<'_>) -> Vec<FixtureProbe> {
    let all = fixture::map(now.actors, |_, it| {
        let is_told = fixture_kind(it.item) == RecordKind::Fixture && it.item != Item::Door;
        is_told.then(|| FixtureProbe {
            item: it.item.id(),
            pos: it.foot.point.pos.to_array(),
            yaw: it.yaw_rad.to_degrees(),
            hemisphere: chart(now, it.foot.point),
        })
    });
    all.into_iter().flatten().collect()
}

fn drop_probe(now: Situation<'_>, drop: &Drop) -> DropProbe {
    DropProbe {
        stack: drop.stack,
        pos: drop.point.pos.to_array(),
        hemisphere: chart(now, drop.point),
    }
}
