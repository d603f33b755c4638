//! A copy of this process that outlives it by a moment: when this one ends, by SIGKILL too, it ends the groups of the programs that still run.
//! (The parent-death signal of Linux reaches a program, but not what that has started: `make`, compilers.)
use nix::libc;
use nix::sys::wait::waitpid;
use nix::unistd::{ForkResult, Pid, fork};
use std::fs::File;
use std::io::Write;
use std::os::fd::{AsRawFd, OwnedFd, RawFd};
use std::sync::{Mutex, PoisonError};

/// Groups that the watchdog can hold; more than programs ever run at a time.
const ROOM: usize = 1024;
/// Milliseconds between the request to end and SIGKILL.
const GRACE: i64 = 500;

struct Watchdog {
    /// Messages: 4 bytes each, a group that runs, or the negative of one that has ended.
    pipe: File,
    pid: Pid,
}

/// None before the first program, and after [`dismiss`].
static WATCHDOG: Mutex<Option<Watchdog>> = Mutex::new(None);

/// Tells of a group that runs, or (negative) has ended. Where no watchdog can be started, nothing watches.
pub fn tell(group: i32) {
    let mut dog = WATCHDOG.lock().unwrap_or_else(PoisonError::into_inner);
    if dog.is_none() && group > 0 {
        *dog = start();
    }
    if let Some(dog) = &mut *dog {
        let _ = dog.pipe.write_all(&group.to_ne_bytes());
    }
}

/// Ends the watchdog and waits for that.
pub fn dismiss() {
    if let Some(dog) = WATCHDOG.lock().unwrap_or_else(PoisonError::into_inner).take() {
        drop(dog.pipe);
        let _ = waitpid(dog.pid, None);
    }
}

fn start() -> Option<Watchdog> {
    let (read, write) = pipe().ok()?;
    let from = read.as_raw_fd();
    // SAFETY: the child runs `watch` and nothing else, which makes system calls only and never returns; it takes no lock and allocates nothing.
    match unsafe { fork() }.ok()? {
        ForkResult::Child => watch(from),
        ForkResult::Parent { child } => Some(Watchdog { pipe: File::from(write), pid: child }),
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
    let mut groups = [0i32; ROOM];
    // SAFETY: system calls on the process itself, on its own descriptors and on buffers of its own stack.
    unsafe {
        // A signal from the terminal is for the process that is watched.
        libc::setpgid(0, 0);
        for signal in [libc::SIGINT, libc::SIGTERM, libc::SIGHUP, libc::SIGQUIT] {
            libc::signal(signal, libc::SIG_IGN);
        }
        // Nobody waits for the end of a pipe or a lock because of this copy; the one descriptor left is 0.
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
            let mut word = [0u8; 4];
            let n = libc::read(0, word.as_mut_ptr().cast(), word.len());
            if n < 0 && std::io::Error::last_os_error().kind() == std::io::ErrorKind::Interrupted {
                continue;
            }
            if n != 4 {
                break;
            }
            let group = i32::from_ne_bytes(word);
            let (old, new) = if group > 0 { (0, group) } else { (-group, 0) };
            if let Some(place) = groups.iter_mut().find(|g| **g == old) {
                *place = new;
            }
        }
        let all = |signal| {
            let running = groups.iter().filter(|g| **g > 0);
            running.fold(false, |_, g| {
                libc::kill(-g, signal);
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
