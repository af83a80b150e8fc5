//! Primitives compressed with Draco, the extension `KHR_draco_mesh_compression`.

use super::rows::Rows;
use draco_core::{DataType, DecodeLimits, DecoderBuffer, Mesh, MeshDecoder};

/// The extension's name.
pub(super) const EXTENSION: &str = "KHR_draco_mesh_compression";

/// Size of a face of a decoded mesh, in bytes.
const BYTES_PER_FACE: usize = 12;

/// A decoded primitive.
pub(super) struct DracoMesh(Mesh);

/// Decodes a primitive into at most `max_bytes`.
///
/// # Errors
/// When the data is not a Draco mesh.
pub(super) fn decode(data: &[u8], max_bytes: usize) -> Result<DracoMesh, String> {
    let limits = DecodeLimits::default()
        .with_max_decoded_bytes(max_bytes as u64)
        .with_max_points(max_bytes as u64)
        .with_max_faces((max_bytes / BYTES_PER_FACE) as u64);
    let mut buffer = DecoderBuffer::new(data).with_limits(limits);
    let mut mesh = Mesh::new();
    let decoded = MeshDecoder::new().decode(&mut buffer, &mut mesh);
    decoded.map_err(|error| format!("its Draco data can't be read ({error})"))?;
    Ok(DracoMesh(mesh))
}

impl DracoMesh {
    /// Approximate memory use, in bytes.
    pub(super) fn size(&self) -> usize {
        let attributes = (0..self.0.num_attributes()).filter_map(|id| self.0.try_attribute(id).ok());
        let values: usize = attributes.map(|attribute| attribute.buffer().data().len()).sum();
        values + self.0.num_faces() * BYTES_PER_FACE
    }

    /// The vertex numbers of all triangles.
    pub(super) fn indices(&self) -> Rows<'static> {
        Rows::of_indices(self.0.faces().iter().flatten().map(|point| point.0))
    }

    /// The values of the attribute with this id. `is_normalized` maps integers to fractions.
    ///
    /// # Errors
    /// When there is no such attribute.
    pub(super) fn attribute(&self, number: usize, is_normalized: bool) -> Result<Rows<'static>, String> {
        let attribute = u32::try_from(number).ok().and_then(|id| self.0.attribute_by_unique_id(id));
        let attribute = attribute.ok_or_else(|| format!("its Draco data has no attribute {number}"))?;
        let width = usize::from(attribute.num_components());
        let mut values = attribute.read_f32s(self.0.num_points(), width);
        let full = match attribute.data_type() {
            DataType::Int8 => 127.0,
            DataType::Uint8 => 255.0,
            DataType::Int16 => 32_767.0,
            DataType::Uint16 => 65_535.0,
            _ => 1.0,
        };
        if is_normalized {
            values.iter_mut().for_each(|value| *value = (*value / full).max(-1.0));
        }
        Ok(Rows::of_floats(values, width))
    }
}
