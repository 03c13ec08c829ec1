//! Terrain to walk on, and a walker: shared by the tests and the benches of this crate.
#![allow(dead_code, reason = "the benches use a part")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

use antipode_geometry::{ChartId, ChunkCoord};
use antipode_physics::{
    Character, CharacterInput, CharacterTuning, ChartGround, PhysicsWorld, TerrainCollider,
};
use glam::{DVec3, IVec3, Vec3};

pub const STEP_S: f64 = 1.0 / 60.0;

/// A bag of triangles.
#[derive(Clone, Default)]
pub struct Soup {
    pub positions: Vec<[f32; 3]>,
    pub triangles: Vec<[u32; 3]>,
}

impl Soup {
    /// Adds a triangle whose air side is the one `towards` points to.
    pub fn triangle(&mut self, corners: [Vec3; 3], towards: Vec3) {
        let [a, b, c] = corners;
        let corners = if (b - a).cross(c - a).dot(towards) < 0.0 {
            [a, c, b]
        } else {
            corners
        };
        let first = self.positions.len() as u32;
        self.positions
            .extend(corners.map(|corner| corner.to_array()));
        self.triangles.push([first, first + 1, first + 2]);
    }

    pub fn quad(&mut self, [a, b, c, d]: [Vec3; 4], towards: Vec3) {
        self.triangle([a, b, c], towards);
        self.triangle([a, c, d], towards);
    }

    /// The surface of a box, solid inside.
    pub fn cuboid(&mut self, min: [f32; 3], max: [f32; 3]) {
        let corner = |i: usize| {
            let pick = |axis: usize| {
                if i >> axis & 1 == 1 {
                    max[axis]
                } else {
                    min[axis]
                }
            };
            Vec3::new(pick(0), pick(1), pick(2))
        };
        for axis in 0..3 {
            let (u, v) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
            for side in [0, 1 << axis] {
                let out = corner(1 << axis) - corner(0);
                let out =
                    Vec3::from_array(std::array::from_fn(
                        |k| if k == axis { out[k] } else { 0.0 },
                    ));
                let towards = if side == 0 { -out } else { out };
                self.quad(
                    [
                        corner(side),
                        corner(side + u),
                        corner(side + u + v),
                        corner(side + v),
                    ],
                    towards,
                );
            }
        }
    }

    /// Ground of 1 m cells whose height is a function of (x, z).
    pub fn field(&mut self, from: i32, to: i32, height: impl Fn(f32, f32) -> f32) {
        let at = |x: i32, z: i32| Vec3::new(x as f32, height(x as f32, z as f32), z as f32);
        for x in from..to {
            for z in from..to {
                self.quad(
                    [at(x, z), at(x + 1, z), at(x + 1, z + 1), at(x, z + 1)],
                    Vec3::Y,
                );
            }
        }
    }

    /// The zero surface of a density (negative is solid) over a box of 1 m cells, each cut into six
    /// tetrahedra: as closed as marching cubes, with more and worse slivers.
    pub fn march(&mut self, min: IVec3, max: IVec3, density: impl Fn(Vec3) -> f32) {
        const PATHS: [[usize; 4]; 6] = [
            [0, 1, 3, 7],
            [0, 1, 5, 7],
            [0, 2, 3, 7],
            [0, 2, 6, 7],
            [0, 4, 5, 7],
            [0, 4, 6, 7],
        ];
        for x in min.x..max.x {
            for y in min.y..max.y {
                for z in min.z..max.z {
                    let corner = |i: usize| {
                        let step = IVec3::new(i as i32 & 1, i as i32 >> 1 & 1, i as i32 >> 2 & 1);
                        (IVec3::new(x, y, z) + step).as_vec3()
                    };
                    for path in PATHS {
                        self.tetrahedron(path.map(corner), &density);
                    }
                }
            }
        }
    }

