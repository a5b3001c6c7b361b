//! The special functions that turn statistics into p-values, exact to 1e-10 down to 1e-300.
