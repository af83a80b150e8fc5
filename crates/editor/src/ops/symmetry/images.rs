//! The mirror images of operations.

use super::Mirroring;
use crate::ops::refs::AnyRef;
use crate::ops::{Op, Slot};
use halfedge::{Mesh, VertexId};
use std::collections::HashMap;
use surface::MirrorImages;

/// Operations with their mirror images.
pub(crate) struct Images {
    /// The given operations, with the images in their lists, and how many elements of the first list were given.
    pub own: Vec<(Op, usize)>,
    /// The operations for images.
    pub others: Vec<Op>,
    /// How many elements have no image.
    pub alone: usize,
}

/// How an operation is reflected.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reflection {
    /// The axis that the mirror's plane is normal to.
    pub axis: usize,
    /// Whether the first edge's image, by the half-edge that amounts are along, runs the other way.
    pub reversed: bool,
    /// Whether the elements are their own images.
    pub is_own: bool,
}

impl Reflection {
    /// The image of a place along the first edge. On an edge that is its own image reversed, only the middle is both.
    pub fn along(self, t: f32) -> f32 {
        match (self.reversed, self.is_own) {
            (false, _) => t,
            (true, false) => 1.0 - t,
            (true, true) => 0.5,
        }
    }

    /// The image of a position or a direction. Between elements that are their own images, it is in the plane.
    pub fn vector(self, vector: [f32; 3]) -> [f32; 3] {
        let mut image = vector;
        if let Some(coordinate) = image.get_mut(self.axis) {
            *coordinate = if self.is_own { 0.0 } else { -*coordinate };
        }
        image
    }
}

/// The elements of each slot, each list in order.
type Key = Vec<Vec<u32>>;

/// Reflects operations of one kind.
pub(super) fn mirror(mut ops: Vec<Op>, mesh: &Mesh, images: &mut MirrorImages) -> Images {
    let mut vertices: Vec<VertexId> = Vec::new();
    let mut is_for_all = false;
    for op in &mut ops {
        let refs: Vec<AnyRef> = op.elements().iter().flat_map(Slot::refs).collect();
        is_for_all |= refs.is_empty();
        refs.into_iter().for_each(|item| vertices.extend(item.vertices(mesh)));
    }
    if is_for_all {
        vertices.extend(mesh.vertices());
    }
    images.look_up(mesh, vertices.iter().copied());
    // Edits of both sides ask for the images of images.
    let others: Vec<VertexId> = vertices.into_iter().filter_map(|v| images.vertex(v)).collect();
    images.look_up(mesh, others);

    let mut alone = 0;
    let mut reflected: Vec<(Option<Op>, Key)> = Vec::new();
    let mut own = Vec::new();
    // Whether an operation makes its image too.
    let mut is_joined = Vec::new();
    for op in &mut ops {
        let (given, count) = (key(op, mesh), op.elements().first().map_or(0, |slot| slot.refs().len()));
        let mut image = op.clone();
        let Found { reversed, missing, empty } = reflect_elements(&mut image, mesh, images);
        alone += missing;
        let of_image = key(&mut image, mesh);
        let is_own = given == of_image;
        let reflection = Reflection { axis: images.axis(), reversed, is_own };
        let mirroring = op.mirroring();
        let is_together = match mirroring {
            Mirroring::Together => op.elements().iter().all(|slot| slot.is_list() || !slot.is_given()),
            Mirroring::Apart => overlap(&given, &of_image) && !is_own,
            Mirroring::Moves => false,
        };
        let leaves_out = empty || (is_own && mirroring != Mirroring::Moves);
        let mut joins = false;
        if is_together {
            unite(op, &mut image, mesh);
            if mirroring == Mirroring::Apart {
                op.reflect(Reflection { is_own: true, ..reflection });
            }
            reflected.push((None, given.clone()));
        } else if leaves_out {
            if is_own {
                op.reflect(reflection);
            }
            reflected.push((None, given.clone()));
        } else {
            if mirroring == Mirroring::Moves {
                // Vertices on both sides follow those that lead.
                subtract(&mut image, op, mesh);
            }
            image.reflect(reflection);
            let image = (!key(&mut image, mesh).iter().all(Vec::is_empty)).then_some(image);
            let is_image = image.is_some();
            let image = image.and_then(|image| op.pair(image, mesh));
            joins = is_image && image.is_none();
            reflected.push((image, of_image));
        }
        is_joined.push(joins);
        own.push((given, count));
    }
    // Of operations that are each other's images, the one on the positive side leads.
    let places: HashMap<Key, usize> =
        own.iter().enumerate().map(|(at, (key, _))| (key.clone(), at)).collect();
    let mut others = Vec::new();
    let mut is_made_by_other = vec![false; ops.len()];
    for at in 0..ops.len() {
        let Some((image, of_image)) = reflected.get_mut(at) else { continue };
        let Some(image) = image.take() else {
            let other = places.get(of_image).copied().filter(|other| *other != at);
            if let (Some(true), Some(other)) = (is_joined.get(at), other) {
                let mut leads =
                    |at: usize| ops.get_mut(at).is_some_and(|op| is_positive(op, mesh, images.axis()));
                let goes_first = (!leads(at), at) < (!leads(other), other);
                is_made_by_other.get_mut(at).into_iter().for_each(|is_made| *is_made = !goes_first);
            }
            continue;
        };
        match places.get(of_image).copied() {
            None => others.push(image),
            Some(other) => {
                let leads = ops.get_mut(at).is_some_and(|op| is_positive(op, mesh, images.axis()));
                if leads && let Some(slot) = ops.get_mut(other) {
                    *slot = image;
                }
            }
        }
    }
    let counts = own.into_iter().map(|(_, count)| count);
    let mut is_made_by_other = is_made_by_other.into_iter();
    let own = ops.into_iter().zip(counts).filter(|_| !is_made_by_other.next().unwrap_or(false)).collect();
    Images { own, others, alone }
}

