//! Planted faults: data laid over the majorants, the look-ups, the tables, the uniforms or the draws of any subject, so that no broken
//! estimator is ever shipped as one. `docs/faults.md` says where they were found.

use freepath_results::Reason;
use serde::{Deserialize, Serialize};

mod block_context;
mod cells;
mod channel_mixture;
mod channels;
mod draws;
mod faulty_medium;
mod faulty_rng;
mod faulty_words;
mod injection;
mod layer;
mod lookups;
mod majorants;
mod numbers;
mod overlay;
mod tables;
mod target;
mod uniforms;
mod walk;
mod walk_progress;

pub(crate) use block_context::BlockContext;
pub use channel_mixture::ChannelMixture;
pub(crate) use faulty_medium::FaultyMedium;
pub(crate) use faulty_rng::FaultyRng;
pub(crate) use faulty_words::FaultyWords;
pub(crate) use injection::Injection;
pub(crate) use layer::Layer;
pub(crate) use overlay::{Overlay, RayView, WalkContext};
pub(crate) use target::{ListedSampler, Target};

/// Names to types: an enum with one variant per file, seen as an [`Injection`]; the folder of the file is its layer.
macro_rules! faults {
    ($($layer:ident::$file:ident::$Type:ident: $words:literal,)*) => {
        $(pub use $layer::$file::$Type;)*

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

            /// The layer that the fault is laid over.
            pub(crate) fn layer(&self) -> Layer {
                match self { $(Self::$Type(_) => $layer::LAYER,)* }
            }

            /// Its injection.
            pub(crate) fn injection(&self) -> &dyn Injection {
                match self { $(Self::$Type(fault) => fault,)* }
            }
        }
    };
}

