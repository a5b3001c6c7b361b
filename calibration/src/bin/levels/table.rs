use crate::LEVELS;
use freepath_calibration::tail::Tail;

/// The measured levels of one test in one setting.
pub(crate) struct Row {
    /// As `freepath describe` takes it.
    pub(crate) test: &'static str,
    /// Of what draws.
    pub(crate) setting: String,
    /// True if the gate of the test lets it in: else the row shows why there is a gate.
    pub(crate) used: bool,
    /// Measured level over nominal level, and its standard error.
    pub(crate) ratios: Vec<(f64, f64)>,
}

/// Most times that a p-value may be too small.
const FACTOR: f64 = 2.0;

impl Row {
    /// `measure` gives the true level for each of [`LEVELS`], in parts that are disjoint.
    pub(crate) fn new(
        test: &'static str,
        setting: impl Into<String>,
        used: bool,
        measure: impl Fn(f64) -> Vec<Tail>,
    ) -> Self {
        let ratio = |&level: &f64| {
            let parts: Vec<_> = measure(level).iter().map(Tail::probability).collect();
            let sum: f64 = parts.iter().map(|(p, _)| p).sum();
            let variance: f64 = parts.iter().map(|(_, error)| error * error).sum();
            (sum / level, variance.sqrt() / level)
        };
        let row = Self { test, setting: setting.into(), used, ratios: LEVELS.iter().map(ratio).collect() };
        eprintln!("{}", row.line());
        row
    }

    /// Not used, or not too small by more than the factor and three standard errors; NaN is not kept.
    pub(crate) fn kept(&self) -> bool {
        !self.used || self.ratios.iter().all(|(ratio, error)| ratio - 3.0 * error <= FACTOR)
    }

    fn line(&self) -> String {
        let ratios: Vec<_> = self.ratios.iter().map(|(ratio, error)| format!("{ratio:.2} ± {error:.2}")).collect();
        let used = match (self.used, self.kept()) {
            (true, true) => "yes",
            (true, false) => "**BROKEN**",
            (false, _) => "no",
        };
        format!("| `{}` | {} | {used} | {} |", self.test, self.setting, ratios.join(" | "))
    }
}

/// The document.
pub(crate) fn print(rows: &[Row], replicates: &u64) {
    println!("{INTRODUCTION}");
    println!(
        "Made by\n\n```sh\ncargo run --release -p freepath-calibration --bin levels -- --replicates {replicates}\n```\n"
    );
    let levels: Vec<_> = LEVELS.iter().map(|level| format!("at {level:e}")).collect();
    println!("| test | setting | used | {} |\n|---|---|---|---:|---:|---:|", levels.join(" | "));
    rows.iter().for_each(|row| println!("{}", row.line()));
}

const INTRODUCTION: &str = "# The true levels of p-values

A run holds some 6,000 p-values, so that Holm reads them near 1e-7. A p-value from a limit law is not true there unless it is
shown to be. Each figure below is the measured probability of a p-value at or below a level, over that level: 1 is perfect, 2 is
twice as many false alarms as promised, 0 is a test that never rejects. The error is one standard error.

`used` says whether the gates of the harness let such draws in. Rows that are not used show what the gate keeps out. Most settings that
are used stand at the edge of their gate, where the level is worst. Gates of skewness and of variance look at the draws too: at their
edge they withhold many p-values, among them most of the small ones, and the figure falls below 1.

Far tails are measured by importance sampling with exact likelihood ratios: counts in cells with Dirichlet probabilities, so that
the statistic has its mean where the tail begins; draws of a law on finitely many points with mass leaning as exp(a y + b y^2) to
where the self-normalised mean first reaches the tail (Shao 1997); chains of draws with neighbours that attract or repel each
other; uniform draws with too many below one of many points. Binomial, Clopper-Pearson, Poisson and empirical Bernstein p-values are
exact or bounds, and are not here, nor is Berk-Jones (`berk_jones check` holds its table). Sums of squares lean towards one direction
each, drawn at random; the left tail of `too_even` is enumerated; tables of neighbours are chains with Dirichlet rows; tables of auxiliary numbers and of two samples have Dirichlet rows.
";
