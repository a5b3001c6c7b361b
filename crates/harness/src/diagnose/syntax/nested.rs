//! Values in brackets: lists and objects.

use std::collections::HashMap;
use std::ops::Range;

use jsonc_parser::tokens::Token;

use super::fault::Fault;
use super::{MAX_DEPTH, Parser};
use crate::diagnose::excerpt::line_of;
use crate::diagnose::path::Step;
use crate::diagnose::tree::{Member, Node, Value};
use crate::diagnose::words::shortened;

/// Reads from the token after the opening bracket, which is at the range, to the closing one.
type Read<'a> = fn(&mut Parser<'a>, &Range<usize>) -> Result<Value, Fault>;

impl<'a> Parser<'a> {
    /// Reads a value in brackets, of which the opening one has been taken.
    pub(super) fn nested(&mut self, read: Read<'a>) -> Result<Value, Fault> {
        let open = self.span();
        if self.depth == MAX_DEPTH {
            return Err(Fault::new(open, format!("the nesting is too deep (at most {MAX_DEPTH} levels)")));
        }
        self.depth += 1;
        self.advance()?;
        let value = read(self, &open)?;
        self.depth -= 1;
        Ok(value)
    }

    pub(super) fn list(&mut self, open: &Range<usize>) -> Result<Value, Fault> {
        let mut items = Vec::new();
        while !self.closes(&Token::CloseBracket, open)? {
            let item = self.value().map_err(|fault| fault.under(Step::Index(items.len())))?;
            items.push(item);
            self.comma(&Token::CloseBracket, open)?;
        }
        Ok(Value::List(items))
    }

    pub(super) fn object(&mut self, open: &Range<usize>) -> Result<Value, Fault> {
        let (mut members, mut seen) = (Vec::new(), HashMap::new());
        while !self.closes(&Token::CloseBrace, open)? {
            let key = self.key()?;
            if let Some(first) = seen.insert(key.text().to_owned(), key.span.start) {
                return Err(self.twice(key, first));
            }
            let value = self.value().map_err(|fault| fault.under(Step::Key(key.text().to_owned())))?;
            members.push(Member { key, value });
            self.comma(&Token::CloseBrace, open)?;
        }
        Ok(Value::Object(members))
    }

    fn twice(&self, key: Node, first: usize) -> Fault {
        let line = line_of(self.text.get(..first).unwrap_or_default());
        let name = shortened(key.text());
        Fault::new(key.span, format!("the key `{name}` stands twice (first on line {line})"))
    }

    /// A key and its colon.
    fn key(&mut self) -> Result<Node, Fault> {
        let Some(Token::String(_)) = self.token else {
            let message = format!("`{}` is no key (must be a string in double quotes)", self.shown());
            return Err(Fault::new(self.span(), message));
        };
        let key = self.value()?;
        if self.token != Some(Token::Colon) {
            let message = format!("`:` is missing after the key `{}`", shortened(key.text()));
            return Err(Fault::new(key.span, message));
        }
        self.advance()?;
        Ok(key)
    }

    /// True if the bracket that was opened at `open` closes here.
    fn closes(&self, close: &Token, open: &Range<usize>) -> Result<bool, Fault> {
        let Some(token) = &self.token else {
            let missing = format!("`{}` is missing before the end of the file", close.as_str());
            return Err(Fault::new(open.clone(), format!("this is never closed ({missing})")));
        };
        Ok(token == close)
    }

    /// Passes the comma after an item; after the last one, there need not be any.
    fn comma(&mut self, close: &Token, open: &Range<usize>) -> Result<(), Fault> {
        if self.token == Some(Token::Comma) {
            return self.advance();
        }
        if self.closes(close, open)? {
            return Ok(());
        }
        let message = format!("`,` or `{}` is missing before `{}`", close.as_str(), self.shown());
        Err(Fault::new(self.span(), message))
    }
}
