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
    use super::super::watchdog::{self, Announced};
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

    /// A program that is being started or runs: known to the watchdog until it is dropped, and to [`stop`] once it runs.
    pub struct Live {
        announced: Announced,
        leader: Option<i32>,
    }

    impl Live {
        /// Gives the program that the command will start a group of its own, which the watchdog hears of from the program itself and, on Linux,
        /// has it asked to end when the thread ends that starts it.
        pub fn confine(command: &mut Command) -> Self {
            command.process_group(0);
            let announced = Announced::new();
            #[cfg(target_os = "linux")]
            let parent = std::process::id();
            // SAFETY: between fork and exec only write, getpid, prctl, getppid and raise run, which are async-signal-safe; nothing is allocated.
            unsafe {
                command.pre_exec(move || {
                    announced.is_here();
                    #[cfg(target_os = "linux")]
                    {
                        nix::sys::prctl::set_pdeathsig(Signal::SIGTERM)?;
                        // The parent may have ended before it was asked for.
                        if nix::unistd::getppid().as_raw() as u32 != parent {
                            nix::sys::signal::raise(Signal::SIGKILL)?;
                        }
                    }
                    Ok(())
                });
            }
            Self { announced, leader: None }
        }

        /// The program runs.
        pub fn runs(&mut self, leader: u32) {
            let leader = leader.cast_signed();
            groups().insert(leader);
            self.leader = Some(leader);
        }
    }

    impl Drop for Live {
        fn drop(&mut self) {
            if let Some(leader) = self.leader {
                groups().remove(&leader);
            }
            self.announced.has_ended();
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
pub(super) use unix::Live;
#[cfg(unix)]
pub use unix::{end, stop};

#[cfg(not(unix))]
mod other {
    use super::{Command, Ordering, STOPPING};

    pub struct Live;

    impl Live {
        pub fn confine(_: &mut Command) -> Self {
            Self
        }

        pub fn runs(&mut self, _: u32) {}
    }

    /// Marks the process as ending: [`super::super::output`] no longer returns.
    pub fn stop() {
        STOPPING.store(true, Ordering::SeqCst);
    }

    /// To be called before the process ends by itself.
    pub fn end() {}
}

#[cfg(not(unix))]
pub(super) use other::Live;
#[cfg(not(unix))]
pub use other::{end, stop};
