//! The order-7 heptagrid {7,3} as a graph without coordinates: exact, and made as it is walked.
//!
//! The edges of a tile are numbered 0 to 6 counterclockwise. A tile at distance n from the first
//! has one or two neighbours at distance n - 1, two at n, and the rest at n + 1; neighbours in
//! the ring at n share one neighbour at n + 1. So the tiles make a tree: edge 0 leads to the
//! parent, and a tile with two neighbours further in counts as the last child of one of them.
//! Every other edge follows from three tiles meeting at each corner.

/// Edges of a tile.
pub const EDGES: usize = 7;

/// A tile of a [`Tiling`], by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Tile(usize);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    First,
    /// One neighbour further in.
    OneInward,
    /// Two neighbours further in: by edge 0 and by edge 6.
    TwoInward,
}

#[derive(Clone, Debug)]
struct Node {
    kind: Kind,
    distance: u32,
    /// The neighbour by each edge, and which of its edges leads back.
    links: [Option<(Tile, usize)>; EDGES],
}

/// The tiles made so far.
#[derive(Clone, Debug)]
pub struct Tiling {
    nodes: Vec<Node>,
}

impl Default for Tiling {
    fn default() -> Self {
        Self::new()
    }
}

fn next(edge: usize) -> usize {
    (edge + 1) % EDGES
}

fn previous(edge: usize) -> usize {
    (edge + EDGES - 1) % EDGES
}

impl Tiling {
    /// The tile that distances are counted from.
    pub const FIRST: Tile = Tile(0);

    /// One tile.
    pub fn new() -> Self {
        let first = Node {
            kind: Kind::First,
            distance: 0,
            links: [None; EDGES],
        };
        Self { nodes: vec![first] }
    }

    /// The distance from the first tile, in tiles.
    pub fn distance(&self, tile: Tile) -> u32 {
        self.nodes[tile.0].distance
    }

    /// The neighbour by an edge (below [`EDGES`]), and the number of that edge on its side.
    pub fn neighbour(&mut self, tile: Tile, edge: usize) -> (Tile, usize) {
        if let Some(link) = self.nodes[tile.0].links[edge] {
            return link;
        }
        let last_child = match self.nodes[tile.0].kind {
            Kind::First => return self.child(tile, edge, Kind::OneInward),
            Kind::OneInward => 5,
            Kind::TwoInward => 4,
        };
        if edge == last_child {
            self.child(tile, edge, Kind::TwoInward)
        } else if (3..last_child).contains(&edge) {
            self.child(tile, edge, Kind::OneInward)
        } else if edge < 3 {
            let (beside, back) = self.neighbour(tile, edge - 1);
            let (found, corner) = self.neighbour(beside, previous(back));
            self.link(tile, edge, found, previous(corner))
        } else {
            let (beside, back) = self.neighbour(tile, next(edge));
            let (found, corner) = self.neighbour(beside, next(back));
            self.link(tile, edge, found, next(corner))
        }
    }

    /// The edge of `from` that leads to `to`, and the edge that leads back, if they are
    /// neighbours.
    pub fn edge_between(&mut self, from: Tile, to: Tile) -> Option<(usize, usize)> {
        (0..EDGES).find_map(|edge| {
            let (found, back) = self.neighbour(from, edge);
            (found == to).then_some((edge, back))
        })
    }

    /// Tiles from `from` to `to`, both included, if they are at most two apart.
    pub fn short_path(&mut self, from: Tile, to: Tile) -> Option<Vec<Tile>> {
        if from == to {
            return Some(vec![from]);
        }
        if self.edge_between(from, to).is_some() {
            return Some(vec![from, to]);
        }
        (0..EDGES).find_map(|edge| {
            let (middle, _) = self.neighbour(from, edge);
            let found = self.edge_between(middle, to).is_some();
            found.then(|| vec![from, middle, to])
        })
    }

    /// Tiles from `from` to `to`, both included: inwards from the farther end until the two ends
    /// are within two tiles. Shortest where one end is the first tile.
    pub fn path(&mut self, from: Tile, to: Tile) -> Vec<Tile> {
        let (mut head, mut tail) = (vec![from], vec![to]);
        loop {
            let (a, b) = (head[head.len() - 1], tail[tail.len() - 1]);
            if let Some(middle) = self.short_path(a, b) {
                head.extend(middle.into_iter().skip(1));
                head.extend(tail.into_iter().rev().skip(1));
                return head;
            }
            // Ends further apart than two tiles are not both the first, so one has a parent.
            if self.distance(a) >= self.distance(b) {
                head.push(self.neighbour(a, 0).0);
            } else {
                tail.push(self.neighbour(b, 0).0);
            }
        }
    }

    fn child(&mut self, tile: Tile, edge: usize, kind: Kind) -> (Tile, usize) {
        let made = Tile(self.nodes.len());
        let distance = self.distance(tile) + 1;
        let links = [None; EDGES];
        self.nodes.push(Node {
            kind,
            distance,
            links,
        });
        self.link(tile, edge, made, 0)
    }

    fn link(&mut self, tile: Tile, edge: usize, other: Tile, back: usize) -> (Tile, usize) {
        self.nodes[tile.0].links[edge] = Some((other, back));
        self.nodes[other.0].links[back] = Some((tile, edge));
        (other, back)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::{BTreeMap, HashSet, VecDeque};

    fn nearby(tiling: &mut Tiling, limit: u32) -> BTreeMap<u32, Vec<Tile>> {
        let mut rings = BTreeMap::from([(0, vec![Tiling::FIRST])]);
        let mut seen = HashSet::from([Tiling::FIRST]);
        let mut queue = VecDeque::from([(Tiling::FIRST, 0)]);
        while let Some((tile, distance)) = queue.pop_front() {
            assert_eq!(tiling.distance(tile), distance);
            for edge in 0..EDGES {
                let (found, _) = tiling.neighbour(tile, edge);
                if distance < limit && seen.insert(found) {
                    rings.entry(distance + 1).or_default().push(found);
                    queue.push_back((found, distance + 1));
                }
            }
        }
        rings
    }

    #[test]
    fn rings_grow_as_those_of_the_heptagrid() {
        let rings = nearby(&mut Tiling::new(), 6);
        let sizes: Vec<_> = rings.values().map(Vec::len).collect();
        assert_eq!(sizes, [1, 7, 21, 56, 147, 385, 1008]);
    }

    #[test]
    fn three_tiles_meet_at_every_corner() {
        let mut tiling = Tiling::new();
        for tile in nearby(&mut tiling, 5).into_values().flatten() {
            for edge in 0..EDGES {
                let (second, back) = tiling.neighbour(tile, edge);
                assert_eq!(tiling.neighbour(second, back), (tile, edge));
                let (third, corner) = tiling.neighbour(second, previous(back));
                let (closed, home) = tiling.neighbour(third, previous(corner));
                assert_eq!((closed, home), (tile, next(edge)));
            }
        }
    }

    #[test]
    fn a_path_goes_from_neighbour_to_neighbour() {
        let mut tiling = Tiling::new();
        let ring = nearby(&mut tiling, 5).remove(&5).unwrap_or_default();
        for &to in ring.iter().step_by(7) {
            let inwards = tiling.path(Tiling::FIRST, to);
            assert_eq!(inwards.len(), 6);
            let across = tiling.path(ring[0], to);
            assert_eq!((across[0], across[across.len() - 1]), (ring[0], to));
            for pair in across.windows(2) {
                assert!(tiling.edge_between(pair[0], pair[1]).is_some());
            }
        }
    }
}
