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
#[path = "programs/place.rs"]
mod place;
#[cfg(unix)]
#[path = "programs/protocol.rs"]
mod protocol;
#[cfg(unix)]
#[path = "programs/rows.rs"]
mod rows;
#[cfg(unix)]
#[path = "programs/scripts.rs"]
mod scripts;
#[path = "cli/support.rs"]
#[allow(dead_code, reason = "shared with the tests of the command line, which need more of it")]
mod support;
#[cfg(unix)]
#[path = "../../../tests/src/tools.rs"]
#[allow(dead_code, unreachable_pub, reason = "shared with the last lines of `cargo test`")]
mod tools;

#[cfg(unix)]
fn main() {
    let filter = std::env::args().skip(1).find(|word| !word.starts_with('-')).unwrap_or_default();
    let all = [errors::TESTS, lives::TESTS, protocol::TESTS, rows::TESTS, adapters::TESTS, media::TESTS];
    let chosen = || all.iter().copied().flatten().filter(|(name, ..)| name.contains(&filter));
    if std::env::args().any(|word| word == "--list") {
        chosen().for_each(|(name, ..)| println!("{name}: test"));
        return;
    }
    let needing =
        || tools::NEEDING.iter().filter(|(package, ..)| *package == "freepath-cli").map(|(_, name, _)| *name);
    needing().for_each(|name| assert!(all.iter().copied().flatten().any(|(other, _)| *other == name), "{name}"));
    let mut left_out = 0;
    for (name, test) in chosen() {
        if !needing().any(|other| other == *name) || tools::can_run("freepath-cli", name) {
            test();
            println!("test {name} ... ok");
        } else {
            left_out += 1;
        }
    }
    println!("\ntest result: ok. {} passed; 0 failed; {left_out} left out", chosen().count() - left_out);
}

#[cfg(not(unix))]
fn main() {
    eprintln!(
        "LEFT OUT: programs as subjects were not tested, they need process groups (Linux, macOS or another Unix)"
    );
}