faults! {
    majorants::short_majorant::ShortMajorant: "the majorant is a factor of what it should be",
    majorants::loose_majorant::LooseMajorant: "the majorant is larger than it need be: only the cost is wrong",
    majorants::cell_majorant::CellMajorant: "the majorant of a cell comes from one place in it",
    majorants::coarse_majorant::CoarseMajorant: "the majorant is the greatest of a few look-ups",
    lookups::clamped_density::ClampedDensity: "the majorant is short and mu is clamped to it",
    lookups::shifted_lookup::ShiftedLookup: "every look-up is off by a distance, such as half a step",
    lookups::next_cell::NextCell: "cells carry the extinction of the next one",
    lookups::backward_cells::BackwardCells: "cells carry the extinction of the next one where the direction is negative",
    lookups::density_cutoff::DensityCutoff: "a small extinction is taken for none",
    lookups::density_floor::DensityFloor: "a small extinction is raised to a floor",
    lookups::missing_scale::MissingScale: "the sampler leaves out the scale of the medium",
    lookups::direction_length::DirectionLength: "the distance is multiplied by the direction's length, not divided",
    lookups::alternating_extinction::AlternatingExtinction: "blocks of draws see the extinction too large and too small in turn",
    lookups::shortened_segment::ShortenedSegment: "the ray ends a little early",
    lookups::uncut_segment::UncutSegment: "the last cell is not cut at the end of the ray",
    lookups::enhanced_cross_section::EnhancedCrossSection: "flights are shortened, and the weight does not make up for it",
    lookups::inverted_acceptance::InvertedAcceptance: "a collision is real where it should be null",
    lookups::flipped_residual::FlippedResidual: "residual tracking with the sign of mu - mu_c flipped",
    lookups::absolute_residual::AbsoluteResidual: "residual tracking with the absolute value of mu - mu_c",
    walk::stale_position::StalePosition: "the collision test uses mu at the position before the step",
    walk::local_step::LocalStep: "the step uses mu where the walk stands instead of the majorant",
    walk::restarted_walk::RestartedWalk: "after a null collision the walk is back at the start",
    uniforms::repeated_flight::RepeatedFlight: "the flight in each segment uses the same uniform",
    walk::leftover_depth::LeftoverDepth: "the optical depth left over is not reduced at a cell's end",
    walk::face_offset::FaceOffset: "behind each face the ray starts again a little further on",
    uniforms::even_uniforms::EvenUniforms: "the first uniforms of the walks lie evenly in strata",
    uniforms::shared_uniform::SharedUniform: "step and acceptance use the same uniform",
    uniforms::reused_start::ReusedStart: "every second draw starts with the number that the draw before it started with",
    uniforms::mirrored_batch::MirroredBatch: "a batch of draws, and then its mirror image",
    uniforms::closed_end::ClosedEnd: "the uniforms may be exactly 1, and the flight infinite",
    uniforms::zero_step::ZeroStep: "a step of exactly zero never ends",
    uniforms::wrong_wedge::WrongWedge: "exponentials from a ziggurat whose wedges use the neighbouring layer",
    walk::rounded_null::RoundedNull: "a null collision of probability 0 is chosen by rounding, and divides by it",
    walk::killing_ratio::KillingRatio: "ratio tracking that kills as well as weighs",
    walk::split_products::SplitProducts: "products of weights and of densities kept apart in single precision",
    walk::signed_roulette::SignedRoulette: "a roulette that kills every negative weight",
    draws::uncompensated_roulette::UncompensatedRoulette: "survivors of a roulette keep their weight",
    draws::window_weight::WindowWeight: "survivors of a roulette are set to a weight that was not scaled with the window",
    draws::truncated_weight::TruncatedWeight: "a small estimate is taken for none",
    draws::absorbed_twice::AbsorbedTwice: "absorption is in the flight and in the weight",
    channels::channel_pdf::ChannelPdf: "chromatic weights are divided by the pdf of one channel alone",
    channels::skewed_pdf::SkewedPdf: "the density of one channel is another in the weight than in the sampling",
    channels::sampled_depth::SampledDepth: "chromatic escapes are weighed at the sampled optical depth",
    channels::hero_nulls::HeroNulls: "null collisions by the sampling channel's probability alone",
    channels::exchanged_weights::ExchangedWeights: "the weights of a draw are handed to the next one of its bin",
    channels::dropped_channel::DroppedChannel: "a transparent channel is never drawn",
    tables::zero_weight_drawn::ZeroWeightDrawn: "a uniform of just a cumulative probability belongs to the category before it",
    tables::unnormalised_alias::UnnormalisedAlias: "the alias table is made of weights that were not divided by their sum",
    tables::broken_alias::BrokenAlias: "the pairing of an alias table ends at the first tie",
    tables::shifted_alias::ShiftedAlias: "aliases are off by one",
    tables::swapped_alias::SwappedAlias: "the alias of a cell is taken for its own category",
    tables::half_texel::HalfTexel: "the cells of a table lie half a cell further on",
    tables::conditional_of_neighbour_row::ConditionalOfNeighbourRow: "the cell is drawn from the conditional law of the next row",
    tables::forgotten_absorption::ForgottenAbsorption: "a walk scores where it ends and does not divide by the probability to end",
    tables::uncounted_start::UncountedStart: "the state where a walk starts is not counted",
    tables::uncounted_end::UncountedEnd: "the state where a walk ends is not counted",
    tables::row_for_column::RowForColumn: "walks go along the transposed matrix, their ends not exchanged",
    tables::stale_state::StaleState: "the state is not set to the new one, and a walk never moves",
    tables::unnormalised_rows::UnnormalisedRows: "rows are scaled to one sum and walks ended by one probability, without a weight",
    numbers::low_envelope::LowEnvelope: "the envelope of a rejection is lower than it should be",
    numbers::reused_uniform::ReusedUniform: "the second uniform of a draw is the first one once more",
    draws::same_seed::SameSeed: "workers share a seed",
    draws::leaked_record::LeakedRecord: "the record of a draw that ended with weight 0 leaks into the next",
    draws::nan_draw::NanDraw: "one walk of so many gives NaN",
    draws::duplicated_draws::DuplicatedDraws: "now and then a draw repeats the one before it",
    draws::copied_batch::CopiedBatch: "a batch of draws is handed out again and again",
    draws::cold_start::ColdStart: "the first draws of a start find the ray empty",
    draws::hot_spot::HotSpot: "one draw of so many lands in one narrow bin",
    draws::bin_centre::BinCentre: "a collision is put at the middle of its bin",
    draws::completion_order::CompletionOrder: "draws are handed out in the order in which walks end",
    uniforms::mirrored_uniforms::MirroredUniforms: "harmless: -ln(u) in place of -ln(1 - u), u in (0, 1]",
    draws::compensated_roulette::CompensatedRoulette: "harmless: a roulette whose survivors are raised",
}

/// The verdict that a case expects of a subject.
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
