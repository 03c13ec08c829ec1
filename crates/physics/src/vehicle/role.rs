//! Which bodies and which ground of one arena meet.
//!
//! Where a vehicle stands in a door, what is on the other side of it is written into the arena of this side. It lies where
//! there is ground of this side, too, so that an arena may have two things at one place that do not meet.

use rapier3d::geometry::{Group, InteractionGroups, InteractionTestMode};

/// How many junctions a pair of doors has: each leaf leads on from either of its sides.
pub(super) const JUNCTIONS: usize = 2;

/// What a vehicle is in a step. The number is that of a junction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Role {
    /// It has to do with no door.
    #[default]
    Free,
    /// It is on this side of one that somebody stands in.
    Native(usize),
    /// It is on the other side of one that somebody stands in.
    Guest(usize),
    /// It stands in one.
    Astride(usize),
}

/// What ground is in an arena. The number is that of a junction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Earth {
    /// That of the chart.
    Own,
    /// That of the other side, whole.
    Far(usize),
    /// That of both sides, each cut at the leaf.
    Sill(usize),
}

const OWN: Group = Group::GROUP_1;
const FREE: Group = Group::GROUP_2;
const FAR: [Group; JUNCTIONS] = [Group::GROUP_3, Group::GROUP_4];
const SILL: [Group; JUNCTIONS] = [Group::GROUP_5, Group::GROUP_6];
const NATIVE: [Group; JUNCTIONS] = [Group::GROUP_7, Group::GROUP_8];
const GUEST: [Group; JUNCTIONS] = [Group::GROUP_9, Group::GROUP_10];
const ASTRIDE: [Group; JUNCTIONS] = [Group::GROUP_11, Group::GROUP_12];

fn either(groups: [Group; JUNCTIONS]) -> Group {
    groups[0].union(groups[1])
}

fn both(memberships: Group, filter: Group) -> InteractionGroups {
    InteractionGroups::new(memberships, filter, InteractionTestMode::And)
}

impl Role {
    /// What a body in it meets.
    pub fn groups(self) -> InteractionGroups {
        let on_this_side = OWN.union(FREE).union(either(NATIVE));
        match self {
            Self::Free => both(FREE, on_this_side),
            Self::Native(at) => both(NATIVE[at], on_this_side.union(ASTRIDE[at])),
            Self::Guest(at) => {
                let others = either(GUEST).union(ASTRIDE[at]);
                both(GUEST[at], FAR[at].union(others))
            }
            Self::Astride(at) => {
                let others = ASTRIDE[at].union(NATIVE[at]).union(GUEST[at]);
                both(ASTRIDE[at], SILL[at].union(others))
            }
        }
    }
}

impl Earth {
    /// What meets it.
    pub fn groups(self) -> InteractionGroups {
        match self {
            Self::Own => both(OWN, FREE.union(either(NATIVE))),
            Self::Far(at) => both(FAR[at], GUEST[at]),
            Self::Sill(at) => both(SILL[at], ASTRIDE[at]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn who_stands_in_a_door_meets_both_sides_and_those_meet_only_their_own() {
        let meets = |a: InteractionGroups, b: InteractionGroups| a.test(b) && b.test(a);
        let astride = Role::Astride(0).groups();
        for other in [Role::Native(0), Role::Guest(0), Role::Astride(0)] {
            assert!(meets(astride, other.groups()), "{other:?}");
        }
        assert!(meets(astride, Earth::Sill(0).groups()));
        for ground in [Earth::Own, Earth::Far(0), Earth::Sill(1)] {
            assert!(!meets(astride, ground.groups()), "{ground:?}");
        }
        let (native, guest) = (Role::Native(0).groups(), Role::Guest(0).groups());
        assert!(!meets(native, guest) && !meets(Role::Free.groups(), guest));
        assert!(meets(native, Earth::Own.groups()) && meets(guest, Earth::Far(0).groups()));
        assert!(meets(native, Role::Free.groups()) && meets(native, Role::Native(1).groups()));
        assert!(!meets(native, Earth::Far(0).groups()) && !meets(guest, Earth::Own.groups()));
    }
}
