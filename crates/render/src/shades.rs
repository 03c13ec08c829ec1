//! The soft shades on the ground below figures: which are drawn, and on which land each falls.

use antipode_frame::{Figure, Frame, Presence};
use antipode_geometry::ChartPoint;
use glam::DVec3;

use crate::charts::offset_of;
use crate::plan::ChunkLand;

/// Shades that are drawn at most; `SHADES` of common.wgsl.
pub const SHADES: usize = 8;
/// No shade reaches farther from the figure's feet than this, metres.
const SHADE_REACH_M: f64 = 3.0;
/// Places that are no farther apart are one, metres.
const SAME_M: f64 = 1e-6;

/// A shade on the ground.
#[derive(Debug)]
struct Shade {
    /// The feet above it from the reference in the common axes, metres.
    place: DVec3,
    /// The feet in each chart whose land it may fall on and that has them there.
    feet: Vec<ChartPoint>,
}

impl Shade {
    /// Those of feet: one, or where charts have no axes in common one for each chart near by.
    fn below(frame: &Frame, point: ChartPoint) -> Vec<Self> {
        let images = frame.view.strategy.images(point, SHADE_REACH_M).into_iter();
        let images = std::iter::once(point).chain(images.map(|image| image.point));
        let mut shades: Vec<Self> = Vec::new();
        for feet in images {
            let place = frame
                .view
                .in_common_axes(feet.chart, offset_of(frame, feet));
            let known = shades
                .iter_mut()
                .find(|it| it.place.distance(place) < SAME_M);
            match known {
                Some(shade) => shade.feet.push(feet),
                None => shades.push(Self {
                    place,
                    feet: vec![feet],
                }),
            }
        }
        shades
    }
}

/// The shades that are drawn, below the figures nearest to the eye.
#[derive(Debug)]
pub struct Shades(Vec<Shade>);

impl Shades {
    /// Those of a frame.
    pub fn of(frame: &Frame) -> Self {
        let (space, eye) = (&*frame.view.strategy, &frame.view.eye);
        let view = space.viewer(eye);
        let figures = frame.content.figures.iter();
        let is_there = |figure: &&Figure| figure.presence == Presence::Real;
        // Of who stands in a door the feet are on one side only.
        let has_feet = |figure: &&Figure| figure.cut.is_none_or(|cut| cut.from_m <= 0.0);
        let casting = figures
            .filter(|figure| figure.model.casts_shade())
            .filter(is_there)
            .filter(has_feet);
        let away_m = |point: ChartPoint| (space.eye_distance_m(eye, view(point)), point);
        let mut feet: Vec<_> = casting.map(|figure| away_m(figure.point)).collect();
        feet.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        let below = |(_, point)| Shade::below(frame, point);
        Self(feet.into_iter().flat_map(below).take(SHADES).collect())
    }

    /// Which of them may fall on a chunk's land, a bit for each.
    pub fn on(&self, land: &ChunkLand) -> u32 {
        let falls = |feet: &ChartPoint| {
            feet.chart == land.coord.chart
                && feet.pos.distance(feet.pos.clamp(land.min, land.max)) < SHADE_REACH_M
        };
        let bits = self.0.iter().enumerate();
        bits.filter(|(_, shade)| shade.feet.iter().any(falls))
            .fold(0, |bits, (place, _)| bits | 1 << place)
    }

    /// Where they are, as the shaders take them.
    pub fn places(&self) -> [[f32; 4]; SHADES] {
        let mut places = [[0.0; 4]; SHADES];
        for (place, shade) in places.iter_mut().zip(&self.0) {
            *place = shade.place.as_vec3().extend(0.0).into();
        }
        places
    }
}
