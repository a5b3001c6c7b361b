//! A grid of 4 x 5 x 6 voxels with unequal neighbours, seen along rays of every kind.

mod any_ray;
mod cells;
mod depth;
mod described;
mod rays;
mod refusals;
mod tiles;
mod values;
