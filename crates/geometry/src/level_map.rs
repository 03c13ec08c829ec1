//! How what is rigid in the space lies in a chart whose metres are not the space's.

use glam::{DMat2, DVec3, Vec3Swizzles};

use crate::{ChartPoint, Metric};

/// Takes short level ways in metres of the space along the frame at a place to metres of the chart there; heights stay.
///
/// To first order: over a metre and a half an arc leaves it by its square over a radius, 4 cm where that is 60 m.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LevelMap(Option<DMat2>);

impl LevelMap {
    /// Where a chart's metres are those in which bodies move.
    pub const SAME: Self = Self(None);

    /// That of a place.
    pub fn at<M: Metric + ?Sized>(space: &M, at: ChartPoint) -> Self {
        if space.moves_in_chart() {
            return Self::SAME;
        }
        let [x, z] = [DVec3::X, DVec3::Z].map(|axis| space.in_chart(at, axis).xz());
        Self(Some(DMat2::from_cols(x, z)))
    }

    /// A way of the space in the chart.
    pub fn in_chart(self, way: DVec3) -> DVec3 {
        self.0.map_or(way, |map| {
            let level = map * way.xz();
            DVec3::new(level.x, way.y, level.y)
        })
    }

    /// A way of the chart in metres of the space.
    pub fn in_space(self, way: DVec3) -> DVec3 {
        self.0.map_or(way, |map| {
            let level = map.inverse() * way.xz();
            DVec3::new(level.x, way.y, level.y)
        })
    }

    /// Its two columns, metres of the chart for a metre along x and along z.
    pub fn columns(self) -> [f64; 4] {
        self.0.unwrap_or(DMat2::IDENTITY).to_cols_array()
    }

    /// A bound of how many times as long a way is in the chart.
    pub fn most_stretch(self) -> f64 {
        let size = |map: DMat2| map.x_axis.length().hypot(map.y_axis.length());
        self.0.map_or(1.0, |map| size(map).max(1.0))
    }

    /// Half the size along each axis of a box of the chart that holds one about the same middle, of half such a size in
    /// metres of the space.
    pub fn half_box(self, half: DVec3) -> DVec3 {
        self.0.map_or(half, |map| {
            let level = map.x_axis.abs() * half.x + map.y_axis.abs() * half.z;
            DVec3::new(level.x, half.y, level.y)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ChartId, Eye, Geometry, strategy};

    #[test]
    fn what_is_a_metre_of_the_space_is_one_in_the_chart_too_whichever_way_it_lies() {
        const SHORT_M: f64 = 1e-4;
        for geometry in Geometry::ALL {
            let space = strategy(geometry, 60.0);
            if space.moves_in_chart() {
                continue;
            }
            for pos in [
                DVec3::new(5.0, 3.0, -2.0),
                DVec3::new(27.0, 12.0, 25.0),
                DVec3::new(-20.0, 8.0, 26.0),
            ] {
                let at = ChartPoint::new(ChartId::FIRST, pos);
                let map = LevelMap::at(&*space, at);
                for turn in 0..8 {
                    let (sin, cos) = f64::from(turn).sin_cos();
                    let way = DVec3::new(cos, 0.0, sin);
                    let there = at.moved(map.in_chart(way * SHORT_M));
                    let far_m = space.distance_m(at, there, &Eye::default());
                    assert!((far_m / SHORT_M - 1.0).abs() < 1e-4, "{geometry} {pos}");
                    let back = map.in_space(map.in_chart(way));
                    assert!(back.distance(way) < 1e-12);
                    let long_m = map.in_chart(way).length();
                    assert!(long_m <= map.most_stretch());
                    let holds = map.half_box(way.abs()) - map.in_chart(way).abs();
                    assert!(holds.min_element() > -1e-12);
                }
            }
        }
    }
}
