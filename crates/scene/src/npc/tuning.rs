//! Figures of the other figures' minds that a player feels, in one place, with their units.

/// Each thinks once in so many steps; they take turns by their numbers.
pub const THINKS_EVERY_STEPS: u64 = 6;
/// The player is noticed in sight within this distance, in metres.
pub const NOTICES_M: f64 = 30.0;
/// One that was noticed is kept in sight up to here, in metres.
pub const KEEPS_SIGHT_M: f64 = 45.0;
/// Half the angle that is seen at a glance, in radians.
pub const GLANCE_HALF_RAD: f64 = 100.0 * std::f64::consts::PI / 180.0;
/// A figure notices everybody who comes this near, from behind too, in metres.
pub const FEELS_M: f64 = 8.0;
/// Shots are heard within this distance, in metres.
pub const HEARS_SHOTS_M: f64 = 45.0;
/// A friend who is hit is seen within this distance, in metres.
pub const SEES_FRIENDS_M: f64 = 20.0;
/// The distances that a fighter keeps, in metres: nearer it backs off, farther it comes.
pub const KEEPS_M: (f64, f64) = (7.0, 13.0);
/// How far within these it goes on before it is content, in metres.
pub const KEEPS_SLACK_M: f64 = 1.5;
/// Farthest shot, in metres.
pub const SHOOTS_M: f64 = 20.0;
/// From noticing to the first shot, in seconds.
pub const FIRST_SHOT_S: f64 = 4.0;
/// How long the display points to one whom the picture hides before he fires, in seconds.
pub const MARKED_S: f64 = 2.0;
/// Between two shots at least and at most, in seconds.
pub const SHOTS_EVERY_S: [f64; 2] = [0.25, 3.0];
/// Speed of its bullets at the muzzle, in metres per second.
pub const MUZZLE_M_S: f64 = 20.0;
/// How far a shot goes astray at most, to each side, in radians.
pub const ASTRAY_RAD: f64 = 0.04;
/// Out of sight for so long, the player is given up, in seconds.
pub const GIVES_UP_S: f64 = 8.0;
/// How long a neutral one stays angry after the last damage, in seconds.
pub const ANGRY_S: f64 = 40.0;
/// With this health or less it flees.
pub const FLEES_AT_HEALTH: f64 = 1.0;
/// How long it flees after the last damage, in seconds.
pub const FLEES_S: f64 = 12.0;
/// How long a scare lasts, in seconds.
pub const SCARED_S: f64 = 5.0;
/// How far ahead who flees looks for a way, in metres.
pub const FLEES_BY_M: f64 = 10.0;
/// Health comes back so long after the last damage, in seconds.
pub const HEALS_AFTER_S: f64 = 10.0;
/// Health that comes back, per second.
pub const HEALS_PER_S: f64 = 0.1;
/// Shares of the walking speed: strolling, fighting, in chase and in flight.
pub const STROLL_PACE: f64 = 0.34;
/// Moving about in a fight.
pub const FIGHT_PACE: f64 = 0.6;
/// Coming after the player.
pub const CHASE_PACE: f64 = 1.0;
/// Running away.
pub const FLEE_PACE: f64 = 1.2;
/// Rest between two walks at most, in seconds.
pub const RESTS_S: f64 = 4.0;
/// How far a walk leads at least and at most, in metres.
pub const WALKS_M: [f64; 2] = [6.0, 18.0];
/// A friendly figure looks at a player within this distance, in metres, for so long and not again for so long, in seconds.
pub const WATCHES_M: f64 = 6.0;
/// How long at least and at most, in seconds.
pub const WATCHES_S: [f64; 2] = [2.0, 4.0];
/// And not again for so long, in seconds.
pub const WATCHES_AGAIN_S: f64 = 10.0;
/// A friendly figure steps aside when a passing player is this near, in metres.
pub const ASIDE_M: f64 = 2.2;
/// A lamp to sit by is looked for within this distance, in metres.
pub const LAMP_M: f64 = 30.0;
/// How far from a lamp one sits, in metres.
pub const SITS_M: f64 = 1.4;
/// Times of day between which one sits by a lamp, in seconds.
pub const DUSK_S: (f64, f64) = (285.0, 420.0);
/// A stone to sit on is looked for within this distance, in metres.
pub const SEATS_M: f64 = 12.0;
/// How often one who sets out by a stone that is fit goes to sit on it.
pub const SITS_SHARE: f64 = 0.4;
/// How long one sits on it at least and at most, in seconds.
pub const SITS_FOR_S: [f64; 2] = [20.0, 60.0];
/// And does not again for so long, in seconds.
pub const SITS_AGAIN_S: f64 = 90.0;
/// Times of day between which one sits down on stones, in seconds.
pub const DAYLIGHT_S: (f64, f64) = (0.0, 300.0);
/// Cover is looked for within this distance, in metres.
pub const COVER_M: f64 = 11.0;
/// Who was hit or aimed at by a shot wants cover for so long, in seconds.
pub const UNDER_FIRE_S: f64 = 3.0;
/// How long one stays in cover at least and at most, in seconds.
pub const COVERS_FOR_S: [f64; 2] = [5.0, 9.0];
/// And takes none again for so long, in seconds.
pub const COVERS_AGAIN_S: f64 = 8.0;
/// In cover one hides for so long, in seconds.
pub const HIDES_S: f64 = 2.0;
/// And looks out for so long by turns, in seconds.
pub const LOOKS_OUT_S: f64 = 1.8;
/// How fast one turns, in radians per second.
pub const TURNS_RAD_S: f64 = 5.0;
/// A car is run from when it would be here within so long, in seconds.
pub const DODGES_S: f64 = 1.8;
/// How far to the side of its way, in metres.
pub const DODGES_BY_M: f64 = 3.5;
/// How near one must be to be talked to, in metres: as near as one is looked at, so that four paces off on a slope,
/// where feet are farther apart than the ground is long, is near enough.
pub const TALKS_M: f64 = 6.0;
/// A figure hears a player this near, turns round and waits, in metres.
pub const HAILS_M: f64 = 25.0;
/// A figure that is spoken to stands still for so long, in seconds: time to come closer, or to read the answer.
pub const LISTENS_S: f64 = 6.0;
/// Bullets that the dead leave: of those who fight, and of others, at least and at most.
pub const LEAVES_BULLETS: [[u32; 2]; 2] = [[4, 8], [2, 4]];
/// How many live in an open world, and in a closed one.
pub const MOST_LIVING: (usize, usize) = (9, 7);
/// How many of them are hostile by nature: as many as one can face at once.
pub const MOST_HOSTILE: usize = 3;
/// A hostile one comes so long after the one before at the earliest, in seconds: who has won a fight has a rest.
pub const HOSTILE_EVERY_S: f64 = 30.0;
/// How old a world is before the first hostile one comes, in seconds: time to learn the keys in.
pub const PEACE_S: f64 = 300.0;
/// How far away one appears at least and at most, in metres.
pub const APPEARS_M: (f64, f64) = (38.0, 48.0);
/// Beyond this distance one that is not seen goes, in metres.
pub const GOES_M: f64 = 64.0;
/// Angle from the middle of the picture from which nothing is seen, in radians.
pub const UNSEEN_RAD: f64 = 70.0 * std::f64::consts::PI / 180.0;
