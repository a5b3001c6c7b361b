use super::quantiles::{LEVELS, ROWS};

/// P(R >= x) by the table, and whether x lies within it: beyond its last column p is that column's.
pub(super) fn sf(m: f64, x: f64) -> (f64, bool) {
    let quantiles = quantiles(m);
    let Some(above) = quantiles.iter().position(|&quantile| x < quantile) else {
        return (LEVELS[LEVELS.len() - 1], false);
    };
    if above == 0 {
        return (1.0, true);
    }
    let (left, right) = (quantiles[above - 1], quantiles[above]);
    let part = (x - left) / (right - left);
    let (high, low) = (libm::log(LEVELS[above - 1]), libm::log(LEVELS[above]));
    (libm::exp(high + part * (low - high)), true)
}

/// The row for `m`, between two rows in proportion to ln m; beyond the rows the nearest.
fn quantiles(m: f64) -> [f64; LEVELS.len()] {
    let Some(above) = ROWS.iter().position(|row| m < row.0) else {
        return ROWS[ROWS.len() - 1].1;
    };
    if above == 0 {
        return ROWS[0].1;
    }
    let (less, more) = (&ROWS[above - 1], &ROWS[above]);
    let part = libm::log(m / less.0) / libm::log(more.0 / less.0);
    std::array::from_fn(|i| less.1[i] + part * (more.1[i] - less.1[i]))
}
