//! Hierarchies of meshes that may move, kept for as long as somebody else keeps the mesh: scenes that are loaded one after another
//! mostly have the same.

use std::sync::{Arc, Mutex, PoisonError, Weak};

use crate::error::RaysError;
use crate::mesh::Mesh;
use crate::tree::Tree;

/// The hierarchies that were made.
#[derive(Debug, Default)]
pub struct Trees(Mutex<Vec<(Weak<Mesh>, Tree)>>);

impl Trees {
    /// That of a mesh, which `make` makes where there is none yet.
    pub fn of(
        &self,
        mesh: &Arc<Mesh>,
        make: impl FnOnce(&Mesh) -> Result<Tree, RaysError>,
    ) -> Result<Tree, RaysError> {
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        // Before it is looked for: another mesh may be where one was that is gone.
        all.retain(|(known, _)| known.strong_count() > 0);
        let is_of = |(known, _): &&(Weak<Mesh>, Tree)| known.as_ptr() == Arc::as_ptr(mesh);
        if let Some((_, tree)) = all.iter().find(is_of) {
            return Ok(tree.clone());
        }
        let tree = make(mesh)?;
        all.push((Arc::downgrade(mesh), tree.clone()));
        Ok(tree)
    }
}
