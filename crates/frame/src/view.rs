//! A view of a world: the part of a picture that it shares with no other.

use std::sync::Arc;

use antipode_geometry::{ChartId, ChartPoint, Eye, Projection, SpaceUniform, Strategy};
use glam::{DMat4, DVec3, DVec4};

use crate::{ModelId, Quality};

/// From where and how a world is seen.
#[derive(Clone, Debug)]
pub struct View {
    /// Where the picture is taken from.
    pub eye: Eye,
    /// Field of view, aspect and near distance.
    pub projection: Projection,
    /// The space the picture is taken in.
    pub strategy: Arc<dyn Strategy>,
    /// What the player sees in the own hand; none from elsewhere than the head.
    pub hand: Option<Hand>,
    /// Distance in metres, measured in the space, at which the fog is complete.
    pub fog_distance_m: f32,
    /// How much the land over the eye covers the sky there, 0 to 1: haze in caves is not lit.
    pub covered: f32,
    /// Whether the marker and the outlines of hit shapes are drawn: what the player is told, and not the world.
    pub shows_marks: bool,
    /// Where the marker is in this picture, if that is not where it is: a door shows it there.
    pub mark: Option<ChartPoint>,
    /// Whether faint contour bands are drawn on the land.
    pub contour_bands: bool,
    /// How far the waves of the wind have gone by, of gusts and of what flutters in them, radians; nothing where it is still.
    pub wind: Option<[f32; 2]>,
    /// What the picture may leave out or simplify.
    pub quality: Quality,
    /// An isometry of the space that is applied to view coordinates, in metres and w without unit. The identity gives the
    /// ordinary picture. A picture by any other is not culled: all land and figures are drawn.
    pub isometry: DMat4,
    /// Covectors n of view coordinates, after the isometry: of land, figures and what stands among them, only that is drawn
    /// for which `n . view >= 0` by all of them. The sheets where that is 0 are totally geodesic. All zero for none.
    pub cuts: [DVec4; View::CUTS],
    /// One that cuts figures only, in the same way. All zero for none.
    pub figure_cut: DVec4,
}

impl View {
    /// Sheets that a picture may be cut by at once.
    pub const CUTS: usize = 4;
    /// A distance of fog that is beyond all land, metres.
    pub const NO_FOG_M: f32 = 1e5;

    /// The world as an eye sees it, with an empty hand, without fog, neither moved nor cut.
    pub fn new(eye: Eye, projection: Projection, strategy: Arc<dyn Strategy>) -> Self {
        Self {
            eye,
            projection,
            strategy,
            hand: None,
            fog_distance_m: Self::NO_FOG_M,
            covered: 0.0,
            shows_marks: true,
            mark: None,
            contour_bands: false,
            wind: None,
            quality: Quality::default(),
            isometry: DMat4::IDENTITY,
            cuts: [DVec4::ZERO; Self::CUTS],
            figure_cut: DVec4::ZERO,
        }
    }

    /// Whether the isometry is another than the identity.
    pub fn is_moved(&self) -> bool {
        self.isometry != DMat4::IDENTITY
    }

    /// Whether anything may be cut off.
    pub fn is_cut(&self) -> bool {
        self.cuts != [DVec4::ZERO; Self::CUTS] || self.figure_cut != DVec4::ZERO
    }

    /// View coordinates after the isometry.
    pub fn moved(&self, view: DVec4) -> DVec4 {
        if self.is_moved() {
            self.isometry * view
        } else {
            view
        }
    }

    /// View coordinates of a chart point, after the isometry.
    pub fn point(&self, point: ChartPoint) -> DVec4 {
        self.moved(self.strategy.view_point(&self.eye, point))
    }

    /// A vector of a chart in the axes in which the light of a picture is told: those of the first chart, against which others
    /// are turned by quarters; of a closed world, whose charts have no axes in common, the chart's own.
    pub fn in_common_axes(&self, chart: ChartId, v: DVec3) -> DVec3 {
        self.strategy.in_common_axes(chart, v)
    }

    /// The directions at the eye that are to the right, upwards and into the picture, in the axes of the sky. They turn with the
    /// isometry as its part of three by three does: exactly where it keeps the eye in its place or the space is flat.
    pub fn axes(&self) -> [DVec3; 3] {
        let eye = &self.eye;
        let axes = if self.is_moved() {
            let back = glam::DMat3::from_mat4(self.isometry).transpose();
            [DVec3::X, DVec3::Y, DVec3::NEG_Z].map(|axis| eye.to_chart(back * axis))
        } else {
            [eye.right(), eye.up(), eye.front()]
        };
        axes.map(|axis| self.strategy.in_sky_axes(eye.point, axis))
    }

    /// What is applied to a ported point of a chart to have view coordinates, after the isometry.
    pub fn chart_matrix(&self, chart: ChartId) -> DMat4 {
        let own = self.strategy.chart_matrix(&self.eye, chart);
        if self.is_moved() {
            self.isometry * own
        } else {
            own
        }
    }

    /// What the shaders need to know of the space, the eye, the projection and the isometry.
    pub fn uniform(&self) -> SpaceUniform {
        let uniform = self.strategy.uniform(&self.eye, &self.projection);
        if !self.is_moved() {
            return uniform;
        }
        let view = self.isometry * self.strategy.view_matrix(&self.eye);
        SpaceUniform {
            view: view.as_mat4().to_cols_array_2d(),
            ..uniform
        }
    }
}

/// What the player sees in the own hand, in first person.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hand {
    /// What is held.
    pub model: ModelId,
    /// How far it is out of the picture, 0 to 1, as while it is being taken in hand.
    pub lowered: f32,
    /// How far the step moves it, metres to the right and up.
    pub bob_m: [f32; 2],
    /// How far it is swung, from 0 raised to 1 struck; -1 where it is not swung.
    pub swing: f32,
    /// How far it is thrown back, 0 to 1.
    pub kick: f32,
    /// Whether it flashes.
    pub flashes: bool,
}
