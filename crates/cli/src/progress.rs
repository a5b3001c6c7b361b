//! The progress bar.

use freepath_harness::run::Progress;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Draws done, of those planned so far. Hidden if standard error is no terminal.
pub(crate) struct Bar(ProgressBar);

impl Bar {
    /// A bar, or none if `quiet`.
    pub(crate) fn new(quiet: bool) -> Self {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let template = "{bar:24} {percent:>3} %  {human_pos} of {human_len} draws, {eta} left  {wide_msg}";
        let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
        let bar = ProgressBar::with_draw_target(Some(0), target);
        bar.set_style(style.progress_chars("#-"));
        Self(bar)
    }

    /// Takes in what the run tells.
    pub(crate) fn tell(&self, progress: Progress, subject: &str) {
        match progress {
            Progress::Planned(draws) => self.0.inc_length(draws),
            Progress::Done(draws) => {
                self.0.set_message(crate::screen::cell(subject, 60));
                self.0.inc(draws);
            }
        }
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
