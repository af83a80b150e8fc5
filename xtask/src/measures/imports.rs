//! Which file of a crate needs which other: what its `use` declarations and paths name, followed through re-exports to
//! the file that defines it.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use super::source::{Product, children_folder};
use super::tokens::Token;

/// Re-exports of re-exports are followed this far; a crate that needs more goes round in a circle.
const MAX_REEXPORTS: usize = 16;

const DEFINING: [&str; 9] =
    ["fn", "struct", "enum", "union", "trait", "type", "const", "static", "macro_rules"];

/// For each of a crate's files, the others that it needs. `root` is the folder of its `lib.rs`.
pub fn imports(files: &[Product], root: &Path) -> Vec<BTreeSet<usize>> {
    let tree = Tree::new(files, root);
    files
        .iter()
        .enumerate()
        .map(|(file, _)| {
            let mut needed: BTreeSet<usize> = tree.references(file).into_iter().collect();
            needed.remove(&file);
            needed
        })
        .collect()
}

/// A name that a `use` declaration brings in, with the path that it stands for; `*` for all names of a module.
struct Import<'a> {
    name: &'a str,
    path: Vec<&'a str>,
}

struct Tree<'a> {
    files: &'a [Product<'a>],
    /// Each module's file, by the path that its children lie in.
    modules: BTreeMap<PathBuf, usize>,
    folders: Vec<PathBuf>,
    roots: Vec<usize>,
    imports: Vec<Vec<Import<'a>>>,
    defined: Vec<BTreeSet<&'a str>>,
}

impl<'a> Tree<'a> {
    fn new(files: &'a [Product<'a>], root: &Path) -> Self {
        let folders: Vec<PathBuf> = files.iter().map(|file| children_folder(file.path)).collect();
        // `lib.rs` and `main.rs` are both the root of a crate; the library comes first.
        let roots =
            (0..files.len()).filter(|&file| folders.get(file).is_some_and(|folder| folder == root)).collect();
        let mut modules = BTreeMap::new();
        for (file, folder) in folders.iter().enumerate() {
            modules.entry(folder.clone()).or_insert(file);
        }
        let imports = files.iter().map(|file| imports_of(&file.tokens)).collect();
        let defined = files.iter().map(|file| definitions(&file.tokens)).collect();
        Self { files, modules, folders, roots, imports, defined }
    }

    fn child(&self, module: usize, name: &str) -> Option<usize> {
        self.modules.get(&self.folders.get(module)?.join(name)).copied().filter(|&child| child != module)
    }

    fn parent(&self, module: usize) -> Option<usize> {
        self.modules.get(self.folders.get(module)?.parent()?).copied()
    }

    fn references(&self, file: usize) -> Vec<usize> {
        let imported = self.imports.get(file).into_iter().flatten().map(|import| import.path.clone());
        let written = self.files.get(file).map(|product| paths(&product.tokens)).unwrap_or_default();
        imported.chain(written).filter_map(|path| self.resolve(file, &path, MAX_REEXPORTS)).collect()
    }

    /// The file that defines what a path means in a module; `None` for what other crates define.
    fn resolve(&self, module: usize, path: &[&str], reexports: usize) -> Option<usize> {
        let mut at = module;
        let mut path = path;
        match path.first() {
            Some(&"crate") => at = self.root_of(module)?,
            Some(&"self") => {}
            Some(&"super") => at = self.parent(module)?,
            Some(name) => {
                // A name without a prefix is a child module, something imported, or another crate.
                return self.follow(at, name, path.get(1..).unwrap_or_default(), reexports);
            }
            None => return None,
        }
        path = path.get(1..).unwrap_or_default();
        while let Some(&"super") = path.first() {
            at = self.parent(at)?;
            path = path.get(1..).unwrap_or_default();
        }
        self.within(at, path, reexports)
    }

    fn root_of(&self, module: usize) -> Option<usize> {
        self.roots.iter().copied().find(|&root| root == module).or_else(|| self.roots.first().copied())
    }

    /// What a path means inside a module; the module itself where it defines it or nobody can tell.
    fn within(&self, module: usize, path: &[&str], reexports: usize) -> Option<usize> {
        let Some((name, rest)) = path.split_first() else { return Some(module) };
        if *name == "*" {
            return Some(module);
        }
        self.follow(module, name, rest, reexports).or(Some(module))
    }

    /// What `name::rest` means in a module, where it is not defined there itself.
    fn follow(&self, module: usize, name: &str, rest: &[&str], reexports: usize) -> Option<usize> {
        if let Some(child) = self.child(module, name) {
            return self.within(child, rest, reexports);
        }
        if self.defined.get(module)?.contains(name) {
            return Some(module);
        }
        let reexports = reexports.checked_sub(1)?;
        let imports = self.imports.get(module)?;
        for import in imports.iter().filter(|import| import.name == name) {
            let path: Vec<&str> = import.path.iter().copied().chain(rest.iter().copied()).collect();
            if let Some(found) = self.resolve(module, &path, reexports) {
                return Some(found);
            }
        }
        imports.iter().filter(|import| import.name == "*").find_map(|import| {
            let folder = self.resolve(module, &import.path, reexports)?;
            if folder == module {
                return None;
            }
            self.follow(folder, name, rest, reexports)
        })
    }
}

