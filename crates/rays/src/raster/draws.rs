//! What a raster is told to draw: stretches of triangles and faces of boxes, for each view those that may be seen in it.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use glam::{Affine3A, DAffine3, DMat3, DVec2, DVec3, Mat4, Vec3, Vec4};

use super::plan::{Face, Kind, NEAR_M, Plan, View};
use crate::packed::stack;

/// Triangles that are drawn or left out together.
const TOGETHER: usize = 128;
/// What is seen: a wall, with its box, axis and side; a door, with its view; or what only rays know. As in
/// `first_by_raster.wgsl`.
const WALL_SEEN: u32 = 0x8000_0000;
const DOOR_SEEN: u32 = 0xc000_0000;
const RAYS_SEE: u32 = 0xe000_0000;
/// Which portal a path has come out of: none, and before its front. As in portal.wgsl.
const NO_PORTAL: u32 = u32::MAX;
const BEFORE_FRONT: u32 = 256;
/// Faces lie so much farther off, as a share, than solids that lie in them; portals as much nearer.
const ASIDE: f32 = 4e-6;

/// Triangles behind each other in the adapter's memory, and their box.
#[derive(Clone, Debug, PartialEq)]
pub struct Chunk {
    /// By number.
    pub triangles: Range<u32>,
    /// Least corner.
    pub low: Vec3,
    /// Greatest corner.
    pub high: Vec3,
}

impl Chunk {
    /// All triangles of a list of three texels for each: a corner and two edges.
    pub fn all(texels: &[[u32; 4]]) -> Vec<Self> {
        let vector =
            |texel: &[u32; 4]| Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(texel[i])));
        let triangles = texels.as_chunks::<3>().0;
        let chunks = triangles
            .chunks(TOGETHER)
            .enumerate()
            .map(|(number, some)| {
                let first = (number * TOGETHER) as u32;
                let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
                for [corner, one, other] in some {
                    let corner = vector(corner);
                    for place in [corner, corner + vector(one), corner + vector(other)] {
                        (low, high) = (low.min(place), high.max(place));
                    }
                }
                Self {
                    triangles: first..first + some.len() as u32,
                    low,
                    high,
                }
            });
        chunks.collect()
    }
}

/// A mesh that moves, where it is.
#[derive(Clone, Debug)]
pub struct Moved {
    /// Its triangles, by number.
    pub triangles: Range<u32>,
    /// To the scene.
    pub pose: Affine3A,
    /// Its box in the scene.
    pub low: Vec3,
    /// The greatest corner of that.
    pub high: Vec3,
    /// Its number as an instance.
    pub instance: u32,
    /// Whether only the eye sees it: not through portals.
    pub is_held: bool,
    /// Whether the eye looks through it: it is seen through portals only.
    pub is_unseen: bool,
    /// A plane in its own coordinates, what is behind which is not there; none if it is whole.
    pub cut: Option<Vec4>,
}

/// What is drawn at once, as raster.wgsl has it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct PackedDraw {
    to_clip: Mat4,
    eye: Vec3,
    depth_factor: f32,
    cut: Vec4,
    own_cut: Vec4,
    what: u32,
    instance: u32,
    view: u32,
    door: u32,
}

/// A view, as `first_by_raster.wgsl` has it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct PackedView {
    origin: Vec3,
    depth: u32,
    k: [Vec4; 3],
    turn: [Vec4; 3],
    stack: [u32; 4],
    scale: f32,
    left: u32,
    passed: u32,
    room: u32,
}

/// A call to draw.
#[derive(Clone, Debug, PartialEq)]
pub struct Call {
    /// In which level.
    pub level: usize,
    /// The part of the picture that it may change: least and greatest x and y, from -1 at the left and the bottom to 1.
    pub extent: (DVec2, DVec2),
    /// Whether faces are drawn, or triangles.
    pub is_faces: bool,
    /// Whether what is drawn is cut.
    pub is_cut: bool,
    /// Vertices.
    pub vertices: Range<u32>,
    /// Which of the draws.
    pub draws: Range<u32>,
}

/// All that is drawn for a sample of a picture.
#[derive(Debug, Default)]
pub struct Draws {
    /// For the adapter.
    pub packed: Vec<PackedDraw>,
    /// Level by level.
    pub calls: Vec<Call>,
}

/// What there is to draw.
#[derive(Clone, Copy, Debug)]
pub struct Stock<'a> {
    /// What stays.
    pub chunks: &'a [Chunk],
    /// What moves.
    pub moved: &'a [Moved],
}

