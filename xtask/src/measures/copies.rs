//! Tools and records that are written once, most of them in `crates/halfedge/src/geometry`, told by the shape of code that
//! only they hold.

use super::source::Product;
use super::tokens::Token;

/// A tool and how a function or type that does its work looks.
pub struct Tool {
    pub name: &'static str,
    /// Files in which the same shape is something else.
    others: &'static [&'static str],
    is_shape: fn(&[Token]) -> bool,
    /// How many tokens the shape is looked for in.
    window: usize,
}

/// Marks its filled pages in an array of its own, to find the first by its leading zeros.
const QUEUE: &str = "crates/surface/src/simplify/queue.rs";
/// Adds up the normals of the triangles round a vertex.
const POLISH: &str = "crates/surface/src/remesh/polish.rs";

pub const TOOLS: [Tool; 5] = [
    Tool { name: "bit sets", others: &[QUEUE], is_shape: shifts_by_index, window: 8 },
    Tool { name: "union-finds", others: &[], is_shape: joins_to_the_smaller, window: 24 },
    Tool { name: "point grids", others: &[], is_shape: keys_by_cell, window: 6 },
    Tool { name: "area vectors of polygons", others: &[POLISH], is_shape: sums_cross_products, window: 40 },
    Tool { name: "records of a mesh with its name", others: &[], is_shape: names_a_mesh, window: 80 },
];

/// The files that hold the shape of a tool, each once, as `path:line`.
pub fn files_with(tool: &Tool, files: &[Product]) -> Vec<String> {
    let first = |file: &Product| {
        let at = (0..file.tokens.len()).find(|&at| {
            let end = (at + tool.window).min(file.tokens.len());
            file.tokens.get(at..end).is_some_and(tool.is_shape)
        })?;
        Some(format!("{}:{}", file.path.display(), file.tokens.get(at)?.line))
    };
    let is_other = |file: &&Product| tool.others.iter().any(|other| file.path.ends_with(other));
    files.iter().filter(|file| !is_other(file)).filter_map(first).collect()
}

/// `<< (index % 64)` or `<< (index & 63)`.
fn shifts_by_index(window: &[Token]) -> bool {
    let [first, second, open, rest @ ..] = window else { return false };
    first.is("<")
        && second.is("<")
        && open.is("(")
        && rest.windows(2).any(|two| match two {
            [operator, number] => {
                (operator.is("%") && ["64", "32"].contains(&number.text))
                    || (operator.is("&") && ["63", "31"].contains(&number.text))
            }
            _ => false,
        })
}

/// `[a.max(b) …] = a.min(b)`, with whatever the index and the slot take besides.
fn joins_to_the_smaller(window: &[Token]) -> bool {
    let [a, dot, max, open, b, close, rest @ ..] = window else { return false };
    a.is_word()
        && dot.is(".")
        && max.is("max")
        && open.is("(")
        && b.is_word()
        && close.is(")")
        && rest.windows(7).any(|seven| match seven {
            [equals, first, dot, min, open, second, close] => {
                equals.is("=")
                    && first.text == a.text
                    && dot.is(".")
                    && min.is("min")
                    && open.is("(")
                    && second.text == b.text
                    && close.is(")")
            }
            _ => false,
        })
}

/// A map keyed by a cell, `Map<[i64; 3], …>`, or `.floor().as_i64vec3()`.
fn keys_by_cell(window: &[Token]) -> bool {
    match window {
        [a, open, close, dot, cast, ..] if a.is("floor") => {
            open.is("(") && close.is(")") && dot.is(".") && cast.is("as_i64vec3")
        }
        [a, open, number, semicolon, size, close] => {
            a.is("<")
                && open.is("[")
                && ["i64", "u64"].contains(&number.text)
                && semicolon.is(";")
                && size.text == "3"
                && close.is("]")
        }
        _ => false,
    }
}

