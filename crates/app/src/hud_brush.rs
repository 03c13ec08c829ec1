//! Fills the display's model of the brush: shapes and kinds of ground in words and colours, and what a stroke has moved.

use antipode_language::{Texts, Value};
use antipode_scene::{Brush, BrushShape, Choice, Heap, Item, Kind, Scene};
use antipode_ui::{BrushForm, BrushModel, BrushRow, HeapModel, Tint};

/// What the display shows of the brush in hand, if one is.
pub fn model(texts: &Texts, scene: &Scene) -> BrushModel {
    let held = scene.inventory().held();
    if scene.is_driving() || held.and_then(Item::brush_strength_per_s).is_none() {
        return BrushModel::default();
    }
    let brush = scene.brush();
    BrushModel {
        form: form(brush.shape),
        words: words(texts, brush, scene.brush_radius_m()),
        tint: brush.kind.map(tint),
        row: scene.brush_chosen().map(|choice| row(texts, brush, choice)),
        heaps: scene
            .heaps_shown()
            .iter()
            .map(|it| heap(texts, it))
            .collect(),
    }
}

/// Nothing of a brush as a new player has it.
fn words(texts: &Texts, brush: Brush, radius_m: f64) -> String {
    if brush == Brush::default() {
        return String::new();
    }
    let radius = ("radius", Value::decimals(radius_m, 1));
    let size = if brush.shape == BrushShape::Ball {
        texts.say_with("display-brush", &[radius])
    } else {
        let shape = ("shape", shape_word(texts, brush.shape).into());
        texts.say_with("display-brush-shape", &[shape, radius])
    };
    match brush.kind {
        Some(kind) => format!("{size} · {}", kind_word(texts, Some(kind))),
        None => size,
    }
}

fn row(texts: &Texts, brush: Brush, choice: Choice) -> BrushRow {
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
            let at = Brush::kinds().position(|it| it == brush.kind);
            let tints = Brush::kinds().map(|kind| kind.map(tint)).collect();
            BrushRow::Kinds(tints, at.unwrap_or_default(), kind_word(texts, brush.kind))
        }
    }
}

fn heap(texts: &Texts, heap: &Heap) -> HeapModel {
    let values = [
        ("sign", if heap.m3 < 0.0 { "\u{2212}" } else { "+" }.into()),
        ("volume", Value::decimals(heap.m3.abs(), 1)),
        ("kind", kind_word(texts, Some(heap.kind)).into()),
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

/// A kind of ground in a word; none is what is found at each place.
fn kind_word(texts: &Texts, kind: Option<Kind>) -> String {
    texts.say(match kind {
        None => "ground-found",
        Some(Kind::Grass) => "ground-grass",
        Some(Kind::Soil) => "ground-soil",
        Some(Kind::Sand) => "ground-sand",
        Some(Kind::Gravel) => "ground-gravel",
        Some(Kind::Rock) => "ground-rock",
        Some(Kind::Ash) => "ground-ash",
        Some(Kind::Snow) => "ground-snow",
        Some(Kind::Moss) => "ground-moss",
        Some(Kind::Clay) => "ground-clay",
        Some(Kind::Basalt) => "ground-basalt",
        Some(Kind::Slate) => "ground-slate",
        Some(Kind::Coal) => "ground-coal",
        Some(Kind::Copper) => "ground-copper",
        Some(Kind::Crystal) => "ground-crystal",
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

/// The colour by which the display knows a kind.
fn tint(kind: Kind) -> Tint {
    match kind {
        Kind::Grass => [104, 152, 66],
        Kind::Soil => [96, 68, 45],
        Kind::Sand => [222, 197, 138],
        Kind::Gravel => [150, 143, 132],
        Kind::Rock => [116, 112, 108],
        Kind::Ash => [72, 69, 71],
        Kind::Snow => [238, 243, 249],
        Kind::Moss => [70, 106, 48],
        Kind::Clay => [178, 104, 70],
        Kind::Basalt => [50, 53, 60],
        Kind::Slate => [88, 101, 122],
        Kind::Coal => [22, 22, 24],
        Kind::Copper => [200, 122, 66],
        Kind::Crystal => [130, 220, 238],
    }
}
