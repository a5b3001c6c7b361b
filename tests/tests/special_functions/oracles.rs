//! Every row of every oracle file.

use crate::same;
use freepath_statistics::special::*;

/// The rows of an oracle file, without its comments and its header.
fn rows(csv: &'static str) -> impl Iterator<Item = Vec<&'static str>> {
    let lines = csv.lines().filter(|line| !line.starts_with('#'));
    lines.skip(1).map(|line| line.split(',').collect())
}

fn number(field: &str) -> f64 {
    field.parse().unwrap()
}

fn count(field: &str) -> u64 {
    field.parse().unwrap()
}

/// The errors over one file, to be judged together so that a failure lists every row that is off.
struct Check {
    file: &'static str,
    worst: (f64, String),
    rows: usize,
    off: Vec<String>,
}

impl Check {
    fn new(file: &'static str) -> Self {
        Self { file, worst: (0.0, String::from("none")), rows: 0, off: Vec::new() }
    }

    fn row(&mut self, what: &str, got: f64, wanted: f64, tolerance: f64) {
        // The oracles hold no zero but the limits of Clopper-Pearson, which have to be hit; a NaN is the worst error.
        let error = if same(got, wanted) { 0.0 } else { (got / wanted - 1.0).abs() };
        let error = if error.is_nan() { f64::INFINITY } else { error };
        self.rows += 1;
        if error > tolerance {
            self.off.push(format!("{what}: {got:e}, not {wanted:e} (relative error {error:.1e})"));
        }
        if error > self.worst.0 {
            self.worst = (error, what.to_owned());
        }
    }

    /// Fails if a row was off, or if not all rows came by.
    fn judge(self, rows: usize) {
        let Self { file, worst: (error, at), off, .. } = self;
        println!("{file}: {} values, worst error {error:.1e} at {at}", self.rows);
        assert!(off.is_empty(), "{} values of {file} are off:\n{}", off.len(), off.join("\n"));
        assert_eq!(self.rows, rows, "{file} has another number of values");
    }
}

#[test]
fn chi_square_meets_its_oracle() {
    let mut check = Check::new("chi2_sf.csv");
    for row in rows(include_str!("../../oracles/chi2_sf.csv")) {
        let got = chi_square_sf(number(row[0]), number(row[1]));
        check.row(&format!("dof {} x {}", row[0], row[1]), got, number(row[2]), 1e-10);
    }
    check.judge(225);
}

#[test]
fn normal_meets_its_oracle() {
    let mut check = Check::new("normal_sf.csv");
    for row in rows(include_str!("../../oracles/normal_sf.csv")) {
        let (z, p) = (number(row[0]), number(row[1]));
        check.row(&format!("z {z}"), normal_sf(z), p, 1e-10);
        check.row(&format!("two-sided z {z}"), normal_two_sided(-z), 2.0 * p, 1e-10);
        check.row(&format!("quantile {p}"), normal_quantile(p), z, 1e-10);
    }
    check.judge(129);
}

#[test]
fn student_t_meets_its_oracle() {
    let mut check = Check::new("student_t_sf.csv");
    for row in rows(include_str!("../../oracles/student_t_sf.csv")) {
        let (dof, t, p) = (number(row[0]), number(row[1]), number(row[2]));
        check.row(&format!("dof {dof} t {t}"), student_t_sf(dof, t), p, 1e-10);
        check.row(&format!("dof {dof} t -{t}"), student_t_sf(dof, -t), 1.0 - p, 1e-10);
        check.row(&format!("two-sided dof {dof} t {t}"), student_t_two_sided(dof, -t), 2.0 * p, 1e-10);
    }
    check.judge(462);
}

#[test]
fn binomial_meets_its_oracle() {
    let mut check = Check::new("binomial_tails.csv");
    for row in rows(include_str!("../../oracles/binomial_tails.csv")) {
        let (n, p, k) = (count(row[0]), number(row[1]), count(row[2]));
        let at = |side| format!("{side} n {n} p {p} k {k}");
        check.row(&at("P_le"), binomial_cdf(n, p, k), number(row[3]), 1e-10);
        check.row(&at("P_ge"), binomial_sf(n, p, k), number(row[4]), 1e-10);
        check.row(&at("two-sided"), binomial_two_sided(n, p, k), number(row[5]), 1e-10);
    }
    check.judge(831);
}

#[test]
fn clopper_pearson_meets_its_oracle() {
    let mut check = Check::new("clopper_pearson.csv");
    for row in rows(include_str!("../../oracles/clopper_pearson.csv")) {
        let (n, k, alpha) = (count(row[0]), count(row[1]), number(row[2]));
        let (lower, upper) = clopper_pearson(n, k, alpha);
        check.row(&format!("lower n {n} k {k} alpha {alpha}"), lower, number(row[3]), 1e-10);
        check.row(&format!("upper n {n} k {k} alpha {alpha}"), upper, number(row[4]), 1e-10);
    }
    check.judge(366);
}

#[test]
fn kolmogorov_smirnov_meets_its_oracle() {
    let mut exact = Check::new("ks_two_sided.csv, exact");
    let mut scipy = Check::new("ks_two_sided.csv, scipy");
    let mut smirnov = Check::new("ks_two_sided.csv, smirnov");
    for row in rows(include_str!("../../oracles/ks_two_sided.csv")) {
        let got = ks_two_sided(count(row[0]), number(row[1]));
        let (check, tolerance) = match row[3] {
            "exact" => (&mut exact, 1e-10),
            "smirnov" => (&mut smirnov, 1e-10),
            _ => (&mut scipy, 1e-4),
        };
        check.row(&format!("n {} d {}", row[0], row[1]), got, number(row[2]), tolerance);
    }
    exact.judge(127);
    smirnov.judge(6);
    scipy.judge(59);
}

#[test]
fn anderson_darling_meets_its_oracle() {
    let mut check = Check::new("ad_limit_sf.csv");
    for row in rows(include_str!("../../oracles/ad_limit_sf.csv")) {
        check.row(&format!("z {}", row[0]), anderson_darling_sf(number(row[0])), number(row[1]), 1e-10);
    }
    check.judge(21);
}

#[test]
fn cramer_von_mises_meets_its_oracle() {
    let mut check = Check::new("cvm_limit_sf.csv");
    for row in rows(include_str!("../../oracles/cvm_limit_sf.csv")) {
        check.row(&format!("z {}", row[0]), cramer_von_mises_limit_sf(number(row[0])), number(row[1]), 1e-10);
    }
    check.judge(20);
}

/// The same approximation as scipy's, to scipy's digits.
#[test]
fn cramer_von_mises_of_few_draws_meets_its_oracle() {
    let mut check = Check::new("cvm_finite_n_sf.csv");
    for row in rows(include_str!("../../oracles/cvm_finite_n_sf.csv")) {
        let got = cramer_von_mises_sf(count(row[0]), number(row[1]));
        check.row(&format!("n {} z {}", row[0], row[1]), got, number(row[2]), 1e-10);
    }
    check.judge(30);
}
