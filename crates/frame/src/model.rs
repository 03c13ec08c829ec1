//! What figures are drawn with: the models of `assets/tables/models.ron`, and every item.

use antipode_items::Item;

antipode_tables::models!();

/// What the table says of a model.
struct Row {
    shape: ModelShape,
    switched: bool,
    shades: bool,
}

/// Where the triangles of a model come from. Bytes are those of a glTF file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModelShape {
    /// The whole of a file, about its origin.
    Whole(&'static [u8]),
    /// What hangs from the node of that name, about it.
    Part(&'static [u8], &'static str),
    /// A file with a skeleton, which is bent by it.
    Bent(&'static [u8]),
    /// No file.
    Made,
}

impl ModelId {
    /// Every model.
    pub const ALL: [Self; Self::OTHERS.len() + Item::ALL.len()] = {
        let mut all = [Self::Astronaut; Self::OTHERS.len() + Item::ALL.len()];
        let mut place = 0;
        while place < all.len() {
            all[place] = if place < Self::OTHERS.len() {
                Self::OTHERS[place]
            } else {
                Self::Item(Item::ALL[place - Self::OTHERS.len()])
            };
            place += 1;
        }
        all
    };

    /// Its row; none of an item.
    fn row(self) -> Option<&'static Row> {
        let place = Self::OTHERS.iter().position(|it| *it == self)?;
        ROWS.get(place)
    }

    /// Where its triangles come from.
    pub fn shape(self) -> ModelShape {
        match self {
            Self::Item(item) => ModelShape::Whole(item.model()),
            other => other.row().map_or(ModelShape::Made, |row| row.shape),
        }
    }

    /// Whether its glowing parts are drawn as bright as a lamp, for others to see by.
    pub fn shines(self) -> bool {
        matches!(self, Self::Item(item) if item.shines())
    }

    /// Whether what glows of it is switched by its figure's `lights` and `brakes`.
    pub fn is_switched(self) -> bool {
        self.row().is_some_and(|row| row.switched)
    }

    /// Whether it is large enough to have a shade below it.
    pub fn casts_shade(self) -> bool {
        self.row().is_some_and(|row| row.shades)
    }
}

impl From<Item> for ModelId {
    fn from(item: Item) -> Self {
        Self::Item(item)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_model_has_a_shape_of_its_own_and_only_the_flash_has_no_file() {
        for (place, model) in ModelId::ALL.into_iter().enumerate() {
            let shape = model.shape();
            assert_eq!(shape == ModelShape::Made, model == ModelId::Flash);
            let others = &ModelId::ALL[..place];
            assert!(others.iter().all(|other| other.shape() != shape));
        }
        let shades = ModelId::ALL.into_iter().filter(|it| it.casts_shade());
        let large = [ModelId::Astronaut, ModelId::AstronautTeal, ModelId::CarBody];
        assert!(shades.eq(large));
    }
}
