//! Second moments of chromatic samplers whose channels are far apart.

use crate::zoo::close;
use freepath_estimators::chromatic::AnyChromatic;
use freepath_estimators::claims::Channel;
use freepath_estimators::medium::Constant;

/// mu of the thick channel beside one of 1, and int_0^2 f^2 / pdf of it, f = mu exp(-mu t) / 2, pdf that of the even mixture: by mpmath
/// 1.3 with 50 digits.
const BALANCED: [(f64, f64); 4] = [
    (3.0, 0.302_260_572_174_220_7),
    (50.0, 0.461_743_439_023_823),
    (5e3, 0.499_148_848_456_813_7),
    (1e6, 0.499_993_092_285_852_7),
];

#[test]
fn the_weights_of_channels_far_apart_have_the_moments_of_the_closed_form() {
    let length = 2.0;
    for (thick, balanced) in BALANCED {
        let media = [1.0, thick].map(|mu| Constant::new(mu, length).expect("a medium"));
        let channels = media.each_ref().map(|extinction| Channel { extinction, albedo: 0.5 });
        let thin: AnyChromatic = serde_json::from_str(r#"{"single_channel": {"channel": 0}}"#).expect("a sampler");
        let claims = thin.claims(&channels);
        assert!(claims.moments_error < 1e-10, "{thick}: {:e}", claims.moments_error);
        // f_1^2 / f_0 falls at the rate 2 mu_1 - mu_0
        let rate = 2.0 * thick - 1.0;
        let due = 0.25 * thick * thick / rate * -libm::expm1(-rate * length);
        close(claims.scatter_moments.expect("known")[1][0], due, 1e-12, &thick);
        let balance: AnyChromatic = serde_json::from_str(r#"{"balance": {}}"#).expect("a sampler");
        let claims = balance.claims(&channels);
        close(claims.scatter_moments.expect("known")[1][0], balanced, 1e-11, &thick);
    }
}
