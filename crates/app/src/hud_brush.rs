//! Fills the display's model of the brush: shapes and kinds of ground in words and colours, and what a stroke has moved.

use antipode_language::{Texts, Value};
use antipode_scene::{Brush, BrushShape, Choice, Heap, Item, Kind, Recipe, Scene};
use antipode_ui::{
    BrushForm, BrushModel, BrushRow, EarthView, HeapModel, MakingModel, PartView, RecipeView, Tint,
};

use crate::hud;

/// Less of a kind is not told, cubic metres.
const LEAST_TOLD_M3: f64 = 0.1;

/// What the display shows of the brush in hand, if one is.
pub fn model(texts: &Texts, scene: &Scene) -> BrushModel {
    let held = scene.inventory().held();
    if scene.is_driving() || held.and_then(Item::brush_strength_per_s).is_none() {
        return BrushModel::default();
    }
    let brush = scene.brush();
    BrushModel {
        form: form(brush.shape),
        words: words(texts, scene, brush),
        tint: brush.kind.or_else(|| scene.stock()?.most()).map(tint),
        row: scene
            .brush_chosen()
            .map(|choice| row(texts, scene, brush, choice)),
        heaps: scene
            .heaps_shown()
            .iter()
            .map(|it| heap(texts, it))
            .collect(),
    }
}

/// Nothing of a brush as a new player of a creative world has it.
fn words(texts: &Texts, scene: &Scene, brush: Brush) -> String {
    let gathers = scene.stock().is_some();
    if brush == Brush::default() && !gathers {
        return String::new();
    }
    let radius = ("radius", Value::decimals(scene.brush_radius_m(), 1));
    let size = if brush.shape == BrushShape::Ball {
        texts.say_with("display-brush", &[radius])
    } else {
        let shape = ("shape", shape_word(texts, brush.shape).into());
        texts.say_with("display-brush-shape", &[shape, radius])
    };
    if brush.kind.is_some() || gathers {
        format!("{size} · {}", built_words(texts, scene, brush.kind))
    } else {
        size
    }
}

/// What is built of; in gathering worlds with how much of it there is.
fn built_words(texts: &Texts, scene: &Scene, kind: Option<Kind>) -> String {
    let Some(stock) = scene.stock() else {
        return kind.map_or_else(|| texts.say("ground-found"), |kind| kind_word(texts, kind));
    };
    match kind.or_else(|| stock.most()) {
        Some(kind) => {
            let values = [
                ("kind", kind_word(texts, kind).into()),
                ("volume", Value::decimals_of_stock(stock.of(kind), 1)),
            ];
            texts.say_with("display-ground-left", &values)
        }
        None => texts.say("ground-none"),
    }
}

fn row(texts: &Texts, scene: &Scene, brush: Brush, choice: Choice) -> BrushRow {
    match choice {
        Choice::Shape => {
            let at = BrushShape::ALL.iter().position(|it| *it == brush.shape);
            let forms = BrushShape::ALL.map(form).to_vec();
            BrushRow::Forms(
                forms,
                at.unwrap_or_default(),
                shape_word(texts, brush.shape),
            )
        }
        Choice::Kind => {
            let kinds = Brush::kinds(scene.stock());
            let at = kinds.iter().position(|it| *it == brush.kind);
            let tints = kinds.iter().map(|kind| kind.map(tint)).collect();
            let words = built_words(texts, scene, brush.kind);
            BrushRow::Kinds(tints, at.unwrap_or_default(), words)
        }
    }
}

/// What can be made of ground, and what there is of it; none in creative worlds.
pub fn making(texts: &Texts, scene: &Scene) -> Option<MakingModel> {
    let stock = scene.stock()?;
    let part = |&(kind, needs_m3): &(Kind, f64)| PartView {
        label: kind_word(texts, kind),
        tint: tint(kind),
        needs_m3,
        has_m3: stock.of(kind),
    };
    let recipes = Recipe::all().into_iter().map(|recipe| RecipeView {
        made: hud::slot(texts, Some(recipe.made)),
        parts: recipe.parts.iter().map(part).collect(),
        possible: scene.can_make(&recipe),
    });
    let earth = Kind::ALL.into_iter().filter_map(|kind| {
        let m3 = stock.of(kind);
        (m3 >= LEAST_TOLD_M3).then(|| EarthView {
            label: kind_word(texts, kind),
            tint: tint(kind),
            m3,
        })
    });
    Some(MakingModel {
        recipes: recipes.collect(),
        earth: earth.collect(),
    })
}

