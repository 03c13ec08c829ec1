//! The ground changed here: all that stands on it, whatever it is, looks anew at what it stands on.

use antipode_geometry::{ChartPoint, ChunkCoord};
use hecs::Component;

use crate::actors::Actors;
use crate::car::Car;
use crate::drops::Drop;
use crate::fixture::Fixture;
use crate::ground::chunks_near;
use crate::npc::Event;
use crate::world::World;

/// Ground within this of a thing may be what it stands on, in metres.
const STANDS_ON_M: f64 = 4.0;

/// What the ground carries.
pub(crate) trait OnGround {
    /// Where it stands or lies.
    fn stands_at(&self) -> ChartPoint;
    /// Whether it is on its way down: then ground anywhere below may be where it was to come to rest.
    fn is_falling(&self) -> bool;
    /// Makes it look for its ground in the next step.
    fn wake(&mut self);
}

/// Tells all that may stand in these chunks that their ground has changed.
pub(crate) fn tell(world: &World, actors: &mut Actors, chunks: &[ChunkCoord]) {
    wake::<Fixture>(world, actors, chunks);
    wake::<Drop>(world, actors, chunks);
    wake::<Car>(world, actors, chunks);
    let places = chunks
        .iter()
        .map(|coord| ChartPoint::new(coord.chart, coord.centre()));
    actors.npcs.events.extend(places.map(Event::Ground));
}

fn wake<T: Component + OnGround>(world: &World, actors: &mut Actors, chunks: &[ChunkCoord]) {
    for it in actors.ecs.query_mut::<&mut T>() {
        if it.is_falling() || may_stand_on(world, it.stands_at(), chunks) {
            it.wake();
        }
    }
}

/// Whether what is at a point may stand on the ground of one of these chunks.
fn may_stand_on(world: &World, point: ChartPoint, chunks: &[ChunkCoord]) -> bool {
    let under = chunks_near(&*world.strategy, point, STANDS_ON_M);
    under.iter().any(|coord| chunks.contains(coord))
}
