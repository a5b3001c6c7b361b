//! The example in C++, built against the header and both libraries, and run.

use std::path::{Path, PathBuf};
use std::process::Command;

/// The folder of the libraries that belong to this test.
fn libraries() -> PathBuf {
    std::env::current_exe().unwrap().parent().unwrap().to_path_buf()
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

#[test]
fn the_example_in_cpp_judges_with_the_static_and_the_shared_library() {
    if Command::new("c++").arg("--version").output().is_err() {
        eprintln!(
            "LEFT OUT: the example in C++ was not built, there is no `c++` (install a C++17 compiler, such as g++)"
        );
        return;
    }
    for (name, link) in [("static", &["libfreepath.a"][..]), ("shared", &["-L.", "-lfreepath"])] {
        let ran = Command::new(built(name, link)).env("LD_LIBRARY_PATH", libraries()).output().unwrap();
        let text = String::from_utf8_lossy(&ran.stdout);
        assert!(ran.status.success(), "{name}: {text}");
        assert_eq!(text.matches("ok ").count(), 3, "{text}");
        assert!(text.contains("wrong_law"), "{text}");
    }
}
