//! One input under judgement: no panic, however it is caught; no more memory than allowed; no more time.
//!
//! What a process does not survive, a stack that overflows or memory that is refused, is seen by [`supervise`](crate::supervise).

use peak_alloc::PeakAlloc;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, Once, PoisonError};
use std::time::{Duration, Instant};

/// Counts what every thread of this process holds.
#[global_allocator]
static HEAP: PeakAlloc = PeakAlloc;

/// Nothing, or why an input was refused.
pub type Answer = Result<(), String>;

/// Reads an input as the program would, and uses what it has read.
pub type Reader = Box<dyn Fn(&[u8]) -> Answer>;

/// The bounds on a reader's time and memory.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    /// Seconds of all processors.
    pub seconds: f64,
    /// Bytes of memory for any input,
    pub bytes: usize,
    /// and so many for each of its bytes.
    pub per_byte: usize,
    /// Seconds by the clock after which it will never end.
    pub hang: f64,
}

/// Some megabytes, some bytes for each byte of input, a second.
pub const SMALL: Bounds = Bounds { seconds: 1.0, bytes: 4 << 20, per_byte: 64, hang: 60.0 };

/// A fault of a reader.
#[derive(Clone, Debug, PartialEq)]
pub enum Find {
    /// It panicked, even if somebody caught it: where, and what it said.
    Panic(String, String),
    /// It held so many bytes where so many are allowed.
    Memory(usize, usize),
    /// It took so many seconds where so many are allowed.
    Time(f64, f64),
}

impl fmt::Display for Find {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Panic(place, said) => write!(f, "panic at {place}: {said}"),
            Self::Memory(held, most) => write!(f, "memory: {held} bytes held, {most} allowed"),
            Self::Time(took, most) => write!(f, "time: {took:.2} s, {most} s allowed"),
        }
    }
}

/// The verdict on an input.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The reader's answer: accepted, or why not; none if the reader did not return.
    pub answer: Option<Answer>,
    /// The faults found.
    pub finds: Vec<Find>,
    /// Seconds of all processors.
    pub seconds: f64,
    /// The most bytes held at a time.
    pub held: usize,
}

/// The verdict on `reader` with `input`. One input at a time in a process, since memory and time are the process's.
#[must_use]
pub fn judge(name: &str, bounds: &Bounds, input: &[u8], reader: &Reader) -> Verdict {
    static ONE: Mutex<()> = Mutex::new(());
    let _one = lock(&ONE);
    listen();
    lock(&PANICS).clear();
    let watched = Watched::new(name, bounds.hang);
    let (started, before) = (cpu_seconds(), HEAP.current_usage());
    HEAP.reset_peak_usage();
    let answer = catch_unwind(AssertUnwindSafe(|| reader(input))).ok();
    let (held, seconds) = (HEAP.peak_usage().saturating_sub(before), cpu_seconds() - started);
    drop(watched);
    let mut finds: Vec<Find> = lock(&PANICS).drain(..).map(|(place, said)| Find::Panic(place, said)).collect();
    let most = bounds.bytes + bounds.per_byte * input.len();
    if held > most {
        finds.push(Find::Memory(held, most));
    }
    if !(seconds <= bounds.seconds) {
        finds.push(Find::Time(seconds, bounds.seconds));
    }
    Verdict { answer, finds, seconds, held }
}

fn lock<T>(of: &Mutex<T>) -> MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The place and message of each panic while an input is judged.
static PANICS: Mutex<Vec<(String, String)>> = Mutex::new(Vec::new());
static JUDGING: AtomicBool = AtomicBool::new(false);

/// The panics of an input are noted, on whatever thread; others go their way.
fn listen() {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let before = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |panic| {
            if !JUDGING.load(Ordering::Relaxed) {
                return before(panic);
            }
            let place = panic.location().map(ToString::to_string).unwrap_or_default();
            lock(&PANICS).push((place, panic.payload_as_str().unwrap_or_default().to_string()));
        }));
    });
}

/// The input being judged: what, since when, how long at most.
static BUSY: Mutex<Option<(String, Instant, Duration)>> = Mutex::new(None);

struct Watched;

impl Watched {
    fn new(name: &str, hang: f64) -> Self {
        static WATCHDOG: Once = Once::new();
        WATCHDOG.call_once(|| drop(std::thread::spawn(watch)));
        *lock(&BUSY) = Some((name.to_string(), Instant::now(), Duration::from_secs_f64(hang)));
        JUDGING.store(true, Ordering::Relaxed);
        Self
    }
}

impl Drop for Watched {
    fn drop(&mut self) {
        JUDGING.store(false, Ordering::Relaxed);
        *lock(&BUSY) = None;
    }
}

/// Nothing but the end of the process stops a reader that hangs.
fn watch() {
    loop {
        std::thread::sleep(Duration::from_millis(200));
        if let Some((name, since, most)) = &*lock(&BUSY)
            && since.elapsed() > *most
        {
            eprintln!("{name} hangs: more than {} s for one input", most.as_secs_f64());
            std::process::abort();
        }
    }
}

#[cfg(unix)]
fn cpu_seconds() -> f64 {
    let now = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    now.tv_sec as f64 + 1e-9 * now.tv_nsec as f64
}

/// By the clock, where there is no other.
#[cfg(not(unix))]
fn cpu_seconds() -> f64 {
    static START: std::sync::LazyLock<Instant> = std::sync::LazyLock::new(Instant::now);
    START.elapsed().as_secs_f64()
}
