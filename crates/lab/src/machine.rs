//! What a report was made on.

use antipode_render::Gpu;

use crate::Effort;

/// Program version, processor, adapter and thoroughness, for the head of a report.
pub fn made_on(effort: Effort, adapter: Option<&Gpu>) -> Vec<(String, String)> {
    let adapter = adapter.map_or_else(
        || "none: nothing was measured on a GPU".to_owned(),
        |gpu| format!("{} ({:?})", gpu.name(), gpu.info.backend),
    );
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let entries = [
        ("Program", format!("antipode {}", env!("CARGO_PKG_VERSION"))),
        ("Processor", format!("{}, {threads} threads", processor())),
        ("Adapter", adapter),
        (
            "Run",
            if effort.quick { "quick" } else { "full" }.to_owned(),
        ),
    ];
    entries.map(|(name, value)| (name.to_owned(), value)).into()
}

/// The processor's name where the system tells it, else its architecture.
fn processor() -> String {
    let told = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    told.lines()
        .filter_map(|line| line.split_once(':'))
        .find(|(name, _)| name.trim() == "model name")
        .map_or_else(
            || std::env::consts::ARCH.to_owned(),
            |(_, value)| value.trim().to_owned(),
        )
}
