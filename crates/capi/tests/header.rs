//! The committed header is the one that the source gives.

use std::path::Path;

fn made() -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).unwrap();
    let mut text = Vec::new();
    let builder = cbindgen::Builder::new().with_config(config).with_src(root.join("src/lib.rs"));
    builder.generate().unwrap().write(&mut text);
    String::from_utf8(text).unwrap()
}

/// To make it anew: `FREEPATH_HEADER=write cargo test -p freepath-capi --test header`.
#[test]
fn the_header_is_up_to_date() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("include/freepath.h");
    let made = made();
    if std::env::var_os("FREEPATH_HEADER").is_some() {
        std::fs::write(&path, &made).unwrap();
    }
    assert!(std::fs::read_to_string(path).unwrap() == made, "the header is not what the source gives");
}