/// What was found out about the elements of an operation.
struct Found {
    reversed: bool,
    /// How many have no image.
    missing: usize,
    /// Whether a slot that takes one or two elements, or every slot, has no image.
    empty: bool,
}

/// Replaces the elements of an operation by their images.
fn reflect_elements(op: &mut Op, mesh: &Mesh, images: &MirrorImages) -> Found {
    let mut found = Found { reversed: false, missing: 0, empty: false };
    let mut reversed = None;
    let mut count = 0;
    for slot in op.elements().into_iter().filter(Slot::is_given) {
        let refs = slot.refs();
        let mut ids = Vec::with_capacity(refs.len());
        for item in &refs {
            match item.image(mesh, images) {
                Some((id, turned)) => {
                    reversed = reversed.or(turned);
                    ids.push(id);
                }
                None => found.missing += 1,
            }
        }
        found.empty |= !slot.is_list() && ids.len() < refs.len();
        count += ids.len();
        slot.fill(&ids);
    }
    found.empty |= count == 0;
    found.reversed = reversed.unwrap_or(false);
    found
}

fn key(op: &mut Op, mesh: &Mesh) -> Key {
    let sorted = |slot: &Slot<'_>| {
        let mut ids: Vec<u32> = slot.refs().iter().filter_map(|item| item.id(mesh)).collect();
        ids.sort_unstable();
        ids.dedup();
        ids
    };
    op.elements().iter().map(sorted).collect()
}

fn overlap(a: &Key, b: &Key) -> bool {
    a.iter().zip(b).any(|(a, b)| a.iter().any(|id| b.binary_search(id).is_ok()))
}

/// Adds the images to an operation's lists, after what they have.
fn unite(op: &mut Op, image: &mut Op, mesh: &Mesh) {
    let (own, added) = (key(op, mesh), key(image, mesh));
    let added = added.into_iter().zip(own);
    for (slot, (added, own)) in op.elements().into_iter().zip(added) {
        if slot.is_given() {
            let mut ids: Vec<u32> = slot.refs().iter().filter_map(|item| item.id(mesh)).collect();
            ids.extend(added.into_iter().filter(|id| own.binary_search(id).is_err()));
            slot.fill(&ids);
        }
    }
}

/// Removes an operation's own elements from the lists of its image.
fn subtract(image: &mut Op, op: &mut Op, mesh: &Mesh) {
    let own = key(op, mesh);
    for (slot, own) in image.elements().into_iter().zip(own) {
        if slot.is_given() && slot.is_list() {
            let ids = slot.refs().into_iter().filter_map(|item| item.id(mesh));
            let ids: Vec<u32> = ids.filter(|id| own.binary_search(id).is_err()).collect();
            slot.fill(&ids);
        }
    }
}

/// Whether an operation's first element is on the positive side.
fn is_positive(op: &mut Op, mesh: &Mesh, axis: usize) -> bool {
    let first = op.elements().iter().flat_map(Slot::refs).next();
    let vertices = first.map(|item| item.vertices(mesh)).unwrap_or_default();
    let coordinate = |v: VertexId| mesh.position(v).to_array().get(axis).copied().unwrap_or_default();
    vertices.into_iter().map(|v| f64::from(coordinate(v))).sum::<f64>() > 0.0
}
