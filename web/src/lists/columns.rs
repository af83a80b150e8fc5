//! The contents of the rows for each kind of element.

use glam::DVec3;
use halfedge::{Color, Element, Mesh, keys, words};
use std::fmt::Write as _;

/// The alignment of a column's text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Align {
    /// Numbers: right, so that digits line up.
    Right,
    /// Lists of corners: left, cut off where the panel ends.
    Left,
}

/// A column of a list.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// Its heading.
    pub title: &'static str,
    /// The heading's tooltip.
    pub meaning: &'static str,
    /// The width in characters; the last column takes the remaining width.
    pub chars: f32,
    /// The alignment of the text.
    pub align: Align,
}

const fn number(title: &'static str, meaning: &'static str, chars: f32) -> Column {
    Column { title, meaning, chars, align: Align::Right }
}

/// The columns for one kind of element, starting with the id.
pub fn columns(kind: Element) -> &'static [Column] {
    const VERTEX: [Column; 4] = [
        number("Id", "The vertex's id", 7.0),
        number("x", "Position along x", 10.5),
        number("y", "Position along y", 10.5),
        number("z", "Position along z", 10.5),
    ];
    const EDGE: [Column; 3] = [
        number("Id", "The edge's id, e; its half-edges are 2e and 2e + 1", 7.0),
        number("From", "The vertex where the edge's first half-edge starts", 10.5),
        number("To", "The vertex where the edge's first half-edge ends", 10.5),
    ];
    const HALFEDGE: [Column; 5] = [
        number("Id", "The half-edge's id", 7.0),
        number("Next", "The next half-edge around the same face", 8.0),
        number("Twin", "The half-edge on the other side of the same edge", 8.0),
        number("Face", "The face to its left; a dash on the boundary", 8.0),
        number("Vertex", "The vertex it points to", 8.0),
    ];
    const FACE: [Column; 3] = [
        number("Id", "The face's id", 7.0),
        number("Sides", "The number of the face's corners", 6.0),
        Column {
            title: "Corners",
            meaning: "The face's vertices in order, counter-clockwise seen from outside",
            chars: 18.0,
            align: Align::Left,
        },
    ];
    match kind {
        Element::Vertex => &VERTEX,
        Element::Edge => &EDGE,
        Element::Halfedge => &HALFEDGE,
        Element::Face => &FACE,
    }
}

/// The contents of one row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row {
    /// The element's id.
    pub id: u32,
    /// One text per column.
    pub cells: Vec<String>,
    /// The face's colour.
    pub swatch: Option<Color>,
}

impl Row {
    /// The row's values in one line, for the accessibility tree.
    pub fn value(&self, kind: Element) -> String {
        let mut text = String::new();
        for (column, cell) in columns(kind).iter().zip(&self.cells).skip(1) {
            if !text.is_empty() {
                text.push_str(", ");
            }
            // Writing to a string can't fail.
            let _ = write!(text, "{} {cell}", column.title.to_lowercase());
        }
        if let Some(color) = self.swatch {
            let _ = write!(text, ", colour {}", color.to_hex());
        }
        text
    }
}

/// The largest number of corners listed in a row; a face can have millions.
const MAX_LISTED_CORNERS: usize = 24;

/// The row of an element; none if it doesn't exist. Adding the document's offset gives the coordinates of
/// the file.
pub fn row(mesh: &Mesh, kind: Element, id: u32, offset: DVec3) -> Option<Row> {
    let mut cells = vec![id.to_string()];
    let mut swatch = None;
    match kind {
        Element::Vertex => {
            let position = mesh.position(mesh.vertex(id)?);
            if offset == DVec3::ZERO {
                cells.extend(position.to_array().map(coordinate));
            } else {
                let far = position.as_dvec3() + offset;
                cells.extend(far.to_array().map(|value| format!("{value:.2}")));
            }
        }
        Element::Edge => cells.extend(mesh.ends(mesh.edge(id)?).map(|v| v.raw().to_string())),
        Element::Halfedge => {
            let h = mesh.halfedge(id)?;
            let face = mesh.face_of(h).map_or_else(|| "–".to_owned(), |f| f.raw().to_string());
            cells.push(mesh.next(h).raw().to_string());
            cells.push(h.twin().raw().to_string());
            cells.push(face);
            cells.push(mesh.to(h).raw().to_string());
        }
        Element::Face => {
            let f = mesh.face(id)?;
            let mut corners = String::new();
            let mut sides = 0;
            for v in mesh.face_vertices(f) {
                if sides < MAX_LISTED_CORNERS {
                    let gap = if sides == 0 { "" } else { " " };
                    let _ = write!(corners, "{gap}{}", v.raw());
                } else if sides == MAX_LISTED_CORNERS {
                    corners.push_str(" …");
                }
                sides += 1;
            }
            cells.push(sides.to_string());
            cells.push(corners);
            swatch = Some(mesh.get(keys::FACE_COLOR, f.index()));
        }
    }
    Some(Row { id, cells, swatch })
}

/// A coordinate in at most ten characters. The inspector shows all digits.
pub fn coordinate(value: f32) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-4..1e6).contains(&size) {
        return format!("{value:.3e}");
    }
    let decimals = match size {
        s if s < 100.0 => 5,
        s if s < 10_000.0 => 3,
        _ => 1,
    };
    let text = format!("{value:.decimals$}");
    // "-0.00000" looks like a small negative number.
    if value == 0.0 { text.trim_start_matches('-').to_owned() } else { text }
}

/// The name of an element in lists, tooltips and the accessibility tree: "Vertex 12".
pub fn element_name(kind: Element, id: u32) -> String {
    let word = match kind {
        Element::Vertex => "Vertex",
        Element::Edge => "Edge",
        Element::Halfedge => "Half-edge",
        Element::Face => "Face",
    };
    format!("{word} {id}")
}

/// The plural of a kind: "Vertices".
pub fn plural(kind: Element) -> &'static str {
    match kind {
        Element::Vertex => "Vertices",
        Element::Edge => "Edges",
        Element::Halfedge => "Half-edges",
        Element::Face => "Faces",
    }
}

/// A count with its noun: "1 vertex", "3 half-edges".
pub fn counted(kind: Element, count: usize) -> String {
    words::counted(count, &kind.to_string(), kind.plural())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_fit_their_column() {
        for value in [0.0, -0.0, 1.5, -99.999_99, 1234.5678, -999_999.0, 1e6, -1.5e-30, f32::MAX, f32::MIN] {
            assert!(coordinate(value).len() <= 10, "{value}: {}", coordinate(value));
        }
        assert_eq!(coordinate(-0.0), "0.00000");
        assert_eq!(coordinate(0.5), "0.50000");
        assert_eq!(coordinate(-1234.5), "-1234.500");
        assert_eq!(coordinate(0.00001), "1.000e-5");
    }

    #[test]
    fn counts_agree_with_their_noun() {
        assert_eq!(counted(Element::Vertex, 1), "1 vertex");
        assert_eq!(counted(Element::Halfedge, 2), "2 half-edges");
        assert_eq!(counted(Element::Face, 0), "0 faces");
    }
}
