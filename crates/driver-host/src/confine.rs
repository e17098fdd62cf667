//! What the process of a driver may use.

#[cfg(unix)]
mod unix {
    use std::fs::File;
    use std::io;

    use rustix::process::{Resource, Rlimit, Signal, getrlimit, setrlimit};

    /// Takes the pipes away from the driver: what it prints goes to the error stream, and it reads nothing.
    pub(crate) fn take_pipes() -> io::Result<(File, File)> {
        let requests = File::from(rustix::io::fcntl_dupfd_cloexec(rustix::stdio::stdin(), 3)?);
        let replies = File::from(rustix::io::fcntl_dupfd_cloexec(rustix::stdio::stdout(), 3)?);
        rustix::stdio::dup2_stdin(File::open("/dev/null")?)?;
        rustix::stdio::dup2_stdout(rustix::stdio::stderr())?;
        Ok((requests, replies))
    }

    /// Limits memory to so many bytes, or to less where less is allowed already, and leaves no core file.
    pub(crate) fn limit(bytes: u64) -> io::Result<()> {
        // On Linux the data of a process are what it has for itself, and shared libraries do not count;
        // elsewhere only the address space can be limited.
        let memory = if cfg!(target_os = "linux") { Resource::Data } else { Resource::As };
        let most = |most| Rlimit { current: Some(most), maximum: Some(most) };
        let allowed = getrlimit(memory).maximum.map_or(bytes, |allowed| allowed.min(bytes));
        setrlimit(memory, most(allowed))?;
        setrlimit(Resource::Core, most(0))?;
        Ok(())
    }

    /// Ends this process and what the driver has started, without running anything of the driver's.
    pub(crate) fn end() -> ! {
        let own = rustix::process::getpid();
        // Started by hand, its group is that of the process that started it.
        if rustix::process::getpgrp() == own {
            let _ = rustix::process::kill_current_process_group(Signal::KILL);
        }
        let _ = rustix::process::kill_process(own, Signal::KILL);
        std::process::abort()
    }
}

#[cfg(unix)]
pub(crate) use unix::{end, limit, take_pipes};

#[cfg(not(unix))]
mod other {
    use std::io::{self, Stdin, Stdout};

    /// The standard streams themselves: a driver that prints breaks its own pipe, and is ended for it.
    pub(crate) fn take_pipes() -> io::Result<(Stdin, Stdout)> {
        Ok((io::stdin(), io::stdout()))
    }

    /// This system has no limit that a process can set for itself.
    pub(crate) fn limit(_bytes: u64) -> io::Result<()> {
        Ok(())
    }

    /// Ends this process.
    pub(crate) fn end() -> ! {
        std::process::abort()
    }
}

#[cfg(not(unix))]
pub(crate) use other::{end, limit, take_pipes};
