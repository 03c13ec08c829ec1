//! What a scene has to tell the player. As text it is English, for logs and scripts; the window says it in the
//! player's language.

use antipode_geometry::HyperbolicMap;
use antipode_items::Item;
use antipode_streaming::{Cause, NotUndone};
use antipode_terrain::Kind;
use thiserror::Error;

use crate::npc::Line;

/// Something that went wrong.
#[derive(Clone, Debug, Error)]
pub enum Notice {
    /// The player of the save was damaged. The land is unchanged.
    #[error(
        "The player in this save was damaged, so you begin at the start again. Your land is unchanged."
    )]
    PlayerDamaged,
    /// The save holds an item that this version does not know.
    #[error(
        "The save holds an item this version does not know (\"{0}\"); it is not shown, but stays in the save."
    )]
    UnknownItem(String),
    /// The save holds so many records of things that only a later version knows.
    #[error("Things of a newer version in the save ({0}) are not shown, but stay in it.")]
    UnknownRecords(usize),
    /// The save names a map that this version does not know.
    #[error("The save names a map this version does not know (\"{0}\"); another is shown.")]
    UnknownMap(String),
    /// A save failed. Nothing is lost yet; the next save tries again.
    #[error("The world could not be saved; the next save tries again. {0}")]
    NotSaved(Cause),
    /// Places of the save are damaged besides those that were told one by one.
    #[error("There are {0} more damaged places in this world; `antipode saves verify` lists them.")]
    MoreDamaged(usize),
    /// A place of the save is damaged, as an English sentence.
    #[error("{0}")]
    Damaged(String),
    /// Something is wrong with the land, as an English sentence.
    #[error("{0}")]
    Land(String),
}

/// Two notices are the same if they tell the same.
impl PartialEq for Notice {
    fn eq(&self, other: &Self) -> bool {
        self.to_string() == other.to_string()
    }
}

/// What is against a place for a door.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum Unfit {
    /// The ground rises or falls too much below it.
    #[error("The ground here is too steep for a door: find a level place, or dig or build one.")]
    Steep,
    /// There is rock where one would walk through.
    #[error("Rock is in the way here: a door needs a metre of room before and behind it.")]
    Walled,
    /// The other one of the pair is too close.
    #[error("The other door is too close: leave two and a half metres between them.")]
    Crowded,
}

/// A short answer to what the player did.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum Hint {
    /// The space has no other map.
    #[error("The sphere has no other map.")]
    NoOtherMap,
    /// This map is shown now.
    #[error("The {0} map")]
    Map(HyperbolicMap),
    /// The picture of a flat world can be bent now.
    #[error("Wheel up bends the picture to hyperbolic, down to spherical.")]
    Bent,
    /// The picture of a flat world is flat again.
    #[error("The picture is flat again.")]
    Unbent,
    /// The gun has nothing to shoot.
    #[error("You have no bullets left.")]
    NoBullets,
    /// The crosshair meets no ground near enough where such a thing would stay.
    #[error("There is no ground within eight metres on which a {} can stand.", .0.id())]
    NoPlaceFor(Item),
    /// The crosshair meets ground, but a door cannot stand there.
    #[error("{0}")]
    Unfit(Unfit),
    /// The crosshair covers no such thing.
    #[error("There is no {} under the crosshair.", .0.id())]
    NoneThere(Item),
    /// The world has as many such things as it can have.
    #[error("There are too many of these in this world: {}. Take one up first.", .0.id())]
    TooMany(Item),
    /// The world had as many such things as it can have, so the oldest stands here now.
    #[error("The older {} stands here now.", .0.id())]
    MovedOldest(Item),
    /// Nothing fits into the hotbar and the backpack any more.
    #[error("You cannot carry any more.")]
    NoRoom,
    /// Too many things lie about for one more.
    #[error("Too many things lie around already; pick something up first.")]
    TooManyDrops,
    /// The player has died of a fall.
    #[error("You fell too far. You will stand up again where you began.")]
    DiedOfFall,
    /// The player was shot dead.
    #[error("You were shot. You will stand up again where you began.")]
    DiedOfShot,
    /// The car that the player drove ran into something too hard.
    #[error("The crash killed you. You will stand up again where you began.")]
    DiedOfCrash,
    /// The player was run over.
    #[error("A car ran you over. You will stand up again where you began.")]
    DiedOfCar,
    /// The player died under a tree.
    #[error("A tree fell on you. You will stand up again where you began.")]
    DiedOfTree,
    /// There is no car to get into.
    #[error("There is no car in view within four metres.")]
    NoCarNear,
    /// A car is close by, but not in view.
    #[error("The car is beside you. Look at it to get in.")]
    LookAtCar,
    /// A car is in view, but not close by.
    #[error("The car is too far away to get in. Go closer.")]
    CarTooFar,
    /// The player has got into a car.
    #[error("You are at the wheel.")]
    AtTheWheel,
    /// The car that the player drives lies on its side or roof.
    #[error("The car has fallen over.")]
    FallenOver,
    /// There is no room beside the car.
    #[error("There is no free ground beside the car to get out on.")]
    NoWayOut,
    /// Nobody peaceful is close by and ahead.
    #[error("There is nobody ahead to talk to.")]
    NobodyToTalkTo,
    /// Somebody peaceful is ahead, but not close by.
    #[error("They are too far away to talk to. Go closer.")]
    TooFarToTalk,
    /// Whoever was called is too far away to talk to, and has stopped.
    #[error("They have heard you and wait. Go closer to talk.")]
    WaitsToTalk,
    /// What would be built would fill the place of a player who cannot be lifted out of it.
    #[error(
        "You stand in the way of what you build, under a roof. Step back, or take a smaller brush."
    )]
    InTheWay,
    /// There is no ground within reach of the tool in hand.
    #[error("Nothing to dig is within reach. Go closer.")]
    OutOfReach,
    /// Such ground is too hard for the tool in hand.
    #[error("The {} is too hard for this pickaxe.", .0.name())]
    TooHard(Kind),
    /// Nothing is left of what would be built; nothing at all where no kind is named.
    #[error("You have no {} left to build with.", .0.map_or("ground", Kind::name))]
    UsedUp(Option<Kind>),
    /// The last of what is laid along a way is laid.
    #[error("That was your last: the way that you lay ends here.")]
    LastLaid(Item),
    /// So many of something were made of ground.
    #[error("You have made this: {} x {}.", .0.id(), .1)]
    Made(Item, u32),
    /// Much was dug in the depth, and no coal.
    #[error(
        "You have dug deep and found no coal. Its beds lie under about half of the land: dig some thirty metres on, or look at the walls of a cave."
    )]
    NoCoalYet,
    /// The last stroke of the brush is undone.
    #[error("The last stroke is undone.")]
    Undone,
    /// The last stroke of the brush stays.
    #[error("{0}")]
    NotUndone(NotUndone),
    /// Somebody says a line about the space.
    #[error("{}{line}", if *greets { "Hello! " } else { "" })]
    Said {
        /// Whether it is the first that this one says.
        greets: bool,
        /// The line.
        line: Line,
    },
    /// The player has gone once round the world.
    #[error("You have come all the way round the world, {0} m, and are back where you were.")]
    BeenRound(u32),
    /// The player has come into another biome, or a cave, by its name.
    #[error("You have come into another kind of land: {0}.")]
    Entered(&'static str),
    /// The player stands up again.
    #[error("You are back at the start. What you carried is still with you.")]
    BackAgain,
}
