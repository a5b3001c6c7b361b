//! The binary from outside: what it takes, what it prints, what it writes, and its exit codes.

mod agree;
mod input;
mod medium;
mod output;
mod power;
mod reference;
mod samples;
mod signals;
mod soak;
mod support;
mod table;
