//! Meshes, soups and attributes as blocks.

use super::derive::Derived;
use super::wire::{BadBytes, Reader, Writer};
use formats::{Bezier, NamedMesh};
use halfedge::attribute::{Column, Value, Values};
use halfedge::{Color, Element, Gaps, Mesh, PolygonSoup, RawMesh};
use serde::{Deserialize, Serialize};
use std::io;
use std::sync::Arc;

/// Writes a mesh with its name, its control points and, if wanted, the original faces of the file.
pub(crate) fn write_named(out: &mut Writer<'_>, named: &NamedMesh, with_soup: bool) -> io::Result<()> {
    let NamedMesh { name, mesh, bezier, soup } = named;
    let soup = soup.as_ref().filter(|_| with_soup);
    out.value(&NamedHead {
        name: name.clone(),
        bezier_is_curve: bezier.as_ref().map(|bezier| bezier.curve().is_some()),
        has_soup: soup.is_some(),
    })?;
    write_mesh(out, mesh)?;
    if let Some(bezier) = bezier {
        out.column(&bezier.points())?;
    }
    soup.map_or(Ok(()), |soup| write_soup(out, soup))
}

pub(crate) async fn read_named(from: &mut Reader<'_>) -> Result<NamedMesh, BadBytes> {
    let NamedHead { name, bezier_is_curve, has_soup } = from.value().await?;
    let mesh = read_mesh(from).await?;
    let bezier = match bezier_is_curve {
        Some(is_curve) => Some(Arc::new(Bezier::from_points(is_curve, from.column().await?))),
        None => None,
    };
    let soup = if has_soup { Some(Arc::new(read_soup(from).await?)) } else { None };
    Ok(NamedMesh { bezier, soup, ..NamedMesh::new(name, mesh) })
}

#[derive(Serialize, Deserialize)]
struct NamedHead {
    name: String,
    /// Present if control points follow the mesh.
    bezier_is_curve: Option<bool>,
    /// Whether the original faces of the file follow.
    has_soup: bool,
}

fn write_mesh(out: &mut Writer<'_>, mesh: &Mesh) -> io::Result<()> {
    let links = mesh.connectivity();
    let gaps = mesh.gaps();
    out.column(mesh.positions())?;
    if out.is_packed() {
        write_gaps(out, &gaps)?;
        write_packed_links(out, mesh, &gaps)?;
    } else {
        for column in
            [links.vertex_halfedge, links.next, links.prev, links.to, links.face, links.face_halfedge]
        {
            out.column(column)?;
        }
        write_gaps(out, &gaps)?;
    }
    Element::ALL
        .into_iter()
        .try_for_each(|element| write_attributes(out, mesh.columns().of(element).iter().collect()))
}

async fn read_mesh(from: &mut Reader<'_>) -> Result<Mesh, BadBytes> {
    let mut raw = RawMesh { positions: from.column().await?, ..RawMesh::default() };
    let gaps = if from.is_packed() {
        let gaps = read_gaps(from).await?;
        read_packed_links(from, &mut raw, &gaps).await?;
        gaps
    } else {
        let columns = [
            &mut raw.vertex_halfedge,
            &mut raw.next,
            &mut raw.prev,
            &mut raw.to,
            &mut raw.face,
            &mut raw.face_halfedge,
        ];
        for column in columns {
            *column = from.column().await?;
        }
        let gaps = read_gaps(from).await?;
        check_gaps(&gaps, &raw)?;
        gaps
    };
    let (vertices, halfedges, faces) = (raw.positions.len(), raw.next.len(), raw.face_halfedge.len());
    check_lengths(&[raw.vertex_halfedge.len()], vertices)?;
    check_lengths(&[raw.prev.len(), raw.to.len(), raw.face.len(), halfedges / 2 * 2], halfedges)?;
    for element in Element::ALL {
        let len = match element {
            Element::Vertex => vertices,
            Element::Edge => halfedges / 2,
            Element::Halfedge => halfedges,
            Element::Face => faces,
        };
        for column in read_attributes(from, len).await? {
            raw.columns.of_mut(element).push(column);
        }
    }
    Ok(Mesh::from_raw_with_gaps(raw, &gaps))
}

