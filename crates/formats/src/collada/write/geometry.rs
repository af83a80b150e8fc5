//! Writing geometries.

use super::escape::escape;
use super::material::Materials;
use crate::soup::hash::Unique;
use crate::text::print::{push_float, push_integer};
use glam::DVec3;
use halfedge::attribute::{AttributeType, Key};
use halfedge::{Color, Element, HalfedgeId, Mesh, NONE, keys};

/// Writes a geometry, and returns the numbers of the materials that it uses.
pub(super) fn write(
    out: &mut Vec<u8>,
    number: usize,
    name: &str,
    mesh: &Mesh,
    offset: DVec3,
    materials: &mut Materials,
) -> Vec<usize> {
    let id = format!("mesh{number}");
    out.extend_from_slice(format!("<geometry id=\"{id}\" name=\"{}\"><mesh>\n", escape(name)).as_bytes());
    let positions = format!("{id}-positions");
    if offset == DVec3::ZERO {
        source(out, &positions, "X Y Z", mesh.positions().iter().map(|p| p.to_array()));
    } else {
        source(out, &positions, "X Y Z", mesh.positions().iter().map(|p| (p.as_dvec3() + offset).to_array()));
    }
    let normals =
        corner_source(out, &format!("{id}-normals"), "X Y Z", mesh, keys::CORNER_NORMAL, |n| n.to_array());
    let uvs = corner_source(out, &format!("{id}-uvs"), "S T", mesh, keys::CORNER_UV, |uv| uv.to_array());
    let colors = VertexColors::write(out, &id, mesh);
    let vertex_colors = match colors {
        VertexColors::All => format!("<input semantic=\"COLOR\" source=\"#{id}-colors\"/>"),
        _ => String::new(),
    };
    out.extend_from_slice(
        format!(
            "<vertices id=\"{id}-vertices\"><input semantic=\"POSITION\" source=\"#{id}-positions\"/>{vertex_colors}\
             </vertices>\n"
        )
        .as_bytes(),
    );
    // Faces keep their order: a new list starts where the material changes, or the attributes that corners
    // have.
    let labels =
        mesh.column(Element::Face, keys::FACE_MATERIAL.name).map_or(&[][..], |column| &column.labels);
    let paint = mesh.attribute(keys::FACE_COLOR);
    let mut runs: Vec<Run> = Vec::new();
    let mut corner = 0;
    for f in mesh.faces() {
        let label = labels.get(mesh.get(keys::FACE_MATERIAL, f.index()) as usize).map_or("", String::as_str);
        let color = paint.and_then(|colors| colors.get(f.index())).copied();
        let plain = label.is_empty() && color.is_none_or(|color| color == Color::UNPAINTED);
        let degree = mesh.face_degree(f);
        let has = |numbers: &[u32]| numbers.get(corner).is_some_and(|&number| number != NONE);
        let run = Run {
            material: (!plain).then(|| materials.number(label, color)),
            normals: has(&normals),
            uvs: has(&uvs),
            colors: colors == VertexColors::Some
                && mesh.face_vertices(f).all(|v| !mesh.get(keys::VERTEX_COLOR, v.index()).is_nan()),
            first_face: f.index(),
            first_corner: corner,
        };
        if runs.last().is_none_or(|last| !last.continues_with(&run)) {
            runs.push(run);
        }
        corner += degree;
    }
    for (i, run) in runs.iter().enumerate() {
        let end = runs.get(i + 1).map_or(mesh.face_count(), |next| next.first_face);
        polylist(out, &id, mesh, run, end, &normals, &uvs);
    }
    out.extend_from_slice(b"</mesh></geometry>\n");
    let mut used: Vec<usize> = runs.iter().filter_map(|run| run.material).collect();
    used.sort_unstable();
    used.dedup();
    used
}

/// Which vertices have colours.
#[derive(Clone, Copy, PartialEq)]
enum VertexColors {
    None,
    /// Given where faces refer to vertices, for faces whose vertices all have one.
    Some,
    /// Given with the vertices.
    All,
}

impl VertexColors {
    /// Writes the source of the colours; a vertex without one is white in it.
    fn write(out: &mut Vec<u8>, id: &str, mesh: &Mesh) -> Self {
        let color = |v: usize| mesh.get(keys::VERTEX_COLOR, v);
        let count = (0..mesh.vertex_count()).filter(|&v| !color(v).is_nan()).count();
        if count == 0 {
            return Self::None;
        }
        let rows = (0..mesh.vertex_count()).map(|v| {
            let color = color(v);
            if color.is_nan() { [1.0; 3] } else { color.to_array() }
        });
        source(out, &format!("{id}-colors"), "R G B", rows);
        if count == mesh.vertex_count() { Self::All } else { Self::Some }
    }
}

