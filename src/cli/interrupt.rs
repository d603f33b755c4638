//! Ends of a run from outside: SIGINT, SIGTERM, SIGHUP.
use std::sync::mpsc::channel;
use std::time::Duration;

/// From here on an interrupted run leaves nothing: no program that it started, no unfinished file. It ends with 128 and the signal's number.
#[cfg(unix)]
pub fn watch() {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    let mut signals = vec![SIGINT, SIGTERM];
    // What runs under `nohup` goes on.
    if !is_ignored(SIGHUP) {
        signals.push(SIGHUP);
    }
    // Without a handler it ends all the same.
    let Ok(mut signals) = signal_hook::iterator::Signals::new(signals) else { return };
    std::thread::spawn(move || {
        if let Some(signal) = signals.forever().next() {
            interrupted(128 + signal);
        }
    });
}

#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
    mask >> (signal - 1) & 1 == 1
}

/// From here on an interrupted run leaves no unfinished file.
#[cfg(not(unix))]
pub fn watch() {
    let _ = ctrlc::set_handler(|| interrupted(130));
}

fn interrupted(code: i32) -> ! {
    // Standard error may be a pipe without a reader: nothing here waits for it.
    let (said, hears) = channel();
    std::thread::spawn(move || {
        super::output::interrupted();
        let _ = said.send(());
    });
    let _ = hears.recv_timeout(Duration::from_millis(200));
    end(code)
}

/// Ends the process at once: the programs that it started, unfinished files, itself.
pub fn end(code: i32) -> ! {
    crate::process::stop();
    crate::process::end();
    crate::files::abandon(code)
}
