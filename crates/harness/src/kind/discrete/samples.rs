use crate::kind::one_column::one_column;

one_column! {
    /// A file of categories, numbered from 0, that any program has drawn: the first third of its rows, in drawing order, is stage 1, the rest stage 2, and
    /// all are judged.
    ///
    /// Target: the table of the scene.
    /// Range:  the categories that have a weight.
    /// Cost:   not known.
    /// Needs:  `.npy`, `.csv`, `.txt` or `.f64`.
    DiscreteSamples,
    /// The column of categories, by name or by number from 0 (default: the only one).
    super::rows
}
