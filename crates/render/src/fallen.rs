//! Trees on their way down: a mesh for each, made anew in every frame.

use antipode_frame::{FallingThing, Frame};
use antipode_geometry::ChartPoint;
use antipode_plants::{Size, shape};
use antipode_terrain::Level;
use glam::Quat;

use crate::baked::Baked;
use crate::charts::Charts;
use crate::chunk_store::ChunkStore;
use crate::draw_list::DrawList;
use crate::lamps::lights_near;
use crate::land_mesh::LandMesh;
use crate::pages::Pages;
use crate::plan::{ChunkChoice, Port};
use crate::renderer::Preset;
use crate::terrain_pipelines::{ShadowReach, TerrainPipelines};
use crate::things::kind_of;
use crate::uniforms::ChunkInstance;

/// How far a thing reaches as it falls, whole metres.
const FALLS_M: i32 = 31;

/// A thing on its way down, in one picture: its mesh, and where that is told from.
#[derive(Debug)]
pub struct Fallen {
    mesh: LandMesh,
    corner: ChartPoint,
}

impl Fallen {
    /// A thing as it hangs at the moment; nothing of what is not known.
    pub fn of(it: &FallingThing, pages: &mut Pages) -> Option<Self> {
        let (species, age) = kind_of(&it.thing)?;
        let corner = it.point.pos.floor() - f64::from(FALLS_M);
        let root = (it.point.pos - corner).as_vec3();
        let turn = it.turn.as_quat() * Quat::from_rotation_y(-it.thing.turn_rad);
        let mut baked = Baked::default();
        baked.put_up(&it.thing, shape(species, age, Size::Near), root, |v| {
            turn * v
        });
        Some(Self {
            mesh: baked.put(pages),
            corner: ChartPoint::new(it.point.chart, corner),
        })
    }

    /// Gives its room back.
    pub fn give_back(self, pages: &mut Pages) {
        self.mesh.give_back(pages);
    }

    /// Lists it, ported by vertex.
    pub fn list(&self, frame: &Frame, preset: Preset, list: &mut DrawList, charts: &mut Charts) {
        let ChartPoint { chart, pos } = self.corner;
        let lights = lights_near(frame, chart, pos, pos + 2.0 * f64::from(FALLS_M));
        let instance = ChunkInstance::at(frame, self.corner, &Port::Vertex)
            .shaded(0, true)
            .lit(lights, Level::FULL);
        let number = TerrainPipelines::number_of_plants(
            &ChunkChoice::LOOSE,
            preset,
            false,
            ShadowReach::All,
            lights,
        );
        let pieces = self.mesh.pieces(0).map(|piece| (number, piece));
        list.add(charts.number(chart), instance, pieces);
    }
}

impl ChunkStore {
    /// Takes what falls in a frame.
    pub(crate) fn renew_fallen(&mut self, frame: &Frame) {
        for before in std::mem::take(&mut self.fallen) {
            before.give_back(&mut self.pages);
        }
        let falling = frame.content.falling.iter();
        self.fallen = falling
            .filter_map(|it| Fallen::of(it, &mut self.pages))
            .collect();
    }

    /// Lists what falls.
    pub(crate) fn list_fallen(&self, frame: &Frame, list: &mut DrawList, charts: &mut Charts) {
        for it in &self.fallen {
            it.list(frame, self.preset, list, charts);
        }
    }
}
