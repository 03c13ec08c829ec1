//! What can go wrong with a scene or with the adapter.

use thiserror::Error;

/// Why rays cannot be drawn. Each message says what happened, to what, and what can be done.
#[derive(Debug, Error)]
pub enum RaysError {
    /// A triangle names a corner that its mesh does not have.
    #[error(
        "Triangle {triangle} of mesh {mesh} has a corner that the mesh lacks. Export the model again."
    )]
    Corner {
        /// The mesh.
        mesh: usize,
        /// Its triangle.
        triangle: usize,
    },
    /// A number that is not finite.
    #[error("Mesh {mesh} has a corner whose place is no number. Export the model again.")]
    Place {
        /// The mesh.
        mesh: usize,
    },
    /// The lists of a mesh have different lengths.
    #[error(
        "Mesh {mesh} has {what} for only some of its corners or triangles. Export the model again."
    )]
    Lengths {
        /// The mesh.
        mesh: usize,
        /// Which list.
        what: &'static str,
    },
    /// A shape is given to a mesh that there is not.
    #[error("There is no mesh {mesh} that may move. Load the model first.")]
    NoMovable {
        /// The mesh, among those that may move.
        mesh: usize,
    },
    /// An instance names a mesh or a material that there is not, or has no size.
    #[error("Object {object} {what}.")]
    Instance {
        /// The object.
        object: u32,
        /// What is wrong with it.
        what: &'static str,
    },
    /// More than the adapter can hold.
    #[error("The room has {what}, more than the adapter can hold ({most}). Use simpler models.")]
    TooLarge {
        /// What there is too much of.
        what: String,
        /// How much there may be.
        most: u64,
    },
    /// The adapter lacks what rays need.
    #[error(
        "The graphics adapter cannot trace rays: {0} Draw the room in another way, or use another adapter."
    )]
    Adapter(String),
    /// The picture could not be read from the adapter's memory.
    #[error("The picture could not be read back: {0}. Start again.")]
    Readback(String),
    /// The adapter gives no memory to put a scene into.
    #[error(
        "The room could not be put into the graphics adapter's memory: {0}. Start again, or use simpler models."
    )]
    Upload(String),
}
