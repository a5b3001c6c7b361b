//! Shell scripts as programs.

use crate::support::{folder, put};
use freepath_draws::Key;
use freepath_draws::random::exponential;
use std::path::Path;

/// A folder with the case of these subjects, each a shell script, in a slab.
pub(crate) fn ready(name: &str, scripts: &[(&str, &str)], more: &str) -> std::path::PathBuf {
    let folder = folder(name);
    let of = |(name, script): &(&str, &str)| {
        put(&folder, &format!("cases/{name}.sh"), &format!("read line\n{NUMBER}{script}\n"));
        format!(r#"{{ "name": "{name}", "free_path": {{ "command": {{ "argv": ["sh", "{name}.sh"] }} }} }}"#)
    };
    let mut subjects: Vec<String> = scripts.iter().map(of).collect();
    subjects.push(r#"{ "transmittance": { "ratio_tracking": {} } }"#.into());
    let medium = r#""constant": { "mu": 1.5, "length": 2.0 }"#;
    let case = format!(
        r#"{{ "title": "Scripts", "medium": {{ {medium} }}, {more} "draws": 16384, "subjects": [ {} ] }}"#,
        subjects.join(",\n")
    );
    put(&folder, "cases/scripts.json", &case);
    right_draws(&folder);
    folder
}

/// `$n` is the number of bytes that are asked for, `$stage` the stage, `$seed` the seed.
pub(crate) const NUMBER: &str = r#"
field() { printf '%s' "$line" | sed "s/.*\"$1\":\([0-9]*\).*/\1/"; }
n=$((8 * $(field draws))); stage=$(field stage); seed=$(field seed)
"#;

/// Right free paths in the slab, in a file that scripts take theirs from: stretches of its first part in stage 1, of the rest in later starts, so
/// that no start has rows of another stage.
fn right_draws(folder: &Path) {
    let mut rng = Key { seed: 1, subject: 9, block: 0 }.rng();
    let mut path = || {
        let t = exponential(&mut rng) / 1.5;
        if t < 2.0 { t } else { f64::INFINITY }
    };
    let bytes: Vec<u8> = (0..104 * 16_384).flat_map(|_| path().to_le_bytes()).collect();
    std::fs::write(folder.join("cases/right.f64"), bytes).unwrap();
}

/// A right program: stage and seed choose where it begins.
pub(crate) const RIGHT: &str =
    "tail -c +$((1 + 8 * (786432 * (stage - 1) + 1024 * (seed % 700)))) right.f64 | head -c $n";
