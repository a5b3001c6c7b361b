//! Programs as subjects. What needs no more than a shell always runs; what needs Python, NumPy or a compiler is left out where
//! they are missing, and the last lines say so.

#[cfg(unix)]
#[path = "programs/adapters.rs"]
mod adapters;
#[cfg(unix)]
#[path = "programs/errors.rs"]
mod errors;
#[cfg(unix)]
#[path = "programs/lives.rs"]
mod lives;
#[cfg(unix)]
#[path = "programs/media.rs"]
mod media;
#[cfg(unix)]
#[path = "programs/protocol.rs"]
mod protocol;
#[cfg(unix)]
#[path = "programs/scripts.rs"]
mod scripts;
#[path = "cli/support.rs"]
#[allow(dead_code, reason = "shared with the tests of the command line, which need more of it")]
mod support;
#[cfg(unix)]
#[path = "programs/tools.rs"]
mod tools;

#[cfg(unix)]
fn main() {
    let filter = std::env::args().skip(1).find(|word| !word.starts_with('-')).unwrap_or_default();
    let all = [errors::TESTS, lives::TESTS, protocol::TESTS, adapters::TESTS, media::TESTS];
    let chosen = || all.iter().copied().flatten().filter(|(name, ..)| name.contains(&filter));
    if std::env::args().any(|word| word == "--list") {
        chosen().for_each(|(name, ..)| println!("{name}: test"));
        return;
    }
    let mut left_out = Vec::new();
    for (name, needs, test) in chosen() {
        let missing: Vec<_> = needs.iter().copied().filter(|tool| !tool.is_there()).collect();
        if missing.is_empty() {
            test();
            println!("test {name} ... ok");
        } else {
            left_out.push((name, missing));
        }
    }
    println!(
        "\ntest result: ok. {} passed; 0 failed; {} left out",
        chosen().count() - left_out.len(),
        left_out.len()
    );
    for (name, missing) in &left_out {
        let missing: Vec<_> = missing.iter().map(|tool| tool.how_to_get()).collect();
        eprintln!("LEFT OUT: {name} was not tested; {}", missing.join("; "));
    }
}

#[cfg(not(unix))]
fn main() {
    eprintln!(
        "LEFT OUT: programs as subjects were not tested, they need process groups (Linux, macOS or another Unix)"
    );
}
