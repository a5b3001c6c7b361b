//! Every shipped case and control is as expected with a tenth of its draws, as `run cases --quick` takes them; `run cases`
//! shows it with all.

use freepath_estimators::medium::AnyMedium;
use freepath_harness::case::{Case, CaseFile, KINDS, Limits};
use freepath_harness::fault::Fault;
use freepath_tests::{case_paths, load, results, root, surprises};
use std::collections::BTreeSet;

#[test]
fn every_shipped_case_is_as_expected() {
    let quick = Limits { effort: 0.1, ..Limits::default() };
    let cases: Vec<_> = case_paths("cases").iter().flat_map(|path| load(path, &quick)).collect();
    let found = surprises(&results(&cases, 1));
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn every_name_is_in_a_case() {
    let paths = [case_paths("cases"), case_paths("adapters/examples")].concat();
    let text: String = paths.iter().filter_map(|path| std::fs::read_to_string(path).ok()).collect();
    let faults = Fault::NAMES.iter().map(|(name, _)| *name);
    let subjects = KINDS.iter().flat_map(|kind| (kind.names)());
    for name in subjects.chain(AnyMedium::NAMES).copied().chain(faults) {
        assert!(text.contains(&format!("\"{name}\"")), "no case names {name:?}");
    }
}

#[test]
fn every_case_survives_being_written_and_read_again() {
    for path in case_paths("cases") {
        let first = CaseFile::load(&path).unwrap_or_else(|error| panic!("{error}")).case;
        let text = serde_json::to_string_pretty(&first).expect("a case is JSON");
        let again: Case = CaseFile::parse(&path, text).unwrap_or_else(|error| panic!("{error}")).case;
        assert_eq!(first, again, "{}", path.display());
    }
}

#[test]
fn every_fault_is_on_its_page_and_most_have_a_setting_that_hides_them() {
    let page = std::fs::read_to_string(root().join("docs/faults.md")).unwrap_or_default();
    let mut hidden = BTreeSet::new();
    for path in case_paths("cases/controls") {
        let case = CaseFile::load(&path).unwrap_or_else(|error| panic!("{error}")).case;
        for subject in case.subjects.iter().filter(|subject| subject.masks_fault) {
            hidden.extend(subject.fault.iter().flat_map(|faults| &faults.0).map(Fault::name));
        }
    }
    assert!(hidden.len() >= 40, "{hidden:?}");
    for (name, _) in Fault::NAMES {
        assert!(page.contains(&format!("`{name}`")), "docs/faults.md does not tell of {name}");
    }
}
