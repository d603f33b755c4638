//! A copy of this process that outlives it by a moment: when this one ends, by SIGKILL too, it ends the groups of the programs that still run.
//! (The parent-death signal of Linux reaches a program, but not what that has started: `make`, compilers.)
use nix::libc;
use nix::sys::wait::waitpid;
use nix::unistd::{ForkResult, Pid, fork};
use std::os::fd::{AsRawFd, OwnedFd, RawFd};
use std::sync::atomic::{AtomicI32, Ordering};
use std::sync::{Mutex, PoisonError};

/// Groups that the watchdog can hold; more than programs ever run at a time.
const ROOM: usize = 1024;
/// Milliseconds between the request to end and SIGKILL.
const GRACE: i64 = 500;
/// In place of a start's number: the process ends by itself.
const DISMISSED: i32 = 0;

/// A message: the number of a start, and the group that it made; 0 when that has ended or never came to be. The pipe takes each message whole.
const MESSAGE: usize = 8;

fn message(start: i32, group: i32) -> [u8; MESSAGE] {
    let mut bytes = [0; MESSAGE];
    bytes[..4].copy_from_slice(&start.to_ne_bytes());
    bytes[4..].copy_from_slice(&group.to_ne_bytes());
    bytes
}

struct Watchdog {
    /// Takes messages. It stays open as long as the process lives, so that a child that is being started can't write to anything else.
    pipe: OwnedFd,
    pid: Pid,
}

/// None before the first program, or where no watchdog can be started: then nothing watches.
static WATCHDOG: Mutex<Option<Watchdog>> = Mutex::new(None);
static STARTS: AtomicI32 = AtomicI32::new(1);

/// One start of a program, which the program itself announces before it becomes that program: were it left to this process, one that is killed
/// between the two would leave it running.
#[derive(Clone, Copy)]
pub struct Announced {
    start: i32,
    pipe: Option<RawFd>,
}

impl Announced {
    /// Has the watchdog running.
    pub fn new() -> Self {
        let mut dog = WATCHDOG.lock().unwrap_or_else(PoisonError::into_inner);
        if dog.is_none() {
            *dog = start();
        }
        Self { start: STARTS.fetch_add(1, Ordering::Relaxed), pipe: dog.as_ref().map(|d| d.pipe.as_raw_fd()) }
    }

    /// To be called between fork and exec: this process leads the group. Makes one system call.
    pub fn is_here(self) {
        self.send(nix::unistd::getpid().as_raw());
    }

    /// The group is gone, or was never made.
    pub fn has_ended(self) {
        self.send(0);
    }

    fn send(self, group: i32) {
        let Some(pipe) = self.pipe else { return };
        let bytes = message(self.start, group);
        // SAFETY: the descriptor is never closed; write is async-signal-safe and reads `bytes` only.
        unsafe { libc::write(pipe, bytes.as_ptr().cast(), bytes.len()) };
    }
}

/// Ends the watchdog, which ends what still runs, and waits for that.
pub fn dismiss() {
    let dog = WATCHDOG.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(dog) = &*dog {
        Announced { start: DISMISSED, pipe: Some(dog.pipe.as_raw_fd()) }.has_ended();
        let _ = waitpid(dog.pid, None);
    }
}

fn start() -> Option<Watchdog> {
    let (read, write) = pipe().ok()?;
    let from = read.as_raw_fd();
    // SAFETY: the child runs `watch` and nothing else, which makes system calls only and never returns; it takes no lock and allocates nothing.
    match unsafe { fork() }.ok()? {
        ForkResult::Child => watch(from),
        ForkResult::Parent { child } => Some(Watchdog { pipe: write, pid: child }),
    }
}

/// A pipe that no program inherits: one that did would keep the watchdog from seeing the end.
fn pipe() -> nix::Result<(OwnedFd, OwnedFd)> {
    #[cfg(any(target_os = "linux", target_os = "android", target_os = "freebsd"))]
    return nix::unistd::pipe2(nix::fcntl::OFlag::O_CLOEXEC);
    #[cfg(not(any(target_os = "linux", target_os = "android", target_os = "freebsd")))]
    {
        let ends = nix::unistd::pipe()?;
        for end in [&ends.0, &ends.1] {
            nix::fcntl::fcntl(end, nix::fcntl::FcntlArg::F_SETFD(nix::fcntl::FdFlag::FD_CLOEXEC))?;
        }
        Ok(ends)
    }
}

/// The watchdog itself.
fn watch(from: RawFd) -> ! {
    // Of each group that runs: the number of its start, and the group.
    let mut groups = [(0i32, 0i32); ROOM];
    // SAFETY: system calls on the process itself, on its own descriptors and on buffers of its own stack.
    unsafe {
        // A signal from the terminal is for the process that is watched.
        libc::setpgid(0, 0);
        for signal in [libc::SIGINT, libc::SIGTERM, libc::SIGHUP, libc::SIGQUIT] {
            libc::signal(signal, libc::SIG_IGN);
        }
        // No process waits for the end of a pipe or a lock because of this copy; the one descriptor left is 0.
        libc::dup2(from, 0);
        let most = libc::sysconf(libc::_SC_OPEN_MAX).clamp(256, 65536);
        #[cfg(target_os = "linux")]
        let closed = libc::syscall(libc::SYS_close_range, 1, libc::c_uint::MAX, 0) == 0;
        #[cfg(not(target_os = "linux"))]
        let closed = false;
        if !closed {
            for fd in 1..most as i32 {
                libc::close(fd);
            }
        }
        loop {
            let mut bytes = [0u8; MESSAGE];
            let n = libc::read(0, bytes.as_mut_ptr().cast(), MESSAGE);
            if n < 0 && std::io::Error::last_os_error().kind() == std::io::ErrorKind::Interrupted {
                continue;
            }
            let start = i32::from_ne_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
            if n != MESSAGE as isize || start == DISMISSED {
                break;
            }
            let group = i32::from_ne_bytes([bytes[4], bytes[5], bytes[6], bytes[7]]);
            // A start that is tried again announces itself again.
            let known = groups.iter().position(|g| g.0 == start).or_else(|| groups.iter().position(|g| g.0 == 0));
            if let Some(place) = known {
                groups[place] = if group > 0 { (start, group) } else { (0, 0) };
            }
        }
        let all = |signal| {
            let running = groups.iter().filter(|g| g.1 > 0);
            running.fold(false, |_, g| {
                libc::kill(-g.1, signal);
                true
            })
        };
        if all(libc::SIGTERM) {
            let pause = libc::timespec { tv_sec: GRACE / 1000, tv_nsec: GRACE % 1000 * 1_000_000 };
            libc::nanosleep(&pause, std::ptr::null_mut());
            all(libc::SIGKILL);
        }
        libc::_exit(0)
    }
}
