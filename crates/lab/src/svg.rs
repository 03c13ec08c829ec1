//! Plots as SVG: decades or even steps along each axis, a legend beside them, light and dark.
//!
//! A plot is the same text wherever it is put: inside the page, and as a file of its own beside
//! the document. Its colours are those of Okabe and Ito, which colour-blind readers tell apart,
//! and every curve has its own dots and dashes as well.

use std::fmt::Write;

use crate::report::{Axis, Plot, Scale, Series};

const WIDTH: f64 = 860.0;
const HEIGHT: f64 = 420.0;
const LEFT: f64 = 78.0;
const RIGHT: f64 = 610.0;
const TOP: f64 = 34.0;
const BOTTOM: f64 = 366.0;
/// Most labels along an axis.
const MOST_LABELS: i32 = 9;
const COLOURS: [&str; 8] = [
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#8c6bb1", "#7f7f7f",
];
const DASHES: [&str; 4] = ["", "7 3", "2 3", "9 3 2 3"];

/// Text that may stand in markup, between tags or in quotes.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            // Control characters are not allowed in SVG at all.
            c if c.is_control() && !"\n\t".contains(c) => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

/// One axis, ready to place values along it.
struct Ruler {
    scale: Scale,
    low: f64,
    high: f64,
    ticks: Vec<f64>,
    from: f64,
    to: f64,
}

impl Ruler {
    fn new(axis: &Axis, values: impl Iterator<Item = f64>, from: f64, to: f64) -> Option<Self> {
        let shown = values.filter(|v| v.is_finite() && (axis.scale == Scale::Linear || *v > 0.0));
        let (low, high) = shown.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
            (low.min(v), high.max(v))
        });
        if low > high {
            return None;
        }
        let (low, high, ticks) = match axis.scale {
            Scale::Linear => even(low, high),
            Scale::Logarithmic => decades(low, high),
        };
        Some(Self {
            scale: axis.scale,
            low,
            high,
            ticks,
            from,
            to,
        })
    }

    /// Where a value stands in the picture, if it can be shown.
    fn at(&self, value: f64) -> Option<f64> {
        let linear = match self.scale {
            Scale::Linear => value,
            Scale::Logarithmic if value > 0.0 => value.log10(),
            Scale::Logarithmic => return None,
        };
        let part = (linear - self.low) / (self.high - self.low);
        part.is_finite()
            .then_some(self.from + part * (self.to - self.from))
    }

    /// The ticks with their labels.
    fn labels(&self) -> impl Iterator<Item = (f64, String)> {
        self.ticks.iter().map(|&tick| match self.scale {
            Scale::Linear => (tick, tick_words(tick)),
            Scale::Logarithmic => (10.0_f64.powf(tick), format!("1e{tick:.0}")),
        })
    }
}

fn tick_words(tick: f64) -> String {
    if tick == 0.0 {
        return "0".to_owned();
    }
    if (1e-3..1e5).contains(&tick.abs()) {
        let words = format!("{tick:.4}");
        return words.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    format!("{tick:.1e}")
}

/// Whole decades about a range, as exponents, thinned out to what can be labelled.
fn decades(low: f64, high: f64) -> (f64, f64, Vec<f64>) {
    let first = low.log10().floor() as i32;
    let last = (high.log10().ceil() as i32).max(first + 1);
    let step = (last - first).div_euclid(MOST_LABELS) + 1;
    let ticks = (first..=last)
        .filter(|n| n.rem_euclid(step) == 0)
        .map(f64::from)
        .collect();
    (f64::from(first), f64::from(last), ticks)
}

/// A range widened to whole steps of 1, 2 or 5 times a power of ten, and those steps.
fn even(low: f64, high: f64) -> (f64, f64, Vec<f64>) {
    let span = if high > low {
        high - low
    } else {
        low.abs().max(1.0)
    };
    let rough = span / f64::from(MOST_LABELS - 2);
    let power = 10.0_f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|m| m * power)
        .find(|step| *step >= rough)
        .unwrap_or(power);
    let first = (low / step).floor();
    let last = (high / step).ceil().max(first + 1.0);
    let count = (last - first) as i32;
    let ticks = (0..=count).map(|i| (first + f64::from(i)) * step).collect();
    (first * step, last * step, ticks)
}

/// The whole plot as one SVG element.
pub fn plot(plot: &Plot) -> String {
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" role=\"img\" \
         font-family=\"sans-serif\" font-size=\"12\">\n<title>{}</title>\n{STYLE}\n\
         <rect class=\"paper\" width=\"{WIDTH}\" height=\"{HEIGHT}\"/>\n",
        escape(&plot.title)
    );
    let points = || plot.series.iter().flat_map(|series| &series.points);
    let x = Ruler::new(&plot.x, points().map(|p| p.0), LEFT, RIGHT);
    let y = Ruler::new(&plot.y, points().map(|p| p.1), BOTTOM, TOP);
    if let (Some(x), Some(y)) = (x, y) {
        grid(&mut out, &x, &y);
        for (i, series) in plot.series.iter().enumerate() {
            curve(&mut out, series, i, &x, &y);
        }
        axis_names(&mut out, plot);
        legend(&mut out, &plot.series);
    } else {
        let _ = writeln!(
            out,
            "<text class=\"ink\" x=\"{LEFT}\" y=\"{TOP}\">Nothing to show.</text>"
        );
    }
    out.push_str("</svg>\n");
    out
}

const STYLE: &str = "<style>.paper{fill:#fff}.ink{fill:#222}.grid{stroke:#d8d8d8}\
@media(prefers-color-scheme:dark){.paper{fill:#16181c}.ink{fill:#e4e4e4}.grid{stroke:#3a3d44}}</style>";