    fn tetrahedron(&mut self, corners: [Vec3; 4], density: &impl Fn(Vec3) -> f32) {
        let (solid, air): (Vec<Vec3>, Vec<Vec3>) =
            corners.into_iter().partition(|&at| density(at) < 0.0);
        if solid.is_empty() || air.is_empty() {
            return;
        }
        let cut = |s: Vec3, a: Vec3| {
            let (ds, da) = (density(s), density(a));
            s.lerp(a, ds / (ds - da))
        };
        let mean = |points: &[Vec3]| points.iter().copied().sum::<Vec3>() / points.len() as f32;
        let towards = mean(&air) - mean(&solid);
        match (solid.as_slice(), air.as_slice()) {
            (&[s], &[a, b, c]) => self.triangle([cut(s, a), cut(s, b), cut(s, c)], towards),
            (&[s, t, u], &[a]) => self.triangle([cut(s, a), cut(t, a), cut(u, a)], towards),
            (&[s, t], &[a, b]) => self.quad([cut(s, a), cut(s, b), cut(t, b), cut(t, a)], towards),
            _ => {}
        }
    }

    pub fn build(&self) -> TerrainCollider {
        TerrainCollider::build(&self.positions, &self.triangles).unwrap()
    }

    /// A chart with this soup at `origin`.
    pub fn world_at(&self, origin: DVec3) -> ChartGround {
        let mut world = ChartGround::new();
        world.set_terrain(coord(0, 0, 0), origin, Some(self.build()));
        world
    }

    /// As [`Self::world_at`], among all charts.
    pub fn charts_at(&self, origin: DVec3) -> PhysicsWorld {
        let mut world = PhysicsWorld::new();
        *world.chart_mut(ChartId::FIRST) = self.world_at(origin);
        world
    }

    pub fn world(&self) -> ChartGround {
        self.world_at(DVec3::ZERO)
    }
}

pub fn coord(x: i32, y: i32, z: i32) -> ChunkCoord {
    ChunkCoord {
        chart: ChartId::FIRST,
        index: IVec3::new(x, y, z),
    }
}

/// Level ground at y = 0, 128 m across.
pub fn plain() -> Soup {
    let mut soup = Soup::default();
    soup.field(-64, 64, |_, _| 0.0);
    soup
}

/// Hills as the terrain makes them, at most about 35 degrees steep, with slivers.
pub fn bumps(at: Vec3) -> f32 {
    at.y - 1.1 * (at.x * 0.45).sin() * (at.z * 0.37).cos() - 0.25 * (at.x * 1.3 + at.z).sin()
}

/// A walker over a world, with its script.
pub struct Walker<'a> {
    pub world: &'a ChartGround,
    pub character: Character,
    pub tuning: CharacterTuning,
}

impl<'a> Walker<'a> {
    pub fn at(world: &'a ChartGround, x: f64, y: f64, z: f64) -> Self {
        let character = Character::at(DVec3::new(x, y, z));
        Self {
            world,
            character,
            tuning: CharacterTuning::default(),
        }
    }

    /// Lets the walker come to rest.
    pub fn rested(mut self) -> Self {
        self.steps(60, CharacterInput::default());
        self
    }

    pub fn step(&mut self, input: CharacterInput) {
        self.world
            .in_chart()
            .move_character(&mut self.character, &self.tuning, &input, STEP_S);
    }

    pub fn steps(&mut self, count: usize, input: CharacterInput) {
        for _ in 0..count {
            self.step(input);
        }
    }

    pub fn feet(&self) -> DVec3 {
        self.character.feet
    }
}

pub fn go(x: f64, z: f64) -> CharacterInput {
    CharacterInput {
        wish: DVec3::new(x, 0.0, z),
        ..CharacterInput::default()
    }
}

pub fn jump() -> CharacterInput {
    CharacterInput {
        jump: true,
        ..CharacterInput::default()
    }
}

pub fn still() -> CharacterInput {
    CharacterInput::default()
}
