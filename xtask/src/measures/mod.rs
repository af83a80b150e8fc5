//! `cargo xtask measures`: what the code's structure is measured by, each measure with its limit.

mod circles;
mod commits;
mod copies;
mod early_returns;
mod imports;
mod lints;
mod operations;
mod source;
mod tokens;
mod types;

use std::path::{Path, PathBuf};

use source::{Product, Source};

use crate::project::Project;
use crate::shell::{self, Result};

/// The commit before the rebuild that the measures watch over.
const START: &str = "658370b";
/// The lines of product code at [`START`], counted as [`product_lines`] counts them.
const LINES_AT_START: usize = 46_485;
const LINES_TO_SAVE: usize = 4000;

const MAX_CIRCLE_FILES: usize = 3;
const MAX_METHODS: usize = 45;
const MAX_IMPL_BLOCKS: usize = 4;
const MAX_SHARED_APP_FIELDS: usize = 8;
const MAX_FOLLOW_CALLS: usize = 2;
const MAX_FILE_LINES: usize = 400;

/// Fewer operations than this are a sign that their names aren't found any more.
const MIN_OPERATIONS: usize = 45;

/// One measure with what was found.
struct Measure {
    name: String,
    value: usize,
    limit: usize,
    /// Whether `cargo xtask test` fails when the limit is broken.
    is_enforced: bool,
    /// What there is to mend, worst first.
    details: Vec<String>,
}

impl Measure {
    fn is_met(&self) -> bool {
        self.value <= self.limit
    }
}

/// Prints the measures. Fails when one that is enforced is broken.
pub fn run(project: &Project) -> Result {
    let crates = product_lines(project)?;
    let measures = measure(project, &crates)?;
    print_lines(&crates);
    print_measures(&measures);
    let broken: Vec<&str> = measures
        .iter()
        .filter(|measure| measure.is_enforced && !measure.is_met())
        .map(|measure| measure.name.as_str())
        .collect();
    if broken.is_empty() { Ok(()) } else { Err(format!("over the limit: {}.", broken.join("; "))) }
}

/// A crate's name, its folder, and the lines of its product code: with blank lines and comments, and without.
struct CrateLines {
    name: String,
    sources: Vec<Source>,
    lines: usize,
    code_lines: usize,
}

/// Counts the Rust files below `src` of each crate that is shipped, without items under `#[cfg(test)]`. What lies in
/// `tests`, `benches` and `examples` isn't counted, nor are `crates/fixtures`, which is for tests only, and `xtask`.
fn product_lines(project: &Project) -> Result<Vec<CrateLines>> {
    let mut folders: Vec<PathBuf> = shell::entries(&project.root.join("crates"));
    folders.retain(|folder| !folder.ends_with("fixtures"));
    folders.extend(["web", "web/worker"].map(|folder| project.root.join(folder)));
    let mut crates = Vec::new();
    for folder in folders {
        let path = folder.strip_prefix(&project.root).unwrap_or(&folder);
        let sources = source::read_folder(&project.root, &path.join("src").to_string_lossy())?;
        let products: Vec<Product> = sources.iter().map(Source::product).collect();
        crates.push(CrateLines {
            name: path.display().to_string(),
            lines: products.iter().map(|product| product.lines).sum(),
            code_lines: products.iter().map(|product| product.code_lines).sum(),
            sources,
        });
    }
    Ok(crates)
}

fn measure(project: &Project, crates: &[CrateLines]) -> Result<Vec<Measure>> {
    let products = |name: &str| -> Result<Vec<Product<'_>>> {
        let found = crates.iter().find(|found| found.name == name);
        let found = found.ok_or_else(|| format!("there is no crate in the folder {name}."))?;
        Ok(found.sources.iter().map(Source::product).collect())
    };
    let (web, formats, editor) = (products("web")?, products("crates/formats")?, products("crates/editor")?);
    let mut measures = vec![
        Measure {
            name: format!("product lines, {LINES_TO_SAVE} less than at {START}"),
            value: crates.iter().map(|found| found.lines).sum(),
            limit: LINES_AT_START.saturating_sub(LINES_TO_SAVE),
            is_enforced: false,
            details: Vec::new(),
        },
        longest_file(crates),
        lints::roots_that_allow_panics(crates),
        largest_circle("web/src", &web, true),
        largest_circle("crates/formats/src", &formats, true),
    ];
    measures.extend(type_measures(&web));
    measures.extend(page_measures(&web, &editor)?);
    let all: Vec<Product> = crates.iter().flat_map(|found| &found.sources).map(Source::product).collect();
    measures.extend(copies::TOOLS.iter().map(|tool| {
        let found = copies::files_with(tool, &all);
        Measure {
            name: format!("files with {} of their own", tool.name),
            value: found.len(),
            limit: 1,
            is_enforced: true,
            details: if found.len() > 1 { found } else { Vec::new() },
        }
    }));
    measures.push(early_returns::in_tests(project)?);
    let subjects = commits::odd_subjects_since(project, START)?;
    measures.push(Measure {
        name: format!("commit subjects since {START} that are too long or not `area: imperative`"),
        value: subjects.len(),
        limit: 0,
        is_enforced: true,
        details: subjects,
    });
    Ok(measures)
}

