//! Formulas of one variable, such as `5 + v + 10*exp(-2*v)`.
//!
//! A formula is read once into steps over a stack. Its functions are those of the crate libm, so that an answer has the same bits on every
//! machine. The crates of expressions that have a licence like ours and are kept well, such as `exmex`, bring regular expressions: 1.2 MB in
//! the command and in the page, whose limit is 1 MB, and 20 s of compilation.

use super::interval::{Interval, Jet};
use super::node::nearest;

/// The longest formula in bytes.
const LONGEST: usize = 1000;
/// The deepest nesting of parentheses and signs.
const DEEPEST: usize = 60;

/// A function of one number.
type Function = (&'static str, fn(f64) -> f64);

const FUNCTIONS: [Function; 17] = [
    ("abs", f64::abs),
    ("sign", |x| if x == 0.0 { 0.0 } else { x.signum() }),
    ("sqrt", f64::sqrt),
    ("exp", libm::exp),
    ("ln", libm::log),
    ("log10", libm::log10),
    ("sin", libm::sin),
    ("cos", libm::cos),
    ("tan", libm::tan),
    ("asin", libm::asin),
    ("acos", libm::acos),
    ("atan", libm::atan),
    ("sinh", libm::sinh),
    ("cosh", libm::cosh),
    ("tanh", libm::tanh),
    ("floor", f64::floor),
    ("ceil", f64::ceil),
];
const PAIRS: [&str; 2] = ["min", "max"];
const CONSTANTS: [(&str, f64); 2] = [("pi", std::f64::consts::PI), ("e", std::f64::consts::E)];

#[derive(Debug, Clone, Copy)]
enum Step {
    Number(f64),
    Variable,
    Negative,
    Apply(usize),
    Pair(usize),
    Operator(u8),
}

/// A formula, ready to be computed.
#[derive(Debug, Clone)]
pub(super) struct Formula {
    text: String,
    steps: Vec<Step>,
}

impl Formula {
    /// Reads a formula of this variable.
    pub(super) fn new(text: &str, variable: &'static str) -> Result<Self, String> {
        if text.len() > LONGEST {
            return Err(format!("has {} bytes, must have ≤ {LONGEST}", text.len()));
        }
        let mut reader = Reader { text, at: 0, variable, steps: Vec::new(), depth: 0 };
        reader.sum()?;
        if let Some(next) = reader.peek() {
            return Err(format!("{next} is not expected at place {}", reader.place()));
        }
        Ok(Self { text: text.trim().to_owned(), steps: reader.steps })
    }

    /// The formula as it was written.
    pub(super) fn text(&self) -> &str {
        &self.text
    }

    /// Its value.
    pub(super) fn at(&self, x: f64) -> f64 {
        let mut stack: Vec<f64> = Vec::with_capacity(16);
        for step in &self.steps {
            let mut pop = || stack.pop().unwrap_or(f64::NAN);
            let value = match *step {
                Step::Number(number) => number,
                Step::Variable => x,
                Step::Negative => -pop(),
                Step::Apply(place) => FUNCTIONS.get(place).map_or(f64::NAN, |(_, function)| function(pop())),
                Step::Pair(place) => {
                    let (b, a) = (pop(), pop());
                    // NaN stays NaN.
                    if a.is_nan() || (!b.is_nan() && (a < b) == (place == 0)) { a } else { b }
                }
                Step::Operator(operator) => {
                    let (b, a) = (pop(), pop());
                    match operator {
                        b'+' => a + b,
                        b'-' => a - b,
                        b'*' => a * b,
                        b'/' => a / b,
                        _ => power(a, b),
                    }
                }
            };
            stack.push(value);
        }
        stack.pop().unwrap_or(f64::NAN)
    }

    /// It and its first two derivatives over an interval.
    pub(super) fn jet(&self, x: Interval) -> Jet {
        let mut stack: Vec<Jet> = Vec::with_capacity(16);
        let none = Jet::number(f64::NAN);
        for step in &self.steps {
            let mut pop = || stack.pop().unwrap_or(none);
            let value = match *step {
                Step::Number(number) => Jet::number(number),
                Step::Variable => Jet::variable(x),
                Step::Negative => pop().negative(),
                Step::Apply(place) => pop().apply(FUNCTIONS.get(place).map_or("", |(name, _)| name)),
                Step::Pair(place) => {
                    let (b, a) = (pop(), pop());
                    a.extreme(b, place == 0)
                }
                Step::Operator(operator) => {
                    let (b, a) = (pop(), pop());
                    match operator {
                        b'+' => a.plus(b),
                        b'-' => a.minus(b),
                        b'*' => a.times(b),
                        b'/' => a.over(b),
                        _ => a.power(b),
                    }
                }
            };
            stack.push(value);
        }
        stack.pop().unwrap_or(none)
    }
}

/// `a^b`; small whole powers by products, which are exact for signs.
fn power(a: f64, b: f64) -> f64 {
    match b {
        2.0 => a * a,
        3.0 => a * a * a,
        _ => libm::pow(a, b),
    }
}

struct Reader<'t> {
    text: &'t str,
    at: usize,
    variable: &'static str,
    steps: Vec<Step>,
    depth: usize,
}