fn write_gaps(out: &mut Writer<'_>, gaps: &Gaps) -> io::Result<()> {
    [&gaps.vertices, &gaps.edges, &gaps.faces].into_iter().try_for_each(|ids| out.links(ids))
}

async fn read_gaps(from: &mut Reader<'_>) -> Result<Gaps, BadBytes> {
    Ok(Gaps { vertices: from.links().await?, edges: from.links().await?, faces: from.links().await? })
}

/// Refuses removed elements that no column has: marking them would take memory for all ids up to theirs.
fn check_gaps(gaps: &Gaps, raw: &RawMesh) -> Result<(), BadBytes> {
    let lengths = [raw.positions.len(), raw.next.len() / 2, raw.face_halfedge.len()];
    let ids = [&gaps.vertices, &gaps.edges, &gaps.faces];
    if ids.into_iter().zip(lengths).any(|(ids, len)| ids.iter().any(|&id| id as usize >= len)) {
        return Err(BadBytes::new("a removed element has an id that no element had"));
    }
    Ok(())
}

/// Writes three columns of links, from which the others follow, and the others where they don't.
fn write_packed_links(out: &mut Writer<'_>, mesh: &Mesh, gaps: &Gaps) -> io::Result<()> {
    let links = mesh.connectivity();
    let removed = Derived::of_removed(links.prev, links.to, links.face, gaps);
    let derived = Derived::from_links(links.vertex_halfedge, links.next, links.face_halfedge, gaps);
    let is_derived = derived.is_some_and(|mut derived| {
        derived.put_removed(&removed, gaps)
            && derived.prev == links.prev
            && derived.to == links.to
            && derived.face == links.face
    });
    out.column(&[u8::from(is_derived)])?;
    [links.vertex_halfedge, links.next, links.face_halfedge]
        .into_iter()
        .try_for_each(|ids| out.links(ids))?;
    if is_derived {
        return out.links(&removed);
    }
    [links.prev, links.to, links.face].into_iter().try_for_each(|ids| out.links(ids))
}

async fn read_packed_links(from: &mut Reader<'_>, raw: &mut RawMesh, gaps: &Gaps) -> Result<(), BadBytes> {
    let is_derived = from.column::<u8>().await? == [1];
    (raw.vertex_halfedge, raw.next, raw.face_halfedge) =
        (from.links().await?, from.links().await?, from.links().await?);
    check_gaps(gaps, raw)?;
    if !is_derived {
        (raw.prev, raw.to, raw.face) = (from.links().await?, from.links().await?, from.links().await?);
        return Ok(());
    }
    let removed = from.links().await?;
    let derived = Derived::from_links(&raw.vertex_halfedge, &raw.next, &raw.face_halfedge, gaps)
        .and_then(|mut derived| derived.put_removed(&removed, gaps).then_some(derived))
        .ok_or_else(|| BadBytes::new("its half-edges form no mesh"))?;
    (raw.prev, raw.to, raw.face) = (derived.prev, derived.to, derived.face);
    Ok(())
}

fn write_soup(out: &mut Writer<'_>, soup: &PolygonSoup) -> io::Result<()> {
    out.column(&soup.positions)?;
    out.links(&soup.corners)?;
    out.links(&soup.face_starts)?;
    [&soup.vertex_columns, &soup.corner_columns, &soup.face_columns]
        .into_iter()
        .try_for_each(|columns| write_attributes(out, columns.iter().collect()))
}

