//! A process in a group of its own: fed, read and killed as a whole, without a deadlock and without waiting for ever.

use super::limits::TOTAL_PER_IDLE;
use super::log::Log;
use freepath_formats::Refusal;
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use std::io::{ErrorKind, Read, Write};
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Child, ChildStderr, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

mod end;

/// The length of a wait before it is looked whether the run was cancelled.
const SLICE: Duration = Duration::from_millis(50);

/// Bytes of the beginning of standard output and of the end of standard error that messages look at.
const GLANCE: usize = 2048;

/// A start of a program.
pub(super) struct Start<'a> {
    pub(super) argv: &'a [String],
    pub(super) folder: &'a Path,
    pub(super) idle: Duration,
    pub(super) log: &'a Log,
    pub(super) cancelled: &'a AtomicBool,
}

/// A running program.
pub(super) struct Process<'a> {
    start: Start<'a>,
    child: Child,
    stdin: Option<ChildStdin>,
    request: Vec<u8>,
    written: usize,
    stdout: ChildStdout,
    stderr: Option<ChildStderr>,
    /// Bytes that it should write, and that it wrote.
    wanted: u64,
    read: u64,
    /// The first bytes that it wrote.
    head: Vec<u8>,
    /// The last bytes of its standard error.
    tail: Vec<u8>,
    /// Time that was spent in waiting for it: at all, and since it last gave a sign of life.
    waited: Duration,
    silent: Duration,
    ended: bool,
}

impl<'a> Start<'a> {
    /// Starts the program, which should read `request` and write so many bytes.
    pub(super) fn start(self, request: Vec<u8>, wanted: u64) -> Result<Process<'a>, Refusal> {
        let refuse = |why: std::io::Error| Refusal::new(why.to_string(), STARTED);
        let mut command = Command::new(&self.argv[0]);
        command.args(&self.argv[1..]).current_dir(self.folder).process_group(0);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().map_err(refuse)?;
        let (Some(stdin), Some(stdout), stderr) = (child.stdin.take(), child.stdout.take(), child.stderr.take())
        else {
            return Err(Refusal::new("it has no pipes", STARTED));
        };
        rustix::io::ioctl_fionbio(&stdin, true).map_err(|why| refuse(why.into()))?;
        Ok(Process {
            start: self,
            child,
            stdin: Some(stdin),
            request,
            written: 0,
            stdout,
            stderr,
            wanted,
            read: 0,
            head: Vec::new(),
            tail: Vec::new(),
            waited: Duration::ZERO,
            silent: Duration::ZERO,
            ended: false,
        })
    }
}

