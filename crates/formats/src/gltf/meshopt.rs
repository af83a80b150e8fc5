//! Views compressed with meshoptimizer: the extensions `EXT_meshopt_compression` and
//! `KHR_meshopt_compression`, which adds a version of the codec and a filter.

use super::json::Object;
use meshoptimizer_rs::codec::{
    decode_filter_color, decode_filter_exp, decode_filter_oct, decode_filter_quat, decode_index_buffer,
    decode_index_sequence, decode_vertex_buffer,
};
use meshoptimizer_rs::{Error, Limits, Workspace};

/// The names of the extensions.
pub(super) const EXTENSIONS: [&str; 2] = ["EXT_meshopt_compression", "KHR_meshopt_compression"];

/// Reverses, in place, a filter that was applied before compression.
type Filter = fn(&mut [u8], usize, usize, &mut Workspace) -> Result<(), Error>;

/// The compression extension of a view.
pub(super) fn extension_of(view: Object<'_>) -> Option<Object<'_>> {
    EXTENSIONS.iter().find_map(|name| view.extension(name))
}

/// Decodes the data of a view into at most `max_bytes`.
///
/// # Errors
/// When the data doesn't match the view.
pub(super) fn decode(view: Object, data: &[u8], max_bytes: usize) -> Result<Vec<u8>, String> {
    let count = view.required_index("count")?;
    let stride = view.required_index("byteStride")?;
    let mut workspace = Workspace::new(Limits { max_bytes, ..Limits::default() });
    let mode = view.text("mode").unwrap_or_default();
    let decode = match mode {
        "ATTRIBUTES" => decode_vertex_buffer,
        "TRIANGLES" => decode_index_buffer,
        "INDICES" => decode_index_sequence,
        _ => return Err(format!("its compression \"{mode}\" is unknown")),
    };
    let filter = view.text("filter").unwrap_or("NONE");
    let filter: Option<Filter> = match filter {
        "NONE" => None,
        "OCTAHEDRAL" => Some(decode_filter_oct),
        "QUATERNION" => Some(decode_filter_quat),
        "EXPONENTIAL" => Some(decode_filter_exp),
        "COLOR" => Some(decode_filter_color),
        _ => return Err(format!("its compression filter \"{filter}\" is unknown")),
    };
    let mut bytes = decode(count, stride, data, &mut workspace).map_err(|error| error.to_string())?;
    if let Some(filter) = filter {
        filter(&mut bytes, count, stride, &mut workspace).map_err(|error| error.to_string())?;
    }
    Ok(bytes)
}