fn longest_file(crates: &[CrateLines]) -> Measure {
    let mut files: Vec<(usize, String)> = crates
        .iter()
        .flat_map(|found| &found.sources)
        .map(Source::product)
        .map(|file| (file.lines, format!("{}: {}", file.path.display(), file.lines)))
        .collect();
    files.sort_by(|a, b| b.cmp(a));
    Measure {
        name: "lines of the longest file".to_owned(),
        value: files.first().map_or(0, |(lines, _)| *lines),
        limit: MAX_FILE_LINES,
        is_enforced: true,
        details: files
            .into_iter()
            .filter(|(lines, _)| *lines > MAX_FILE_LINES)
            .map(|(_, text)| text)
            .collect(),
    }
}

fn largest_circle(folder: &str, files: &[Product], is_enforced: bool) -> Measure {
    let circles = circles::circles(&imports::imports(files, Path::new(folder)));
    let name = |file: &usize| {
        files.get(*file).map_or_else(String::new, |file| {
            file.path.strip_prefix(folder).unwrap_or(file.path).display().to_string()
        })
    };
    Measure {
        name: format!("files in the largest import circle of {folder}"),
        value: circles.first().map_or(0, Vec::len),
        limit: MAX_CIRCLE_FILES,
        is_enforced,
        details: circles
            .iter()
            .filter(|circle| circle.len() > MAX_CIRCLE_FILES)
            .map(|circle| circle.iter().map(name).collect::<Vec<_>>().join(" "))
            .collect(),
    }
}

fn type_measures(web: &[Product]) -> [Measure; 3] {
    let sizes = types::sizes(web);
    let worst = |name: &str, limit: usize, count: fn(&types::Size) -> usize| {
        let mut counts: Vec<(usize, &str)> = sizes.iter().map(|(name, size)| (count(size), *name)).collect();
        counts.sort_by(|a, b| b.cmp(a));
        Measure {
            name: name.to_owned(),
            value: counts.first().map_or(0, |(count, _)| *count),
            limit,
            is_enforced: true,
            details: counts
                .into_iter()
                .filter(|(count, _)| *count > limit)
                .map(|(count, name)| format!("{name}: {count}"))
                .collect(),
        }
    };
    [
        worst("methods of the largest type in web/src", MAX_METHODS, |size| size.methods),
        worst("`impl` blocks of the most scattered type in web/src", MAX_IMPL_BLOCKS, |size| size.blocks),
        Measure {
            name: "fields of `App` that other files reach into".to_owned(),
            value: sizes.get("App").map_or(0, |app| app.shared_fields),
            limit: MAX_SHARED_APP_FIELDS,
            is_enforced: true,
            details: Vec::new(),
        },
    ]
}

fn page_measures(web: &[Product], editor: &[Product]) -> Result<[Measure; 3]> {
    let names = operations::names(editor);
    if names.len() < MIN_OPERATIONS {
        return Err(format!(
            "only {} names of operations were found in crates/editor/src: has `SPEC` changed its form? \
             xtask/src/measures/operations.rs reads it.",
            names.len()
        ));
    }
    let counted = |name: &str, limit: usize, is_enforced: bool, found: Vec<String>| Measure {
        name: name.to_owned(),
        value: found.len(),
        limit,
        is_enforced,
        details: if found.len() > limit { found } else { Vec::new() },
    };
    Ok([
        counted("calls of `self.follow()` in web/src", MAX_FOLLOW_CALLS, true, follow_calls(web)),
        counted("names of operations as text in web/src", 0, true, operations::mentions(web, &names)),
        counted("commands put together as JSON in web/src", 0, true, operations::json_commands(web)),
    ])
}

/// Calls of the method that has the whole page follow the editor: `….follow()` without arguments.
fn follow_calls(files: &[Product]) -> Vec<String> {
    let mut found = Vec::new();
    for file in files {
        for four in file.tokens.windows(4) {
            if let [dot, name, open, close] = four
                && dot.is(".")
                && name.is("follow")
                && open.is("(")
                && close.is(")")
            {
                found.push(format!("{}:{}", file.path.display(), name.line));
            }
        }
    }
    found
}

fn print_lines(crates: &[CrateLines]) {
    println!(
        "Product code: lines of the files in src, tests left out; then lines with more than comments.\n"
    );
    println!("{:<20} {:>7} {:>7}", "crate", "lines", "code");
    for found in crates {
        println!("{:<20} {:>7} {:>7}", found.name, found.lines, found.code_lines);
    }
    let sum = |count: fn(&CrateLines) -> usize| crates.iter().map(count).sum::<usize>();
    println!("{:<20} {:>7} {:>7}", "all", sum(|found| found.lines), sum(|found| found.code_lines));
    println!("{:<20} {:>7}\n", format!("all at {START}"), LINES_AT_START);
}

fn print_measures(measures: &[Measure]) {
    println!("{:<74} {:>6} {:>6}", "measure", "is", "limit");
    for measure in measures {
        let verdict = match (measure.is_met(), measure.is_enforced) {
            (true, _) => "",
            (false, true) => "  FAILED",
            (false, false) => "  not met yet",
        };
        println!("{:<74} {:>6} {:>6}{verdict}", measure.name, measure.value, measure.limit);
        for detail in measure.details.iter().take(MAX_DETAILS) {
            println!("    {detail}");
        }
        if measure.details.len() > MAX_DETAILS {
            println!("    and {} more", measure.details.len() - MAX_DETAILS);
        }
    }
}

const MAX_DETAILS: usize = 12;
