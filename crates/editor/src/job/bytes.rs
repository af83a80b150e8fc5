//! Jobs as bytes, for sending them to a worker and back.
//!
//! Eight bytes of magic, a checksum of the rest, the length of a JSON header, the header, then raw
//! columns one after the other, in native byte order (both ends are the same program on the same
//! machine). The header says what the columns are and how long, so nothing is allocated that the
//! bytes don't hold.
//!
//! The page must not freeze while it takes in millions of faces, and validating them takes longer
//! than a frame. So the writing end, the worker, validates, and says so in the header; the checksum
//! tells the reading end that what arrives is what was written.

use super::{ExportHead, JobId, JobRequest, JobResult, Made, Work};
use crate::ops::{Action, Command, Input, Op, Output};
use crate::outcome::ElementIds;
use formats::{
    Bezier, Format, Image, Import, ImportReport, Materials, Model, NamedBytes, NamedMesh, Repairs,
};
use halfedge::attribute::{Column, Columns, Value, Values};
use halfedge::{Color, Element, Gaps, Mesh, PolygonSoup, RawMesh};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::fmt;
use std::sync::Arc;

/// Bytes that are not a job.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BadBytes(String);

impl fmt::Display for BadBytes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "these bytes are not a job: {}", self.0)
    }
}

impl std::error::Error for BadBytes {}

fn bad(text: impl fmt::Display) -> BadBytes {
    BadBytes(text.to_string())
}

const REQUEST: [u8; 8] = *b"MWjobRq1";
const RESULT: [u8; 8] = *b"MWjobRs1";

#[derive(Serialize, Deserialize)]
enum RequestHeader {
    Import {
        id: u64,
        files: Vec<FileHeader>,
        repairs: Repairs,
    },
    Run {
        id: u64,
        ops: Vec<serde_json::Value>,
        meshes: Vec<MeshHeader>,
    },
    Export {
        id: u64,
        format: Format,
        name: String,
        offset: [f64; 3],
        materials: MaterialsHeader,
        meshes: Vec<MeshHeader>,
    },
}

#[derive(Serialize, Deserialize)]
struct ResultHeader {
    /// Whether the writing end found every mesh valid.
    validated: bool,
    made: MadeHeader,
}

#[derive(Serialize, Deserialize)]
enum MadeHeader {
    Import {
        name: String,
        report: ImportReport,
        offset: [f64; 3],
        materials: MaterialsHeader,
        meshes: Vec<MeshHeader>,
    },
    Meshes {
        meshes: Vec<MeshHeader>,
        ids: Option<[usize; 6]>,
        notes: Vec<String>,
    },
    Files {
        files: Vec<FileHeader>,
    },
}

#[derive(Serialize, Deserialize)]
struct FileHeader {
    name: String,
    bytes: usize,
}

#[derive(Default, Serialize, Deserialize)]
struct MaterialsHeader {
    /// The materials, with images without their contents.
    materials: Materials,
    /// How many bytes the contents of each image take, where they are known.
    images: Vec<Option<usize>>,
}

#[derive(Serialize, Deserialize)]
struct MeshHeader {
    name: String,
    vertices: usize,
    edges: usize,
    faces: usize,
    /// Its control points, where it is a Bezier object.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    controls: Option<ControlsHeader>,
    /// The faces as they were in its file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    soup: Option<SoupHeader>,
    /// How many vertices, edges and faces are removed.
    gaps: [usize; 3],
    /// Per kind of element, in the order of `Element::ALL`.
    columns: [Vec<ColumnHeader>; 4],
}

#[derive(Serialize, Deserialize)]
struct ControlsHeader {
    curve: bool,
    points: usize,
}

#[derive(Serialize, Deserialize)]
struct SoupHeader {
    positions: usize,
    corners: usize,
    faces: usize,
    /// Those of vertices, corners and faces.
    columns: [Vec<ColumnHeader>; 3],
}

#[derive(Serialize, Deserialize)]
struct ColumnHeader {
    name: String,
    kind: Kind,
    /// The bits of the default's components.
    default: Vec<u32>,
    labels: Vec<String>,
}

#[derive(Clone, Copy, Serialize, Deserialize)]
enum Kind {
    F32,
    Vec2,
    Vec3,
    Color,
    U32,
}

