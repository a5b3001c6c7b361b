/// Tables that a program makes of the values of a grid, once, before it draws: cumulative probabilities, and where the cells lie.
#[derive(Clone, Debug, PartialEq)]
pub struct GridTables {
    /// The probability of each row and of those before it.
    pub rows: Vec<f64>,
    /// The probability of each cell and of those before it in its row, row by row; of a row without mass all 0.
    pub cells: Vec<f64>,
    /// The place where the first cell of a row begins, and where its last one ends.
    pub x: [f64; 2],
    /// The place where the first row begins, and where the last one ends.
    pub y: [f64; 2],
}