async fn read_soup(from: &mut Reader<'_>) -> Result<PolygonSoup, BadBytes> {
    let (positions, corners, face_starts): (Vec<_>, _, _) =
        (from.column().await?, from.links().await?, from.links().await?);
    let (vertices, faces) = (positions.len(), face_starts.len().saturating_sub(1));
    let starts_fit = face_starts.first() == Some(&0)
        && face_starts.last().is_some_and(|&last| last as usize == corners.len())
        && face_starts.is_sorted();
    if !starts_fit || corners.iter().any(|&vertex| vertex as usize >= vertices) {
        return Err(BadBytes::new("the faces of the file don't fit its vertices"));
    }
    Ok(PolygonSoup {
        vertex_columns: read_attributes(from, vertices).await?,
        corner_columns: read_attributes(from, corners.len()).await?,
        face_columns: read_attributes(from, faces).await?,
        positions,
        corners,
        face_starts,
    })
}

#[derive(Serialize, Deserialize)]
struct AttributeHead {
    name: String,
    labels: Vec<String>,
    kind: Kind,
}

#[derive(Clone, Copy, Serialize, Deserialize)]
enum Kind {
    F32,
    Vec2,
    Vec3,
    Color,
    U32,
}

fn write_attributes(out: &mut Writer<'_>, columns: Vec<&Column>) -> io::Result<()> {
    let heads: Vec<AttributeHead> = columns
        .iter()
        .map(|column| AttributeHead {
            name: column.name.clone(),
            labels: column.labels.clone(),
            kind: match column.values {
                Values::F32(_) => Kind::F32,
                Values::Vec2(_) => Kind::Vec2,
                Values::Vec3(_) => Kind::Vec3,
                Values::Color(_) => Kind::Color,
                Values::U32(_) => Kind::U32,
            },
        })
        .collect();
    out.value(&heads)?;
    for column in columns {
        // A default may be NaN, which JSON can't express.
        match column.default {
            Value::F32(value) => out.column(&[value])?,
            Value::Vec2(value) => out.column(&[value])?,
            Value::Vec3(value) => out.column(&[value])?,
            Value::Color(value) => out.column(&[value])?,
            Value::U32(value) => out.column(&[value])?,
        }
        match &column.values {
            Values::F32(values) => out.column(values)?,
            Values::Vec2(values) => out.column(values)?,
            Values::Vec3(values) => out.column(values)?,
            Values::Color(values) => out.column(values)?,
            Values::U32(values) => out.column(values)?,
        }
    }
    Ok(())
}

async fn read_attributes(from: &mut Reader<'_>, len: usize) -> Result<Vec<Column>, BadBytes> {
    let heads: Vec<AttributeHead> = from.value().await?;
    let mut columns = Vec::new();
    for AttributeHead { name, labels, kind } in heads {
        let (default, values) = match kind {
            Kind::F32 => (Value::F32(default(from).await?), Values::F32(from.column().await?)),
            Kind::Vec2 => (Value::Vec2(default(from).await?), Values::Vec2(from.column().await?)),
            Kind::Vec3 => (Value::Vec3(default(from).await?), Values::Vec3(from.column().await?)),
            Kind::Color => (Value::Color(default::<Color>(from).await?), Values::Color(from.column().await?)),
            Kind::U32 => (Value::U32(default(from).await?), Values::U32(from.column().await?)),
        };
        check_lengths(&[values.len()], len)?;
        columns.push(Column { name, values, default, labels });
    }
    Ok(columns)
}

async fn default<T: bytemuck::AnyBitPattern + bytemuck::NoUninit>(
    from: &mut Reader<'_>,
) -> Result<T, BadBytes> {
    match from.column().await?.as_slice() {
        [value] => Ok(*value),
        _ => Err(BadBytes::new("a column's default is missing")),
    }
}

fn check_lengths(lengths: &[usize], expected: usize) -> Result<(), BadBytes> {
    match lengths.iter().find(|len| **len != expected) {
        None => Ok(()),
        Some(len) => Err(BadBytes::new(format!("a column has {len} values where another has {expected}"))),
    }
}
