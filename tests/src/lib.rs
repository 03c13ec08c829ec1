//! Helpers shared by the tests: running the program, reading its probes, comparing pictures.

pub mod background;
pub mod processes;
pub mod program;
pub mod screen;
pub mod seam;
pub mod system;
pub mod window;
