//! Takes the arguments of a command off its line, and checks them.

use super::diagnostic::Place;
use super::field::{Field, Number};
use super::log::Log;
use super::number;
use super::text::{Token, shorten};

/// The unread rest of a line.
pub(super) struct Arguments<'t> {
    /// The command and all its arguments.
    tokens: Vec<Token<'t>>,
    next: usize,
    /// The command's syntax, for messages.
    pub usage: &'static str,
}

impl<'t> Arguments<'t> {
    /// The arguments of the line `tokens`, whose first token is its command.
    pub fn new(tokens: Vec<Token<'t>>, usage: &'static str) -> Self {
        Self {
            tokens,
            next: 1,
            usage,
        }
    }

    /// The command itself.
    pub fn command(&self) -> Token<'t> {
        self.tokens[0]
    }

    /// The argument that was taken last; before the first, the command.
    pub fn last(&self) -> Token<'t> {
        self.tokens[self.next - 1]
    }

    /// Arguments not yet taken.
    pub fn rest(&self) -> &[Token<'t>] {
        &self.tokens[self.next..]
    }

    /// The next argument; an error if there is none. `what` names it.
    pub fn word(&mut self, log: &mut Log, what: &str) -> Option<Token<'t>> {
        let token = self.tokens.get(self.next).copied();
        if token.is_none() {
            self.too_few(log, what);
        }
        self.next += usize::from(token.is_some());
        token
    }

    /// The next arguments, one legal number per field. Reports every wrong one.
    pub fn numbers<const N: usize>(
        &mut self,
        log: &mut Log,
        fields: [Field; N],
    ) -> Option<[Number; N]> {
        let mut numbers = [Number {
            value: 0.0,
            place: self.command().place,
        }; N];
        let mut good = true;
        for (index, field) in fields.into_iter().enumerate() {
            let Some(token) = self.rest().first().copied() else {
                let missing: Vec<_> = fields[index..].iter().map(|field| field.name).collect();
                self.too_few(log, &missing.join(" "));
                return None;
            };
            self.next += 1;
            match self.parse_number(log, token, field) {
                Some(number) => numbers[index] = number,
                None => good = false,
            }
        }
        good.then_some(numbers)
    }

    /// Skips the next argument, which the caller already knows.
    pub fn skip_one(&mut self) {
        self.next = (self.next + 1).min(self.tokens.len());
    }

    /// Skips all remaining arguments.
    pub fn skip(&mut self) {
        self.next = self.tokens.len();
    }

    /// Ends the line: warns about unread arguments.
    pub fn finish(self, log: &mut Log) {
        if let (Some(first), Some(last)) = (self.rest().first(), self.rest().last()) {
            let message = format!("`{}` has more arguments than it takes", self.command().text);
            log.warning(first.place.to(last.place), message, "ignored")
                .help(format!("usage: {}", self.usage));
        }
    }

    /// Reports that the line ends before the argument `what`.
    fn too_few(&self, log: &mut Log, what: &str) {
        let Token { text, place: last } = self.last();
        let gap = Place {
            column: last.column + text.chars().count(),
            start: last.start + last.length,
            length: 0,
            ..last
        };
        let message = format!("`{}` has too few arguments", self.command().text);
        log.error(gap, message, &format!("{what} missing"))
            .help(format!("usage: {}", self.usage));
    }

    fn parse_number(&self, log: &mut Log, token: Token<'_>, field: Field) -> Option<Number> {
        let (text, place) = (token.text, token.place);
        let is_not_finite = number::is_not_finite(text);
        // The prefix of `1.#QNAN` is a number.
        let length = if is_not_finite {
            0
        } else {
            number::prefix_length(text)
        };
        let Ok(value) = text[..length].parse::<f64>() else {
            let message = match is_not_finite {
                true => format!("`{}` is not a finite number", shorten(text)),
                false => format!("`{}` is not a number", shorten(text)),
            };
            log.error(place, message, &format!("expected {} here", field.name))
                .help(format!("usage: {}", self.usage));
            return None;
        };
        // The renderer computes in single precision: a value that overflows there would be infinite in the picture.
        if value.abs() > f64::from(f32::MAX) {
            let message = format!(
                "`{}` is beyond the range of single precision",
                shorten(text)
            );
            log.error(place, message, &format!("{} would be infinite", field.name));
            return None;
        }
        if length < text.len() {
            let message = format!(
                "`{}` is read as {}",
                shorten(text),
                shorten(&text[..length])
            );
            log.warning(
                place,
                message,
                &format!("`{}` is ignored", shorten(&text[length..])),
            );
        }
        field.check(log, Number { value, place })
    }
}
