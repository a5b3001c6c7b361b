//! Ctrl-C.
#![cfg(unix)]

use crate::support::{contents, decoded, freepath, with_good};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

#[test]
fn ctrl_c_ends_a_run_soon_and_leaves_the_earlier_report() {
    let folder = with_good("interrupted");
    assert!(freepath(&folder, &["run"]).output().unwrap().status.success());
    let before = contents(&folder);
    let mut long = freepath(&folder, &["run", "--draws", "1e11", "--jobs", "2"]);
    let child = long.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    sleep(Duration::from_millis(700));
    let asked = Instant::now();
    let kill = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(kill.success());
    let (code, out, err) = decoded(&child.wait_with_output().unwrap());
    assert!(asked.elapsed() < Duration::from_secs(10));
    assert_eq!((code, out.as_str()), (130, ""));
    assert!(err.contains("interrupted"), "{err}");
    assert!(contents(&folder) == before, "nothing has changed");
}
