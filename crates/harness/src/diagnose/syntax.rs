//! The grammar: from text to a tree.

use std::ops::Range;

use jsonc_parser::tokens::Token;
use jsonc_parser::{Scanner, ScannerOptions};

use super::diagnosis::Finding;
use super::tree::{Node, Value};
use super::words::shortened;
use super::{MAX_BYTES, MAX_DEPTH};
use fault::Fault;

mod fault;
mod nested;
mod number;

/// Nothing that JSON has not, but comments, which the scanner always takes.
const STRICT: ScannerOptions = ScannerOptions {
    allow_single_quoted_strings: false,
    allow_hexadecimal_numbers: false,
    allow_unary_plus_numbers: false,
    allow_bare_decimal_point_numbers: false,
    allow_non_finite_numbers: false,
    allow_extended_string_escapes: false,
};

/// Reads a text that holds one value.
pub(super) fn parse(text: &str) -> Result<Node, Finding> {
    Ok(read(text)?)
}

fn read(text: &str) -> Result<Node, Fault> {
    if text.len() > MAX_BYTES {
        let message = format!("the file has {} bytes (at most {MAX_BYTES} are read)", text.len());
        return Err(Fault::new(0..0, message));
    }
    let scanner = Scanner::new(text, &STRICT);
    let mut parser = Parser { text, scanner, token: None, depth: 0 };
    parser.advance()?;
    let root = parser.value()?;
    match parser.token {
        None => Ok(root),
        Some(_) => {
            let message = format!("`{}` follows the end (a file holds one value)", parser.shown());
            Err(Fault::new(parser.span(), message))
        }
    }
}

/// The text, and the token that is to be read next.
struct Parser<'a> {
    text: &'a str,
    scanner: Scanner<'a>,
    token: Option<Token<'a>>,
    depth: usize,
}

impl Parser<'_> {
    /// Moves to the next token that is no comment.
    fn advance(&mut self) -> Result<(), Fault> {
        self.token = self.scanner.scan()?;
        while let Some(Token::CommentLine(_) | Token::CommentBlock(_)) = self.token {
            self.token = self.scanner.scan()?;
        }
        Ok(())
    }

    /// The place of the token.
    fn span(&self) -> Range<usize> {
        self.scanner.token_start()..self.scanner.token_end()
    }

    /// The token as the text has it.
    fn shown(&self) -> String {
        shortened(self.text.get(self.span()).unwrap_or_default())
    }

    fn value(&mut self) -> Result<Node, Fault> {
        let mut span = self.span();
        let value = match self.token.take() {
            Some(Token::OpenBrace) => self.nested(Parser::object)?,
            Some(Token::OpenBracket) => self.nested(Parser::list)?,
            Some(Token::String(text)) => Value::Text(self.checked(text.into_owned())?),
            Some(Token::Number(digits)) => {
                number::read(digits).map_err(|message| Fault::new(span.clone(), message))?
            }
            Some(Token::Boolean(value)) => Value::Bool(value),
            Some(Token::Null) => Value::Null,
            Some(_) => return Err(self.no_value()),
            None => return Err(Fault::new(span, "the file ends where a value is expected")),
        };
        span.end = self.scanner.token_end();
        self.advance()?;
        Ok(Node { span, value })
    }

    fn no_value(&self) -> Fault {
        let allowed = "an object, a list, a string in double quotes, a number, true, false or null";
        Fault::new(self.span(), format!("`{}` is no value (must be {allowed})", self.shown()))
    }

    /// A string without raw control characters, which JSON forbids: mostly, its closing quote was forgotten.
    fn checked(&self, text: String) -> Result<String, Fault> {
        let raw = self.text.get(self.span()).unwrap_or_default();
        match raw.bytes().find(|&byte| byte < b' ') {
            None => Ok(text),
            Some(b'\n' | b'\r') => Err(Fault::no_quote(self.span())),
            Some(byte) => {
                let allowed = format!("must be written `\\u{byte:04x}`");
                Err(Fault::new(self.span(), format!("the string holds a raw control character ({allowed})")))
            }
        }
    }
}
