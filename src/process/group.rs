//! Process groups of the programs that run, and ending them.
use std::process::Command;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

static STOPPING: AtomicBool = AtomicBool::new(false);

/// Whether [`stop`] was called.
pub fn stopping() -> bool {
    STOPPING.load(Ordering::SeqCst)
}

/// Sleeps for good if [`stop`] was called: whoever called it ends the process.
pub(super) fn wait_if_stopping() {
    while stopping() {
        std::thread::sleep(Duration::from_secs(1));
    }
}

#[cfg(unix)]
mod unix {
    use super::super::watchdog;
    use super::{Command, Duration, Ordering, STOPPING};
    use nix::errno::Errno;
    use nix::sys::signal::{Signal, killpg};
    use nix::unistd::Pid;
    use std::collections::BTreeSet;
    use std::os::unix::process::CommandExt;
    use std::sync::{Mutex, PoisonError};
    use std::time::Instant;

    /// How long a program has to end by itself when it is asked to.
    const GRACE: Duration = Duration::from_millis(1000);

    /// Groups of the programs that run, by their leaders.
    static GROUPS: Mutex<BTreeSet<i32>> = Mutex::new(BTreeSet::new());

    fn groups() -> std::sync::MutexGuard<'static, BTreeSet<i32>> {
        GROUPS.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Gives the program a group of its own and, on Linux, has it asked to end when the thread ends that starts it.
    pub fn confine(command: &mut Command) {
        command.process_group(0);
        #[cfg(target_os = "linux")]
        {
            let parent = std::process::id();
            // SAFETY: between fork and exec only prctl, getppid and raise run, which are async-signal-safe; nothing is allocated.
            unsafe {
                command.pre_exec(move || {
                    nix::sys::prctl::set_pdeathsig(Signal::SIGTERM)?;
                    // The parent may have ended before it was asked for.
                    if nix::unistd::getppid().as_raw() as u32 != parent {
                        nix::sys::signal::raise(Signal::SIGKILL)?;
                    }
                    Ok(())
                });
            }
        }
    }

    /// A running program's group, known to [`stop`] and to the watchdog until it is dropped.
    pub struct Live(i32);

    impl Live {
        pub fn new(leader: u32) -> Self {
            let leader = leader.cast_signed();
            groups().insert(leader);
            watchdog::tell(leader);
            Self(leader)
        }
    }

    impl Drop for Live {
        fn drop(&mut self) {
            groups().remove(&self.0);
            watchdog::tell(-self.0);
        }
    }

    /// Asks all programs to end, and kills what has not ended a second later. From here on [`super::super::output`] does not return.
    pub fn stop() {
        STOPPING.store(true, Ordering::SeqCst);
        let all: Vec<Pid> = groups().iter().map(|g| Pid::from_raw(*g)).collect();
        let gone = |signal: Option<Signal>, group: &Pid| killpg(*group, signal) == Err(Errno::ESRCH);
        let start = Instant::now();
        let mut left: Vec<Pid> = all.into_iter().filter(|g| !gone(Some(Signal::SIGTERM), g)).collect();
        while !left.is_empty() && start.elapsed() < GRACE {
            std::thread::sleep(Duration::from_millis(5));
            left.retain(|g| !gone(None, g));
        }
        for group in left {
            let _ = killpg(group, Signal::SIGKILL);
        }
    }

    /// To be called before the process ends by itself: ends the watchdog, so that nothing of this process is left.
    pub fn end() {
        watchdog::dismiss();
    }
}

#[cfg(unix)]
pub(super) use unix::{Live, confine};
#[cfg(unix)]
pub use unix::{end, stop};

#[cfg(not(unix))]
mod other {
    use super::{Command, Ordering, STOPPING};

    pub fn confine(_: &mut Command) {}

    pub struct Live;

    impl Live {
        pub fn new(_: u32) -> Self {
            Self
        }
    }

    /// Marks the process as ending: [`super::super::output`] no longer returns.
    pub fn stop() {
        STOPPING.store(true, Ordering::SeqCst);
    }

    /// To be called before the process ends by itself.
    pub fn end() {}
}

#[cfg(not(unix))]
pub(super) use other::{Live, confine};
#[cfg(not(unix))]
pub use other::{end, stop};
