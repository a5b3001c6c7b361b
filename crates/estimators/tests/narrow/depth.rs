//! Optical depths by quadrature: of a user's medium that provides no tau, and of a formula.

use crate::zoo::{BASE, Bump, Hidden, LENGTH, PEAK, bumps, close};
use freepath_estimators::medium::{Gaussian, numeric};
use freepath_estimators::{Extinction, Medium};

#[test]
fn the_provided_depth_of_a_narrow_bump_is_right() {
    for bump in bumps() {
        let due = BASE * LENGTH + PEAK * bump.area(1, 0.0, LENGTH);
        let plain = Hidden::<false>(bump.medium());
        close(plain.tau(LENGTH), due, 1e-12, &bump);
        assert!(plain.tau_error() < 1e-11, "{bump:?}: {}", plain.tau_error());
        let half = BASE * bump.center + PEAK * bump.area(1, 0.0, bump.center);
        close(plain.tau(bump.center), half, 1e-12, &bump);
    }
    let reported = Hidden::<false>(Gaussian::new(20.0, 1.31416, 0.01, LENGTH, 0.5).expect("a medium"));
    close(reported.tau(LENGTH), 1.501_325_654_926_2, 1e-12, &"the issue's");
}

#[test]
fn the_depth_of_a_narrow_formula_is_right() {
    for bump in bumps() {
        let inner = bump.medium();
        let medium = numeric(move |t| inner.mu(t), LENGTH, BASE + PEAK, vec![]).expect("a medium");
        let due = BASE * LENGTH + PEAK * bump.area(1, 0.0, LENGTH);
        close(medium.tau(LENGTH), due, 1e-12, &bump);
        assert!(medium.tau_error() < 1e-11, "{bump:?}");
        let features = medium.features();
        let flank = |x: &&f64| (**x - bump.center).abs() < 3.0 * bump.width;
        assert!(bump.width > 1e-3 || features.iter().filter(flank).count() > 1, "{bump:?} {}", features.len());
    }
}

#[test]
fn features_increase_inside_every_medium_and_view() {
    use freepath_estimators::medium::{reversed, scaled, segment};
    for Bump { center, width } in bumps() {
        let bump = Bump { center, width }.medium();
        let media: [Box<dyn Medium>; 4] = [
            Box::new(scaled(2.0, bump.clone()).expect("scaled")),
            Box::new(reversed(bump.clone()).expect("reversed")),
            Box::new(segment(bump.clone(), 0.3, 1.9).expect("a part")),
            Box::new(bump.clone()),
        ];
        for medium in media {
            let features = medium.features();
            assert!(features.windows(2).all(|w| w[0] < w[1]));
            assert!(features.iter().all(|&t| t > 0.0 && t < medium.length()));
        }
        let mirrored = reversed(bump).expect("reversed").features();
        assert!(mirrored.iter().any(|t| (t - (LENGTH - center)).abs() < 1e-12));
    }
}
