/// One side of the rectangle in equal parts. A number belongs to the part whose edges, as they are rounded, hold it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side {
    ends: [f64; 2],
    parts: usize,
}

/// One of equal parts, and how far into it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Part {
    /// Its number, from 0 on.
    pub(super) index: usize,
    /// The share of its width before the number, in [0, 1].
    pub(super) within: f64,
}

impl Side {
    pub(super) fn new(ends: [f64; 2], parts: usize) -> Self {
        Self { ends, parts }
    }

    /// The part in which a number lies, if it lies on the side; its far end belongs to the last one.
    pub(super) fn part(self, number: f64) -> Option<Part> {
        let [from, to] = self.ends;
        if !(from <= number && number <= to) {
            return None;
        }
        let along = (number - from) / (to - from) * self.parts as f64;
        let near = if along < self.parts as f64 { along as usize } else { self.parts - 1 };
        let index = if number < self.edge(near) {
            near - 1
        } else if number >= self.edge(near + 1) && near + 1 < self.parts {
            near + 1
        } else {
            near
        };
        let within = along - index as f64;
        let within = if within < 1.0 { within } else { 1.0 };
        Some(Part { index, within: if within > 0.0 { within } else { 0.0 } })
    }

    /// The number so far into a part: never on its far edge, by rounding, where the next part begins.
    pub(super) fn place(self, Part { index, within }: Part) -> f64 {
        let place = self.at(index as f64 + within);
        let end = self.edge(index + 1);
        if place < end { place } else { end.next_down() }
    }

    fn edge(self, part: usize) -> f64 {
        self.at(part as f64)
    }

    fn at(self, along: f64) -> f64 {
        let [from, to] = self.ends;
        from + (to - from) * (along / self.parts as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_never_leaves_its_part_by_rounding() {
        for parts in [1, 3, 4, 7, 100_003] {
            for ends in [[0.0, 1.0], [-3.0, -1.0], [1e6, 1e6 + 1.0]] {
                let side = Side::new(ends, parts);
                for index in [0, parts / 3, parts / 2, parts - 1] {
                    for within in [0.0, f64::EPSILON, 0.5, 1.0 - 0.5 * f64::EPSILON, 1.0] {
                        let found = side.part(side.place(Part { index, within })).unwrap();
                        assert_eq!(found.index, index, "{parts} {ends:?} {within}");
                    }
                }
            }
        }
    }

    #[test]
    fn ends_belong_to_the_side_and_nothing_beyond() {
        let side = Side::new([0.0, 2.0], 3);
        assert_eq!(side.part(2.0).map(|part| part.index), Some(2));
        assert_eq!(side.part(0.0), Some(Part { index: 0, within: 0.0 }));
        assert!([-1e-300, 2.0_f64.next_up(), f64::NAN, f64::INFINITY].iter().all(|&x| side.part(x).is_none()));
    }
}
