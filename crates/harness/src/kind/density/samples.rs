use crate::kind::one_column::one_column;

one_column! {
    /// A file of numbers that any program has drawn: the first third of its rows, in drawing order, is stage 1, the rest stage 2, and
    /// all are judged.
    ///
    /// Target: the law of the scene.
    /// Range:  its domain.
    /// Cost:   not known.
    /// Needs:  `.npy`, `.csv`, `.txt` or `.f64`; float32 is judged with a tolerance of 6e-8.
    DensitySamples,
    /// The column of numbers, by name or by number from 0 (default: the only one).
    super::rows
}
