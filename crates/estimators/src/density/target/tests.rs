use super::*;

const BETA: &str = "6*x*(1 - x)";

fn of_pdf(text: &str, domain: [f64; 2], atoms: &[Atom]) -> Result<Target, ParameterError> {
    Target::of_pdf(&Curve::Formula(text.into()), domain, &[], atoms)
}

fn refusal(text: &str, domain: [f64; 2], atoms: &[Atom]) -> String {
    of_pdf(text, domain, atoms).err().map(|why| why.to_string()).unwrap_or_default()
}

#[test]
fn a_density_and_its_distribution_function_are_one_target() {
    let pdf = of_pdf("x/2", [0.0, 2.0], &[]).unwrap();
    let cdf = Target::of_cdf(&Curve::Formula("x^2/4".into()), [0.0, 2.0], &[]).unwrap();
    for (x, mass) in [(0.1, 1.0 / 400.0), (0.8, 0.16), (1.0, 0.25)] {
        assert!((pdf.continuous_mass(x) - mass).abs() < 1e-12 && (cdf.continuous_mass(x) - mass).abs() < 1e-15);
        assert!((pdf.quantile(mass) - x).abs() < 1e-9 && (cdf.quantile(mass) - x).abs() < 1e-12);
    }
    assert_eq!((cdf.pdf(1.0), pdf.pdf(1.0), pdf.pdf(2.5)), (None, Some(0.5), Some(0.0)));
}

#[test]
fn tables_start_anywhere_and_atoms_come_last() {
    let hat = Curve::Table(Table { x: vec![-1.0, 0.0, 1.0], y: vec![0.0, 0.75, 0.0] });
    let atoms = [Atom { at: -1.0, mass: 0.1 }, Atom { at: 0.5, mass: 0.15 }];
    let target = Target::of_pdf(&hat, [-1.0, 1.0], &[], &atoms).unwrap();
    assert!((target.quantile(0.375) - 0.0).abs() < 1e-12);
    assert_eq!((target.quantile(0.8), target.quantile(0.9)), (-1.0, 0.5));
    assert_eq!((target.pdf(0.5), target.pdf(0.0)), (Some(0.15), Some(0.75)));
    let ramp = Curve::Table(Table { x: vec![0.0, 1.0, 3.0], y: vec![0.0, 0.5, 1.0] });
    let target = Target::of_cdf(&ramp, [0.0, 3.0], &[]).unwrap();
    assert_eq!((target.pdf(0.5), target.pdf(2.0)), (Some(0.5), Some(0.25)));
}

#[test]
fn mass_is_seen_to_the_ends_and_not_in_a_gap() {
    let beta = of_pdf(BETA, [0.0, 1.0], &[]).unwrap();
    assert!([0.0, 0.5, 1.0 - 1e-16, 1.0].iter().all(|&x| beta.has_mass(x)));
    assert!([-0.1, 1.1, f64::NAN, f64::INFINITY].iter().all(|&x| !beta.has_mass(x)));
    let x = vec![0.0, 1.0, 2.0, 3.0];
    let gap = Curve::Table(Table { x, y: vec![0.0, 0.5, 0.5, 1.0] });
    let target = Target::of_cdf(&gap, [0.0, 3.0], &[]).unwrap();
    assert!(target.has_mass(0.5) && target.has_mass(1.0) && !target.has_mass(1.5));
}

#[test]
fn what_is_no_law_is_refused() {
    assert!(refusal("x", [0.0, 1.0], &[]).starts_with("pdf must be one whose mass is 1"));
    assert!(refusal("x - 0.5", [0.0, 1.0], &[]).contains("not -0.5 at x = 0"));
    assert!(refusal("t", [0.0, 1.0], &[]).contains("unknown name `t` at column 1 (x, pi"));
    assert!(refusal(BETA, [1.0, 1.0], &[]).starts_with("domain must be two finite numbers"));
    assert!(refusal(BETA, [0.0, f64::NAN], &[]).starts_with("domain"));
    assert!(refusal(BETA, [0.0, 1.0], &[Atom { at: 2.0, mass: 0.5 }]).starts_with("atoms must be increasing"));
    assert!(refusal(BETA, [0.0, 1.0], &[Atom { at: 0.5, mass: f64::NAN }]).starts_with("atoms must be"));
    let down = Target::of_cdf(&Curve::Formula("1 - (1 - 2*x)^2".into()), [0.0, 1.0], &[]);
    assert!(down.is_err());
}
