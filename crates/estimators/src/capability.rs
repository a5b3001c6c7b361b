//! Capabilities of a sampler, as far as a planted fault must lay hold of it.

use crate::control::Control;

/// One thing that a sampler does inside. A fault needs some of them, and is refused over a sampler that does not state them.
///
/// A uniform counts from the last look-up of mu, or from the start of the walk: where the words say *first*, a sampler draws
/// nothing between that look-up and this uniform.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Capability {
    /// Looks mu up along one ray: a look-up that is answered wrongly changes its law.
    LookUps,
    /// Steps under the majorants: one that is wrong changes its law or its cost.
    Majorants,
    /// Takes an optical depth, -ln(1 - u), from the first uniform, and flies that far.
    Flights,
    /// Makes tentative collisions at the rate of the majorant: each flight is -ln(1 - u) / mu_bar, u the first uniform.
    TentativeCollisions,
    /// Draws a fresh flight in each segment of the majorant that it enters ([`Form::Restart`](crate::woodcock::Form)).
    FreshFlights,
    /// Accepts a tentative collision if u < mu / mu_bar, u the second uniform, and ends there; mu is looked up after it.
    Acceptance,
    /// Analog: an escape weighs 1, and nothing is weighed on the way.
    Analog,
    /// Weighs by the product of 1 - mu / mu_bar over its tentative collisions, and by nothing else.
    RatioWeight,
    /// Weighs by the product of 1 - (mu - control) / rate over its tentative collisions, this being the control.
    Residual(Control),
    /// Spends an optical depth cell by cell, each of the extinction that one look-up in it gives.
    ConstantCells,
    /// Counts its tentative collisions in the column `collisions` of its blocks.
    Collisions,
    /// Divides its weights by the density of the channel that was drawn, alone.
    ChannelDensity,
    /// Weighs by the densities of all channels (multiple importance sampling), and tells their mixture as its pdf.
    ChannelMixture,
    /// Divides its weights by the density of the mixture of all channels (the balance heuristic).
    BalanceHeuristic,
    /// Inverts a table of cumulative probabilities: the first entry above the uniform is the category.
    CumulativeTable,
    /// Picks a cell of an alias table, and in it the category or its alias.
    AliasTable,
    /// Accepts a trial if the second of two uniforms, times an envelope, is below the density at the first; nothing else is drawn.
    Envelope,
    /// Inverts the cumulative table of the rows of a grid, and then that of the cells in the row.
    ConditionalTable,
    /// Walks over states by the tables of the system, from the detector or from the source.
    WalkTables,
    /// Scores a source over the probability to end where a walk ends.
    EndScore,
    /// Scores a source in every state that a walk visits.
    VisitScore,
}

impl Capability {
    /// The words for having it: *samplers that* ..
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Self::LookUps => "look one extinction up",
            Self::Majorants => "step under majorants",
            Self::Flights => "take an optical depth from the first uniform",
            Self::TentativeCollisions => "make tentative collisions at the rate of the majorant",
            Self::FreshFlights => "draw a fresh flight in each segment",
            Self::Acceptance => "accept a tentative collision with probability mu / mu_bar",
            Self::Analog => "are analog",
            Self::RatioWeight => "weigh by the product of 1 - mu / mu_bar",
            Self::Residual(_) => "weigh by a residual, mu less its control",
            Self::ConstantCells => "spend an optical depth in cells of constant extinction",
            Self::Collisions => "count their tentative collisions",
            Self::ChannelDensity => "divide by the density of the channel that was drawn",
            Self::ChannelMixture => "weigh by the densities of all channels",
            Self::CumulativeTable => "invert a cumulative table",
            Self::AliasTable => "keep an alias table",
            Self::Envelope => "reject under an envelope",
            Self::ConditionalTable => "invert the tables of rows and of cells",
            Self::WalkTables => "walk by the coefficients of a system",
            Self::EndScore => "score where a walk ends",
            Self::VisitScore => "score in every state that a walk visits",
            Self::BalanceHeuristic => "divide by the density of the mixture of channels",
        }
    }

    /// True if it is the same thing as `other`, with whatever parameters.
    #[must_use]
    pub fn is_like(self, other: Self) -> bool {
        std::mem::discriminant(&self) == std::mem::discriminant(&other)
    }
}

/// Capabilities of delta tracking, whose uniforms are those of flight and acceptance in turn.
pub const DELTA_TRACKING: &[Capability] = &[
    Capability::LookUps,
    Capability::Majorants,
    Capability::Flights,
    Capability::TentativeCollisions,
    Capability::Acceptance,
    Capability::Analog,
];

/// Capabilities of ratio tracking, whose uniforms are those of flights.
pub const RATIO_TRACKING: &[Capability] = &[
    Capability::LookUps,
    Capability::Majorants,
    Capability::Flights,
    Capability::TentativeCollisions,
    Capability::RatioWeight,
];
