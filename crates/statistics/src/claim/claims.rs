use super::{Asked, Claim, Comparable, Contender, Design, Finding, SequentialTest, Summary, Withdrawal};
use crate::detection::Detection;
use crate::evidence::Fact;
use crate::fold::{Folds, ProbableEscape, Tallies};
use crate::judged::Judged;
use freepath_draws::Draws;

/// The claims that stand, and the folds that they read.
#[derive(Default)]
pub struct Claims<'a> {
    /// The folds that tally the draws.
    pub folds: Folds,
    list: Vec<Box<dyn Claim + 'a>>,
}

impl<'a> Claims<'a> {
    /// Adds a claim, behind those that stand: their order is that of the tests in the results.
    pub fn push(&mut self, claim: impl Claim + 'a) {
        self.list.push(Box::new(claim));
    }

    /// Those that stand after some are withdrawn.
    #[must_use]
    pub fn without(mut self, withdrawn: &[Withdrawal]) -> Self {
        self.list.retain(|claim| !claim.withdrawn_by().iter().any(|one| withdrawn.contains(one)));
        self
    }

    /// The claims in their order.
    pub fn iter(&self) -> impl Iterator<Item = &(dyn Claim + 'a)> {
        self.list.iter().map(|claim| &**claim)
    }

    /// Puts every claim to its tests.
    #[must_use]
    pub fn judge(&self, tallies: &Tallies) -> Judged {
        let mut judged = Judged::default();
        self.iter().for_each(|claim| claim.judge(tallies, &mut judged));
        match self.precluded(tallies) {
            Some(why) => judged.withheld(&why),
            None => judged,
        }
    }

    fn precluded(&self, tallies: &Tallies) -> Option<String> {
        self.iter().find_map(|claim| claim.precludes(tallies))
    }

    /// What draws and later ones, which `what` names, contradict for certain.
    #[must_use]
    pub fn between(&self, first: &Tallies, later: &Tallies, what: &str) -> Vec<Fact> {
        self.iter().filter_map(|claim| claim.between(first, later, what)).collect()
    }

    /// The first thing that is wrong for certain with the rows of a block.
    #[must_use]
    pub fn look(&self, draws: &Draws) -> Option<Finding> {
        (0..draws.rows()).find_map(|row| self.iter().find_map(|claim| claim.look(draws, row)))
    }

    /// The stand-in that is probably meant for an escape in these draws, though nothing says so.
    #[must_use]
    pub fn probable_escape(&self, tallies: &Tallies) -> Option<ProbableEscape> {
        self.iter().find_map(|claim| claim.probable_escape(tallies))
    }

    /// The test that draws may grow under, towards the bound that is asked for.
    #[must_use]
    pub fn sequential(&self, asked: &Asked) -> Option<SequentialTest<'_>> {
        self.iter().find_map(|claim| claim.sequential(asked))
    }

    /// The data that a ranking by efficiency needs, if the subject can stand in one.
    #[must_use]
    pub fn contender<'b>(&'b self, tallies: &'b Tallies) -> Option<Contender<'b>> {
        self.iter().find_map(|claim| claim.contender(tallies))
    }

    /// The law or mean that the subject must have in common with itself in another setting.
    #[must_use]
    pub fn comparable<'b>(&self, tallies: &'b Tallies) -> Option<Comparable<'b>> {
        self.iter().find_map(|claim| claim.comparable(tallies))
    }

    /// The finding that a method biased by design should give after so many draws.
    #[must_use]
    pub fn design(&self, draws: u64) -> Design {
        let mut designs = self.iter().map(|claim| claim.design(draws));
        designs.find(|design| *design != Design::Unbiased).unwrap_or(Design::Unbiased)
    }

    /// The additions of all of them to the results, after the decision; without tallies of a subject that did not finish its draws.
    #[must_use]
    pub fn summary(&self, tallies: Option<&Tallies>, detection: Detection) -> Summary {
        let claims = self.iter().filter_map(Claim::statement).collect();
        let mut summary = Summary { claims, ..Summary::new(detection) };
        self.iter().for_each(|claim| claim.state(&mut summary));
        if let Some(tallies) = tallies {
            self.iter().for_each(|claim| claim.summarize(tallies, &mut summary));
            if self.precluded(tallies).is_some() {
                summary.series.life_table = None; // nor is there a place where a law breaks
            }
        }
        summary
    }
}