impl JobRequest {
    /// The job as bytes, which [`JobRequest::from_bytes`] reads. Costs a copy of the meshes.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = Writer::default();
        let header = match &self.work {
            Work::Import(files, repairs) => {
                RequestHeader::Import { id: self.id.0, files: out.files(files), repairs: *repairs }
            }
            Work::Run(ops, inputs) => RequestHeader::Run {
                id: self.id.0,
                ops: ops.iter().map(|op| Command { object: None, op: op.clone() }.to_value()).collect(),
                meshes: inputs.iter().map(|input| out.input(input, reads_soup(ops))).collect(),
            },
            Work::Export(head, inputs) => RequestHeader::Export {
                id: self.id.0,
                format: head.format,
                name: head.name.clone(),
                offset: head.offset.to_array(),
                materials: out.materials(&head.materials),
                meshes: inputs.iter().map(|input| out.input(input, false)).collect(),
            },
        };
        out.finish(REQUEST, &header)
    }

    /// Reads a job that [`JobRequest::to_bytes`] wrote.
    ///
    /// # Errors
    /// Bytes that are not a job, or were damaged on the way.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, BadBytes> {
        let (header, mut rest) = Reader::open(REQUEST, bytes)?;
        let inputs = |rest: &mut Reader<'_>, meshes: Vec<MeshHeader>| {
            meshes
                .into_iter()
                .map(|header| {
                    let name = header.name.clone();
                    let (mesh, controls, soup) = rest.mesh(header)?;
                    let bezier = controls.map(Arc::new);
                    Ok(Input { name, mesh: Arc::new(mesh), bezier, soup })
                })
                .collect::<Result<Vec<_>, BadBytes>>()
        };
        let (id, work) = match header {
            RequestHeader::Import { id, files, repairs } => (id, Work::Import(rest.files(files)?, repairs)),
            RequestHeader::Run { id, ops, meshes } => {
                let ops = ops
                    .into_iter()
                    .map(|value| Ok(Command::from_value(value).map_err(bad)?.op))
                    .collect::<Result<Vec<Op>, BadBytes>>()?;
                (id, Work::Run(ops, inputs(&mut rest, meshes)?))
            }
            RequestHeader::Export { id, format, name, offset, materials, meshes } => {
                let materials = rest.materials(materials)?;
                let head = ExportHead { format, name, offset: offset.into(), materials };
                (id, Work::Export(head, inputs(&mut rest, meshes)?))
            }
        };
        rest.end()?;
        Ok(Self { id: JobId(id), work })
    }
}

impl JobResult {
    /// The result as bytes, which [`JobResult::from_bytes`] reads. Validates the meshes, so that the
    /// reading end need not. Costs that and a copy of the meshes.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = Writer::default();
        let validated = self.validated || self.made.validate().is_ok();
        let made = match &self.made {
            Made::Import(import) => MadeHeader::Import {
                name: import.model.name.clone(),
                report: import.report.clone(),
                offset: import.model.offset.to_array(),
                materials: out.materials(&import.model.materials),
                meshes: import
                    .model
                    .objects
                    .iter()
                    .map(|object| {
                        let header = out.mesh(&object.name, &object.mesh);
                        let controls = out.controls(object.bezier.as_deref());
                        MeshHeader { controls, soup: out.soup(object.soup.as_deref()), ..header }
                    })
                    .collect(),
            },
            Made::Meshes(outputs, ids, notes) => MadeHeader::Meshes {
                meshes: outputs.iter().map(|output| out.mesh(&output.name, &output.mesh)).collect(),
                ids: ids.as_ref().map(|(created, removed)| {
                    let [a, b, c] = out.ids(created);
                    let [d, e, f] = out.ids(removed);
                    [a, b, c, d, e, f]
                }),
                notes: notes.clone(),
            },
            Made::Files(files) => MadeHeader::Files { files: out.files(files) },
        };
        out.finish(RESULT, &ResultHeader { validated, made })
    }

    /// Reads a result that [`JobResult::to_bytes`] wrote. Costs a copy of the meshes.
    ///
    /// # Errors
    /// Bytes that are not a result, or were damaged on the way.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, BadBytes> {
        let (ResultHeader { validated, made }, mut rest) = Reader::open(RESULT, bytes)?;
        let made = match made {
            MadeHeader::Import { name, report, offset, materials, meshes } => {
                let materials = rest.materials(materials)?;
                let objects = meshes
                    .into_iter()
                    .map(|header| {
                        let name = header.name.clone();
                        let (mesh, controls, soup) = rest.mesh(header)?;
                        Ok(NamedMesh { bezier: controls.map(Arc::new), soup, ..NamedMesh::new(name, mesh) })
                    })
                    .collect::<Result<_, BadBytes>>()?;
                let model = Model { name, objects, offset: offset.into(), materials };
                Made::Import(Import { model, report })
            }
            MadeHeader::Meshes { meshes, ids, notes } => {
                let outputs = meshes
                    .into_iter()
                    .map(|header| {
                        let name = header.name.clone();
                        Ok(Output::new(name, rest.mesh(header)?.0))
                    })
                    .collect::<Result<_, BadBytes>>()?;
                let ids = match ids {
                    Some([a, b, c, d, e, f]) => Some((rest.ids([a, b, c])?, rest.ids([d, e, f])?)),
                    None => None,
                };
                Made::Meshes(outputs, ids, notes)
            }
            MadeHeader::Files { files } => Made::Files(rest.files(files)?),
        };
        rest.end()?;
        Ok(Self { made, validated })
    }
}

