//! Variance against cost.

use super::{Figure, WIDTH, span};
use crate::draw::{Axis, Frame, Ink, Inset, Key, MARKS, Picture, SERIES, Stroke};
use crate::text::clean;
use freepath_results::Efficiency;

/// The cost of an estimator, and its efficiency.
pub(crate) struct Cost<'a> {
    pub(crate) name: String,
    pub(crate) efficiency: &'a Efficiency,
    /// Look-ups for one draw.
    pub(crate) lookups: f64,
    /// Seconds for one draw.
    pub(crate) seconds: Option<f64>,
}

impl Cost<'_> {
    /// 1 / (V T) with its limits, T in look-ups; nothing where no limits hold.
    pub(crate) fn per_lookup(&self) -> Option<(f64, f64, f64)> {
        self.over(self.lookups)
    }

    /// As [`Cost::per_lookup`], T in seconds.
    pub(crate) fn per_second(&self) -> Option<(f64, f64, f64)> {
        self.over(self.seconds?)
    }

    /// True if it has a place in a plane of positive numbers.
    fn is_placed(&self) -> bool {
        [self.lookups, self.efficiency.relative_variance.0].iter().all(|x| x.is_finite() && *x > 0.0)
    }

    fn over(&self, cost: f64) -> Option<(f64, f64, f64)> {
        let of = |variance: f64| 1.0 / (variance * cost);
        let e = self.efficiency;
        let all = (of(e.high?.0), of(e.relative_variance.0), of(e.low?.0));
        let usable = |x: f64| x.is_finite() && x > 0.0;
        (usable(all.0) && usable(all.1) && usable(all.2)).then_some(all)
    }
}

/// Every estimator with a variance and a cost, among lines of equal efficiency.
pub(crate) fn figure(costs: &[Cost], title: &str) -> Figure {
    let words = "Each marker is an estimator: cheaper to the left, quieter below. Along a grey line efficiency is the same; each \
                 line further down and left is ten times better. Hollow markers are not ranked."
        .into();
    Figure { name: "cost", picture: picture(costs, title), heading: "Variance against cost".into(), words }
}

/// The number of inks times that of markers: more would look alike.
const MOST: usize = 30;

fn picture(costs: &[Cost], title: &str) -> Picture {
    let shown: Vec<&Cost> = costs.iter().filter(|c| c.is_placed()).take(MOST).collect();
    let mut picture = Picture::new(WIDTH, 0.0, format!("{title}: relative variance against look-ups"));
    let keys: Vec<Key> = shown.iter().enumerate().map(|(i, c)| key(i, &clean(&c.name, 46))).collect();
    let rows = picture.legend_height(&keys, 12.0);
    picture.height = 310.0 + rows;
    let of = |value: fn(&Cost) -> f64| span(shown.iter().map(|c| value(c))).unwrap_or((1.0, 10.0));
    let (x, v) = (of(|c| c.lookups), of(|c| c.efficiency.relative_variance.0));
    let y = Axis::log("relative variance of one draw", v.0 / 3.0, v.1 * 3.0);
    let mut inset = Inset::around(&y);
    inset.top += picture.legend(&keys, 12.0, 11.0);
    let frame = picture.frame(Axis::log("look-ups per draw", x.0 / 2.0, x.1 * 2.0), y, inset);
    isolines(&mut picture, &frame);
    for (i, cost) in shown.iter().enumerate() {
        if let Some(at) = frame.point(cost.lookups, cost.efficiency.relative_variance.0) {
            picture.mark(at, MARKS[i % MARKS.len()], SERIES[i % SERIES.len()], !cost.efficiency.ranked);
        }
    }
    if shown.is_empty() {
        picture.note(&frame, "no estimator has a finite variance and cost");
    }
    picture
}

fn key(i: usize, name: &str) -> Key {
    Key::Mark(MARKS[i % MARKS.len()], SERIES[i % SERIES.len()], name.into())
}

/// Lines of equal variance times cost, one for each power of ten.
fn isolines(picture: &mut Picture, frame: &Frame) {
    let decade = |x: f64, y: f64| libm::log10(x) + libm::log10(y);
    let (least, most) = (decade(frame.x.lo, frame.y.lo), decade(frame.x.hi, frame.y.hi));
    let step = 1 + ((most - least) / 12.0) as i32;
    let mut n = libm::ceil(least) as i32;
    while f64::from(n) < most {
        let product = crate::number::ten(n);
        let from = (product / frame.y.hi).max(frame.x.lo);
        let to = (product / frame.y.lo).min(frame.x.hi);
        if let (Some(a), Some(b)) = (frame.point(from, product / from), frame.point(to, product / to)) {
            picture.line(vec![a, b], Stroke::new(Ink::Axis, 1.0));
        }
        n += step;
    }
}
