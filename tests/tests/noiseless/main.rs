//! Faults that statistics cannot see: scripted generators and identities catch mutants, and leave right subjects alone.

mod identities;
mod rays;
mod scripted;
mod shipped;
mod state;
mod subject;
mod truth;