/// Collects raw columns, copying nothing until the end.
#[derive(Default)]
struct Writer<'a> {
    body: Vec<Cow<'a, [u8]>>,
}

impl<'a> Writer<'a> {
    fn column<T: bytemuck::NoUninit>(&mut self, column: &'a [T]) {
        self.body.push(Cow::Borrowed(bytemuck::cast_slice(column)));
    }

    fn files(&mut self, files: &'a [NamedBytes]) -> Vec<FileHeader> {
        files
            .iter()
            .map(|file| {
                self.column(&file.bytes);
                FileHeader { name: file.name.clone(), bytes: file.bytes.len() }
            })
            .collect()
    }

    fn materials(&mut self, materials: &'a Materials) -> MaterialsHeader {
        let mut header = MaterialsHeader::default();
        header.materials.list = materials.list.clone();
        for image in &materials.images {
            let (name, media_type) = (image.name.clone(), image.media_type.clone());
            header.materials.images.push(Image { name, media_type, bytes: None });
            header.images.push(image.bytes.as_ref().map(|bytes| {
                self.column(bytes);
                bytes.len()
            }));
        }
        header
    }

    fn ids(&mut self, ids: &'a ElementIds) -> [usize; 3] {
        [&ids.vertices, &ids.edges, &ids.faces].map(|list| {
            self.column(list);
            list.len()
        })
    }

    fn input(&mut self, input: &'a Input, with_soup: bool) -> MeshHeader {
        let header = self.mesh(&input.name, &input.mesh);
        let controls = self.controls(input.bezier.as_deref());
        let soup = self.soup(input.soup.as_deref().filter(|_| with_soup));
        MeshHeader { controls, soup, ..header }
    }

    fn soup(&mut self, soup: Option<&'a PolygonSoup>) -> Option<SoupHeader> {
        let soup = soup?;
        self.column(&soup.positions);
        self.column(&soup.corners);
        self.column(&soup.face_starts);
        let columns = [&soup.vertex_columns, &soup.corner_columns, &soup.face_columns];
        Some(SoupHeader {
            positions: soup.positions.len(),
            corners: soup.corners.len(),
            faces: soup.face_count(),
            columns: columns.map(|columns| columns.iter().map(|column| self.attribute(column)).collect()),
        })
    }

    /// Control points, which come after their mesh.
    fn controls(&mut self, controls: Option<&Bezier>) -> Option<ControlsHeader> {
        let controls = controls?;
        let points = controls.points();
        self.body.push(Cow::Owned(bytemuck::cast_slice(&points).to_vec()));
        Some(ControlsHeader { curve: controls.curve().is_some(), points: points.len() })
    }

    fn mesh(&mut self, name: &str, mesh: &'a Mesh) -> MeshHeader {
        let links = mesh.connectivity();
        self.column(mesh.positions());
        for column in
            [links.vertex_halfedge, links.next, links.prev, links.to, links.face, links.face_halfedge]
        {
            self.column(column);
        }
        let gaps = mesh.gaps();
        let lengths = [&gaps.vertices, &gaps.edges, &gaps.faces].map(|list| {
            self.body.push(Cow::Owned(bytemuck::cast_slice(list).to_vec()));
            list.len()
        });
        MeshHeader {
            name: name.to_owned(),
            vertices: mesh.vertex_capacity(),
            edges: mesh.edge_capacity(),
            faces: mesh.face_capacity(),
            controls: None,
            soup: None,
            gaps: lengths,
            columns: Element::ALL.map(|element| {
                mesh.columns().of(element).iter().map(|column| self.attribute(column)).collect()
            }),
        }
    }