fn heap(texts: &Texts, heap: &Heap) -> HeapModel {
    let values = [
        ("sign", if heap.m3 < 0.0 { "\u{2212}" } else { "+" }.into()),
        ("volume", Value::decimals(heap.m3.abs(), 1)),
        ("kind", kind_word(texts, heap.kind).into()),
    ];
    HeapModel {
        words: texts.say_with("display-heap", &values),
        tint: tint(heap.kind),
    }
}

fn shape_word(texts: &Texts, shape: BrushShape) -> String {
    texts.say(match shape {
        BrushShape::Ball => "brush-ball",
        BrushShape::Box => "brush-box",
        BrushShape::Cylinder => "brush-cylinder",
        BrushShape::Flatten => "brush-flatten",
        BrushShape::Smooth => "brush-smooth",
    })
}

/// A kind of ground in a word.
pub fn kind_word(texts: &Texts, kind: Kind) -> String {
    texts.say(match kind {
        Kind::Grass => "ground-grass",
        Kind::Soil => "ground-soil",
        Kind::Sand => "ground-sand",
        Kind::Gravel => "ground-gravel",
        Kind::Rock => "ground-rock",
        Kind::Ash => "ground-ash",
        Kind::Snow => "ground-snow",
        Kind::Moss => "ground-moss",
        Kind::Clay => "ground-clay",
        Kind::Basalt => "ground-basalt",
        Kind::Slate => "ground-slate",
        Kind::Coal => "ground-coal",
        Kind::Copper => "ground-copper",
        Kind::Crystal => "ground-crystal",
        Kind::Wood => "ground-wood",
    })
}

fn form(shape: BrushShape) -> BrushForm {
    match shape {
        BrushShape::Ball => BrushForm::Ball,
        BrushShape::Box => BrushForm::Box,
        BrushShape::Cylinder => BrushForm::Cylinder,
        BrushShape::Flatten => BrushForm::Flatten,
        BrushShape::Smooth => BrushForm::Smooth,
    }
}

/// The colours by which the display knows a kind.
fn tint(kind: Kind) -> Tint {
    let (ground, specks) = match kind {
        Kind::Grass => ([104, 152, 66], [142, 188, 92]),
        Kind::Soil => ([96, 68, 45], [130, 98, 68]),
        Kind::Sand => ([222, 197, 138], [242, 224, 176]),
        Kind::Gravel => ([150, 143, 132], [200, 194, 184]),
        Kind::Rock => ([116, 112, 108], [92, 88, 85]),
        Kind::Ash => ([84, 80, 82], [176, 170, 168]),
        Kind::Snow => ([238, 243, 249], [206, 219, 236]),
        Kind::Moss => ([70, 106, 48], [112, 152, 74]),
        Kind::Clay => ([178, 104, 70], [126, 66, 42]),
        Kind::Basalt => ([50, 53, 60], [30, 32, 37]),
        Kind::Slate => ([88, 101, 122], [126, 142, 168]),
        Kind::Coal => ([22, 22, 24], [104, 106, 114]),
        Kind::Copper => ([190, 128, 76], [74, 164, 130]),
        Kind::Crystal => ([130, 220, 238], [236, 252, 255]),
        Kind::Wood => ([152, 106, 58], [196, 148, 92]),
    };
    Tint { ground, specks }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_kinds_look_alike_on_the_display() {
        let apart = |a: [u8; 3], b: [u8; 3]| -> i32 {
            let pairs = a.into_iter().zip(b);
            pairs
                .map(|(a, b)| (i32::from(a) - i32::from(b)).abs())
                .sum()
        };
        for (n, one) in Kind::ALL.into_iter().enumerate() {
            for other in Kind::ALL.into_iter().skip(n + 1) {
                let (a, b) = (tint(one), tint(other));
                let far = apart(a.ground, b.ground) + apart(a.specks, b.specks) / 2;
                assert!(far >= 70, "{one:?} and {other:?}: {far}");
            }
        }
    }
}
