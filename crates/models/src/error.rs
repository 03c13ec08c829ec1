//! Why a file is not taken as a model.

/// Why a file is not taken as a model; each reads as one sentence for the player.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    /// It does not begin as a .glb file does.
    #[error("This is not a binary glTF file (.glb).")]
    NotGlb,
    /// The container's version, which is not 2.
    #[error("This is version {0} of binary glTF, and only version 2 can be read.")]
    Version(u32),
    /// It ends before its own lengths say.
    #[error("The file is cut short.")]
    Truncated,
    /// The file's description cannot be read; what the parser says.
    #[error("The file's description is damaged ({0}).")]
    Description(String),
    /// It has an extension that it cannot be shown without.
    #[error("The file needs the extension {0}, which is not supported.")]
    Extension(String),
    /// Data that lie in other files.
    #[error("The file stores its {0} in another file, and only self-contained files can be read.")]
    External(&'static str),
    /// Shapes that are blended.
    #[error("The mesh '{0}' has morph targets, which are not supported.")]
    MorphTargets(String),
    /// More than four joints for a vertex.
    #[error("The mesh '{0}' has vertices with more than four joints.")]
    Influences(String),
    /// Points or lines.
    #[error("The mesh '{0}' is made of points or lines, and only triangles can be drawn.")]
    NotTriangles(String),
    /// Something has another type than it must.
    #[error("The {0} are stored in a way that glTF does not allow or that is not supported.")]
    Format(&'static str),
    /// A reference to something that is not there.
    #[error("The file refers to {0} that it does not have.")]
    OutOfRange(&'static str),
    /// Not a number, infinite, or far too large.
    #[error("The {0} contain values that are not numbers or that are far too large.")]
    Absurd(&'static str),
    /// More of something than anyone needs.
    #[error("The file has too many {0}.")]
    TooMany(&'static str),
    /// Nodes that hang from each other in a circle, or from two others.
    #[error("The file's nodes do not form a tree.")]
    NotATree,
    /// Key times that do not grow.
    #[error("The clip '{0}' has key times that do not rise from zero.")]
    KeyTimes(String),
    /// The picture cannot be decoded.
    #[error("A picture in the file cannot be read ({0}).")]
    Picture(String),
    /// There is nothing to draw.
    #[error("The file has nothing to draw.")]
    Empty,
}
