//! Attributes of the children, interpolated linearly; creases are treated elsewhere.

use super::Level;
use super::triangles;
use glam::{Vec2, Vec3};
use halfedge::attribute::{AttributeType, Column, Columns, Values, keys};
use halfedge::{Color, Element};

/// Values with a mean.
trait Blend: AttributeType {
    /// The mean of the values that aren't missing; the first of values that are no quantities.
    fn mean(values: &[Self]) -> Self;
}

macro_rules! blend_floats {
    ($type:ty, $zero:expr, $missing:expr) => {
        impl Blend for $type {
            fn mean(values: &[Self]) -> Self {
                let (mut sum, mut count) = ($zero, 0u32);
                for value in values.iter().filter(|value| !value.is_nan()) {
                    sum += *value;
                    count += 1;
                }
                if count == 0 { $missing } else { sum / count as f32 }
            }
        }
    };
}

blend_floats!(f32, 0.0, f32::NAN);
blend_floats!(Vec2, Vec2::ZERO, Vec2::NAN);
blend_floats!(Vec3, Vec3::ZERO, Vec3::NAN);

impl Blend for Color {
    fn mean(values: &[Self]) -> Self {
        let count = values.len().max(1) as u32;
        Color([0, 1, 2].map(|channel| {
            let sum: u32 = values.iter().map(|value| u32::from(value.0[channel])).sum();
            ((sum + count / 2) / count) as u8
        }))
    }
}

impl Blend for u32 {
    fn mean(values: &[Self]) -> Self {
        values.first().copied().unwrap_or(halfedge::NONE)
    }
}

/// How faces are split, which determines the children's ids.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Split {
    /// Each corner of a face becomes a quad.
    Quads,
    /// Each triangle becomes four.
    Triangles,
}

/// Whether columns that describe the shape still fit.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    /// New vertices lie on the old faces: normals still fit.
    Kept,
    /// Vertices move: corner normals no longer fit and are dropped.
    Smoothed,
}

/// The columns of the level that `split` makes, without creases.
pub(super) fn columns(level: &Level<'_>, split: Split, shape: Shape) -> Columns {
    let mut out = Columns::default();
    for element in Element::ALL {
        for column in level.columns.of(element) {
            let crease = match element {
                Element::Edge => column.name == keys::EDGE_CREASE.name,
                Element::Vertex => column.name == keys::VERTEX_CREASE.name,
                _ => false,
            };
            let stale = shape == Shape::Smoothed
                && element == Element::Halfedge
                && column.name == keys::CORNER_NORMAL.name;
            if crease || stale {
                continue;
            }
            let values = match &column.values {
                Values::F32(values) => carry(level, split, element, values, column),
                Values::Vec2(values) => carry(level, split, element, values, column),
                Values::Vec3(values) => carry(level, split, element, values, column),
                Values::Color(values) => carry(level, split, element, values, column),
                Values::U32(values) => carry(level, split, element, values, column),
            };
            out.of_mut(element).push(Column {
                name: column.name.clone(),
                values,
                default: column.default,
                labels: column.labels.clone(),
            });
        }
    }
    out
}

fn carry<T: Blend>(
    level: &Level<'_>,
    split: Split,
    element: Element,
    values: &[T],
    column: &Column,
) -> Values {
    // Gathering nothing gives the default with its type.
    let default = Values::empty_like(column.default).gather(std::iter::once(halfedge::NONE), column.default);
    let Some(&default) = T::slice(&default).and_then(<[T]>::first) else { return column.values.clone() };
    let carried = match (element, split) {
        (Element::Vertex, _) => vertex_values(level, split, values),
        (Element::Halfedge, Split::Quads) => quad_corners(level, values, default),
        (Element::Halfedge, Split::Triangles) => triangle_corners(level, values, default),
        (Element::Edge, _) => {
            let inner = match split {
                Split::Quads => level.corners(),
                Split::Triangles => 3 * level.faces(),
            };
            let mut carried: Vec<T> = Vec::with_capacity(2 * values.len() + inner);
            carried.extend(values.iter().flat_map(|&value| [value; 2]));
            carried.resize(2 * values.len() + inner, default);
            carried
        }
        (Element::Face, Split::Quads) => {
            let mut carried = Vec::with_capacity(level.corners());
            for (f, &value) in values.iter().enumerate() {
                each_side(level, f, |_| carried.push(value));
            }
            carried
        }
        (Element::Face, Split::Triangles) => values.iter().flat_map(|&value| [value; 4]).collect(),
    };
    T::values(carried)
}

fn each_side(level: &Level<'_>, face: usize, mut side: impl FnMut(u32)) {
    let first = level.links.face_halfedge[face];
    let mut h = first;
    loop {
        side(h);
        h = level.links.next[h as usize];
        if h == first {
            break;
        }
    }
}

fn vertex_values<T: Blend>(level: &Level<'_>, split: Split, values: &[T]) -> Vec<T> {
    let to = level.links.to;
    let mut carried = Vec::with_capacity(level.vertices() + level.edges() + level.faces());
    carried.extend_from_slice(values);
    carried.extend(
        to.chunks_exact(2).map(|ends| T::mean(&[values[ends[1] as usize], values[ends[0] as usize]])),
    );
    if split == Split::Quads {
        let mut corners = Vec::new();
        for f in 0..level.faces() {
            corners.clear();
            each_side(level, f, |h| corners.push(values[to[h as usize ^ 1] as usize]));
            carried.push(T::mean(&corners));
        }
    }
    carried
}

fn quad_corners<T: Blend>(level: &Level<'_>, values: &[T], default: T) -> Vec<T> {
    let edges = level.edges();
    let mut carried = vec![default; 4 * edges + 2 * level.corners()];
    let (mut ring, mut corners) = (Vec::new(), Vec::new());
    let mut inner = 4 * edges;
    for f in 0..level.faces() {
        ring.clear();
        corners.clear();
        each_side(level, f, |h| {
            ring.push(h as usize);
            corners.push(values[h as usize]);
        });
        let middle = T::mean(&corners);
        for k in 0..ring.len() {
            let after = if k + 1 == ring.len() { 0 } else { k + 1 };
            let half = T::mean(&[corners[k], corners[after]]);
            carried[2 * ring[k]] = corners[k];
            carried[2 * (ring[k] ^ 1) + 1] = half;
            carried[inner] = half;
            carried[inner + 1] = middle;
            inner += 2;
        }
    }
    carried
}

fn triangle_corners<T: Blend>(level: &Level<'_>, values: &[T], default: T) -> Vec<T> {
    let edges = level.edges();
    let mut carried = vec![default; 4 * edges + 6 * level.faces()];
    for f in 0..level.faces() {
        let ring = triangles::sides(level, f).map(|h| h as usize);
        let halves = [0, 1, 2].map(|k| T::mean(&[values[ring[k]], values[ring[(k + 1) % 3]]]));
        for k in 0..3 {
            let cut = 4 * edges + 6 * f + 2 * k;
            carried[2 * ring[k]] = values[ring[k]];
            carried[2 * (ring[k] ^ 1) + 1] = halves[k];
            carried[cut] = halves[k];
            carried[cut + 1] = halves[(k + 2) % 3];
        }
    }
    carried
}
