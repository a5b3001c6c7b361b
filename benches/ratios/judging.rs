//! Judging against bare sampling, in time and in memory.

use crate::clock::cpu;
use crate::scenes;
use crate::table::key;
use freepath_draws::{Draws, Row, Streams, column};
use freepath_estimators::FreePathSampler;
use freepath_estimators::free_path::DeltaTracking;
use freepath_estimators::medium::Gaussian;
use freepath_harness::collect::{Watch, observe};
use freepath_harness::kind::{FreePathKind, InScene, Ray};
use freepath_harness::subject::{BLOCK, Subject};
use freepath_statistics::Judged;
use std::hint::black_box;
use std::sync::atomic::AtomicBool;

type Fallible<T> = Result<T, Box<dyn std::error::Error>>;

/// Free paths judged in the comparison of times.
const DRAWS: u64 = 10_000_000;

/// Claims, draws, tallies and tests of delta tracking, on the threads of the current pool.
fn judged(medium: &Gaussian, draws: u64) -> Fallible<Judged> {
    let sampler = DeltaTracking::default();
    let experiment = InScene::<FreePathKind>::of(&sampler, Ray::of(medium));
    let subject = Subject::new(&experiment);
    let plan = subject.plan();
    let watch = Watch { cancelled: &AtomicBool::new(false), progress: &|_| () };
    let blocks = 0..Subject::blocks(draws);
    let seen = observe(&subject, &plan, 1, blocks, &watch).map_err(|stopped| format!("{stopped:?}"))?;
    Ok(plan.claims.judge(&seen.tallies))
}

fn bare(medium: &Gaussian, draws: &mut Draws) {
    for block in 0..Subject::blocks(DRAWS) {
        DeltaTracking::default().sample_block(medium, &Streams::new(key(block)), draws);
        black_box(&*draws);
    }
}

/// Prints nanoseconds per draw of judging and of bare sampling on one thread.
pub(crate) fn print(rounds: usize) -> Fallible<()> {
    let medium = scenes::gaussian()?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let mut draws = Draws::new(&Row::new().with_f64(column::T), BLOCK);
    let (mut with, mut without) = (vec![], vec![]);
    for _ in 0..rounds {
        let start = cpu();
        bare(&medium, &mut draws);
        let middle = cpu();
        let found = pool.install(|| judged(&medium, DRAWS).map_err(|e| e.to_string()))?;
        with.push(cpu() - middle);
        without.push(middle - start);
        black_box(found);
    }
    let each = |times| crate::clock::median(times) / (Subject::blocks(DRAWS) * BLOCK as u64) as f64;
    let (with, without) = (each(with), each(without));
    println!(
        "judging 1e7 free paths (delta gaussian, 1 thread): {with:.2} ns per draw, bare sampling {without:.2}, \
         judging / bare {:.2}",
        with / without
    );
    Ok(())
}

/// Judges so many draws on all threads and prints the peak memory of this process in kB.
pub(crate) fn peak(draws: u64) -> Fallible<()> {
    black_box(judged(&scenes::gaussian()?, draws)?);
    let status = std::fs::read_to_string("/proc/self/status")?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    println!("{}", line.ok_or("no VmHWM")?.trim().trim_end_matches(" kB"));
    Ok(())
}

/// Prints the peak memory of judging, each in a process of its own.
pub(crate) fn print_peaks(sizes: &[u64]) -> Fallible<()> {
    for &draws in sizes {
        let child =
            std::process::Command::new(std::env::current_exe()?).args(["--peak", &draws.to_string()]).output()?;
        let kib: f64 = String::from_utf8(child.stdout)?.trim().parse()?;
        println!("peak memory of judging {draws:.0e} free paths on all threads: {:.1} MB", kib * 1024e-6);
    }
    Ok(())
}