/// The names that a file defines outside all braces, macros without their `!`.
fn definitions<'a>(tokens: &[Token<'a>]) -> BTreeSet<&'a str> {
    let mut depth = 0_usize;
    let mut names = BTreeSet::new();
    for (at, token) in tokens.iter().enumerate() {
        depth += usize::from(token.is("{"));
        depth = depth.saturating_sub(usize::from(token.is("}")));
        if depth == 0 && DEFINING.iter().any(|keyword| token.is(keyword)) {
            let name = tokens.iter().skip(at + 1).find(|token| !token.is("!"));
            names.extend(name.filter(|name| name.is_word()).map(|name| name.text));
        }
    }
    names
}

/// What a file's `use` declarations bring in, wherever in the file they stand.
fn imports_of<'a>(tokens: &[Token<'a>]) -> Vec<Import<'a>> {
    let mut imports = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        // `impl Trait + use<'a>` is no import.
        if token.is("use") && !tokens.get(at + 1).is_some_and(|next| next.is("<")) {
            UseTree { tokens, at: at + 1, imports: &mut imports }.read(&[]);
        }
    }
    imports
}

struct UseTree<'a, 'b> {
    tokens: &'b [Token<'a>],
    at: usize,
    imports: &'b mut Vec<Import<'a>>,
}

impl<'a> UseTree<'a, '_> {
    fn peek(&self) -> Option<Token<'a>> {
        self.tokens.get(self.at).copied()
    }

    /// One tree: `a::b`, `a::b as c`, `a::*` or `a::{…}`, below a prefix.
    fn read(&mut self, prefix: &[&'a str]) {
        let mut path = prefix.to_vec();
        while let Some(token) = self.peek() {
            self.at += 1;
            if token.is("{") {
                return self.read_group(&path);
            } else if token.is("*") {
                path.push("*");
                return self.imports.push(Import { name: "*", path });
            } else if token.is("as") {
                let name = self.peek().map_or("_", |name| name.text);
                self.at += 1;
                return self.push(path, Some(name));
            } else if token.is_word() {
                path.push(token.text);
            } else if !token.is(":") {
                // The comma, brace or semicolon that ends the tree is read by the one around it.
                self.at -= 1;
                break;
            }
        }
        self.push(path, None);
    }

    fn read_group(&mut self, prefix: &[&'a str]) {
        while let Some(token) = self.peek() {
            if token.is("}") {
                self.at += 1;
                return;
            } else if token.is(",") {
                self.at += 1;
            } else {
                let before = self.at;
                self.read(prefix);
                if self.at == before {
                    return;
                }
            }
        }
    }

    fn push(&mut self, mut path: Vec<&'a str>, name: Option<&'a str>) {
        // `use a::{self}` is `use a`.
        if path.len() > 1 && path.last() == Some(&"self") {
            path.pop();
        }
        if let Some(name) = name.or(path.last().copied()) {
            self.imports.push(Import { name, path });
        }
    }
}

/// The paths of two and more names in a file's code, outside `use` declarations.
fn paths<'a>(tokens: &[Token<'a>]) -> Vec<Vec<&'a str>> {
    let mut paths = Vec::new();
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        if token.is("use") {
            at += tokens.iter().skip(at).take_while(|token| !token.is(";")).count();
        } else if token.is_word() {
            let mut path = vec![token.text];
            while let [colon, second, name, ..] = tokens.get(at + 1..).unwrap_or_default()
                && colon.is(":")
                && second.is(":")
                && name.is_word()
            {
                path.push(name.text);
                at += 3;
            }
            if path.len() > 1 {
                paths.push(path);
            }
        }
        at += 1;
    }
    paths
}

