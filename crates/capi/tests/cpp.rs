//! The example in C++, built against the header and both libraries, and run.

#[path = "../../../tests/src/tools.rs"]
#[allow(dead_code, unreachable_pub, reason = "shared with the last lines of `cargo test`")]
mod tools;

use std::path::{Path, PathBuf};
use std::process::Command;

/// The folder of the libraries that belong to this test: beside `deps`, where the test is.
fn libraries() -> PathBuf {
    std::env::current_exe().unwrap().parent().unwrap().parent().unwrap().join("examples")
}

fn built(name: &str, link: &[&str]) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let program = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let made = Command::new("c++")
        .args(["-std=c++17", "-O2", "-Wall", "-Wextra", "-Werror", "-I"])
        .arg(root.join("include"))
        .arg(root.join("examples/delta_tracking.cpp"))
        .arg("-o")
        .arg(&program)
        .current_dir(libraries())
        .args(link)
        .args(["-lpthread", "-ldl", "-lm"])
        .output()
        .unwrap();
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    program
}

/// The commands of the README, with the libraries of this test in the place of those of a release.
#[test]
fn the_commands_of_the_readme_build_and_run_the_example() {
    if !tools::can_run("freepath-capi", "the_commands_of_the_readme_build_and_run_the_example") {
        return;
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let readme = std::fs::read_to_string(root.join("README.md")).unwrap();
    let fences = readme.split("```bash\n").skip(1).map(|rest| rest.split("```").next().unwrap());
    let fence = fences.into_iter().find(|fence| fence.contains("freepath-capi")).unwrap();
    let (first, rest) = fence.split_once('\n').unwrap();
    assert_eq!(first, "cargo build --release -p freepath-capi", "cargo has built the library for this test");
    let library = libraries().join("libfreepath.a").display().to_string();
    let program = Path::new(env!("CARGO_TARGET_TMPDIR")).join("of_the_readme").display().to_string();
    let commands = rest.replace("target/release/libfreepath.a", &library);
    let commands = commands.replace("target/delta_tracking", &program);
    let ran = Command::new("sh").args(["-e", "-c", &commands]).current_dir(&root).output().unwrap();
    let text = String::from_utf8_lossy(&ran.stdout);
    assert!(ran.status.success(), "{text}{}", String::from_utf8_lossy(&ran.stderr));
    assert_eq!(text.lines().filter(|line| line.starts_with("ok ")).count(), 4, "{text}");
}

#[test]
fn the_example_in_cpp_judges_with_the_static_and_the_shared_library() {
    if !tools::can_run("freepath-capi", "the_example_in_cpp_judges_with_the_static_and_the_shared_library") {
        return;
    }
    for (name, link) in [("static", &["libfreepath.a"][..]), ("shared", &["-L.", "-lfreepath"])] {
        let ran = Command::new(built(name, link)).env("LD_LIBRARY_PATH", libraries()).output().unwrap();
        let text = String::from_utf8_lossy(&ran.stdout);
        assert!(ran.status.success(), "{name}: {text}");
        assert_eq!(text.lines().filter(|line| line.starts_with("ok ")).count(), 4, "{text}");
        assert!(text.contains("wrong_law") && text.contains("non_finite"), "{text}");
    }
}
