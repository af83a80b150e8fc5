//! Statements of material libraries.

use super::texture::TEXTURES;
use crate::model::material::{Material, MtlStatements};
use crate::report::counted_words;

/// The word that a statement begins with, and the rest.
pub(super) fn first_word(line: &str) -> (&str, &str) {
    line.split_once(char::is_whitespace).map_or((line, ""), |(word, rest)| (word, rest.trim()))
}

/// Whether `tobj` takes a statement, and its values are finite.
pub(super) fn is_readable(word: &str, rest: &str) -> bool {
    let has_numbers = |count: usize| {
        let is_number = |word: &&str| word.parse::<f32>().is_ok_and(f32::is_finite);
        rest.split_whitespace().take(count).filter(is_number).count() == count
    };
    match word {
        "Ka" | "Kd" | "Ks" | "Ke" => has_numbers(3),
        "Ns" | "Ni" | "d" | "Tr" | "Pr" | "Pm" => has_numbers(1),
        "illum" => rest.split_whitespace().next().is_some_and(|word| word.parse::<u8>().is_ok()),
        word if TEXTURES.iter().any(|(texture, _)| *texture == word) => !rest.is_empty(),
        _ => true,
    }
}

/// The words of statements that fill no field of a material.
pub(crate) fn other_statements(mtl: &MtlStatements) -> impl Iterator<Item = &str> {
    const FIELDS: [&str; 10] = ["Ka", "Kd", "Ks", "Ke", "Ns", "Ni", "d", "Tr", "Pm", "Pr"];
    let is_field =
        |word: &str| FIELDS.contains(&word) || TEXTURES.iter().any(|(texture, _)| *texture == word);
    mtl.others
        .lines()
        .map(first_word)
        .filter(move |(word, rest)| !is_field(word) || !is_readable(word, rest))
        .map(|(word, _)| word)
}

/// The words that statements of materials begin with besides `Kd`, each with how many of them there are:
/// "Ks (3), map_Kd (1)"; none where there are no statements.
pub(crate) fn statement_counts<'a>(materials: impl Iterator<Item = &'a Material>) -> Option<String> {
    let statements = materials.filter_map(|material| material.mtl.as_ref());
    let words = statements.flat_map(|mtl| mtl.others.lines()).map(|line| first_word(line).0);
    counted_words(words)
}
