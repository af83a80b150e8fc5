//! Values that follow vertices as an edit moves them.
//!
//! When a vertex moves, its corners get the values that its faces have at the new place: texture coordinates, colours and
//! normals stay where they are on the surface, and the corners slide over them. Each corner's value is interpolated, or
//! continued, within the face that the corner comes from, so an edge with different values on its two sides (a seam) keeps
//! them. Corners that shared a value at a vertex get the mean of theirs and share it, so no seam appears.

use super::blend::normalize_if_normal;
use super::face_sample::{FaceSample, Numbers, numbers};
use crate::attribute::{Column, Value, keys};
use crate::geometry::UnionFind;
use crate::mesh::Mesh;
use crate::{Color, Element, FaceId, HalfedgeId, VertexId};
use glam::{DVec3, Vec2, Vec3};
use rustc_hash::FxHashMap;

/// A corner that follows its vertex.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Follower {
    /// The corner before the edit: its value and its face are followed.
    pub corner: HalfedgeId,
    /// The vertex at the corner after the edit.
    pub vertex: VertexId,
    /// The half-edge that leaves the corner after the edit. None for a corner that vanishes but whose face still
    /// tells the values at the new place.
    pub side: Option<HalfedgeId>,
    /// Of corners that share a value, only those of the highest rank count.
    pub rank: usize,
}

/// Followers and what they follow, read from the mesh before an edit. After the edit, [`Followers::update`] gives them the
/// values at the places of their vertices, any number of times.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Followers {
    samples: Vec<FaceSample>,
    /// Where samples are evaluated: at a vertex; with the sample's number.
    places: Vec<(VertexId, usize)>,
    columns: Vec<FollowedColumn>,
}

/// A column of half-edges or of vertices.
#[derive(Clone, Debug, PartialEq)]
struct FollowedColumn {
    element: Element,
    column: usize,
    is_color: bool,
    /// Per sample: the values at its corners; none if some are missing.
    values: Vec<Option<Vec<Numbers>>>,
    groups: Vec<Group>,
}

/// Elements that share a value: the mean of the values at some places.
#[derive(Clone, Debug, Default, PartialEq)]
struct Group {
    /// Numbers of places, each with a value in case the sample can't be evaluated.
    places: Vec<(usize, Numbers)>,
    targets: Vec<u32>,
}

impl Followers {
    /// Reads what the followers follow, in the columns of half-edges and vertices that are `wanted`. Whole numbers
    /// and creases never follow.
    pub(crate) fn new(
        mesh: &Mesh,
        mut followers: Vec<Follower>,
        wanted: impl Fn(Element, usize) -> bool,
    ) -> Self {
        let columns: Vec<_> = columns_of(mesh).filter(|&(element, column)| wanted(element, column)).collect();
        if columns.is_empty() || followers.is_empty() {
            return Self::default();
        }
        let face = |follower: &Follower| mesh.face_of(follower.corner);
        followers.sort_by_key(|follower| (face(follower), follower.corner, follower.vertex, follower.side));
        let mut result = Self::default();
        let mut place_numbers = FxHashMap::default();
        let places: Vec<usize> = result
            .sample_faces(mesh, &followers)
            .into_iter()
            .zip(&followers)
            .map(|(sample, follower)| {
                *place_numbers.entry((follower.vertex, sample)).or_insert_with(|| {
                    result.places.push((follower.vertex, sample));
                    result.places.len() - 1
                })
            })
            .collect();
        for (element, column) in columns {
            let values = result.samples.iter().map(|sample| sample.values(mesh, element, column)).collect();
            let groups = group_followers(mesh, element, column, &followers, &places);
            let is_color = mesh.columns.of(element)[column].name == keys::VERTEX_COLOR.name;
            result.columns.push(FollowedColumn { element, column, is_color, values, groups });
        }
        result
    }

    /// Whether a mesh has columns that follow.
    pub(crate) fn has_columns(mesh: &Mesh) -> bool {
        columns_of(mesh).next().is_some()
    }

    /// Makes the samples of the followers' faces; returns the number of each follower's sample.
    fn sample_faces(&mut self, mesh: &Mesh, followers: &[Follower]) -> Vec<usize> {
        let mut numbers = Vec::with_capacity(followers.len());
        let mut sides: Vec<HalfedgeId> = Vec::new();
        let mut places: FxHashMap<HalfedgeId, usize> = FxHashMap::default();
        let mut sampled: Option<(Option<FaceId>, HalfedgeId)> = None;
        for follower in followers {
            let face = mesh.face_of(follower.corner);
            let is_new_face = sampled.is_none_or(|(last, _)| last != face);
            if is_new_face {
                sides.clear();
                sides.extend(mesh.loop_of(follower.corner));
                places.clear();
                if !FaceSample::is_shared(&sides) {
                    places.extend(sides.iter().enumerate().map(|(i, &h)| (h, i)));
                }
            }
            let is_new_corner = sampled.is_none_or(|(_, last)| last != follower.corner);
            if is_new_face || is_new_corner && !FaceSample::is_shared(&sides) {
                let own = places.get(&follower.corner).copied().unwrap_or(0);
                self.samples.push(FaceSample::new(mesh, &sides, own));
            }
            sampled = Some((face, follower.corner));
            numbers.push(self.samples.len() - 1);
        }
        numbers
    }

    /// Gives the followers the values at the current places of their vertices. The result doesn't depend on earlier
    /// calls. Costs O(followers * corners of their faces, but at most 32).
    pub(crate) fn update(&self, mesh: &mut Mesh) {
        let weights: Vec<Option<Vec<f64>>> = self
            .places
            .iter()
            .map(|&(vertex, sample)| self.samples.get(sample)?.weights(mesh.position(vertex)))
            .collect();
        for followed in &self.columns {
            for group in &followed.groups {
                let value = self.value(followed, group, &weights);
                for &target in &group.targets {
                    followed.set(mesh, target, value);
                }
            }
        }
    }

