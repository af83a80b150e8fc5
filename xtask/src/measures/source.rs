//! Rust source files without their tests.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::tokens::{Token, tokens};
use crate::shell::{self, Result};

/// A source file's text and where it lies.
pub struct Source {
    /// Relative to the project's folder.
    pub path: PathBuf,
    text: String,
}

/// What of a source file goes into the product.
pub struct Product<'a> {
    pub path: &'a Path,
    /// Its tokens, without items under `#[cfg(test)]`.
    pub tokens: Vec<Token<'a>>,
    /// How many lines it has, blank ones and comments included.
    pub lines: usize,
    /// How many lines hold more than comments.
    pub code_lines: usize,
}

impl Source {
    #[cfg(test)]
    pub fn new(path: &str, text: &str) -> Self {
        Self { path: path.into(), text: text.to_owned() }
    }

    /// All its tokens, those of tests too.
    pub fn tokens(&self) -> Vec<Token<'_>> {
        tokens(&self.text)
    }

    pub fn product(&self) -> Product<'_> {
        let all = self.tokens();
        let mut kept = Vec::with_capacity(all.len());
        let mut test_lines = 0;
        let mut rest = all.as_slice();
        while let Some((first, after)) = rest.split_first() {
            let length = if starts_test_attribute(rest) { item_length(rest) } else { 0 };
            if let Some(last) = rest.get(..length).and_then(<[_]>::last) {
                // The item's last token is a brace, a semicolon or a comma: it ends on the line it starts on.
                test_lines += last.line + 1 - first.line;
                rest = rest.get(length..).unwrap_or_default();
            } else {
                kept.push(*first);
                rest = after;
            }
        }
        Product {
            path: &self.path,
            lines: self.text.lines().count() - test_lines,
            code_lines: kept.iter().map(|token| token.line).collect::<BTreeSet<_>>().len(),
            tokens: kept,
        }
    }
}

/// All Rust files below a folder of the project, sorted. Files that are modules for tests alone are left out.
pub fn read_folder(root: &Path, folder: &str) -> Result<Vec<Source>> {
    let mut sources = Vec::new();
    for (name, path) in shell::files_below(&root.join(folder)) {
        if name.ends_with(".rs") {
            let text = shell::read(&path)?;
            let path = path.strip_prefix(root).unwrap_or(&path).to_path_buf();
            sources.push(Source { path, text });
        }
    }
    let tests = test_modules(&sources);
    sources.retain(|source| !tests.iter().any(|module| source.path.starts_with(module)));
    sources.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(sources)
}

/// The files and folders of modules declared as `#[cfg(test)] mod name;`.
fn test_modules(sources: &[Source]) -> Vec<PathBuf> {
    let mut modules = Vec::new();
    for source in sources {
        let all = source.tokens();
        for start in 0..all.len() {
            let rest = all.get(start..).unwrap_or_default();
            if !starts_test_attribute(rest) {
                continue;
            }
            let item = rest.get(..item_length(rest)).unwrap_or_default();
            if let [.., keyword, name, end] = item
                && keyword.is("mod")
                && end.is(";")
            {
                let folder = children_folder(&source.path).join(name.text);
                modules.push(folder.with_extension("rs"));
                modules.push(folder);
            }
        }
    }
    modules
}

/// The folder in which a module's file looks for its children.
pub fn children_folder(file: &Path) -> PathBuf {
    let is_own_folder =
        file.file_name().is_some_and(|name| name == "mod.rs" || name == "lib.rs" || name == "main.rs");
    if is_own_folder { file.parent().unwrap_or(file).to_path_buf() } else { file.with_extension("") }
}

/// `#[cfg(test)]`, `#[cfg(all(test, …))]` and `#[test]`, but not `#[cfg(not(test))]`.
fn starts_test_attribute(rest: &[Token]) -> bool {
    let Some(attribute) = rest.get(..attribute_length(rest)) else { return false };
    match attribute {
        [_, _, name, _] => name.is("test"),
        [_, _, name, ..] => {
            name.is("cfg")
                && attribute.iter().any(|token| token.is("test"))
                && !attribute.iter().any(|token| token.is("not"))
        }
        _ => false,
    }
}

