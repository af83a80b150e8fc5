//! Splits Rust source into tokens: enough to count what a file defines, imports and names, with comments and the
//! insides of strings out of the way.

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A name or a keyword; a raw one (`r#type`) without its prefix.
    Word,
    /// A string or byte string; its text is what stands between the quotes, escapes as written.
    Text,
    /// A character, a lifetime or a number.
    Other,
    /// One character of punctuation.
    Mark,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token<'a> {
    pub kind: Kind,
    pub text: &'a str,
    /// The line on which it starts, from 1.
    pub line: usize,
}

impl Token<'_> {
    /// Whether it is this word or mark; never true of what a string holds.
    pub fn is(&self, text: &str) -> bool {
        matches!(self.kind, Kind::Word | Kind::Mark) && self.text == text
    }

    pub fn is_word(&self) -> bool {
        self.kind == Kind::Word
    }
}

/// The tokens of a source text. Costs O(length).
pub fn tokens(source: &str) -> Vec<Token<'_>> {
    let mut reader = Reader { source, at: 0, line: 1 };
    let mut tokens = Vec::new();
    while let Some(token) = reader.next_token() {
        tokens.push(token);
    }
    tokens
}

struct Reader<'a> {
    source: &'a str,
    at: usize,
    line: usize,
}

impl<'a> Reader<'a> {
    fn rest(&self) -> &'a str {
        self.source.get(self.at..).unwrap_or_default()
    }

    fn peek(&self, ahead: usize) -> Option<char> {
        self.rest().chars().nth(ahead)
    }

    /// Moves on by this many bytes and counts the lines passed.
    fn skip(&mut self, bytes: usize) -> &'a str {
        let passed = self.rest().get(..bytes).unwrap_or_else(|| self.rest());
        self.at += passed.len();
        self.line += passed.matches('\n').count();
        passed
    }

    fn skip_while(&mut self, belongs: impl Fn(char) -> bool) -> &'a str {
        let rest = self.rest();
        self.skip(rest.find(|c| !belongs(c)).unwrap_or(rest.len()))
    }

    fn next_token(&mut self) -> Option<Token<'a>> {
        self.skip_blanks_and_comments();
        let line = self.line;
        let first = self.peek(0)?;
        let (kind, text) = if let Some(text) = self.string() {
            (Kind::Text, text)
        } else if first == '\'' {
            (Kind::Other, self.character_or_lifetime())
        } else if first.is_ascii_digit() {
            // `1..2` is a number and a range; a decimal point and what follows it make a token of their own.
            (Kind::Other, self.skip_while(is_word_character))
        } else if is_word_character(first) {
            if self.rest().starts_with("r#") {
                self.skip(2);
            }
            (Kind::Word, self.skip_while(is_word_character))
        } else {
            (Kind::Mark, self.skip(first.len_utf8()))
        };
        Some(Token { kind, text, line })
    }

    fn skip_blanks_and_comments(&mut self) {
        loop {
            self.skip_while(char::is_whitespace);
            if self.rest().starts_with("//") {
                self.skip_while(|c| c != '\n');
            } else if self.rest().starts_with("/*") {
                self.skip_block_comment();
            } else {
                return;
            }
        }
    }

    /// Block comments nest.
    fn skip_block_comment(&mut self) {
        let mut depth = 0_usize;
        loop {
            let rest = self.rest();
            if rest.starts_with("/*") {
                depth += 1;
                self.skip(2);
            } else if rest.starts_with("*/") {
                depth -= 1;
                self.skip(2);
            } else if let Some(c) = rest.chars().next() {
                self.skip(c.len_utf8());
            } else {
                return;
            }
            if depth == 0 {
                return;
            }
        }
    }

    /// The content of a string that starts here: `"…"`, `b"…"`, `c"…"`, `r"…"`, `r#"…"#`, `br"…"`.
    fn string(&mut self) -> Option<&'a str> {
        let rest = self.rest();
        let prefix = rest.find(|c| !matches!(c, 'b' | 'c' | 'r')).unwrap_or(rest.len());
        let is_raw = rest.get(..prefix)?.contains('r');
        let after = rest.get(prefix..)?;
        let hashes = if is_raw { after.find(|c| c != '#').unwrap_or(after.len()) } else { 0 };
        if prefix > 2 || !after.get(hashes..)?.starts_with('"') {
            return None;
        }
        self.skip(prefix + hashes + 1);
        let body = self.rest();
        let end = if is_raw { body.find(&format!("\"{}", "#".repeat(hashes))) } else { end_of_string(body) };
        let text = self.skip(end.unwrap_or(body.len()));
        self.skip(1 + hashes);
        Some(text)
    }

    /// `'a'`, `'\n'` and `'\''` are characters, `'a` is a lifetime.
    fn character_or_lifetime(&mut self) -> &'a str {
        let rest = self.rest();
        if self.peek(1) == Some('\\') {
            let end = rest.get(3..).and_then(|after| after.find('\''));
            return self.skip(end.map_or(rest.len(), |end| end + 4));
        }
        if self.peek(2) == Some('\'') {
            return self.skip(2 + self.peek(1).map_or(0, char::len_utf8));
        }
        self.skip(1);
        self.skip_while(is_word_character)
    }
}