/// Cross products of what lies around a first corner, added up: `.cross(…)).sum()` or `+= ….cross(…)`, but not what is
/// measured of each on its own.
fn sums_cross_products(window: &[Token]) -> bool {
    let [first, second, rest @ ..] = window else { return false };
    let has = |names: &[&str]| {
        let mut statement = rest.iter().take_while(|token| !token.is(";") && !token.is("{"));
        statement.any(|token| names.iter().any(|name| token.is(name)))
    };
    let is_sum = (first.is("+") && second.is("=") && has(&["cross"]))
        || (first.is(".") && second.is("cross") && has(&["sum"]));
    is_sum && !has(&["dot", "length"])
}

/// `struct … { name: …, mesh: …Mesh… }`, with other fields besides.
fn names_a_mesh(window: &[Token]) -> bool {
    let [keyword, rest @ ..] = window else { return false };
    let body = rest.iter().position(|token| token.is("{") || token.is(";"));
    let Some((open, body)) = body.and_then(|at| rest.get(at..)).and_then(<[Token]>::split_first) else {
        return false;
    };
    let fields = body.iter().position(|token| token.is("}")).and_then(|end| body.get(..end)).unwrap_or(body);
    let has = |name: &str| fields.windows(2).position(|two| matches!(two, [a, b] if a.is(name) && b.is(":")));
    let is_mesh = |at: usize| {
        let kind = fields.iter().skip(at).take_while(|token| !token.is(","));
        kind.into_iter().any(|token| token.is("Mesh"))
    };
    keyword.is("struct") && open.is("{") && has("name").is_some() && has("mesh").is_some_and(is_mesh)
}

#[cfg(test)]
mod tests {
    use super::super::source::Source;
    use super::*;

    fn found(text: &str) -> Vec<&'static str> {
        let source = Source::new("a.rs", text);
        let files = [source.product()];
        TOOLS.iter().filter(|tool| !files_with(tool, &files).is_empty()).map(|tool| tool.name).collect()
    }

    #[test]
    fn each_tool_is_told_by_its_shape() {
        assert_eq!(found("self.words[i / 64] |= 1 << (i % 64);"), ["bit sets"]);
        assert_eq!(found("let bit = 1_u64 << (id as usize & 63);"), ["bit sets"]);
        assert_eq!(found("self.0[a.max(b) as usize] = a.min(b);"), ["union-finds"]);
        assert_eq!(
            found("if let Some(slot) = p.get_mut(a.max(b) as usize) { *slot = a.min(b); }"),
            ["union-finds"]
        );
        assert_eq!(found("cells: HashMap<[u64; 3], Vec<u32>>"), ["point grids"]);
        assert_eq!(found("let cell = |p: Vec3| (p / size).floor().as_i64vec3();"), ["point grids"]);
        let area = "area vectors of polygons";
        assert_eq!(found("pairs.map(|(a, b)| (a - o).cross(b - o)).sum::<DVec3>() * 0.5"), [area]);
        assert_eq!(found("sum += before.cross(here);"), [area]);
        let record = "records of a mesh with its name";
        assert_eq!(found("pub struct Part<'a> { pub name: &'a str, pub mesh: &'a Mesh, id: u32 }"), [record]);
        assert_eq!(found("struct Input { mesh: Arc<Mesh>, name: String }"), [record]);
    }

    #[test]
    fn other_code_is_left_alone() {
        for text in [
            "1 << (bits + 3)",
            "a.max(b); c = a.min(d);",
            "HashMap<[u32; 3], u32>",
            "area += (b - a).cross(c - a).length();",
            "volume += a.dot(b.cross(c));",
            "let normal = (b - a).cross(c - a); let sum = 0;",
            "struct Instance { name: String, mesh: Option<usize> }",
            "struct Target<'a> { mesh: &'a Mesh, selection: u32 } struct Named { name: String }",
            "fn plan(name: &str, mesh: &Mesh) {}",
        ] {
            assert_eq!(found(text), Vec::<&str>::new(), "{text}");
        }
    }
}
