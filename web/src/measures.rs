//! Lengths and areas of the active mesh: what forms suggest for their fields and reckon results with.

use editor::{Changes, Editor};
use surface::measure;

/// Measures of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measures {
    /// The mean length of the edges; 0 where there is none.
    pub mean_edge: f64,
    /// The area of all faces.
    pub area: f64,
    /// The diagonal of the bounding box.
    pub diagonal: f64,
}

/// The measures of the active mesh, taken when they are first asked for after a change.
#[derive(Debug, Default)]
pub struct Measured {
    known: Option<Measures>,
    stale: bool,
}

/// While a mesh larger than this is being dragged, its measures may lag behind: taking them at every
/// movement would be felt.
const SMALL: usize = 20_000;

impl Measured {
    /// Forgets what the active object measured, where it changed or is another.
    pub fn follow(&mut self, editor: &Editor, changes: &Changes) {
        let active = editor.document().active().map(editor::Object::id);
        if changes.document || active.is_some_and(|id| changes.of(id).is_some()) {
            self.stale = true;
        }
    }

    /// The measures; none where there is no mesh. Costs O(mesh) after a change.
    pub fn get(&mut self, editor: &Editor) -> Option<Measures> {
        let mesh = editor.mesh()?;
        let may_lag = editor.is_editing() && mesh.face_count() > SMALL && self.known.is_some();
        if (self.stale || self.known.is_none()) && !may_lag {
            self.known = Some(Measures {
                mean_edge: measure::mean_edge_length(mesh),
                area: measure::surface_area(mesh),
                diagonal: measure::bounding_box(mesh).map_or(0.0, |bounds| bounds.diagonal()),
            });
            self.stale = false;
        }
        self.known
    }
}

/// A length to suggest, with as many digits as anybody would type.
pub fn rounded(length: f64) -> f64 {
    if !length.is_finite() || length <= 0.0 {
        return 0.0;
    }
    let unit = 10_f64.powi(length.log10().floor() as i32 - 3);
    let steps = (length / unit).round();
    // Dividing by a whole power of ten gives the number that is written with these digits.
    if unit < 1.0 { steps / (1.0 / unit).round() } else { steps * unit }
}

#[cfg(test)]
mod tests {
    use super::rounded;

    #[test]
    fn lengths_are_rounded_to_four_digits() {
        let cases = [(0.123456, 0.1235), (2.0, 2.0), (98765.4, 98770.0), (1.23456e-5, 1.235e-5), (0.0, 0.0)];
        for (length, wanted) in cases {
            assert_eq!(rounded(length), wanted);
        }
        assert_eq!(rounded(f64::NAN), 0.0);
        assert_eq!(rounded(-1.0), 0.0);
    }
}