    /// The mean of the values at a group's places. Colours stay within the range of the faces' colours.
    fn value(&self, followed: &FollowedColumn, group: &Group, weights: &[Option<Vec<f64>>]) -> Numbers {
        let mut sum = DVec3::ZERO;
        let (mut low, mut high) = (DVec3::MAX, DVec3::MIN);
        for &(place, own) in &group.places {
            let sampled = followed.values[self.places[place].1].as_ref().zip(weights[place].as_ref());
            let (values, weights) = match sampled {
                Some((values, weights)) => (values.as_slice(), weights.as_slice()),
                None => (&[own][..], &[1.0][..]),
            };
            for (&value, &weight) in values.iter().zip(weights) {
                let value = Vec3::from(value).as_dvec3();
                sum += value * weight;
                (low, high) = (low.min(value), high.max(value));
            }
        }
        let mean = sum / group.places.len() as f64;
        let value = if followed.is_color { mean.max(low).min(high) } else { mean };
        value.as_vec3().to_array()
    }
}

/// The columns of half-edges and vertices that follow.
fn columns_of(mesh: &Mesh) -> impl Iterator<Item = (Element, usize)> + '_ {
    [Element::Halfedge, Element::Vertex].into_iter().flat_map(move |element| {
        let follows = move |column: &Column| {
            let is_number = !matches!(column.default, Value::U32(_));
            is_number && !(element == Element::Vertex && column.name == keys::VERTEX_CREASE.name)
        };
        let columns = mesh.columns.of(element).iter().enumerate();
        columns.filter(move |(_, column)| follows(column)).map(move |(at, _)| (element, at))
    })
}

impl FollowedColumn {
    fn set(&self, mesh: &mut Mesh, target: u32, numbers: Numbers) {
        let Some(column) = mesh.columns.of(self.element).get(self.column) else { return };
        let [x, y, _] = numbers;
        let value = match column.default {
            Value::F32(_) => Value::F32(x),
            Value::Vec2(_) => Value::Vec2(Vec2::new(x, y)),
            Value::Vec3(_) => Value::Vec3(Vec3::from(numbers)),
            // `as` keeps channels in range.
            Value::Color(_) => Value::Color(Color(numbers.map(|x| x.round() as u8))),
            Value::U32(_) => return,
        };
        let value = normalize_if_normal(column, value);
        mesh.set_value(self.element, self.column, target as usize, value);
    }
}

/// Groups the followers that share a value in a column. `places` has the number of each follower's place.
fn group_followers(
    mesh: &Mesh,
    element: Element,
    column: usize,
    followers: &[Follower],
    places: &[usize],
) -> Vec<Group> {
    let values = &mesh.columns.of(element)[column].values;
    let own: Vec<Option<Numbers>> = followers
        .iter()
        .map(|follower| {
            let id = match element {
                Element::Vertex => mesh.from(follower.corner).raw(),
                _ => follower.corner.raw(),
            };
            numbers(values.get(id as usize)?)
        })
        .collect();
    let mut groups = UnionFind::new(followers.len());
    let mut first: FxHashMap<Alike, u32> = FxHashMap::default();
    for (i, follower) in followers.iter().enumerate() {
        let vertex = follower.vertex;
        let mut join = |alike: Alike| {
            let other = *first.entry(alike).or_insert(i as u32);
            groups.union(i as u32, other);
        };
        if element == Element::Vertex {
            join(Alike::Vertex(vertex));
            continue;
        }
        if let Some(own) = own[i] {
            // Adding zero makes both zeros the same.
            let bits = own.map(|x| (x + 0.0).to_bits());
            join(Alike::Value(vertex, mesh.from(follower.corner), bits));
        }
        if let Some(side) = follower.side {
            join(Alike::Side(side));
        }
    }
    // A group's number is that of its first follower.
    let mut members: Vec<Vec<usize>> = vec![Vec::new(); followers.len()];
    for i in 0..followers.len() {
        members[groups.find(i as u32) as usize].push(i);
    }
    members.iter().filter_map(|members| make_group(element, members, followers, &own, places)).collect()
}

/// What followers of a group have in common.
#[derive(PartialEq, Eq, Hash)]
enum Alike {
    Vertex(VertexId),
    /// The vertices after and before the edit, and the value.
    Value(VertexId, VertexId, [u32; 3]),
    /// Corners that become one.
    Side(HalfedgeId),
}

/// The group of these followers; none if none has a value, or no corner is left to get one.
fn make_group(
    element: Element,
    members: &[usize],
    followers: &[Follower],
    own: &[Option<Numbers>],
    places: &[usize],
) -> Option<Group> {
    let rank = members.iter().filter(|&&i| own[i].is_some()).map(|&i| followers[i].rank).max()?;
    let mut group = Group::default();
    for &i in members {
        if let Some(own) = own[i].filter(|_| followers[i].rank == rank) {
            group.places.push((places[i], own));
        }
        match element {
            Element::Vertex => group.targets.push(followers[i].vertex.raw()),
            _ => group.targets.extend(followers[i].side.map(HalfedgeId::raw)),
        }
    }
    group.places.sort_by_key(|(place, _)| *place);
    group.places.dedup_by_key(|(place, _)| *place);
    group.targets.sort_unstable();
    group.targets.dedup();
    (!group.targets.is_empty()).then_some(group)
}