fn grid(out: &mut String, x: &Ruler, y: &Ruler) {
    for (value, label) in x.labels() {
        let Some(at) = x.at(value) else { continue };
        let below = BOTTOM + 18.0;
        let _ = writeln!(
            out,
            "<line class=\"grid\" x1=\"{at:.1}\" y1=\"{TOP}\" x2=\"{at:.1}\" y2=\"{BOTTOM}\"/>\
             <text class=\"ink\" x=\"{at:.1}\" y=\"{below}\" text-anchor=\"middle\">{label}</text>"
        );
    }
    for (value, label) in y.labels() {
        let Some(at) = y.at(value) else { continue };
        let (beside, middle) = (LEFT - 8.0, at + 4.0);
        let _ = writeln!(
            out,
            "<line class=\"grid\" x1=\"{LEFT}\" y1=\"{at:.1}\" x2=\"{RIGHT}\" y2=\"{at:.1}\"/>\
             <text class=\"ink\" x=\"{beside}\" y=\"{middle:.1}\" text-anchor=\"end\">{label}</text>"
        );
    }
}

fn axis_names(out: &mut String, plot: &Plot) {
    let (middle, below) = (0.5 * (LEFT + RIGHT), HEIGHT - 10.0);
    let _ = writeln!(
        out,
        "<text class=\"ink\" x=\"{middle}\" y=\"{below}\" text-anchor=\"middle\">{}</text>\n\
         <text class=\"ink\" x=\"12\" y=\"18\">{}</text>",
        escape(&plot.x.label),
        escape(&plot.y.label)
    );
}

/// Colour and, where the line is not solid, the attribute for its dashes.
fn look(i: usize) -> (&'static str, String) {
    let dashes = match DASHES[i % DASHES.len()] {
        "" => String::new(),
        dashes => format!("stroke-dasharray=\"{dashes}\" "),
    };
    (COLOURS[i % COLOURS.len()], dashes)
}

fn curve(out: &mut String, series: &Series, i: usize, x: &Ruler, y: &Ruler) {
    let (colour, dashes) = look(i);
    let places: Vec<(f64, f64)> = series
        .points
        .iter()
        .filter_map(|&(a, b)| Some((x.at(a)?, y.at(b)?)))
        .collect();
    if series.joined {
        let path: Vec<String> = places
            .iter()
            .map(|(a, b)| format!("{a:.1},{b:.1}"))
            .collect();
        let _ = writeln!(
            out,
            "<polyline fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.8\" \
             {dashes}points=\"{}\"/>",
            path.join(" ")
        );
    }
    for (a, b) in places {
        out.push_str(&dot(i, a, b, if series.joined { 2.2 } else { 3.5 }));
    }
}

/// A dot, a square or a diamond.
fn dot(i: usize, x: f64, y: f64, r: f64) -> String {
    let (colour, _) = look(i);
    match i % 3 {
        0 => format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{r}\" fill=\"{colour}\"/>\n"),
        1 => format!(
            "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"{side:.1}\" height=\"{side:.1}\" fill=\"{colour}\"/>\n",
            x - r,
            y - r,
            side = 2.0 * r
        ),
        _ => format!(
            "<path d=\"M{x:.1} {:.1}l{r} {r}l-{r} {r}l-{r} -{r}z\" fill=\"{colour}\"/>\n",
            y - r
        ),
    }
}

fn legend(out: &mut String, all: &[Series]) {
    for (i, series) in all.iter().enumerate() {
        let (colour, dashes) = look(i);
        let (x, y) = (RIGHT + 18.0, TOP + 10.0 + 22.0 * i as f64);
        if series.joined {
            let _ = writeln!(
                out,
                "<line x1=\"{x}\" y1=\"{y}\" x2=\"{}\" y2=\"{y}\" stroke=\"{colour}\" \
                 stroke-width=\"1.8\" {dashes}/>",
                x + 26.0
            );
        }
        out.push_str(&dot(i, x + 13.0, y, 3.5));
        let _ = writeln!(
            out,
            "<text class=\"ink\" x=\"{}\" y=\"{}\">{}</text>",
            x + 34.0,
            y + 4.0,
            escape(&series.name)
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_logarithmic_axis_has_whole_decades() {
        let (low, high, ticks) = decades(3e-8, 2e-3);
        assert_eq!((low, high), (-8.0, -2.0));
        assert_eq!(ticks, [-8.0, -7.0, -6.0, -5.0, -4.0, -3.0, -2.0]);
        let (_, _, ticks) = decades(1e-40, 1e3);
        assert!(ticks.len() <= MOST_LABELS as usize + 1, "{ticks:?}");
    }

    #[test]
    fn an_even_axis_has_round_steps() {
        let (low, high, ticks) = even(0.0, 13.0);
        assert_eq!((low, high), (0.0, 14.0));
        assert_eq!(ticks[1], 2.0);
    }

    #[test]
    fn values_that_a_logarithm_cannot_show_are_left_out() {
        let axis = || Axis {
            label: "d < 1 & so on".into(),
            scale: Scale::Logarithmic,
        };
        let made = plot(&Plot {
            id: "p".into(),
            title: "<b>".into(),
            x: axis(),
            y: axis(),
            series: vec![Series {
                name: "\"ours\"".into(),
                points: vec![(0.0, 1.0), (1.0, 1e-7), (10.0, f64::NAN), (100.0, 1e-5)],
                joined: true,
            }],
        });
        assert!(made.contains("d &lt; 1 &amp; so on") && made.contains("&quot;ours&quot;"));
        assert!(!made.contains("<b>") && !made.contains("NaN"));
        // Two points and the one of the legend.
        assert_eq!(made.matches("<circle").count(), 3);
    }
}
