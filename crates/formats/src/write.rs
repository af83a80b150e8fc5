//! Writing: a model in, files out.

use crate::error::WriteError;
use crate::file::NamedBytes;
use crate::format::Holds;
use crate::formats::Format;
use crate::model::{Model, NamedMesh};

/// Writes a model: the model file first, then its companion files. The files are named after the model.
/// Ids of meshes may have gaps; files are numbered without.
///
/// # Errors
/// When the model is too large for the format's numbers, or has nothing that the format holds.
pub fn write(format: Format, model: &Model) -> Result<Vec<NamedBytes>, WriteError> {
    let info = format.info();
    let name = format.name();
    let write = format.codec().write.ok_or_else(|| WriteError::new(format!("{name} can't be written")))?;
    let is_curve = |object: &NamedMesh| object.bezier.as_ref().map(|bezier| bezier.curve().is_some());
    if info.holds != Holds::Meshes {
        let wanted = Some(info.holds == Holds::Curves);
        if !model.objects.iter().any(|object| is_curve(object) == wanted) {
            let what = if info.holds == Holds::Curves { "curve" } else { "surface" };
            return Err(WriteError::new(format!(
                "{name} holds control points, and the document has no Bezier {what}: save it in a format for meshes"
            )));
        }
        return write(model);
    }
    if !model.objects.is_empty() && model.objects.iter().all(NamedMesh::is_curve) {
        let other = Format::for_bezier(true).map_or("", Format::name);
        return Err(WriteError::new(format!(
            "{name} holds meshes, and the document has only Bezier curves: save it as {other}"
        )));
    }
    write(&model.without_curves())
}
