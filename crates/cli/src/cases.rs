//! From paths to cases ready to run: all of them, or every reason why not.

use crate::command_error::CommandError;
use freepath_harness::case::{CaseFile, Limits, Prepared};
use freepath_harness::run::id;
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

/// The case files among `paths` and, sorted, in the folders among them. `out`, where reports go, is not searched.
pub(crate) fn find(paths: &[PathBuf], out: &Path) -> Result<Vec<PathBuf>, CommandError> {
    let (mut files, mut messages) = (Vec::new(), Vec::new());
    for path in paths {
        let before = files.len();
        match search(path, out, &mut files) {
            Err(why) => messages.push(format!("error: {why}")),
            Ok(()) if files.len() == before && path.is_dir() => messages.push(format!(
                "error: cannot find a case in {} (a file that ends in .json or .jsonc)",
                path.display()
            )),
            Ok(()) => {}
        }
    }
    match messages.is_empty() {
        true => Ok(distinct(files)),
        false => Err(CommandError::Unusable(messages)),
    }
}

/// A file is a case because it is named; in a folder, its ending tells.
fn search(path: &Path, out: &Path, files: &mut Vec<PathBuf>) -> Result<(), String> {
    let unreadable = |why| format!("cannot read {}: {why}", path.display());
    if !fs::metadata(path).map_err(unreadable)?.is_dir() {
        files.push(path.to_path_buf());
        return Ok(());
    }
    let mut inside = Vec::new();
    for entry in fs::read_dir(path).map_err(unreadable)? {
        inside.push(entry.map_err(unreadable)?);
    }
    inside.sort_by_key(fs::DirEntry::file_name);
    for entry in inside {
        let path = entry.path();
        // Links to folders are not followed: they may lead in a circle.
        let folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
        let case = path.extension().is_some_and(|end| end == "json" || end == "jsonc");
        if (folder && !same(&path, out)) || (!folder && case && !path.is_dir()) {
            search(&path, out, files)?;
        }
    }
    Ok(())
}

fn same(a: &Path, b: &Path) -> bool {
    matches!((fs::canonicalize(a), fs::canonicalize(b)), (Ok(a), Ok(b)) if a == b)
}

/// Each file once, where it is named first.
fn distinct(mut files: Vec<PathBuf>) -> Vec<PathBuf> {
    let mut seen = std::collections::HashSet::new();
    files.retain(|file| seen.insert(fs::canonicalize(file).unwrap_or_else(|_| file.clone())));
    files
}

/// Every case of `files` along each of its rays.
pub(crate) fn prepare(files: &[PathBuf], limits: &Limits, color: bool) -> Result<Vec<Prepared>, CommandError> {
    let (mut cases, mut messages) = (Vec::new(), Vec::new());
    for file in files {
        match CaseFile::load(file).and_then(|case| case.prepare(limits)) {
            Ok(prepared) => cases.extend(prepared),
            Err(why) => messages.push(why.render(color)),
        }
    }
    match messages.is_empty() {
        true => unambiguous(cases),
        false => Err(CommandError::Unusable(messages)),
    }
}

/// Refuses two subjects of one id.
fn unambiguous(cases: Vec<Prepared>) -> Result<Vec<Prepared>, CommandError> {
    let mut seen = HashMap::new();
    for case in &cases {
        for subject in &case.subjects {
            let id = id(case, subject);
            if let Some(other) = seen.insert(id.clone(), &case.file) {
                let (file, name) = (&case.file, &subject.name);
                return Err(CommandError::unusable(format!(
                    "cannot tell \"{name}\" of {file} from a subject of {other}: both have the id {id} (give one another \
                     `name`, or the file another name)"
                )));
            }
        }
    }
    Ok(cases)
}