#[cfg(test)]
mod tests {
    use super::super::source::Source;
    use super::*;

    /// The edges of a crate as `from to` lines, files without their folder and extension.
    fn edges(files: &[(&str, &str)]) -> Vec<String> {
        let sources: Vec<Source> =
            files.iter().map(|(path, text)| Source::new(&format!("src/{path}"), text)).collect();
        let products: Vec<Product> = sources.iter().map(Source::product).collect();
        let name = |file: usize| files[file].0.trim_end_matches(".rs").trim_end_matches("/mod").to_owned();
        let edges = imports(&products, Path::new("src"));
        edges
            .iter()
            .enumerate()
            .flat_map(|(from, needed)| needed.iter().map(move |&to| (from, to)))
            .map(|(from, to)| format!("{} {}", name(from), name(to)))
            .collect()
    }

    #[test]
    fn declaring_a_module_needs_nothing_of_it() {
        assert_eq!(edges(&[("lib.rs", "mod a;"), ("a.rs", "use crate::B; fn f() {}")]), ["a lib"]);
    }

    #[test]
    fn groups_renames_and_globs_are_read() {
        let files = [
            ("lib.rs", "mod a; mod b; mod c; mod d;"),
            ("a.rs", "use crate::{b::{self, X as Y}, c::*, std::z};\nuse super::d::{E};"),
            ("b.rs", "pub struct X;"),
            ("c.rs", "pub struct Z;"),
            ("d.rs", "pub enum E {}"),
        ];
        assert_eq!(edges(&files), ["a lib", "a b", "a c", "a d"]);
    }

    #[test]
    fn a_reexport_is_followed_to_the_definition() {
        let files = [
            ("lib.rs", "mod a; mod b; mod user; pub use a::{Thing, Other as Renamed}; pub use b::*;"),
            ("a/mod.rs", "mod deep; pub use deep::Thing; pub struct Other;"),
            ("a/deep.rs", "pub struct Thing;"),
            ("b.rs", "pub fn act() {}"),
            ("user.rs", "use crate::{Renamed, Thing, act};"),
        ];
        let edges = edges(&files);
        let of_user: Vec<_> = edges.iter().filter(|edge| edge.starts_with("user")).collect();
        assert_eq!(of_user, ["user a", "user a/deep", "user b"]);
    }

    #[test]
    fn paths_in_code_count_and_other_crates_do_not() {
        let files = [
            ("lib.rs", "mod a; mod b;"),
            (
                "a/mod.rs",
                "mod inner; use std::fmt; fn f() { inner::g(); crate::b::h::<u8>(); fmt::write(); }",
            ),
            ("a/inner.rs", "pub fn g() { super::f(); \"crate::b::h\" }"),
            ("b.rs", "// use crate::a;\npub fn h<T>() {}"),
        ];
        assert_eq!(edges(&files), ["a a/inner", "a b", "a/inner a"]);
    }

    #[test]
    fn an_imported_module_is_followed_where_it_is_used() {
        let files = [
            ("lib.rs", "mod a; mod folder;"),
            ("a.rs", "use crate::folder; fn f() { folder::leaf::g(); }"),
            ("folder/mod.rs", "pub mod leaf;"),
            ("folder/leaf.rs", "pub fn g() {}"),
        ];
        assert_eq!(edges(&files), ["a folder", "a folder/leaf"]);
    }

    #[test]
    fn names_that_lead_nowhere_end() {
        let files = [
            ("lib.rs", "mod a; pub use a::*; pub use self::x::y;"),
            ("a.rs", "pub use crate::*; use crate::Gone;"),
        ];
        assert_eq!(edges(&files), ["lib a", "a lib"]);
    }
}
