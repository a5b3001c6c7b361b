//! Judging a file of samples against reading and summing it.

use crate::clock::{cpu, median};
use freepath_draws::{Key, random};
use freepath_estimators::medium::Constant;
use freepath_harness::collect::{Watch, observe};
use freepath_harness::kind::{FreePathKind, InScene, Ray, Source};
use freepath_harness::samples::{EscapeRule, Escapes, Place, Request, RowFormat, SampleFile};
use freepath_harness::subject::Subject;
use std::fs::File;
use std::hint::black_box;
use std::io::{BufRead, BufReader, BufWriter, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

type Fallible<T> = Result<T, Box<dyn std::error::Error>>;

/// The medium in which they are drawn.
const MU: f64 = 1.5;
const LENGTH: f64 = 2.1;
/// The most that judging may cost of reading and summing as many bytes in double precision, on a machine that may be busy.
const MOST: f64 = 12.0;
/// Bytes read at a time where nothing is judged.
const PART: usize = 1 << 16;

/// The sum of the finite numbers, in lanes so that no addition waits for another.
fn total<const W: usize>(cells: &[[u8; W]], number: impl Fn([u8; W]) -> f64) -> f64 {
    let mut lanes = [0.0; 16];
    for part in cells.chunks(lanes.len()) {
        for (lane, cell) in lanes.iter_mut().zip(part) {
            let x = number(*cell);
            *lane += if x.is_finite() { x } else { 0.0 };
        }
    }
    lanes.iter().sum()
}

/// The ways in which a file is written here.
#[derive(Clone, Copy)]
enum Kind {
    Double,
    Single,
    Text,
}

impl Kind {
    const ALL: [(Self, &str, &str); 3] = [
        (Self::Double, "npy float64", "f64.npy"),
        (Self::Single, "npy float32", "f32.npy"),
        (Self::Text, "csv", "text.csv"),
    ];

    /// Draws in the file.
    fn rows(self) -> u64 {
        if matches!(self, Self::Text) { 3_000_000 } else { 20_000_000 }
    }

    /// The most that judging may cost of reading and summing: a row of single precision is half as long to read, and is asked
    /// all the same.
    fn most(self) -> f64 {
        if matches!(self, Self::Single) { 2.0 * MOST } else { MOST }
    }

    fn write(self, path: &Path) -> Fallible<()> {
        let mut file = BufWriter::new(File::create(path)?);
        let rows = self.rows();
        let descr = if matches!(self, Self::Single) { "<f4" } else { "<f8" };
        let header = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': ({rows},), }}\n");
        match self {
            Self::Text => writeln!(file, "t")?,
            Self::Double | Self::Single => {
                file.write_all(b"\x93NUMPY\x01\x00")?;
                file.write_all(&u16::try_from(header.len())?.to_le_bytes())?;
                file.write_all(header.as_bytes())?;
            }
        }
        let mut rng = Key { seed: 1, subject: 3, block: 0 }.rng();
        for _ in 0..rows {
            let t = random::exponential(&mut rng) / MU;
            let t = if t < LENGTH { t } else { f64::INFINITY };
            match self {
                Self::Double => file.write_all(&t.to_le_bytes())?,
                Self::Single => file.write_all(&(t as f32).to_le_bytes())?,
                Self::Text => writeln!(file, "{t}")?,
            }
        }
        Ok(file.flush()?)
    }

    /// The sum of the finite numbers.
    fn sum(self, path: &Path) -> Fallible<f64> {
        let mut file = BufReader::with_capacity(PART, File::open(path)?);
        let mut sum = 0.0;
        if let Self::Text = self {
            let mut line = String::new();
            while file.read_line(&mut line)? > 0 {
                sum += line.trim().parse().ok().filter(|x: &f64| x.is_finite()).unwrap_or(0.0);
                line.clear();
            }
            return Ok(sum);
        }
        let mut length = [0; 10];
        file.read_exact(&mut length)?;
        let mut header = vec![0; usize::from(u16::from_le_bytes([length[8], length[9]]))];
        file.read_exact(&mut header)?;
        let mut part = vec![0; PART];
        loop {
            let read = file.read(&mut part)?;
            if read == 0 {
                return Ok(sum);
            }
            sum += match self {
                Self::Single => total(part[..read].as_chunks().0, |x| f64::from(f32::from_le_bytes(x))),
                Self::Double | Self::Text => total(part[..read].as_chunks().0, f64::from_le_bytes),
            };
        }
    }
}

/// Both stages of the file, as `freepath check` judges them.
fn judged(path: &Path, medium: &Constant) -> Fallible<()> {
    let rows = RowFormat::free_path(Place::Only, EscapeRule { length: LENGTH, escapes: Escapes::AtInfinity });
    let request = Request { rows, format: None, draws: None, tolerance: None, group: None };
    let file = SampleFile::open(path, &request)?;
    let source = Source::External(&file);
    let experiment = InScene::<FreePathKind> { source, scene: Ray::of(medium) };
    let subject = Subject {
        draws: file.first_rows(),
        tolerance: file.tolerance(),
        bits: file.resolution_bits(),
        ..Subject::new(&experiment)
    };
    let plan = subject.plan();
    let watch = Watch { cancelled: &AtomicBool::new(false), progress: &|_| () };
    let blocks = Subject::blocks(subject.draws);
    for stage in [0..blocks, blocks..3 * blocks] {
        let seen = observe(&subject, &plan, 1, stage, &watch).map_err(|stopped| format!("{stopped:?}"))?;
        black_box(plan.claims.judge(&seen.tallies));
    }
    Ok(())
}

/// A file in the folder for temporary files, removed when done.
struct Temporary(PathBuf);

impl Drop for Temporary {
    fn drop(&mut self) {
        drop(std::fs::remove_file(&self.0)); // nobody is left to tell
    }
}

/// Nanoseconds per draw of judging, and of reading and summing, on one thread.
fn measure(rounds: usize, kind: Kind, name: &str) -> Fallible<[f64; 2]> {
    let file = Temporary(std::env::temp_dir().join(format!("freepath-bench-{}-{name}", std::process::id())));
    kind.write(&file.0)?;
    let medium = Constant::new(MU, LENGTH)?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let (mut with, mut without) = (vec![], vec![]);
    for _ in 0..rounds {
        let start = cpu();
        black_box(kind.sum(&file.0)?);
        let middle = cpu();
        pool.install(|| judged(&file.0, &medium).map_err(|e| e.to_string()))?;
        with.push(cpu() - middle);
        without.push(middle - start);
    }
    Ok([median(with), median(without)].map(|ns| ns / kind.rows() as f64))
}

/// Prints each kind of file; whether judging is cheap enough for all, with room for a busy machine.
pub(crate) fn print(rounds: usize) -> Fallible<bool> {
    let mut sound = true;
    for (kind, words, name) in Kind::ALL {
        let [with, without] = measure(rounds, kind, name)?;
        println!(
            "judging {:.0e} free paths from {words} (1 thread): {with:.2} ns per draw, reading and summing {without:.2}, \
             ratio {:.2} (at most {})",
            kind.rows() as f64,
            with / without,
            kind.most()
        );
        sound &= with / without <= kind.most();
    }
    Ok(sound)
}
