//! Semi-sharp creases and corners by OpenSubdiv's uniform rule.
//!
//! DeRose, Kass, Truong: Subdivision surfaces in character animation (1998). An edge of sharpness s follows
//! the crease rule for s levels; each level subtracts 1. Where a fraction is left, the points of the crease
//! rule and of the smooth rule are mixed by it.

use super::{BoundaryRule, Level};
use glam::DVec3;
use halfedge::attribute::{Column, keys};
use halfedge::{Element, Mesh, NONE, RawMesh};

/// Creases of this sharpness and more never soften.
const INFINITE_SHARPNESS: f32 = 10.0;

/// The sharpness of the children of an edge or vertex.
fn soften(sharpness: f32) -> f32 {
    if sharpness >= INFINITE_SHARPNESS {
        sharpness
    } else if sharpness > 1.0 {
        sharpness - 1.0
    } else {
        0.0
    }
}

/// The sharpness per edge and per vertex; an empty list if all are smooth.
#[derive(Default)]
pub(super) struct Sharpness {
    edges: Vec<f32>,
    vertices: Vec<f32>,
}

impl Sharpness {
    pub(super) fn of(mesh: &Mesh) -> Self {
        let column = |values: Option<&[f32]>| match values {
            Some(values) if values.iter().any(|&s| s > 0.0) => {
                values.iter().map(|&s| if s > 0.0 { s } else { 0.0 }).collect()
            }
            _ => Vec::new(),
        };
        Self {
            edges: column(mesh.attribute(keys::EDGE_CREASE)),
            vertices: column(mesh.attribute(keys::VERTEX_CREASE)),
        }
    }

    fn edge(&self, edge: usize) -> f32 {
        self.edges.get(edge).copied().unwrap_or(0.0)
    }

    fn is_smooth(&self) -> bool {
        self.edges.is_empty() && self.vertices.is_empty()
    }

    /// The children's sharpness: the halves of edge `e` are edges `2e` and `2e + 1`, vertices keep their ids, and
    /// everything after is smooth. This holds for both splits.
    pub(super) fn of_children(level: &Level<'_>, parent: &Self, child: &RawMesh) -> Self {
        let column = |values: Vec<f32>, len: usize| {
            let mut values = values;
            if values.iter().all(|&s| s == 0.0) {
                return Vec::new();
            }
            values.resize(len, 0.0);
            values
        };
        debug_assert!(parent.edges.is_empty() || parent.edges.len() == level.edges());
        Self {
            edges: column(parent.edges.iter().flat_map(|&s| [soften(s); 2]).collect(), child.to.len() / 2),
            vertices: column(parent.vertices.iter().map(|&s| soften(s)).collect(), child.positions.len()),
        }
    }

    pub(super) fn into_columns(self, raw: &mut RawMesh) {
        if !self.edges.is_empty() {
            raw.columns.of_mut(Element::Edge).push(Column::with_values(keys::EDGE_CREASE, self.edges));
        }
        if !self.vertices.is_empty() {
            raw.columns.of_mut(Element::Vertex).push(Column::with_values(keys::VERTEX_CREASE, self.vertices));
        }
    }
}

/// The position of an edge point; `smooth` gives that of the smooth rule for an edge with two faces.
#[inline]
pub(super) fn edge_point(
    level: &Level<'_>,
    sharpness: &Sharpness,
    edge: usize,
    smooth: impl FnOnce(DVec3) -> DVec3,
) -> DVec3 {
    let (even, odd) = (2 * edge, 2 * edge + 1);
    let ends = position(level, level.links.to[even]) + position(level, level.links.to[odd]);
    if level.links.face[even] == NONE || level.links.face[odd] == NONE {
        return ends * 0.5;
    }
    let sharp = sharpness.edge(edge);
    if sharp <= 0.0 {
        return smooth(ends);
    }
    if sharp >= 1.0 {
        return ends * 0.5;
    }
    let sharp = f64::from(sharp);
    ends * (0.5 * sharp) + smooth(ends) * (1.0 - sharp)
}

#[inline]
pub(super) fn position(level: &Level<'_>, v: u32) -> DVec3 {
    level.positions[v as usize].as_dvec3()
}