impl Reader<'_> {
    fn rest(&self) -> &str {
        self.text.get(self.at..).unwrap_or("")
    }

    /// The next character but blanks.
    fn peek(&mut self) -> Option<char> {
        let rest = self.rest();
        self.at = self.at.saturating_add(rest.len().saturating_sub(rest.trim_start().len()));
        self.rest().chars().next()
    }

    /// The place of the next character, from 1.
    fn place(&self) -> usize {
        self.text.get(..self.at).map_or(0, |before| before.chars().count()).saturating_add(1)
    }

    fn takes(&mut self, one: char) -> bool {
        let is = self.peek() == Some(one);
        if is {
            self.at = self.at.saturating_add(one.len_utf8());
        }
        is
    }

    fn expect(&mut self, one: char) -> Result<(), String> {
        if self.takes(one) {
            return Ok(());
        }
        Err(match self.peek() {
            Some(next) => format!("{next} at place {} must be {one}", self.place()),
            None => format!("ends where {one} must follow"),
        })
    }

    fn sum(&mut self) -> Result<(), String> {
        self.depth = self.depth.saturating_add(1);
        if self.depth > DEEPEST {
            return Err(format!("must be nested ≤ {DEEPEST} deep"));
        }
        self.product()?;
        while let Some(operator) = self.peek().filter(|next| "+-−".contains(*next)) {
            self.takes(operator);
            self.product()?;
            self.steps.push(Step::Operator(if operator == '+' { b'+' } else { b'-' }));
        }
        self.depth = self.depth.saturating_sub(1);
        Ok(())
    }

    fn product(&mut self) -> Result<(), String> {
        self.factor()?;
        while let Some(operator) = self.peek().filter(|next| "*·/".contains(*next)) {
            self.takes(operator);
            self.factor()?;
            self.steps.push(Step::Operator(if operator == '/' { b'/' } else { b'*' }));
        }
        Ok(())
    }

    /// A power with its sign, which binds less: −v^2 is −(v^2).
    fn factor(&mut self) -> Result<(), String> {
        self.depth = self.depth.saturating_add(1);
        if self.depth > DEEPEST {
            return Err(format!("must be nested ≤ {DEEPEST} deep"));
        }
        if self.takes('-') || self.takes('−') {
            self.factor()?;
            self.steps.push(Step::Negative);
        } else if self.takes('+') {
            self.factor()?;
        } else {
            self.operand()?;
            if self.takes('^') {
                self.factor()?;
                self.steps.push(Step::Operator(b'^'));
            }
        }
        self.depth = self.depth.saturating_sub(1);
        Ok(())
    }

    fn operand(&mut self) -> Result<(), String> {
        match self.peek() {
            Some('(') => {
                self.expect('(')?;
                self.sum()?;
                self.expect(')')
            }
            Some(next) if next.is_ascii_digit() || next == '.' => self.number(),
            Some(next) if next.is_alphabetic() => self.name(),
            Some(next) => Err(format!("{next} is not expected at place {}", self.place())),
            None => Err("ends where a number, a name or a parenthesis must follow".to_owned()),
        }
    }

    fn number(&mut self) -> Result<(), String> {
        let bytes = self.rest().as_bytes();
        let digits = |from: usize| {
            bytes.iter().skip(from).take_while(|byte| byte.is_ascii_digit() || **byte == b'.').count()
        };
        let mut length = digits(0);
        if matches!(bytes.get(length), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(length.saturating_add(1)), Some(b'+' | b'-')));
            let from = length.saturating_add(1).saturating_add(sign);
            let count = digits(from);
            if count > 0 {
                length = from.saturating_add(count);
            }
        }
        let text = self.rest().get(..length).unwrap_or("");
        let number = text.parse().map_err(|_| format!("{text} is no number at place {}", self.place()))?;
        self.at = self.at.saturating_add(length);
        self.steps.push(Step::Number(number));
        Ok(())
    }

    fn name(&mut self) -> Result<(), String> {
        let is_part = |letter: char| letter.is_alphanumeric() || letter == '_';
        let length = self.rest().find(|letter| !is_part(letter)).unwrap_or(self.rest().len());
        let name = self.rest().get(..length).unwrap_or("").to_owned();
        self.at = self.at.saturating_add(length);
        let called = self.peek() == Some('(');
        let pair = PAIRS.iter().position(|own| *own == name);
        let function = FUNCTIONS.iter().position(|(own, _)| *own == name);
        match (function, pair) {
            (Some(_), _) | (_, Some(_)) if !called => {
                Err(format!("{name} must have a number in parentheses"))
            }
            (Some(place), _) => {
                self.expect('(')?;
                self.sum()?;
                self.expect(')')?;
                self.steps.push(Step::Apply(place));
                Ok(())
            }
            (_, Some(place)) => {
                self.expect('(')?;
                self.sum()?;
                self.expect(',')?;
                self.sum()?;
                self.expect(')')?;
                self.steps.push(Step::Pair(place));
                Ok(())
            }
            (None, None) => {
                let constant = CONSTANTS.iter().find(|(own, _)| *own == name).map(|(_, value)| *value);
                let step =
                    if name == self.variable { Some(Step::Variable) } else { constant.map(Step::Number) };
                let step = step.filter(|_| !called).ok_or_else(|| {
                    let names = [self.variable].into_iter().chain(CONSTANTS.map(|(name, _)| name));
                    let names: Vec<_> = names.chain(FUNCTIONS.map(|(name, _)| name)).chain(PAIRS).collect();
                    format!("{name} is unknown. {}", nearest(&name, names.into_iter()))
                })?;
                self.steps.push(step);
                Ok(())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str, x: f64) -> f64 {
        Formula::new(text, "v").unwrap_or_else(|e| panic!("{text}: {e}")).at(x)
    }

    #[test]
    fn formulas_have_the_values_of_their_arithmetic() {
        let v: f64 = 0.7;
        for (text, due) in [
            ("5 + v + 10*exp(-2*v)", 5.0 + v + 10.0 * libm::exp(-2.0 * v)),
            ("-v^2", -(v * v)),
            ("2^-1^2", 0.5),
            ("2^3^2", 512.0),
            ("8/4/2 - 3 - 4", 1.0 - 7.0),
            ("1.5e-3*v + 2E2 − 1·v", 1.5e-3 * v + 200.0 - v),
            ("max(v, 1) + min(2, abs(-3)) + sign(-v)", 1.0 + 2.0 - 1.0),
            ("((v))*pi + e", v * std::f64::consts::PI + std::f64::consts::E),
            ("+v--v", v + v),
            ("tanh(v)/sqrt(1+v^2.5)", libm::tanh(v) / (1.0 + libm::pow(v, 2.5)).sqrt()),
        ] {
            let found = value(text, v);
            assert!((found - due).abs() <= 1e-15 * due.abs().max(1.0), "{text}: {found} {due}");
        }
        assert!(value("max(v, 0/0)", 1.0).is_nan() && value("max(0/0, v)", 1.0).is_nan());
    }

    #[test]
    fn what_is_no_formula_is_told() {
        for (text, why) in [
            ("5 + w", "w is unknown"),
            ("5 + vv", "Did you mean v?"),
            ("5 +", "ends where a number"),
            ("(5", "ends where ) must follow"),
            ("5 v", "v is not expected at place 3"),
            ("exp v", "exp must have a number in parentheses"),
            ("max(1)", ") at place 6 must be ,"),
            ("v(3)", "v is unknown"),
            ("1.2.3", "1.2.3 is no number"),
            ("5 $ 3", "$ is not expected"),
            ("", "ends where a number"),
        ] {
            let found = Formula::new(text, "v").unwrap_err();
            assert!(found.contains(why), "{text}: {found}");
        }
        for deep in ["(", "-", "exp(", "2^"] {
            let text = format!("{}v", deep.repeat(240));
            assert!(Formula::new(&text, "v").unwrap_err().contains("nested"), "{deep}");
        }
        assert!(Formula::new(&"1+".repeat(600), "v").unwrap_err().contains("bytes"));
    }
}