fn is_word_character(c: char) -> bool {
    c == '_' || c.is_alphanumeric()
}

/// Where the closing quote of a string with escapes is.
fn end_of_string(body: &str) -> Option<usize> {
    let mut escaped = false;
    body.char_indices().find_map(|(at, c)| {
        let closes = c == '"' && !escaped;
        escaped = c == '\\' && !escaped;
        closes.then_some(at)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(source: &str) -> Vec<&str> {
        tokens(source).iter().map(|token| token.text).collect()
    }

    #[test]
    fn words_and_marks_are_told_apart() {
        assert_eq!(
            texts("pub(crate) fn a_1(&self) -> u8;"),
            ["pub", "(", "crate", ")", "fn", "a_1", "(", "&", "self", ")", "-", ">", "u8", ";"]
        );
        assert_eq!(texts("r#type 0..10 1.5"), ["type", "0", ".", ".", "10", "1", ".", "5"]);
    }

    #[test]
    fn comments_are_left_out() {
        assert_eq!(texts("a // b \"c\n/* d /* e */ f */ g"), ["a", "g"]);
        assert_eq!(tokens("a\n// b\n\nc").last().map(|token| token.line), Some(4));
    }

    #[test]
    fn strings_keep_what_they_hold() {
        let source = r####"f("a\"b", r#"c"d"#, b"e", br"f\", "//g")"####;
        let held: Vec<&str> =
            tokens(source).iter().filter(|token| token.kind == Kind::Text).map(|token| token.text).collect();
        assert_eq!(held, [r#"a\"b"#, "c\"d", "e", r"f\", "//g"]);
    }

    #[test]
    fn a_word_that_starts_like_a_string_is_a_word() {
        assert_eq!(texts("break crb b c r br"), ["break", "crb", "b", "c", "r", "br"]);
    }

    #[test]
    fn characters_and_lifetimes_do_not_swallow_code() {
        assert_eq!(
            texts("'\"' x '\\'' y 'é' &'a str '\\u{1f}' z"),
            ["'\"'", "x", "'\\''", "y", "'é'", "&", "a", "str", "'\\u{1f}'", "z"]
        );
    }

    #[test]
    fn what_a_string_holds_is_no_word() {
        assert!(tokens("fn").iter().all(|token| token.is("fn")));
        assert!(tokens("\"fn\"").iter().all(|token| !token.is("fn")));
    }

    #[test]
    fn unfinished_sources_end() {
        for source in ["\"abc", "/* a", "'", "'\\", "r#\"a", "b\"", "r#"] {
            tokens(source);
        }
    }
}