impl Draws {
    /// Adds all that a plan shows. `shift` is how far the picture is moved, in its own coordinates from -1 to 1.
    pub fn add(&mut self, plan: &Plan, stock: &Stock<'_>, shift: DVec2) {
        let mut faces = plan.faces.iter().peekable();
        for (number, view) in plan.views.iter().enumerate() {
            let camera = Camera::new(number, view, shift);
            self.add_resting(&camera, stock.chunks);
            for moved in stock.moved {
                let hidden = if view.passed > 0 {
                    moved.is_held
                } else {
                    moved.is_unseen
                };
                if !hidden && camera.may_see(moved.low, moved.high) {
                    let pose = DAffine3 {
                        matrix3: DMat3::from_cols(
                            moved.pose.matrix3.x_axis.as_dvec3(),
                            moved.pose.matrix3.y_axis.as_dvec3(),
                            moved.pose.matrix3.z_axis.as_dvec3(),
                        ),
                        translation: moved.pose.translation.as_dvec3(),
                    };
                    let draw = PackedDraw {
                        own_cut: moved.cut.unwrap_or_default(),
                        ..camera.packed(&pose, 0, moved.instance)
                    };
                    self.call(view, vertices(&moved.triangles), draw, moved.cut.is_some());
                }
            }
            let own = std::iter::from_fn(|| faces.next_if(|face| face.view == number));
            let (portals, sides): (Vec<_>, Vec<_>) = own.partition(|face| face.is_portal);
            for (faces, vertices) in [(sides, 0..6), (portals, 0..3)] {
                let first = self.packed.len() as u32;
                self.packed
                    .extend(faces.into_iter().map(|face| camera.face(face)));
                self.calls.push(Call {
                    level: view.level,
                    extent: view.extent,
                    is_faces: true,
                    is_cut: false,
                    vertices,
                    draws: first..self.packed.len() as u32,
                });
            }
        }
    }

    fn add_resting(&mut self, camera: &Camera<'_>, chunks: &[Chunk]) {
        let mut run: Option<Range<u32>> = None;
        let draw = camera.packed(&DAffine3::IDENTITY, 0, 0);
        for chunk in chunks.iter().filter(|it| camera.may_see(it.low, it.high)) {
            match &mut run {
                Some(run) if run.end == chunk.triangles.start => run.end = chunk.triangles.end,
                _ => {
                    if let Some(done) = run.replace(chunk.triangles.clone()) {
                        self.call(camera.view, vertices(&done), draw, false);
                    }
                }
            }
        }
        if let Some(last) = run {
            self.call(camera.view, vertices(&last), draw, false);
        }
    }

    fn call(&mut self, view: &View, vertices: Range<u32>, draw: PackedDraw, is_cut: bool) {
        let first = self.packed.len() as u32;
        self.packed.push(draw);
        self.calls.push(Call {
            level: view.level,
            extent: view.extent,
            is_faces: false,
            is_cut,
            vertices,
            draws: first..first + 1,
        });
    }
}

fn vertices(triangles: &Range<u32>) -> Range<u32> {
    3 * triangles.start..3 * triangles.end
}

/// A view as a camera.
struct Camera<'a> {
    number: usize,
    view: &'a View,
    shift: DVec2,
    /// What is seen has no negative product, about the origin of the view, with any of these.
    planes: [DVec3; 4],
}

impl<'a> Camera<'a> {
    fn new(number: usize, view: &'a View, shift: DVec2) -> Self {
        let [x, y, depth] = view.rows;
        // Samples lie beside the middles of pixels.
        let spare = 0.01;
        let (low, high) = (view.extent.0 - spare, view.extent.1 + spare);
        Self {
            number,
            view,
            shift,
            planes: [
                x - depth * low.x,
                y - depth * low.y,
                depth * high.x - x,
                depth * high.y - y,
            ],
        }
    }

    /// Whether a part of a box may lie in the view and behind its door.
    fn may_see(&self, low: Vec3, high: Vec3) -> bool {
        let (low, high) = (low.as_dvec3(), high.as_dvec3());
        let farthest = |n: DVec3| n.max(DVec3::ZERO).dot(high) + n.min(DVec3::ZERO).dot(low);
        let is_in = |n: &DVec3| farthest(*n) >= n.dot(self.view.origin);
        let is_beyond = self.view.cut.is_none_or(|(n, d)| farthest(n) >= d);
        is_beyond && self.planes.iter().all(is_in)
    }

