use crate::kind::one_column::one_column;
use crate::samples::RowFormat;

one_column! {
    /// A file of estimates that any program has drawn: the first third of its rows, in drawing order, is stage 1, the rest stage 2,
    /// and all are judged.
    ///
    /// Target: the integral of the scene.
    /// Range:  as is declared.
    /// Cost:   not known.
    /// Needs:  `.npy`, `.csv`, `.txt` or `.f64`; float32 is judged with a tolerance of 6e-8.
    IntegralSamples,
    /// The column of estimates, by name or by number from 0 (default: the only one).
    RowFormat::estimate
}