impl Process<'_> {
    /// Reads as many bytes as `bytes` has.
    pub(super) fn fill(&mut self, bytes: &mut [u8]) -> Result<(), Refusal> {
        let mut filled = 0;
        while filled < bytes.len() {
            match self.read_stdout(&mut bytes[filled..])? {
                0 => return Err(self.short_output()),
                more => filled += more,
            }
        }
        Ok(())
    }

    /// Sees to it that there is nothing after the last byte, and that the program ends well.
    pub(super) fn finish(&mut self) -> Result<(), Refusal> {
        if self.read_stdout(&mut [0])? > 0 {
            let cause = format!("it wrote more than {} bytes{}", self.wanted, self.text_remark());
            return Err(Refusal::new(cause, SHAPE));
        }
        let status = self.wait_for_exit()?;
        if status.success() { Ok(()) } else { Err(self.failure(status)) }
    }

    /// The next bytes of standard output, none at its end; meanwhile the request is written and standard error read.
    fn read_stdout(&mut self, bytes: &mut [u8]) -> Result<usize, Refusal> {
        self.silent = Duration::ZERO;
        loop {
            if !self.poll_pipes(true)? {
                continue;
            }
            match self.stdout.read(bytes) {
                Ok(n) => {
                    let room = GLANCE - self.head.len();
                    self.head.extend(bytes[..n].iter().take(room));
                    self.read += n as u64;
                    return Ok(n);
                }
                Err(why) if why.kind() == ErrorKind::Interrupted => {}
                Err(why) => return Err(Refusal::new(format!("its output cannot be read: {why}"), SHAPE)),
            }
        }
    }

    /// Waits a little, and serves the other pipes: whether standard output can be read, if that is asked for.
    fn poll_pipes(&mut self, output: bool) -> Result<bool, Refusal> {
        self.check_limits()?;
        let (started, timeout) = (Instant::now(), Timespec { tv_sec: 0, tv_nsec: SLICE.subsec_nanos().into() });
        let (readable, writable) = (PollFlags::IN, PollFlags::OUT);
        let mut fds = Vec::with_capacity(3);
        fds.extend(output.then(|| PollFd::new(&self.stdout, readable)));
        fds.extend(self.stderr.as_ref().map(|pipe| PollFd::new(pipe, readable)));
        fds.extend(self.stdin.as_ref().map(|pipe| PollFd::new(pipe, writable)));
        if let Err(why) = poll(&mut fds, Some(&timeout))
            && why != rustix::io::Errno::INTR
        {
            return Err(Refusal::new(format!("its pipes cannot be read: {why}"), SHAPE));
        }
        let mut ready = fds.iter().map(|fd| !fd.revents().is_empty());
        let out = output && ready.next() == Some(true);
        let err = self.stderr.is_some() && ready.next() == Some(true);
        let request = self.stdin.is_some() && ready.next() == Some(true);
        drop(ready);
        self.waited += started.elapsed();
        self.silent = if out || err { Duration::ZERO } else { self.silent + started.elapsed() };
        if err {
            self.read_stderr();
        }
        if request {
            self.write_request();
        }
        Ok(out)
    }

    fn check_limits(&self) -> Result<(), Refusal> {
        let idle = self.start.idle;
        let total = idle.saturating_mul(TOTAL_PER_IDLE);
        let seconds = |limit: Duration| format!("{} s", limit.as_secs_f64());
        let allowed = "a longer time: state `timeout`, or run with --timeout SECONDS";
        if self.start.cancelled.load(Ordering::Relaxed) {
            return Err(Refusal::new("the run was cancelled", "a run that goes on"));
        }
        let (read, wanted) = (self.read, self.wanted);
        if self.silent >= idle {
            let done = if read == wanted { ": all of them, but it or what it has started goes on" } else { "" };
            let cause = format!("it was silent for {} after {read} of {wanted} bytes{done}", seconds(idle));
            return Err(Refusal::new(cause, allowed));
        }
        if self.waited >= total {
            let cause = format!("it took longer than {} for {read} of {wanted} bytes", seconds(total));
            return Err(Refusal::new(cause, allowed));
        }
        Ok(())
    }

    /// Reads some of standard error.
    fn read_stderr(&mut self) {
        let (Some(pipe), mut said) = (&mut self.stderr, [0; 4096]) else { return };
        match pipe.read(&mut said) {
            Ok(n) if n > 0 => {
                self.start.log.add(&said[..n]);
                self.tail.extend_from_slice(&said[..n]);
                self.tail.drain(..self.tail.len().saturating_sub(GLANCE));
            }
            Err(why) if why.kind() == ErrorKind::Interrupted => {}
            _ => self.stderr = None,
        }
    }

    /// Writes some of the request, and closes standard input after it. A program need not read it.
    fn write_request(&mut self) {
        let Some(pipe) = &mut self.stdin else { return };
        match pipe.write(&self.request[self.written..]) {
            Ok(n) => self.written += n,
            Err(why) if matches!(why.kind(), ErrorKind::Interrupted | ErrorKind::WouldBlock) => {}
            Err(_) => self.written = self.request.len(),
        }
        if self.written == self.request.len() {
            self.stdin = None;
        }
    }
}

/// The programs that can be started.
const STARTED: &str =
    "an executable on PATH, or from the folder of the case by a name with a /, and its interpreter";

/// The output that is right.
const SHAPE: &str = "raw doubles, little endian, as many as the request asks for";

impl Drop for Process<'_> {
    fn drop(&mut self) {
        drop(self.kill());
    }
}
