//! What each crate adds to a WebAssembly module, by the names of its functions.

use std::collections::HashMap;
use std::ops::Range;

use wasmparser::{KnownCustom, Name, Parser, Payload};

use crate::shell::Result;

/// The section with the names of functions, by which the weights are found. Browsers don't need it.
const NAMES: &str = "name";

/// What the bytes of a module are for, the largest share first.
pub fn by_crate(module: &[u8]) -> Result<Vec<(String, usize)>> {
    let broken = |error: wasmparser::BinaryReaderError| format!("the module can't be read: {error}.");
    let bytes_in = |range: &Range<u64>| (range.end - range.start) as usize;
    let (mut imported, mut bodies, mut names) = (0, Vec::new(), HashMap::new());
    let (mut data, mut section_of_names) = (0, 0);
    for payload in Parser::new(0).parse_all(module) {
        match payload.map_err(broken)? {
            Payload::ImportSection(imports) => {
                for import in imports.into_imports() {
                    imported += u32::from(matches!(import.map_err(broken)?.ty, wasmparser::TypeRef::Func(_)));
                }
            }
            Payload::CodeSectionEntry(body) => bodies.push(bytes_in(&body.range())),
            Payload::DataSection(section) => data = bytes_in(&section.range()),
            Payload::CustomSection(section) => {
                if let KnownCustom::Name(subsections) = section.as_known() {
                    section_of_names = bytes_in(&section.range());
                    for subsection in subsections {
                        if let Name::Function(functions) = subsection.map_err(broken)? {
                            for naming in functions {
                                let naming = naming.map_err(broken)?;
                                names.insert(naming.index, naming.name);
                            }
                        }
                    }
                }
            }
            _ => {}
        }
    }
    let mut weights: HashMap<String, usize> = HashMap::new();
    for (index, size) in (imported..).zip(&bodies) {
        let owner = names.get(&index).map_or("code without a name", |name| crate_of(name));
        *weights.entry(owner.to_owned()).or_default() += size;
    }
    weights.insert("constants: fonts, texts, tables".to_owned(), data);
    let counted = bodies.iter().sum::<usize>() + data + section_of_names;
    weights.insert("types, imports and other sections".to_owned(), module.len().saturating_sub(counted));
    let mut weights: Vec<_> = weights.into_iter().collect();
    weights.sort_by(|(name_a, a), (name_b, b)| b.cmp(a).then_with(|| name_a.cmp(name_b)));
    Ok(weights)
}

/// A module without the names of its functions.
pub fn without_names(module: &[u8]) -> Result<Vec<u8>> {
    let mut kept = Vec::with_capacity(module.len());
    // Each section ends where the next one, or rather its header, begins.
    let (mut from, mut to) = (0, 0);
    for payload in Parser::new(0).parse_all(module) {
        let payload = payload.map_err(|error| format!("the module can't be read: {error}."))?;
        let Some((_, range)) = payload.as_section() else { continue };
        let end = range.end as usize;
        if matches!(&payload, Payload::CustomSection(section) if section.name() == NAMES) {
            kept.extend_from_slice(module.get(from..to).unwrap_or_default());
            from = end;
        }
        to = end;
    }
    kept.extend_from_slice(module.get(from..).unwrap_or_default());
    Ok(kept)
}

/// The crate that a function is of: what is instantiated of the standard library counts for the crate that it is for.
fn crate_of(function: &str) -> &str {
    const STANDARD: [&str; 5] = ["core", "alloc", "std", "hashbrown", "compiler_builtins"];
    let words = function.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'));
    let mut crates = words.filter_map(|word| {
        let (first, _) =
            word.split_once("::").filter(|(first, rest)| !first.is_empty() && !rest.is_empty())?;
        first.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_').then_some(first)
    });
    let first = crates.clone().next();
    crates.find(|name| !STANDARD.contains(name)).or(first).unwrap_or("code of no crate")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_belong_to_crates() {
        for (function, wanted) in [
            ("egui::context::Context::read::h0123456789abcdef", "egui"),
            ("<egui::Ui as core::fmt::Debug>::fmt::h1", "egui"),
            ("core::ptr::drop_in_place<alloc::vec::Vec<wgpu_core::device::Device>>::h1", "wgpu_core"),
            ("<alloc::vec::Vec<T,A> as core::ops::drop::Drop>::drop::h1", "alloc"),
            ("<&mut serde_json::de::Deserializer<R> as serde::de::Deserializer>::x", "serde_json"),
            ("__wbindgen_malloc", "code of no crate"),
        ] {
            assert_eq!(crate_of(function), wanted, "{function}");
        }
    }

    /// A module with one function, `name`, whose body has eight bytes.
    fn module(name: &str) -> Vec<u8> {
        let section = |id: u8, contents: &[u8]| {
            let mut bytes = vec![id, contents.len() as u8];
            bytes.extend_from_slice(contents);
            bytes
        };
        let text = |text: &str| [&[text.len() as u8], text.as_bytes()].concat();
        let names = [vec![1, 0], text(name)].concat();
        let names = [text("name"), section(1, &names)].concat();
        [
            b"\0asm\x01\0\0\0".to_vec(),
            section(1, &[1, 0x60, 0, 0]),
            section(3, &[1, 0]),
            section(10, &[1, 8, 0, 1, 1, 1, 1, 1, 1, 0x0b]),
            section(0, &names),
        ]
        .concat()
    }

    #[test]
    fn bytes_are_counted_and_names_removed() {
        let whole = module("egui::ui::Ui::label");
        let weights = by_crate(&whole).expect("a module");
        assert!(weights.contains(&("egui".to_owned(), 8)), "{weights:?}");
        let bare = without_names(&whole).expect("a module");
        let names_end = "egui::ui::Ui::label".len() + 1 + 2 + 2 + 5 + 2;
        assert_eq!(bare, whole[..whole.len() - names_end]);
        assert_eq!(without_names(&bare).expect("a module"), bare);
        let weights = by_crate(&bare).expect("a module");
        assert!(weights.contains(&("code without a name".to_owned(), 8)), "{weights:?}");
        assert!(by_crate(b"no module").is_err());
    }
}
