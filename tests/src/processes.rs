//! Processes that no test has started itself, found by what they were started with.

use std::path::Path;

/// The game that was started with an option on these saves, by its arguments.
pub fn started_with(saves: &Path, option: &str) -> Option<u32> {
    let processes = std::fs::read_dir("/proc").ok()?;
    let numbers = processes.filter_map(|entry| entry.ok()?.file_name().to_str()?.parse().ok());
    let saves = saves.to_str()?;
    numbers.into_iter().find(|process| {
        arguments(*process).is_some_and(|all| {
            all.iter().any(|argument| argument == option) && all.iter().any(|a| a == saves)
        })
    })
}

/// What a process was started with; `None` once it has ended.
pub fn arguments(process: u32) -> Option<Vec<String>> {
    let text = std::fs::read_to_string(format!("/proc/{process}/cmdline")).ok()?;
    let all: Vec<_> = text.split('\0').map(str::to_owned).collect();
    (all.len() > 1).then_some(all)
}
