//! Path data and texts, in as few characters as it takes: whole units, relative, with nothing between what cannot be misread.

use std::fmt::Write;

/// Units of an SVG for a pixel of a picture: finer than any screen shows.
pub(super) const UNITS: f64 = 4.0;

/// A place in whole units.
pub(super) type Place = (i32, i32);

/// A length or coordinate of a picture in whole units; what lies far outside is held near the picture.
pub(super) fn units(v: f64) -> i32 {
    libm::round((v * UNITS).clamp(-1e4, 1e5)) as i32
}

/// Writes the `d` of a path, or the texts of a group.
#[derive(Default)]
pub(super) struct Pen {
    data: String,
    at: Place,
    /// The beginning of the subpath.
    begin: Place,
    /// The command that further numbers would belong to.
    command: char,
}

impl Pen {
    /// Starts a subpath.
    pub(super) fn start(&mut self, at: Place) {
        self.write('m', &[at.0 - self.at.0, at.1 - self.at.1]);
        self.command = ' '; // further numbers would be a line
        (self.at, self.begin) = (at, at);
    }

    /// A straight line.
    pub(super) fn to(&mut self, (x, y): Place) {
        let by = (x - self.at.0, y - self.at.1);
        match by {
            (0, 0) => return,
            (dx, 0) => self.write('h', &[dx]),
            (0, dy) => self.write('v', &[dy]),
            (dx, dy) => self.write('l', &[dx, dy]),
        }
        self.at = (x, y);
    }

    /// Straight lines through `places`.
    pub(super) fn polyline(&mut self, places: &[Place]) {
        if let [first, rest @ ..] = places {
            self.start(*first);
            rest.iter().for_each(|&place| self.to(place));
        }
    }

    /// The shape between `corners`.
    pub(super) fn polygon(&mut self, corners: &[Place]) {
        self.polyline(corners);
        self.close();
    }

    /// A circle, the way around in which the corners of other markers follow.
    pub(super) fn circle(&mut self, (x, y): Place, r: i32) {
        self.start((x - r, y));
        self.write('a', &[r, r, 0, 0, 1, 2 * r, 0]);
        self.write('a', &[r, r, 0, 0, 1, -2 * r, 0]);
        self.close();
    }

    fn close(&mut self) {
        self.write('z', &[]);
        self.at = self.begin;
    }

    /// A text, of which nothing is markup; the place is where its base line is anchored.
    pub(super) fn text(&mut self, (x, y): Place, text: &str) {
        let _ = write!(self.data, "<text x=\"{x}\" y=\"{y}\">{text}</text>"); // a string takes everything
    }

    /// The commands written.
    pub(super) fn data(self) -> String {
        self.data
    }

    fn write(&mut self, command: char, numbers: &[i32]) {
        let mut apart = command == self.command;
        if !apart {
            self.data.push(command);
            self.command = command;
        }
        for n in numbers {
            if apart && *n >= 0 {
                self.data.push(' ');
            }
            let _ = write!(self.data, "{n}"); // a string takes everything
            apart = true;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_short_and_whole() {
        let mut pen = Pen::default();
        pen.polyline(&[(10, 20), (13, 16), (15, 26), (15, 26), (15, 30), (9, 30), (3, 30)]);
        pen.polygon(&[(0, 0), (4, 0), (4, 4)]);
        pen.polygon(&[(5, 0), (9, 0), (9, 4)]);
        assert_eq!(pen.data(), "m10 20l3-4 2 10v4h-6-6m-3-30h4v4zm5 0h4v4z");
        let mut pen = Pen::default();
        pen.circle((10, 10), 4);
        assert_eq!(pen.data(), "m6 10a4 4 0 0 1 8 0 4 4 0 0 1-8 0z");
        assert_eq!([units(1.13), units(f64::INFINITY), units(-1e9)], [5, 100_000, -10_000]);
    }
}
