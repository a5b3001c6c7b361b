use super::*;

#[test]
fn a_handful_of_draws_is_no_pass() {
    let folder = folder("few");
    for n in [1, 2, 3, 2997] {
        put_f64(&folder, "t.f64", &paths(11, n, 1.0));
        let few = judged(&folder, CONSTANT, FREE_PATH);
        assert_eq!((few.verdict, few.reasons), (Verdict::Inconclusive, vec![Reason::NotEnoughDraws]), "{n}");
    }
    put_f64(&folder, "t.f64", &paths(11, 2998, 1.0));
    assert_eq!(judged(&folder, CONSTANT, FREE_PATH).verdict, Verdict::Pass);
}

#[test]
fn tests_keep_their_level_at_any_number_of_rows() {
    let folder = folder("level");
    for rows in [30, 4_000, 40_000] {
        let mut all: std::collections::BTreeMap<String, Vec<f64>> = std::collections::BTreeMap::new();
        for seed in 0..150 {
            put_f64(&folder, "t.f64", &paths(seed, rows, 1.0));
            for test in judged(&folder, CONSTANT, FREE_PATH).tests {
                all.entry(test.name).or_default().extend(test.p.map(|p| p.0));
            }
        }
        assert!(all.values().any(|p| p.len() == 300), "both stages are tested");
        for (name, p) in all {
            for level in [0.01, 0.1, 0.5] {
                let below = p.iter().filter(|p| !(**p > level)).count() as u64;
                let chance = binomial_sf(p.len() as u64, level, below);
                assert!(chance > 1e-6, "{name} of {rows} rows: {below} of {} p-values below {level}", p.len());
            }
        }
    }
}

#[test]
fn results_have_the_same_bytes_for_any_number_of_threads() {
    let folder = folder("threads");
    put_f64(&folder, "t.f64", &paths(12, 1_000_003, 1.0));
    let rows: String = paths(13, 150_001, 1.0).iter().map(|t| format!("{t:e} {:e}\n", t * 0.7)).collect();
    put(&folder, "w.txt", rows.as_bytes());
    let subjects = format!(
        r#"{FREE_PATH}, {{ "transmittance": {{ "samples": {{ "file": "t.f64" }} }} }},
        {{ "free_path": {{ "samples": {{ "file": "w.txt", "column": "0", "weight": "1" }} }} }}"#
    );
    let bytes = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        let cases = prepared(&folder, CONSTANT, &subjects);
        pool.install(|| serde_json::to_string(&results(&cases, 1)).expect("results are JSON"))
    };
    let one = bytes(1);
    for threads in [2, 3, 7] {
        assert!(bytes(threads) == one, "{threads} threads give other bytes");
    }
}

#[test]
fn a_source_that_breaks_off_is_a_subject_error() {
    let folder = folder("breaks");
    put_f64(&folder, "t.f64", &paths(14, 100_000, 1.0));
    let cases = prepared(&folder, CONSTANT, FREE_PATH);
    put_f64(&folder, "t.f64", &paths(14, 20_000, 1.0));
    let broken = results(&cases, 1).results.remove(0);
    assert_eq!((broken.verdict, broken.reasons), (Verdict::Fail, vec![Reason::SubjectError]));
    assert!(broken.notes[0].contains("it ends after 20000 of 100000 draws"), "{:?}", broken.notes);
}