/// Consecutive faces that share a list.
struct Run {
    material: Option<usize>,
    normals: bool,
    uvs: bool,
    /// Whether the colours of vertices are given here.
    colors: bool,
    first_face: usize,
    first_corner: usize,
}

impl Run {
    fn continues_with(&self, other: &Self) -> bool {
        let kind = |run: &Self| (run.material, run.normals, run.uvs, run.colors);
        kind(self) == kind(other)
    }
}

/// Writes the faces from those of `run` up to `end`.
fn polylist(out: &mut Vec<u8>, id: &str, mesh: &Mesh, run: &Run, end: usize, normals: &[u32], uvs: &[u32]) {
    let material = run.material.map_or(String::new(), |material| format!(" material=\"material{material}\""));
    let mut head = format!(
        "<polylist count=\"{}\"{material}><input semantic=\"VERTEX\" source=\"#{id}-vertices\" offset=\"0\"/>",
        end - run.first_face
    );
    if run.colors {
        head += &format!("<input semantic=\"COLOR\" source=\"#{id}-colors\" offset=\"0\" set=\"0\"/>");
    }
    let mut offset = 1;
    for (is_there, semantic, part) in [(run.normals, "NORMAL", "normals"), (run.uvs, "TEXCOORD", "uvs")] {
        if is_there {
            head += &format!("<input semantic=\"{semantic}\" source=\"#{id}-{part}\" offset=\"{offset}\"/>");
            offset += 1;
        }
    }
    out.extend_from_slice(head.as_bytes());
    let faces = || (run.first_face..end).map(halfedge::FaceId::new);
    out.extend_from_slice(b"<vcount>");
    for f in faces() {
        push_integer(out, mesh.face_degree(f) as u64);
        out.push(b' ');
    }
    out.extend_from_slice(b"</vcount><p>");
    for (corner, v) in (run.first_corner..).zip(faces().flat_map(|f| mesh.face_vertices(f))) {
        push_integer(out, u64::from(v.raw()));
        out.push(b' ');
        for (is_there, numbers) in [(run.normals, normals), (run.uvs, uvs)] {
            if let Some(&number) = numbers.get(corner).filter(|_| is_there) {
                push_integer(out, u64::from(number));
                out.push(b' ');
            }
        }
    }
    out.extend_from_slice(b"</p></polylist>\n");
}

/// Writes a source with these parameters, one for each number of a row.
fn source<F: zmij::Float, const N: usize>(
    out: &mut Vec<u8>,
    id: &str,
    params: &str,
    rows: impl ExactSizeIterator<Item = [F; N]>,
) {
    let count = rows.len();
    out.extend_from_slice(
        format!("<source id=\"{id}\"><float_array id=\"{id}-array\" count=\"{}\">", count * N).as_bytes(),
    );
    for value in rows.flatten() {
        push_float(out, value);
        out.push(b' ');
    }
    let params: String = params.split(' ').map(|p| format!("<param name=\"{p}\" type=\"float\"/>")).collect();
    out.extend_from_slice(
        format!(
            "</float_array><technique_common><accessor source=\"#{id}-array\" count=\"{count}\" stride=\"{N}\">{params}\
             </accessor></technique_common></source>\n"
        )
        .as_bytes(),
    );
}

/// Writes the different values of a corner column as a source, and returns each corner's number, faces
/// in order; those of faces without values have none. A face's corners all have a number or none does: where
/// some values are missing, a row of NaN stands for them. No numbers where no corner has a value.
fn corner_source<T: AttributeType, const N: usize>(
    out: &mut Vec<u8>,
    id: &str,
    params: &str,
    mesh: &Mesh,
    key: Key<T>,
    array: impl Fn(T) -> [f32; N],
) -> Vec<u32> {
    let Some(column) = mesh.attribute(key) else { return Vec::new() };
    let mut unique = Unique::new();
    let mut rows: Vec<[f32; N]> = Vec::new();
    let mut numbers: Vec<u32> = Vec::new();
    for f in mesh.faces() {
        let value = |h: HalfedgeId| {
            let value = array(column.get(h.index()).copied().unwrap_or(key.default));
            if value.iter().any(|c| c.is_nan()) { [f32::NAN; N] } else { value }
        };
        let is_missing = |h: HalfedgeId| value(h).iter().any(|c| c.is_nan());
        let has_value = mesh.face_halfedges(f).any(|h| !is_missing(h));
        numbers.extend(mesh.face_halfedges(f).map(|h| {
            if !has_value {
                return NONE;
            }
            let value = value(h);
            let (number, is_new) = unique.number(value);
            if is_new {
                rows.push(value);
            }
            number
        }));
    }
    if rows.is_empty() {
        return Vec::new();
    }
    source(out, id, params, rows.into_iter());
    numbers
}
