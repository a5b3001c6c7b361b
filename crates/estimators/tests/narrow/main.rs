//! Media that are narrow somewhere: whatever is claimed by formula holds to the last digits, or says how far it may be off.

mod chromatic;
mod depth;
mod lookups;
mod ray_marching;
mod weights;
mod zoo;
