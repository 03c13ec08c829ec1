//! What newcomers are taught, thing by thing, so that the file can keep what they have done already.

use crate::choice::words;

words! {
    /// Something to do for the first time.
    Lesson {
        /// Looking round.
        Look = "look",
        /// Walking.
        Walk = "walk",
        /// Jumping.
        Jump = "jump",
        /// Looking up to the land overhead, in a closed world.
        Overhead = "overhead",
        /// Talking.
        Talk = "talk",
        /// Getting into a car.
        Car = "car",
        /// Digging.
        Dig = "dig",
        /// Building.
        Build = "build",
        /// Turning the picture's dial.
        Curve = "curve",
        /// Changing to the space's other picture.
        Map = "map",
        /// Seeing oneself from behind.
        Camera = "camera",
        /// Switching the flashlight.
        Light = "light",
        /// Opening the backpack.
        Backpack = "backpack",
        /// The photo mode.
        Photo = "photo",
        /// Walking over the equator and straight on until one is home, in a closed world.
        Home = "home",
        /// The menu.
        Menu = "menu",
    }
}
