//! Where the page names operations as text.

use std::collections::BTreeSet;

use super::source::Product;
use super::tokens::Kind;

/// The names of the operations: the first text in each definition of a `SPEC`.
pub fn names<'a>(editor: &[Product<'a>]) -> BTreeSet<&'a str> {
    let mut names = BTreeSet::new();
    for file in editor {
        for (at, two) in file.tokens.windows(2).enumerate() {
            if let [name, colon] = two
                && name.is("SPEC")
                && colon.is(":")
            {
                let mut definition = file.tokens.iter().skip(at).take_while(|token| !token.is(";"));
                names.extend(definition.find(|token| token.kind == Kind::Text).map(|name| name.text));
            }
        }
    }
    names
}

/// The places at which a file's code holds an operation's name as text, as `path:line: name`. The key of a JSON object,
/// `"smooth": …`, is no name of an operation.
pub fn mentions(files: &[Product], names: &BTreeSet<&str>) -> Vec<String> {
    let mut found = Vec::new();
    for file in files {
        for (at, token) in file.tokens.iter().enumerate() {
            let is_key = file.tokens.get(at + 1).is_some_and(|next| next.is(":"));
            if token.kind == Kind::Text && names.contains(token.text) && !is_key {
                found.push(format!("{}:{}: {}", file.path.display(), token.line, token.text));
            }
        }
    }
    found
}

/// The places at which commands are put together as JSON, `json!({ "op": …` or `insert("op", …`, as `path:line`.
pub fn json_commands(files: &[Product]) -> Vec<String> {
    let mut found = Vec::new();
    for file in files {
        for three in file.tokens.windows(3) {
            if let [before, open, key] = three
                && (before.is("(") && open.is("{") || before.is("insert") && open.is("("))
                && key.kind == Kind::Text
                && key.text == "op"
            {
                found.push(format!("{}:{}", file.path.display(), key.line));
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::super::source::Source;
    use super::*;

    #[test]
    fn names_come_from_specs_and_are_found_in_text_only() {
        let spec = Source::new(
            "a.rs",
            "const SPEC: Spec = Spec::new(Scope::Elements, \"split-edge\", \"Split edge\").fields(&[one(\"edge\")]);",
        );
        let declared = Source::new("t.rs", "trait Operation { const SPEC: Spec; fn f() { \"smooth\" } }");
        let other =
            Source::new("b.rs", "struct X { name: &'static str } const A: X = X { name: \"smooth\" };");
        let editor = [spec.product(), declared.product(), other.product()];
        let names = names(&editor);
        assert_eq!(names, BTreeSet::from(["split-edge"]));

        let page = Source::new(
            "c.rs",
            "f(\"split-edge\"); g[\"op\"]; // \"split-edge\"\njson!({ \"op\": name });\n#[cfg(test)]\nmod t { const A: &str = \"split-edge\"; }",
        );
        let page = [page.product()];
        assert_eq!(mentions(&page, &names), ["c.rs:1: split-edge"]);
        assert_eq!(json_commands(&page), ["c.rs:2"]);
    }
}
