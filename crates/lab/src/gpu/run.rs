//! A run from beginning to end: the sections one after the other, what is missing in them, and the report.

use std::time::{Duration, Instant};

use antipode_render::Gpu;

use super::amount::Amount;
use super::cost::{self, Found};
use super::spread::{self, Spread};
use super::suite::Suite;
use super::told::{self, Tally};
use super::{Listener, MISSING, News, Outcome, Plan, adapter, pictures, worlds};
use crate::accuracy::{self, Bench};
use crate::{LabError, Report, Section};

/// The suite of the shader's functions.
const FUNCTIONS: &str = "accuracy-functions";

/// A run under way.
struct Run<'a, 'l> {
    plan: &'a Plan,
    tell: &'a mut Listener<'l>,
    warnings: Vec<String>,
    lacks: Vec<String>,
    sections: Vec<Section>,
}

/// Measures, and tells of everything as it comes.
///
/// # Errors
/// Those of the listener. What goes wrong in a section is a sentence in its place, and among what is lacking.
pub fn run(plan: &Plan, tell: &mut Listener<'_>) -> Result<Outcome, LabError> {
    let began = Instant::now();
    let mut run = Run {
        plan,
        tell,
        warnings: Vec::new(),
        lacks: Vec::new(),
        sections: Vec::new(),
    };
    let mut made_on = match Bench::open(plan.effort, Some(plan.adapter)) {
        Ok(bench) => run.measure(&bench)?,
        Err(why) => {
            run.lack(format!("Nothing was measured. {why}"))?;
            adapter::head(plan.effort, None)
        }
    };
    let took = format!("{:.0} s", began.elapsed().as_secs_f64());
    made_on.push(("Took".to_owned(), took));
    let missing = run.missing();
    let sections = missing.into_iter().chain(run.sections).collect();
    let report = Report { made_on, sections };
    let lacks = run.lacks;
    Ok(Outcome { report, lacks })
}

impl Run<'_, '_> {
    /// Measures everything; returns the report's head.
    fn measure(&mut self, bench: &Bench) -> Result<Vec<(String, String)>, LabError> {
        let head = adapter::head(self.plan.effort, bench.gpu.as_ref());
        (self.tell)(News::Head(&head))?;
        let Some(gpu) = &bench.gpu else {
            return Ok(head);
        };
        for warning in adapter::warnings(gpu) {
            self.warn(warning)?;
        }
        let amount = Amount::of(self.plan.effort, gpu.is_software());
        let (costs, spreads) = self.times(gpu, &amount)?;
        let pictures = self.pictures(gpu, &amount)?;
        let functions = self.functions(bench)?;
        let tallies = [("pictures", pictures), ("rows of functions", functions)];
        let short = told::short(&costs, &spreads, &tallies);
        (self.tell)(News::Done(&short))?;
        self.sections.insert(0, short);
        Ok(head)
    }

    fn warn(&mut self, warning: String) -> Result<(), LabError> {
        (self.tell)(News::Warning(&warning))?;
        self.warnings.push(warning);
        Ok(())
    }

    fn lack(&mut self, lack: String) -> Result<(), LabError> {
        (self.tell)(News::Warning(&lack))?;
        self.lacks.push(lack);
        Ok(())
    }

    fn take(&mut self, section: Section) -> Result<(), LabError> {
        (self.tell)(News::Done(&section))?;
        self.sections.push(section);
        Ok(())
    }

