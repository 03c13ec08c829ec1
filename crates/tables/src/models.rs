//! The rows of `assets/tables/models.ron`.

use serde::Deserialize;

use crate::reader::{Assets, Fault, Row, need};
use crate::source::{Names, Source, embedded};

/// What the fields are, the head of the table says.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Model {
    id: String,
    what: String,
    shape: Shape,
    #[serde(default)]
    switched: bool,
    #[serde(default)]
    shades: bool,
}

#[derive(Debug, Deserialize)]
enum Shape {
    Whole(String),
    Part(String, String),
    Bent(String),
    Made,
}

impl Shape {
    fn file(&self) -> Option<&str> {
        match self {
            Self::Whole(file) | Self::Part(file, _) | Self::Bent(file) => Some(file),
            Self::Made => None,
        }
    }
}

impl Row for Model {
    const FILE: &'static str = "assets/tables/models.ron";

    fn id(&self) -> &str {
        &self.id
    }

    fn check(&self, assets: Assets<'_>) -> Result<(), Fault> {
        if let Some(file) = self.shape.file() {
            assets.need("shape", "models", file)?;
        }
        let is_named = !matches!(&self.shape, Shape::Part(_, node) if node.is_empty());
        need("shape", is_named, "is to name a node of its file")?;
        let is_still = !self.switched || !matches!(self.shape, Shape::Bent(_) | Shape::Made);
        need(
            "switched",
            is_still,
            "is for what has a file and is not bent",
        )
    }
}

impl Source for Model {
    const NAMES: Option<Names> = Some(Names {
        name: "ModelId",
        about: "Which model a figure is drawn with.",
        derives: "",
        is_written: false,
        list: ("OTHERS", "Those that are no items."),
        other: "/// Something that can be carried, about where its file has its origin: what has a grip there.\n    \
                Item(antipode_items::Item),",
    });

    fn what(&self) -> &str {
        &self.what
    }

    fn expression(&self, _: &dyn Fn(&Fault) -> String) -> String {
        let file = self.shape.file().map(|file| embedded("models", file));
        let file = file.unwrap_or_default();
        let shape = match &self.shape {
            Shape::Whole(_) => format!("Whole({file})"),
            Shape::Part(_, node) => format!("Part({file}, {node:?})"),
            Shape::Bent(_) => format!("Bent({file})"),
            Shape::Made => "Made".to_owned(),
        };
        let (switched, shades) = (self.switched, self.shades);
        format!("Row {{ shape: ModelShape::{shape}, switched: {switched}, shades: {shades} }}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reader::testing::refuses;

    const TWO: &str = r#"[
  (id: "wheel", what: "A wheel.", shape: Part("car.glb", "wheel")),
  (
    id: "car-body",
    what: "A car.",
    shape: Whole("car.glb"),
    switched: true,
    shades: true,
  ),
]"#;

    #[test]
    fn an_unsound_model_is_told_by_file_line_and_field() {
        let is_none = "shape of \"wheel\" is \"none.glb\", and assets/models has no such file";
        refuses::<Model>(
            TWO,
            &[
                ("car.glb", "none.glb", &format!("2: {is_none}")),
                (
                    "\"wheel\")",
                    "\"\")",
                    "2: shape of \"wheel\" is to name a node",
                ),
                (
                    "car-body",
                    "wheel",
                    "4: id of \"wheel\" is the id of an earlier row, too",
                ),
                (
                    "car-body",
                    "car--body",
                    "4: id of \"car--body\" is to be words",
                ),
                (
                    "Whole(\"car.glb\")",
                    "Half(\"car.glb\")",
                    "6: shape of \"car-body\": ",
                ),
                (
                    "Whole",
                    "Bent",
                    "7: switched of \"car-body\" is for what has a file and is not bent",
                ),
                ("shades: true", "shades: 1", "8: shades of \"car-body\": "),
                (
                    "shades",
                    "shadows",
                    "8: \"car-body\": Unexpected field named `shadows`",
                ),
                (
                    "\n    what: \"A car.\",",
                    "",
                    "4: what of \"car-body\" is missing",
                ),
            ],
        );
    }
}
