use super::record::Test;
use super::{
    agree, along, anderson_darling, atom, auxiliary, batch_shares, batches, berk_jones, bounded_mean, breaks,
    chi_square, coleman, count_law, cramer_von_mises, exposure, growth, kolmogorov, kuiper, lag, lookups, mean,
    neyman, null_positions, order, pairs, pairs_far, pdf_integral, period, poisson_count, rare_lags, scan,
    second_moment, series, ties, too_even, triples, weighted, whole_law,
};

/// Every test, in the order in which they are told.
pub const TESTS: &[Test] = &[
    atom::TEST,
    chi_square::TESTS[0],
    chi_square::TESTS[1],
    chi_square::TESTS[2],
    kolmogorov::TEST,
    exposure::TEST,
    neyman::TEST,
    anderson_darling::TEST,
    cramer_von_mises::TEST,
    kuiper::TEST,
    whole_law::TEST,
    scan::TEST,
    breaks::TEST,
    too_even::TEST,
    berk_jones::TEST,
    coleman::TEST,
    poisson_count::TEST,
    count_law::TEST,
    ties::TEST,
    lag::TEST,
    lag::FURTHER,
    pairs::TEST,
    order::TEST,
    rare_lags::TEST,
    period::TEST,
    pairs_far::TEST,
    triples::TEST,
    batches::TEST,
    along::TEST,
    along::ESCAPES,
    null_positions::TEST,
    series::TEST,
    auxiliary::TEST,
    batch_shares::TEST,
    mean::TEST,
    bounded_mean::TEST,
    weighted::TESTS[0],
    weighted::TESTS[1],
    growth::TEST,
    second_moment::TEST,
    lookups::TEST,
    agree::TESTS[0],
    agree::TESTS[1],
    agree::TESTS[2],
    agree::TESTS[3],
    agree::TESTS[4],
    pdf_integral::TEST,
];

#[cfg(test)]
mod tests {
    use super::TESTS;
    use std::fs;
    use std::path::Path;

    #[test]
    fn every_file_of_a_test_has_its_records_in_the_list() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/hypothesis");
        let mut missing = Vec::new();
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let module = path.file_stem().unwrap().to_string_lossy().into_owned();
            let text = fs::read_to_string(path.with_extension("rs")).unwrap();
            let own = text.split("#[cfg(test)]").next().unwrap_or_default();
            let tests = own.contains("\npub fn ") && own.contains("-> Evidence");
            let name = TESTS.iter().any(|test| own.contains(&format!("\"{}\"", test.name)));
            if tests && !name {
                missing.push(format!("hypothesis/{module}.rs has no TEST in hypothesis/list.rs"));
            }
        }
        assert!(missing.is_empty(), "{missing:?}");
    }

    #[test]
    fn every_record_is_whole_and_of_one_test() {
        let missing = TESTS.iter().flat_map(|test| {
            let twice = TESTS.iter().filter(|other| other.name == test.name).count() != 1;
            let words = test.words.is_empty() || test.details.is_empty();
            let faults =
                [(twice, "a name of its own"), (words, "words and details"), (test.nulls.is_empty(), "nulls")];
            faults.into_iter().filter(|(fault, _)| *fault).map(|(_, what)| format!("{} lacks {what}", test.name))
        });
        assert_eq!(missing.collect::<Vec<_>>(), [] as [String; 0]);
    }

    #[test]
    fn every_section_stands_in_the_page() {
        let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/statistics.md");
        let page = fs::read_to_string(page).unwrap();
        let anchor = |heading: &str| heading.replace(['`', ','], "").replace(' ', "-");
        let sections: Vec<_> = page.lines().filter_map(|line| line.strip_prefix("### ")).map(anchor).collect();
        let missing: Vec<_> =
            TESTS.iter().filter(|test| !sections.iter().any(|one| one == test.section)).collect();
        assert!(missing.is_empty(), "no section of {missing:?}");
    }
}