    fn packed(&self, pose: &DAffine3, what: u32, instance: u32) -> PackedDraw {
        let View {
            rows, origin, cut, ..
        } = self.view;
        let [x, y, depth] = rows;
        let rows = [x + depth * self.shift.x, y + depth * self.shift.y, *depth];
        let matrix = pose.matrix3;
        // x, y, z and w of the picture: z is the same everywhere, so that z / w falls with depth from 1 to 0.
        let [x, y, w] = rows.map(|row| matrix.transpose() * row);
        let near = NEAR_M as f32;
        let to_clip = Mat4::from_cols(
            Vec4::new(x.x as f32, y.x as f32, 0.0, w.x as f32),
            Vec4::new(x.y as f32, y.y as f32, 0.0, w.y as f32),
            Vec4::new(x.z as f32, y.z as f32, 0.0, w.z as f32),
            Vec4::new(0.0, 0.0, near, 0.0),
        );
        let cut = cut.map_or(Vec4::ZERO, |(n, d)| {
            let away = n.dot(pose.translation) - d;
            (matrix.transpose() * n).as_vec3().extend(away as f32)
        });
        PackedDraw {
            to_clip,
            eye: pose.inverse().transform_point3(*origin).as_vec3(),
            depth_factor: 1.0,
            cut,
            own_cut: Vec4::ZERO,
            what,
            instance,
            view: self.number as u32,
            door: DOOR_SEEN | self.number as u32,
        }
    }

    fn face(&self, face: &Face) -> PackedDraw {
        let what = match face.kind {
            Kind::Wall(number, axis, is_far) => {
                WALL_SEEN | (number as u32) << 3 | (axis as u32) << 1 | u32::from(is_far)
            }
            Kind::Door(view) => DOOR_SEEN | view as u32,
            Kind::Rays => RAYS_SEE,
        };
        let mut draw = self.packed(&face.pose, what, 0);
        // A solid that lies in a face of a box is seen, and one in the plane of a portal is not.
        draw.depth_factor = if face.is_portal {
            1.0 + ASIDE
        } else {
            1.0 - ASIDE
        };
        draw
    }
}

/// A view for the adapter.
pub fn pack(view: &View) -> PackedView {
    let columns = |m: &DMat3| [0, 1, 2].map(|i| m.col(i).as_vec3().extend(0.0));
    let left = view.left.map_or(NO_PORTAL, |(portal, front)| {
        portal as u32 | if front { BEFORE_FRONT } else { 0 }
    });
    PackedView {
        origin: view.origin.as_vec3(),
        depth: view.stack.len() as u32,
        k: columns(&(view.carry * view.turn.transpose())),
        turn: columns(&view.turn),
        stack: stack(&view.stack),
        scale: view.scale as f32,
        left,
        passed: view.passed,
        room: 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Eye;
    use antipode_deformation::{Place, Space};

    fn triangle(x: f32) -> [[u32; 4]; 3] {
        crate::mesh::triangle(
            [Vec3::X * x, Vec3::X * x + Vec3::Y, Vec3::X * x + Vec3::Z],
            0,
            true,
            0,
        )
    }

    #[test]
    fn triangles_out_of_view_are_left_out() {
        let texels: Vec<_> = (0..1000).flat_map(|n| triangle(0.1 * n as f32)).collect();
        let chunks = Chunk::all(&texels);
        assert_eq!(chunks.last().map(|it| it.triangles.end), Some(1000));
        let space = Space::default();
        let from = DVec3::new(50.0, 0.0, 20.0);
        let eye = Eye::looking(Place::at(&space, from), DVec3::NEG_Z, DVec3::Y, 0.5);
        let plan = Plan::plain(&space, &eye, 1.0);
        let stock = Stock {
            chunks: &chunks,
            moved: &[],
        };
        let mut draws = Draws::default();
        draws.add(&plan, &stock, DVec2::ZERO);
        let drawn: Vec<_> = draws.calls.iter().filter(|it| !it.is_faces).collect();
        // It sees from x = 45 to 55.
        assert_eq!(drawn.len(), 1, "{drawn:?}");
        let seen = &drawn[0].vertices;
        assert!(seen.start <= 3 * 450 && seen.end >= 3 * 550, "{seen:?}");
        assert!(
            seen.end - seen.start <= 3 * (100 + 2 * TOGETHER as u32),
            "{seen:?}"
        );
    }
}
