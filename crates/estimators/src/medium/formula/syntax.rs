use super::functions::{ONE, TWO, Two, names};
use super::step::{DEEPEST, Step};

/// The depth to which brackets, signs and powers may be nested; a step needs at most one place of the stack for each.
const NESTED: usize = DEEPEST / 4;

/// A reader of formulas: operators by precedence (Pratt 1973), values to postfix.
///
/// Written here since the expression crates at hand read `-t^2` as (-t)^2 or call the C library's functions, whose bits
/// depend on the machine.
pub(super) struct Parser<'a> {
    text: &'a str,
    variable: &'a str,
    at: usize,
    depth: usize,
    steps: Vec<Step>,
}

/// The binding powers of `+ -`, `* /`, a sign and `^`.
const SUM: u8 = 1;
const PRODUCT: u8 = 2;
const SIGN: u8 = 3;
const POWER: u8 = 4;

impl<'a> Parser<'a> {
    pub(super) fn new(text: &'a str, variable: &'a str) -> Self {
        Self { text, variable, at: 0, depth: 0, steps: Vec::new() }
    }

    /// The whole text as one formula.
    pub(super) fn all(mut self) -> Result<Vec<Step>, String> {
        self.operators(SUM)?;
        match self.peek() {
            None => Ok(self.steps),
            Some(c) => Err(self.wrong(format!("unexpected `{c}`"), " (an operator: + - * / ^)")),
        }
    }

    fn peek(&mut self) -> Option<char> {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
        self.text[self.at..].chars().next()
    }

    fn accept(&mut self, token: char) -> bool {
        let found = self.peek() == Some(token);
        self.at += if found { token.len_utf8() } else { 0 };
        found
    }

    fn wrong(&self, what: impl std::fmt::Display, allowed: &str) -> String {
        let column = self.text[..self.at].chars().count() + 1;
        format!("{what} at column {column}{allowed}")
    }

    /// A value, and all operators after it that bind at least as tightly as `least`.
    fn operators(&mut self, least: u8) -> Result<(), String> {
        self.depth += 1;
        if self.depth > NESTED {
            return Err(self.wrong("the formula is nested too deeply", ""));
        }
        self.value()?;
        while let Some(operator) = self.peek().and_then(Operator::of).filter(|next| next.binds >= least) {
            self.at += 1;
            self.operators(operator.right)?;
            self.steps.push(Step::Two(operator.operation));
        }
        self.depth -= 1;
        Ok(())
    }

    fn value(&mut self) -> Result<(), String> {
        match self.peek() {
            Some('(') => self.brackets(1, "("),
            Some('-') => {
                self.at += 1;
                self.operators(SIGN)?;
                self.steps.push(Step::One(std::ops::Neg::neg));
                Ok(())
            }
            Some('+') => {
                self.at += 1;
                self.operators(SIGN)
            }
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_alphabetic() || c == '_' => self.name(),
            _ => {
                let allowed = format!(" (a number, {}, pi, a function or a bracket)", self.variable);
                Err(self.wrong("a value is missing", &allowed))
            }
        }
    }

    fn number(&mut self) -> Result<(), String> {
        let rest = &self.text[self.at..];
        let exponent = |i: usize| i > 0 && matches!(rest.as_bytes()[i - 1], b'e' | b'E');
        let part = |(i, c): (usize, char)| {
            c.is_ascii_digit() || c == '.' || ((c == '-' || c == '+') && exponent(i)) || (c == 'e' || c == 'E')
        };
        let end = rest.char_indices().find(|&at| !part(at)).map_or(rest.len(), |(i, _)| i);
        let word = &rest[..end];
        let number: f64 = word.parse().map_err(|_| self.wrong(format!("`{word}` is not a number"), ""))?;
        self.steps.push(Step::Number(number));
        self.at += end;
        Ok(())
    }

    fn name(&mut self) -> Result<(), String> {
        let rest = &self.text[self.at..];
        let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(rest.len());
        let name = &rest[..end];
        let (one, two) = (ONE.iter().find(|(n, _)| *n == name), TWO.iter().find(|(n, _)| *n == name));
        let (step, arguments) = match (name, one, two) {
            (name, ..) if name == self.variable => (Step::Variable, 0),
            ("pi", ..) => (Step::Number(std::f64::consts::PI), 0),
            (_, Some((_, f)), _) => (Step::One(*f), 1),
            (_, _, Some((_, f))) => (Step::Two(*f), 2),
            _ => return Err(self.wrong(format!("unknown name `{name}`"), &format!(" ({})", names(self.variable)))),
        };
        self.at += end;
        if arguments > 0 {
            self.brackets(arguments, name)?;
        }
        self.steps.push(step);
        Ok(())
    }

    /// `arguments` formulas in brackets.
    fn brackets(&mut self, arguments: usize, of: &str) -> Result<(), String> {
        if !self.accept('(') {
            let what = if arguments == 1 { "its argument" } else { "its arguments" };
            return Err(self.wrong(format!("`{of}` needs {what} in brackets"), ""));
        }
        for i in 0..arguments {
            if i > 0 && !self.accept(',') {
                return Err(self.wrong(format!("`{of}` needs {arguments} arguments"), ""));
            }
            self.operators(SUM)?;
        }
        if self.accept(')') { Ok(()) } else { Err(self.wrong("a `)` is missing", "")) }
    }
}

/// An operator between two values.
struct Operator {
    operation: Two,
    /// Its binding power.
    binds: u8,
    /// The binding power of operators that belong to its right side.
    right: u8,
}

impl Operator {
    fn of(c: char) -> Option<Self> {
        let (operation, binds, right): (Two, _, _) = match c {
            '+' => (std::ops::Add::add, SUM, SUM + 1),
            '-' => (std::ops::Sub::sub, SUM, SUM + 1),
            '*' => (std::ops::Mul::mul, PRODUCT, PRODUCT + 1),
            '/' => (std::ops::Div::div, PRODUCT, PRODUCT + 1),
            '^' => (libm::pow, POWER, SIGN),
            _ => return None,
        };
        Some(Self { operation, binds, right })
    }
}
