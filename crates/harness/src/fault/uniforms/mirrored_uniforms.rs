use crate::fault::{Injection, Overlay, WalkContext};
use freepath_estimators::Capability;

/// Harmless: every uniform u becomes 1 - u, less one unit in the last place, so that -ln(1 - u) is -ln(u) with u in (0, 1].
///
/// ```text
/// right: t = -ln(1 - u) / mu, u in [0, 1);   right as well: t = -ln(u) / mu, u in (0, 1]
/// ```
///
/// Shows in: nothing. A harness that finds it is too strict.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MirroredUniforms {}

struct Mirror;

impl Overlay for Mirror {
    fn word(&self, stream: &mut dyn FnMut() -> u64) -> u64 {
        !stream()
    }
}

impl Injection for MirroredUniforms {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::LookUps]
    }
    fn overlay<'a>(&'a self, _context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        Some(Box::new(Mirror))
    }
}
