//! Where the page names operations as text.

use std::collections::BTreeSet;

use super::source::Product;
use super::tokens::Kind;

/// The names of the operations: the first `name:` behind each definition of a `SPEC`.
pub fn names<'a>(editor: &[Product<'a>]) -> BTreeSet<&'a str> {
    let mut names = BTreeSet::new();
    for file in editor {
        let mut in_spec = false;
        for three in file.tokens.windows(3) {
            let [name, colon, value] = three else { continue };
            if name.is("SPEC") && colon.is(":") {
                in_spec = true;
            } else if in_spec && name.is("name") && colon.is(":") && value.kind == Kind::Text {
                names.insert(value.text);
                in_spec = false;
            }
        }
    }
    names
}

/// The places at which a file's code holds an operation's name as text, as `path:line: name`.
pub fn mentions(files: &[Product], names: &BTreeSet<&str>) -> Vec<String> {
    let mut found = Vec::new();
    for file in files {
        let texts = file.tokens.iter().filter(|token| token.kind == Kind::Text && names.contains(token.text));
        found.extend(texts.map(|token| format!("{}:{}: {}", file.path.display(), token.line, token.text)));
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
            "const SPEC: Spec = Spec { name: \"split-edge\", label: \"Split\", fields: &[Field { name: \"t\" }] };",
        );
        let other =
            Source::new("b.rs", "struct X { name: &'static str } const A: X = X { name: \"smooth\" };");
        let editor = [spec.product(), other.product()];
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
