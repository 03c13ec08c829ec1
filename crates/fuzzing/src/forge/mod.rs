//! What a forger needs: the layouts of saves, written down a second time and apart from
//! the game, so that changed bytes can be given the checksums that they should have.

pub mod bases;
pub mod container;
pub mod pages;
pub mod plan;
pub mod record;
