use super::step::{DEEPEST, Step};
use super::syntax::Parser;

/// The longest text that is read.
const LONGEST: usize = 4096;

/// A formula in one variable, ready to be evaluated.
#[derive(Clone, Debug)]
pub(crate) struct Expression {
    text: String,
    steps: Vec<Step>,
}

/// The same text is the same formula.
impl PartialEq for Expression {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}

impl Expression {
    /// Reads `text`, a formula in `variable`.
    ///
    /// # Errors
    /// With the column and what is allowed there.
    pub(crate) fn new(text: &str, variable: &str) -> Result<Self, String> {
        if text.len() > LONGEST {
            return Err(format!("the formula has {} bytes (at most {LONGEST})", text.len()));
        }
        Ok(Self { text: text.into(), steps: Parser::new(text, variable).all()? })
    }

    /// Its value where the variable is `t`.
    #[inline(always)]
    pub(crate) fn at(&self, t: f64) -> f64 {
        let (mut stack, mut top) = ([0.0; DEEPEST], 0);
        for step in &self.steps {
            match *step {
                Step::Number(x) => (stack[top], top) = (x, top + 1),
                Step::Variable => (stack[top], top) = (t, top + 1),
                Step::One(f) => stack[top - 1] = f(stack[top - 1]),
                Step::Two(f) => (stack[top - 2], top) = (f(stack[top - 2], stack[top - 1]), top - 1),
            }
        }
        stack[0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn value(text: &str, t: f64) -> f64 {
        Expression::new(text, "t").unwrap().at(t)
    }

    fn refusal(text: &str) -> String {
        Expression::new(text, "t").unwrap_err()
    }

    #[test]
    fn it_is_read_as_in_print() {
        let close = |text: &str, t: f64, x: f64| assert!((value(text, t) - x).abs() < 1e-14, "{text}: {x}");
        close("-t^2", 3.0, -9.0);
        close("2^3^2", 0.0, 512.0);
        close("8 - 4 - 2", 0.0, 2.0);
        close("8/4/2", 0.0, 1.0);
        close("2*-t + 1e-1", 3.0, -5.9);
        close("2^-1", 0.0, 0.5);
        close("min(t, 2)*max(t, 2) + step(1, t)", 1.0, 3.0);
        close("sin(pi/2) + ln(exp(2)) + sqrt(16)", 0.0, 7.0);
        close("+t - (t)", 1.5, 0.0);
    }

    #[test]
    fn what_is_wrong_is_said_with_its_column() {
        assert_eq!(refusal("1 + "), "a value is missing at column 5 (a number, t, pi, a function or a bracket)");
        assert_eq!(refusal("(1 + t"), "a `)` is missing at column 7");
        assert!(refusal("1 + x*t").starts_with("unknown name `x` at column 5 (t, pi, abs, "));
        assert_eq!(refusal("sin t"), "`sin` needs its argument in brackets at column 5");
        assert_eq!(refusal("min(t)"), "`min` needs 2 arguments at column 6");
        assert_eq!(refusal("1 2"), "unexpected `2` at column 3 (an operator: + - * / ^)");
        assert_eq!(refusal("2t"), "unexpected `t` at column 2 (an operator: + - * / ^)");
        assert_eq!(refusal("1.2.3"), "`1.2.3` is not a number at column 1");
        assert!(refusal("t $ 2").starts_with("unexpected `$` at column 3"));
    }

    #[test]
    fn deep_and_long_formulas_are_refused() {
        let brackets = "(".repeat(2000) + "t" + &")".repeat(2000);
        assert!(refusal(&brackets).starts_with("the formula is nested too deeply at column"));
        assert!(refusal(&"-".repeat(4000)).starts_with("the formula is nested too deeply"));
        assert!(refusal(&("1^".repeat(2000) + "1")).starts_with("the formula is nested too deeply"));
        assert!(refusal(&("1+".repeat(3000) + "1")).contains("at most 4096"));
    }

    #[test]
    fn nan_is_not_dropped() {
        assert!(value("min(sqrt(-1), t)", 1.0).is_nan() && value("max(t, ln(-1))", 1.0).is_nan());
        assert!(value("step(0, ln(-1))", 1.0).is_nan());
    }

    proptest! {
        #[test]
        fn any_text_is_read_or_refused(text in "[t0-9piexpsinmax+*/^(), .e-]{0,200}|\\PC{0,60}") {
            if let Ok(expression) = Expression::new(&text, "t") {
                let _ = expression.at(0.7);
            }
        }
    }
}
