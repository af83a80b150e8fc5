//! How large the types of a crate are: their methods, `impl` blocks and fields that others reach into.

use std::collections::BTreeMap;

use super::source::Product;
use super::tokens::Token;

/// What is counted of one type, over all files of a crate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Size {
    pub methods: usize,
    /// Blocks of its own methods; those that implement traits are not counted, nor are their methods.
    pub blocks: usize,
    /// `pub(crate)` and `pub(super)` fields.
    pub shared_fields: usize,
}

/// The types of a crate by name.
pub fn sizes<'a>(files: &'a [Product]) -> BTreeMap<&'a str, Size> {
    let mut sizes: BTreeMap<&str, Size> = BTreeMap::new();
    for file in files {
        for (at, token) in file.tokens.iter().enumerate() {
            let after = file.tokens.get(at + 1..).unwrap_or_default();
            // `impl` in a type or argument comes behind another token than one that ends an item.
            if token.is("impl") && starts_item(file.tokens.get(..at).unwrap_or_default()) {
                if let Some((name, body)) = inherent_impl(after) {
                    let size = sizes.entry(name).or_default();
                    size.blocks += 1;
                    size.methods += at_depth_one(body).filter(|token| token.is("fn")).count();
                }
            } else if token.is("struct")
                && let [name, rest @ ..] = after
            {
                let body = rest.iter().take_while(|token| !token.is(";") && !token.is("{")).count();
                let size = sizes.entry(name.text).or_default();
                let fields: Vec<_> = at_depth_one(rest.get(body..).unwrap_or_default()).collect();
                let shared = fields.windows(3).filter(|three| match three {
                    [visibility, open, scope] => {
                        visibility.is("pub") && open.is("(") && (scope.is("crate") || scope.is("super"))
                    }
                    _ => false,
                });
                size.shared_fields += shared.count();
            }
        }
    }
    sizes
}

fn starts_item(before: &[Token]) -> bool {
    before
        .last()
        .is_none_or(|token| ["}", ";", "]", "{", "unsafe", "default"].iter().any(|end| token.is(end)))
}

/// The type's name and the tokens from its body on; `None` for the implementation of a trait.
fn inherent_impl<'a, 'b>(after: &'b [Token<'a>]) -> Option<(&'a str, &'b [Token<'a>])> {
    let length = after.iter().take_while(|token| !token.is("{")).count();
    let (header, body) = after.split_at_checked(length)?;
    if header.iter().any(|token| token.is("for")) {
        return None;
    }
    // Behind the type parameters, `impl<'a, T> name::Of<T>`.
    let mut depth = 0_usize;
    let mut name = None;
    for token in header.iter().take_while(|token| !token.is("where")) {
        depth += usize::from(token.is("<"));
        depth = depth.saturating_sub(usize::from(token.is(">")));
        if depth == 0 && token.is_word() {
            name = Some(token.text);
        }
    }
    Some((name?, body))
}

/// The tokens directly inside the first pair of braces, with the brackets and what is in round ones.
fn at_depth_one<'a, 'b>(body: &'b [Token<'a>]) -> impl Iterator<Item = &'b Token<'a>> {
    let mut depth = 0_usize;
    let mut ended = false;
    body.iter().filter(move |token| {
        depth += usize::from(token.is("{"));
        depth = depth.saturating_sub(usize::from(token.is("}")));
        ended |= depth == 0;
        !ended && depth == 1
    })
}

#[cfg(test)]
mod tests {
    use super::super::source::Source;
    use super::*;

    #[test]
    fn methods_blocks_and_fields_are_added_up() {
        let sources = [
            Source::new(
                "a.rs",
                "pub struct App<'a> { pub(crate) b: fn(u8) -> u8, c: u8, pub(super) d: Vec<u8>, pub e: u8 }
                 impl<'a> App<'a> where Self: Sized { fn a() { fn inner() {} } pub fn b(x: impl Fn()) {} }
                 impl Drop for App<'_> { fn drop(&mut self) {} }",
            ),
            Source::new(
                "b.rs",
                "impl super::App { fn c() {} } struct Unit; struct Pair(pub(crate) u8); fn f() -> impl X { y }",
            ),
        ];
        let products: Vec<Product> = sources.iter().map(Source::product).collect();
        let sizes = sizes(&products);
        assert_eq!(sizes["App"], Size { methods: 3, blocks: 2, shared_fields: 2 });
        assert_eq!(sizes["Unit"], Size::default());
        assert_eq!(sizes.len(), 3);
    }
}