    fn attribute(&mut self, column: &'a Column) -> ColumnHeader {
        let kind = match &column.values {
            Values::F32(values) => {
                self.column(values);
                Kind::F32
            }
            Values::Vec2(values) => {
                self.column(values);
                Kind::Vec2
            }
            Values::Vec3(values) => {
                self.column(values);
                Kind::Vec3
            }
            Values::Color(values) => {
                self.body.push(Cow::Owned(values.iter().flat_map(|color| color.0).collect()));
                Kind::Color
            }
            Values::U32(values) => {
                self.column(values);
                Kind::U32
            }
        };
        let default = match column.default {
            Value::F32(v) => vec![v.to_bits()],
            Value::Vec2(v) => v.to_array().map(f32::to_bits).to_vec(),
            Value::Vec3(v) => v.to_array().map(f32::to_bits).to_vec(),
            Value::Color(v) => v.0.map(u32::from).to_vec(),
            Value::U32(v) => vec![v],
        };
        ColumnHeader { name: column.name.clone(), kind, default, labels: column.labels.clone() }
    }

    fn finish(self, magic: [u8; 8], header: &impl Serialize) -> Vec<u8> {
        // Headers are plain data with text keys: writing them can't fail.
        let header = serde_json::to_vec(header).unwrap_or_default();
        let body: usize = self.body.iter().map(|part| part.len()).sum();
        let mut out = Vec::with_capacity(24 + header.len() + body);
        out.extend_from_slice(&magic);
        out.extend_from_slice(&[0; 8]);
        out.extend_from_slice(&(header.len() as u64).to_le_bytes());
        out.extend_from_slice(&header);
        for part in &self.body {
            out.extend_from_slice(part);
        }
        if let Some((head, rest)) = out.split_at_mut_checked(16)
            && let Some(slot) = head.last_chunk_mut::<8>()
        {
            *slot = checksum(rest).to_le_bytes();
        }
        out
    }
}

/// A sum that every change of a single word changes: each step is a bijection of the lane and of
/// the word. Four lanes, so that the processor does four at a time.
fn checksum(bytes: &[u8]) -> u64 {
    const ODD: u64 = 0x9e37_79b9_7f4a_7c15;
    let step = |lane: u64, word: u64| (lane ^ word).wrapping_mul(ODD).rotate_left(23);
    let mut lanes = [1, 2, 3, 4u64];
    let (blocks, rest) = bytes.as_chunks::<32>();
    for block in blocks {
        let (words, _) = block.as_chunks::<8>();
        for (lane, word) in lanes.iter_mut().zip(words) {
            *lane = step(*lane, u64::from_le_bytes(*word));
        }
    }
    let tail = rest.iter().fold(bytes.len() as u64, |sum, &byte| step(sum, u64::from(byte)));
    lanes.into_iter().fold(tail, step)
}

/// A mesh, and what it was made from.
type Parts = (Mesh, Option<Bezier>, Option<Arc<PolygonSoup>>);

/// Whether an operation reads what files held: nothing else needs it sent.
fn reads_soup(ops: &[Op]) -> bool {
    ops.iter().any(|op| matches!(op.action(), Action::WholeMesh(whole) if whole.reads_soup()))
}

/// Takes raw columns off the front of bytes, never more than are there.
struct Reader<'a> {
    rest: &'a [u8],
}

