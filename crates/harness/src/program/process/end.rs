//! The end of a program: waited for, told in words, and brought about where need be.

use super::{Process, SHAPE};
use crate::program::log::last_line;
use freepath_formats::Refusal;
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::process::{Pid, Signal, WaitId, WaitIdOptions, kill_process_group, waitid};
use std::os::fd::AsFd;
use std::os::unix::process::ExitStatusExt;
use std::process::ExitStatus;
use std::time::Duration;

impl Process<'_> {
    /// Waits for the end; what it has left running is killed.
    pub(super) fn wait_for_exit(&mut self) -> Result<ExitStatus, Refusal> {
        let unknown = |why: std::io::Error| Refusal::new(format!("its end is not known: {why}"), "exit code 0");
        let looked = WaitIdOptions::EXITED | WaitIdOptions::NOHANG | WaitIdOptions::NOWAIT;
        loop {
            let ended = waitid(WaitId::Pid(Pid::from_child(&self.child)), looked);
            if ended.map_err(|why| unknown(why.into()))?.is_some() {
                break;
            }
            self.wait_briefly()?;
        }
        self.drain_stderr();
        self.kill().map_err(unknown)
    }

    /// Waits a moment: for standard error, or for nothing.
    fn wait_briefly(&mut self) -> Result<(), Refusal> {
        if self.stderr.is_none() && self.stdin.is_none() {
            let nap = Duration::from_millis(2);
            std::thread::sleep(nap);
            (self.waited, self.silent) = (self.waited + nap, self.silent + nap);
            return self.check_limits();
        }
        let before = (self.tail.len(), self.stderr.is_some());
        self.poll_pipes(false)?;
        if before == (self.tail.len(), self.stderr.is_some()) && self.stdin.is_some() {
            self.stdin = None; // nobody reads it any more
        }
        Ok(())
    }

    /// Reads the rest that stands in the pipe of standard error.
    fn drain_stderr(&mut self) {
        let now = Timespec { tv_sec: 0, tv_nsec: 0 };
        for _ in 0..64 {
            let Some(pipe) = &self.stderr else { return };
            if !matches!(poll(&mut [PollFd::new(&pipe.as_fd(), PollFlags::IN)], Some(&now)), Ok(1..)) {
                return;
            }
            self.read_stderr();
        }
    }

    /// Kills the whole group and reaps its leader, which until then keeps the group's number.
    pub(super) fn kill(&mut self) -> std::io::Result<ExitStatus> {
        if !self.ended {
            // A group that has gone cannot be killed, and need not be.
            let _ = kill_process_group(Pid::from_child(&self.child), Signal::KILL);
            self.ended = true;
        }
        self.child.wait()
    }

    pub(super) fn short_output(&mut self) -> Refusal {
        let (read, wanted) = (self.read, self.wanted);
        match self.wait_for_exit() {
            Ok(status) if !status.success() => self.failure(status),
            Ok(_) => Refusal::new(format!("it wrote {read} of {wanted} bytes{}", self.text_remark()), SHAPE),
            Err(why) => why,
        }
    }

    pub(super) fn failure(&self, status: ExitStatus) -> Refusal {
        let how = match (status.signal(), status.code()) {
            (Some(signal), _) => format!("it was killed by signal {signal}"),
            (None, code) => format!("it ended with exit code {}", code.unwrap_or(-1)),
        };
        let said = last_line(&self.tail).map(|line| format!(", and said: {line}")).unwrap_or_default();
        Refusal::new(format!("{how} after {} of {} bytes{said}", self.read, self.wanted), "exit code 0")
    }

    /// A remark if the bytes are no doubles.
    pub(super) fn text_remark(&self) -> &'static str {
        let text = |byte: &u8| byte.is_ascii_graphic() || byte.is_ascii_whitespace();
        let is_text = !self.head.is_empty() && self.head.iter().all(text);
        if is_text { ", which look like text" } else { "" }
    }
}
