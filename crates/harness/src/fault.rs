//! Planted faults: data laid over the majorants, the look-ups, the uniforms or the draws of any subject, so that no broken
//! estimator is ever shipped as one. `docs/faults.md` says where they were found.

use freepath_results::Reason;
use serde::{Deserialize, Serialize};

mod cells;
mod faulty;
mod overlay;
mod place;
mod plant;
mod target;
mod uniforms;

pub use faulty::Faulty;
pub use overlay::{Overlay, Shape, Site};
pub use place::BlockPlace;
pub use plant::{Layer, Plant};
pub use target::Target;
pub use uniforms::Wrapped;

/// Names to types: an enum with one variant per file, seen as [`Plant`].
macro_rules! faults {
    ($($file:ident::$Type:ident: $words:literal,)*) => {
        $(mod $file; pub use $file::$Type;)*

        /// A planted fault that a case can name.
        #[derive(Clone, Debug, PartialEq, Deserialize, Serialize, schemars::JsonSchema)]
        #[serde(rename_all = "snake_case")]
        pub enum Fault {
            $(
                #[doc = concat!("See [`", stringify!($Type), "`].")]
                // The schema refers to the type, whose own words are the ones to show.
                #[schemars(description = "")]
                $Type($Type),
            )*
        }

        impl Fault {
            /// The names that a case may use, and what they do.
            pub const NAMES: &[(&str, &str)] = &[$((stringify!($file), $words),)*];

            /// The fault's name in a case.
            #[must_use]
            pub fn name(&self) -> &'static str {
                match self { $(Self::$Type(_) => stringify!($file),)* }
            }
        }

        impl std::ops::Deref for Fault {
            type Target = dyn Plant;
            fn deref(&self) -> &(dyn Plant + 'static) {
                match self { $(Self::$Type(fault) => fault,)* }
            }
        }
    };
}

faults! {
    short_majorant::ShortMajorant: "the majorant is a factor of what it should be",
    loose_majorant::LooseMajorant: "the majorant is larger than it need be: only the cost is wrong",
    cell_majorant::CellMajorant: "the majorant of a cell comes from one place in it",
    coarse_majorant::CoarseMajorant: "the majorant is the greatest of a few look-ups",
    clamped_density::ClampedDensity: "the majorant is short and mu is clamped to it",
    shifted_lookup::ShiftedLookup: "every look-up is off by a distance, such as half a step",
    next_cell::NextCell: "cells carry the extinction of the next one",
    backward_cells::BackwardCells: "cells carry the extinction of the next one where the direction is negative",
    density_cutoff::DensityCutoff: "a small extinction is taken for none",
    density_floor::DensityFloor: "a small extinction is raised to a floor",
    missing_scale::MissingScale: "the sampler leaves out the scale of the medium",
    direction_length::DirectionLength: "the distance is multiplied by the direction's length, not divided",
    shortened_segment::ShortenedSegment: "the ray ends a little early",
    uncut_segment::UncutSegment: "the last cell is not cut at the end of the ray",
    enhanced_cross_section::EnhancedCrossSection: "flights are shortened, and the weight does not make up for it",
    inverted_acceptance::InvertedAcceptance: "a collision is real where it should be null",
    flipped_residual::FlippedResidual: "residual tracking with the sign of mu - mu_c flipped",
    absolute_residual::AbsoluteResidual: "residual tracking with the absolute value of mu - mu_c",
    stale_position::StalePosition: "the collision test uses mu at the position before the step",
    local_step::LocalStep: "the step uses mu where the walk stands instead of the majorant",
    restarted_walk::RestartedWalk: "after a null collision the walk is back at the start",
    repeated_flight::RepeatedFlight: "the flight in each segment uses the same uniform",
    leftover_depth::LeftoverDepth: "the optical depth left over is not reduced at a cell's end",
    shared_uniform::SharedUniform: "step and acceptance use the same uniform",
    reused_start::ReusedStart: "every second draw starts with the number that the draw before it started with",
    closed_end::ClosedEnd: "the uniforms may be exactly 1, and the flight infinite",
    zero_step::ZeroStep: "a step of exactly zero never ends",
    wrong_wedge::WrongWedge: "exponentials from a ziggurat whose wedges use the neighbouring layer",
    rounded_null::RoundedNull: "a null collision of probability 0 is chosen by rounding, and divides by it",
    killing_ratio::KillingRatio: "ratio tracking that kills as well as weighs",
    split_products::SplitProducts: "products of weights and of densities kept apart in single precision",
    signed_roulette::SignedRoulette: "a roulette that kills every negative weight",
    uncompensated_roulette::UncompensatedRoulette: "survivors of a roulette keep their weight",
    window_weight::WindowWeight: "survivors of a roulette are set to a weight that was not scaled with the window",
    truncated_weight::TruncatedWeight: "a small estimate is taken for none",
    absorbed_twice::AbsorbedTwice: "absorption is in the flight and in the weight",
    channel_pdf::ChannelPdf: "chromatic weights are divided by the pdf of one channel alone",
    skewed_pdf::SkewedPdf: "the density of one channel is another in the weight than in the sampling",
    sampled_depth::SampledDepth: "chromatic escapes are weighed at the sampled optical depth",
    hero_nulls::HeroNulls: "null collisions by the sampling channel's probability alone",
    dropped_channel::DroppedChannel: "a transparent channel is never drawn",
    same_seed::SameSeed: "workers share a seed",
    leaked_record::LeakedRecord: "the record of a draw that ended with weight 0 leaks into the next",
    nan_draw::NanDraw: "one walk of so many gives NaN",
    duplicated_draws::DuplicatedDraws: "now and then a draw repeats the one before it",
    completion_order::CompletionOrder: "draws are handed out in the order in which walks end",
    mirrored_uniforms::MirroredUniforms: "harmless: -ln(u) in place of -ln(1 - u), u in (0, 1]",
    compensated_roulette::CompensatedRoulette: "harmless: a roulette whose survivors are raised",
}

/// What a case expects of a subject.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Expectation {
    /// A pass.
    Pass,
    /// A failure with this reason among those found.
    Fail(Reason),
    /// An inconclusive verdict with this reason among those found.
    Inconclusive(Reason),
}

#[cfg(test)]
mod tests;