    /// The sections of times, and what they hold.
    fn times(&mut self, gpu: &Gpu, amount: &Amount) -> Result<(Vec<Found>, Vec<Spread>), LabError> {
        (self.tell)(News::Begun("the land of the three worlds is made"))?;
        let worlds = match worlds::all(amount.view_distance) {
            Ok(worlds) => worlds,
            Err(why) => {
                self.lack(format!("No times were measured. {why}"))?;
                Vec::new()
            }
        };
        (self.tell)(News::Begun("triangles and pixels apart"))?;
        let costs = match cost::measured(gpu, &worlds, amount) {
            Ok(costs) => costs,
            Err(why) => {
                self.lack(format!("Triangles and pixels were not measured. {why}"))?;
                Vec::new()
            }
        };
        for it in &costs {
            self.judge_costs(it, amount)?;
        }
        self.take(told::costs(&costs))?;
        let mut spreads = Vec::new();
        for size in amount.sizes {
            let words = told::size(size);
            (self.tell)(News::Begun(&format!("frames of {words}")))?;
            match spread::at_size(gpu, &worlds, size, amount) {
                Ok(found) => spreads.extend(found),
                Err(why) => self.lack(format!("Frames of {words} were not measured. {why}"))?,
            }
        }
        self.tell_cut(&spreads, amount)?;
        spreads.sort_by_key(|it| worlds.iter().position(|world| world.name() == it.space));
        self.take(told::spreads(&spreads, amount))?;
        Ok((costs, spreads))
    }

    fn judge_costs(&mut self, found: &Found, amount: &Amount) -> Result<(), LabError> {
        let Found { space, rounds, .. } = found;
        match &found.fit {
            None => self.lack(format!(
                "Triangles and pixels of the {space} world could not be told apart: its frames were too much alike."
            ))?,
            Some(fit) if !fit.is_sure() => self.warn(format!(
                "Unsure: what a million triangles or pixels of the {space} world cost is less than twice its standard error."
            ))?,
            Some(_) => {}
        }
        if *rounds < amount.rounds {
            self.warn(format!(
                "Cut: {rounds} of {} rounds of the {space} world's costs were measured in {} s.",
                amount.rounds, amount.cost_s
            ))?;
        }
        Ok(())
    }

    /// Says which frames were not timed for want of time.
    fn tell_cut(&mut self, spreads: &[Spread], amount: &Amount) -> Result<(), LabError> {
        let cut = spreads.iter().filter(|it| it.frames < amount.frames);
        let cut: Vec<String> = cut
            .map(|it| format!("{} of {} at {}", it.frames, it.space, told::size(it.size)))
            .collect();
        if cut.is_empty() {
            return Ok(());
        }
        self.warn(format!(
            "Cut: not all {} frames were timed in {} s, but {}. The 99th of a hundred of so few is the longest.",
            amount.frames,
            amount.spread_s,
            cut.join(", ")
        ))
    }

    fn pictures(&mut self, gpu: &Gpu, amount: &Amount) -> Result<Tally, LabError> {
        (self.tell)(News::Begun("the image suite, drawn by the game"))?;
        let suite = Suite {
            game: self.plan.game.clone(),
            scenes: self.plan.scenes.clone(),
            adapter: self.plan.adapter,
            patience: Duration::from_secs_f64(amount.script_s),
        };
        let (section, lacks) = pictures::section(&suite, gpu.name());
        for lack in lacks {
            self.lack(lack)?;
        }
        let tally = Tally::of(&section);
        self.take(section)?;
        Ok(tally)
    }

    fn functions(&mut self, bench: &Bench) -> Result<Tally, LabError> {
        (self.tell)(News::Begun("the rows of the shader's functions"))?;
        let suite = accuracy::suite(FUNCTIONS);
        let section = match suite.map(|suite| suite.run(bench)) {
            Some(Ok(section)) => section,
            Some(Err(why)) => {
                let why = format!("The functions were not measured. {why}");
                self.lack(why.clone())?;
                told::absent(FUNCTIONS, "Functions", &why)
            }
            None => told::absent(FUNCTIONS, "Functions", "There is no such suite."),
        };
        let tally = Tally::of(&section);
        self.take(section)?;
        Ok(tally)
    }

    /// The section of what is missing or to be known first, if anything is.
    fn missing(&self) -> Option<Section> {
        let told = self.lacks.iter().chain(&self.warnings);
        let told: Vec<&str> = told.map(String::as_str).collect();
        let title = if self.lacks.is_empty() {
            "To be known first"
        } else {
            "What is missing"
        };
        (!told.is_empty()).then(|| Section::new(MISSING, title, told, []))
    }
}