/// How many tokens the attribute takes that starts here; none where none does.
fn attribute_length(rest: &[Token]) -> usize {
    match rest {
        [hash, bracket, ..] if hash.is("#") && bracket.is("[") => {
            let mut depth = 0_usize;
            for (at, token) in rest.iter().enumerate().skip(1) {
                depth += usize::from(token.is("["));
                depth -= usize::from(token.is("]"));
                if depth == 0 {
                    return at + 1;
                }
            }
            rest.len()
        }
        _ => 0,
    }
}

const ITEM_KEYWORDS: [&str; 11] =
    ["fn", "struct", "enum", "impl", "trait", "mod", "use", "const", "static", "type", "macro_rules"];

/// How many tokens an item takes with the attributes in front of it: up to the brace that closes it, or a semicolon
/// or comma outside all brackets.
fn item_length(rest: &[Token]) -> usize {
    let mut at = 0;
    loop {
        match attribute_length(rest.get(at..).unwrap_or_default()) {
            0 => break,
            length => at += length,
        }
    }
    // Between type parameters a comma ends nothing.
    let is_item = rest.iter().skip(at).take_while(|token| token.is_word() || token.is("(") || token.is(")"));
    let is_item = is_item.clone().any(|token| ITEM_KEYWORDS.iter().any(|keyword| token.is(keyword)));
    let mut depth = 0_usize;
    for (at, token) in rest.iter().enumerate().skip(at) {
        depth += usize::from(["(", "[", "{"].iter().any(|open| token.is(open)));
        if [")", "]", "}"].iter().any(|close| token.is(close)) {
            // The bracket around the item: a last field or argument has no comma behind it.
            let Some(outside) = depth.checked_sub(1) else { return at };
            depth = outside;
            if depth == 0 && token.is("}") {
                return at + 1;
            }
        }
        if depth == 0 && (token.is(";") || token.is(",") && !is_item) {
            return at + 1;
        }
    }
    rest.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn product(text: &str) -> (String, usize, usize) {
        let source = Source::new("src/a.rs", text);
        let product = source.product();
        let words: Vec<&str> = product.tokens.iter().map(|token| token.text).collect();
        (words.join(" "), product.lines, product.code_lines)
    }

    #[test]
    fn tests_inside_a_file_are_left_out() {
        let text = "fn a() {}\n\n// b\n#[cfg(test)]\nmod tests {\n    fn c() { d(); }\n}\n";
        assert_eq!(product(text), ("fn a ( ) { }".to_owned(), 3, 1));
    }

    #[test]
    fn only_the_item_with_the_attribute_is() {
        let text = "#[cfg(test)]\n#[allow(x)]\nuse a::{b};\n#[cfg(all(test, unix))]\npub fn c<A, B>() -> [u8; 2] {}\nfn d() {}";
        // A group in an import closes like a block, and the semicolon behind it is of no account.
        assert!(product(text).0.ends_with("fn d ( ) { }"));
        assert_eq!(product("struct A {\n#[cfg(test)]\nb: u8,\nc: u8 }").0, "struct A { c : u8 }");
        assert_eq!(product("struct A { c: u8,\n#[cfg(test)]\nb: u8 }").0, "struct A { c : u8 , }");
    }

    #[test]
    fn what_tests_are_without_is_product() {
        assert_eq!(product("#[cfg(not(test))]\nfn a() {}").1, 2);
        assert_eq!(product("#[cfg(feature = \"test\")]\nfn a() {}").1, 2);
    }

    #[test]
    fn test_modules_in_files_of_their_own_are_found() {
        let sources = [
            Source::new("src/a.rs", "#[cfg(test)]\nmod checks;\nmod kept;"),
            Source::new("src/b/mod.rs", "#[cfg(test)] mod tests;"),
        ];
        let found = test_modules(&sources);
        assert_eq!(
            found,
            ["src/a/checks.rs", "src/a/checks", "src/b/tests.rs", "src/b/tests"].map(PathBuf::from)
        );
    }
}