impl<'a> Reader<'a> {
    fn open<H: Deserialize<'a>>(magic: [u8; 8], bytes: &'a [u8]) -> Result<(H, Self), BadBytes> {
        let rest = bytes.strip_prefix(&magic).ok_or_else(|| bad("they don't start like one"))?;
        let (sum, rest) = rest.split_first_chunk::<8>().ok_or_else(|| bad("they end too early"))?;
        if checksum(rest) != u64::from_le_bytes(*sum) {
            return Err(bad("they are damaged"));
        }
        let (length, rest) = rest.split_first_chunk::<8>().ok_or_else(|| bad("they end too early"))?;
        let length = usize::try_from(u64::from_le_bytes(*length)).map_err(bad)?;
        let (header, rest) = rest.split_at_checked(length).ok_or_else(|| bad("they end too early"))?;
        Ok((serde_json::from_slice(header).map_err(bad)?, Self { rest }))
    }

    fn end(self) -> Result<(), BadBytes> {
        if self.rest.is_empty() { Ok(()) } else { Err(bad("there is something after the end")) }
    }

    fn take(&mut self, bytes: usize) -> Result<&'a [u8], BadBytes> {
        let (taken, rest) = self.rest.split_at_checked(bytes).ok_or_else(|| bad("they end too early"))?;
        self.rest = rest;
        Ok(taken)
    }

    fn column<T: bytemuck::AnyBitPattern + bytemuck::NoUninit>(
        &mut self,
        len: usize,
    ) -> Result<Vec<T>, BadBytes> {
        let bytes = len.checked_mul(size_of::<T>()).ok_or_else(|| bad("a column is too long"))?;
        let bytes = self.take(bytes)?;
        // Room for the next edits, which would otherwise move every column of the mesh at once.
        let mut column = Vec::with_capacity(len + len / 16);
        match bytemuck::try_cast_slice(bytes) {
            Ok(values) => column.extend_from_slice(values),
            // Not aligned for the type.
            Err(_) => {
                column.extend(bytes.chunks_exact(size_of::<T>()).map(bytemuck::pod_read_unaligned::<T>))
            }
        }
        Ok(column)
    }

    fn files(&mut self, headers: Vec<FileHeader>) -> Result<Vec<NamedBytes>, BadBytes> {
        headers
            .into_iter()
            .map(|header| Ok(NamedBytes { name: header.name, bytes: self.take(header.bytes)?.to_vec() }))
            .collect()
    }

    fn materials(&mut self, header: MaterialsHeader) -> Result<Materials, BadBytes> {
        let mut materials = header.materials;
        for (image, length) in materials.images.iter_mut().zip(header.images) {
            if let Some(length) = length {
                image.bytes = Some(self.take(length)?.into());
            }
        }
        Ok(materials)
    }

    fn ids(&mut self, [vertices, edges, faces]: [usize; 3]) -> Result<ElementIds, BadBytes> {
        Ok(ElementIds {
            vertices: self.column(vertices)?,
            edges: self.column(edges)?,
            faces: self.column(faces)?,
        })
    }

    fn mesh(&mut self, header: MeshHeader) -> Result<Parts, BadBytes> {
        let halfedges = header.edges.checked_mul(2).ok_or_else(|| bad("a column is too long"))?;
        let mut raw = RawMesh {
            positions: self.column(header.vertices)?,
            vertex_halfedge: self.column(header.vertices)?,
            next: self.column(halfedges)?,
            prev: self.column(halfedges)?,
            to: self.column(halfedges)?,
            face: self.column(halfedges)?,
            face_halfedge: self.column(header.faces)?,
            columns: Columns::default(),
        };
        let gaps = Gaps {
            vertices: self.column(header.gaps[0])?,
            edges: self.column(header.gaps[1])?,
            faces: self.column(header.gaps[2])?,
        };
        for (element, headers) in Element::ALL.into_iter().zip(header.columns) {
            let len = match element {
                Element::Vertex => header.vertices,
                Element::Edge => header.edges,
                Element::Halfedge => halfedges,
                Element::Face => header.faces,
            };
            for column in headers {
                let column = self.attribute(column, len)?;
                raw.columns.of_mut(element).push(column);
            }
        }
        let controls = match header.controls {
            Some(header) => Some(Bezier::from_points(header.curve, self.column(header.points)?)),
            None => None,
        };
        let soup = match header.soup {
            Some(header) => Some(Arc::new(self.soup(header)?)),
            None => None,
        };
        Ok((Mesh::from_raw_with_gaps(raw, &gaps), controls, soup))
    }

    fn soup(&mut self, header: SoupHeader) -> Result<PolygonSoup, BadBytes> {
        let starts = header.faces.checked_add(1).ok_or_else(|| bad("a column is too long"))?;
        let mut soup = PolygonSoup {
            positions: self.column(header.positions)?,
            corners: self.column(header.corners)?,
            face_starts: self.column(starts)?,
            ..PolygonSoup::default()
        };
        let lengths = [header.positions, header.corners, header.faces];
        let lists = [&mut soup.vertex_columns, &mut soup.corner_columns, &mut soup.face_columns];
        for ((headers, len), list) in header.columns.into_iter().zip(lengths).zip(lists) {
            for header in headers {
                list.push(self.attribute(header, len)?);
            }
        }
        Ok(soup)
    }

    fn attribute(&mut self, header: ColumnHeader, len: usize) -> Result<Column, BadBytes> {
        let bits = |at: usize| header.default.get(at).copied().ok_or_else(|| bad("a column has no default"));
        let float = |at: usize| bits(at).map(f32::from_bits);
        let byte = |at: usize| bits(at).and_then(|bits| u8::try_from(bits).map_err(bad));
        let (values, default) = match header.kind {
            Kind::F32 => (Values::F32(self.column(len)?), Value::F32(float(0)?)),
            Kind::Vec2 => (Values::Vec2(self.column(len)?), Value::Vec2([float(0)?, float(1)?].into())),
            Kind::Vec3 => {
                (Values::Vec3(self.column(len)?), Value::Vec3([float(0)?, float(1)?, float(2)?].into()))
            }
            Kind::Color => (
                Values::Color(self.column::<[u8; 3]>(len)?.into_iter().map(Color).collect()),
                Value::Color(Color([byte(0)?, byte(1)?, byte(2)?])),
            ),
            Kind::U32 => (Values::U32(self.column(len)?), Value::U32(bits(0)?)),
        };
        Ok(Column { name: header.name, values, default, labels: header.labels })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use halfedge::PolygonSoup;

    /// Bytes with a right checksum, whatever the header promises.
    fn sealed(header: &RequestHeader, body: &[u8]) -> Vec<u8> {
        Writer { body: vec![Cow::Borrowed(body)] }.finish(REQUEST, header)
    }

    fn promising(vertices: usize, edges: usize, faces: usize) -> RequestHeader {
        let columns = [const { Vec::new() }; 4];
        let (name, controls, soup) = (String::new(), None, None);
        let mesh = MeshHeader { name, vertices, edges, faces, controls, soup, gaps: [0; 3], columns };
        let (format, name, offset) = (Format::default(), String::new(), [0.0; 3]);
        let materials = MaterialsHeader::default();
        RequestHeader::Export { id: 1, format, name, offset, materials, meshes: vec![mesh] }
    }

    #[test]
    fn headers_that_promise_more_than_there_is_are_refused() {
        assert!(JobRequest::from_bytes(&sealed(&promising(0, 0, 0), &[])).is_ok());
        for [vertices, edges, faces] in [
            [1, 0, 0],
            [usize::MAX / 12, 0, 0],
            [0, usize::MAX, 0],
            [0, usize::MAX / 8, 0],
            [0, 0, usize::MAX],
        ] {
            let error = JobRequest::from_bytes(&sealed(&promising(vertices, edges, faces), &[0; 8]));
            let text = error.expect_err("there are eight bytes").to_string();
            assert!(text.ends_with("too early") || text.ends_with("too long"), "{text}");
        }
        let error = JobRequest::from_bytes(&sealed(&promising(0, 0, 0), &[0])).expect_err("one byte more");
        assert!(error.to_string().contains("after the end"), "{error}");
    }

    #[test]
    fn every_damaged_byte_is_noticed() {
        let bytes: Vec<u8> = (0..100).collect();
        let sum = checksum(&bytes);
        for at in 0..bytes.len() {
            for bit in 0..8 {
                let mut damaged = bytes.clone();
                damaged[at] ^= 1 << bit;
                assert_ne!(checksum(&damaged), sum, "{at}");
            }
            assert_ne!(checksum(&bytes[..at]), sum, "{at}");
        }
    }

    #[test]
    fn a_mesh_that_is_not_valid_is_said_to_be_so() {
        let soup = PolygonSoup::new(vec![glam::Vec3::ZERO; 3], &[[0, 1, 2]]);
        let mut raw = Mesh::build(soup).expect("small").mesh.into_raw();
        raw.next.swap(0, 1);
        let output = Output::new("", Mesh::from_raw(raw));
        let made = Made::Meshes(vec![output], None, Vec::new());
        let result = JobResult { made, validated: false };
        let read = JobResult::from_bytes(&result.to_bytes()).expect("its own bytes");
        assert!(!read.validated);
        assert!(read.made.validate().is_err());
    }
}
