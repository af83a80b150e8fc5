//! What could not be read of an OBJ, or has no meaning here.

use crate::report::{ImportReport, Places, counted_words};

/// The places of faults and of what is left out, by line.
#[derive(Default)]
pub(super) struct Troubles {
    pub bad_vertices: Places,
    pub bad_uvs: Places,
    pub bad_normals: Places,
    pub bad_faces: Places,
    pub small_faces: Places,
    pub missing_vertex: Places,
    pub missing_attribute: Places,
    pub fourth_coordinate: Places,
    pub third_texture_coordinate: Places,
    pub bad_smoothing: Places,
    pub lines_and_points: Places,
    pub unknown: Places,
    unused: Places,
    /// The words of unused statements, with how often each comes.
    unused_words: Vec<(&'static str, usize)>,
}

impl Troubles {
    /// Adds a statement that has no meaning here.
    pub(super) fn add_unused(&mut self, word: &'static str, line: usize) {
        self.unused.add(line);
        match self.unused_words.iter_mut().find(|(known, _)| *known == word) {
            Some((_, count)) => *count += 1,
            None => self.unused_words.push((word, 1)),
        }
    }

    /// Adds a note for each kind.
    pub(super) fn report(&self, report: &mut ImportReport) {
        let faults = [
            (
                &self.bad_vertices,
                "vertex",
                "vertices",
                "put at the origin: a vertex is \"v\" and three numbers, a fourth (w) or a colour of three may follow",
            ),
            (
                &self.bad_faces,
                "face",
                "faces",
                "left out: a corner can't be read as vertex numbers, like 1 or 1/2/3",
            ),
            (&self.small_faces, "face", "faces", "left out: a face needs three corners or more"),
            (
                &self.missing_vertex,
                "face",
                "faces",
                "left out: a corner refers to a vertex that doesn't exist",
            ),
            (
                &self.missing_attribute,
                "corner",
                "corners",
                "without texture coordinate or normal: the one it refers to doesn't exist",
            ),
            (&self.bad_uvs, "texture coordinate", "texture coordinates", "ignored: not one to three numbers"),
            (&self.bad_normals, "normal", "normals", "ignored: not three numbers"),
            (
                &self.bad_smoothing,
                "smoothing group",
                "smoothing groups",
                "ignored: neither a number nor \"off\"",
            ),
            (
                &self.fourth_coordinate,
                "vertex",
                "vertices",
                "kept as x, y, z: the fourth coordinate (w) is not used",
            ),
            (
                &self.third_texture_coordinate,
                "texture coordinate",
                "texture coordinates",
                "kept as u, v: the third coordinate (w) is not used",
            ),
            (
                &self.lines_and_points,
                "line or point element (l, p)",
                "line or point elements (l, p)",
                "left out: only faces are edited here",
            ),
        ];
        for (places, one, many, what) in faults {
            if !places.is_empty() {
                report.warn(places.sentence(one, many, what, "line"));
            }
        }
        let words = self.unused_words.iter().flat_map(|&(word, count)| std::iter::repeat_n(word, count));
        if let Some(words) = counted_words(words) {
            let what = format!(
                "left out: free-form curves and surfaces and display settings are not used here: {words}"
            );
            report.warn(self.unused.sentence("statement", "statements", &what, "line"));
        }
        if !self.unknown.is_empty() {
            let what = "ignored: it doesn't start with a word of the OBJ format";
            report.warn(self.unknown.sentence("line", "lines", what, "line"));
        }
    }
}