/// The new position of a vertex; `smooth` gives that of the smooth rule from a half-edge leaving it. Both
/// schemes have the same crease rule (3/4, 1/8, 1/8) and corner rule (the vertex stays).
#[inline]
pub(super) fn vertex_point(
    level: &Level<'_>,
    sharpness: &Sharpness,
    boundary: BoundaryRule,
    v: usize,
    smooth: impl Fn(u32) -> DVec3,
) -> DVec3 {
    let links = level.links;
    let here = level.positions[v].as_dvec3();
    let first = links.vertex_halfedge[v];
    if first == NONE {
        return here;
    }
    let open = links.face[first as usize] == NONE;
    if !sharpness.is_smooth() {
        return creased_vertex_point(level, sharpness, boundary, v, first, smooth);
    }
    if !open {
        return smooth(first);
    }
    if boundary == BoundaryRule::EdgeAndCorner && has_one_face(level, first) {
        return here;
    }
    let before = links.prev[first as usize] ^ 1;
    crease(level, here, [first, before])
}

/// Whether the vertex that a boundary half-edge leaves has only one face.
fn has_one_face(level: &Level<'_>, boundary: u32) -> bool {
    level.links.next[boundary as usize ^ 1] == level.links.prev[boundary as usize] ^ 1
}

fn crease(level: &Level<'_>, here: DVec3, along: [u32; 2]) -> DVec3 {
    let [a, b] = along.map(|h| position(level, level.links.to[h as usize]));
    here * 0.75 + (a + b) * 0.125
}

/// The rules for a vertex's position.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Rule {
    /// At most one sharp edge (one is a dart).
    Smooth,
    /// Two sharp edges: the half-edges leaving along them.
    Crease([u32; 2]),
    /// A sharp vertex, or three or more sharp edges.
    Corner,
}

/// Counts sharp edges at a vertex.
#[derive(Default)]
struct Sharps {
    count: usize,
    latest: [u32; 2],
}

impl Sharps {
    fn add(&mut self, h: u32) {
        self.latest = [self.latest[1], h];
        self.count += 1;
    }

    fn rule(&self, vertex: f32) -> Rule {
        match self.count {
            _ if vertex > 0.0 => Rule::Corner,
            0 | 1 => Rule::Smooth,
            2 => Rule::Crease(self.latest),
            _ => Rule::Corner,
        }
    }
}

#[cold]
fn creased_vertex_point(
    level: &Level<'_>,
    sharpness: &Sharpness,
    boundary: BoundaryRule,
    v: usize,
    first: u32,
    smooth: impl Fn(u32) -> DVec3,
) -> DVec3 {
    let links = level.links;
    let here = level.positions[v].as_dvec3();
    let stays = boundary == BoundaryRule::EdgeAndCorner
        && links.face[first as usize] == NONE
        && has_one_face(level, first);
    let vertex = if stays { INFINITE_SHARPNESS } else { sharpness.vertices.get(v).copied().unwrap_or(0.0) };
    let (mut now, mut later) = (Sharps::default(), Sharps::default());
    // The mean of the sharpnesses that end in this level is the share of the old rule.
    let (mut ending, mut ending_sum) = (0u32, 0.0f64);
    if vertex > 0.0 && soften(vertex) <= 0.0 {
        ending = 1;
        ending_sum = f64::from(vertex);
    }
    let mut h = first;
    loop {
        let open = links.face[h as usize] == NONE || links.face[h as usize ^ 1] == NONE;
        let sharp = if open { INFINITE_SHARPNESS } else { sharpness.edge(h as usize / 2) };
        if sharp > 0.0 {
            now.add(h);
            if sharp <= 1.0 {
                ending += 1;
                ending_sum += f64::from(sharp);
            }
        }
        if soften(sharp) > 0.0 {
            later.add(h);
        }
        h = links.next[h as usize ^ 1];
        if h == first {
            break;
        }
    }
    let point = |rule: Rule| match rule {
        Rule::Smooth => smooth(first),
        Rule::Crease(along) => crease(level, here, along),
        Rule::Corner => here,
    };
    let (rule, rule_later) = (now.rule(vertex), later.rule(soften(vertex)));
    if rule == rule_later || rule == Rule::Smooth {
        return point(rule);
    }
    let left = if ending == 0 { 0.0 } else { (ending_sum / f64::from(ending)).min(1.0) };
    point(rule) * left + point(rule_later) * (1.0 - left)
}
