//! The formats, and how a file's is told.

use crate::collada;
use crate::detect::by_content;
use crate::import::NamedBytes;
use crate::losses::Part;
use crate::material::Property;
use crate::obj;

/// A file format. Where one is written in two ways, reading tells them apart and calls both by the
/// first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// Wavefront OBJ, with materials in an MTL beside it.
    Obj,
    /// PLY, written binary (little-endian).
    Ply,
    /// PLY written as text.
    PlyText,
    /// STL, written binary.
    Stl,
    /// STL written as text.
    StlText,
    /// OFF.
    Off,
    /// COLLADA.
    Collada,
    /// glTF as one binary file.
    Glb,
    /// glTF as JSON, with its data beside it.
    Gltf,
    /// A Bezier curve's control points, as the CS184 course has them.
    BezierCurve,
    /// The patches of a Bezier surface, as the CS184 course has them.
    BezierSurface,
    /// The half-edge mesh itself as JSON; written only.
    Json,
}

impl Format {
    /// All formats, in the order menus show them.
    pub const ALL: [Self; 12] = [
        Self::Obj,
        Self::Ply,
        Self::PlyText,
        Self::Stl,
        Self::StlText,
        Self::Off,
        Self::Collada,
        Self::Glb,
        Self::Gltf,
        Self::BezierCurve,
        Self::BezierSurface,
        Self::Json,
    ];

    /// What users call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Obj => "OBJ",
            Self::Ply => "PLY",
            Self::PlyText => "PLY (text)",
            Self::Stl => "STL",
            Self::StlText => "STL (text)",
            Self::Off => "OFF",
            Self::Collada => "COLLADA",
            Self::Glb => "GLB",
            Self::Gltf => "glTF",
            Self::BezierCurve => "BZC",
            Self::BezierSurface => "BEZ",
            Self::Json => "Half-edge JSON",
        }
    }

    /// The extensions of its files, in lower case without a dot, the usual one first.
    pub fn extensions(self) -> &'static [&'static str] {
        match self {
            Self::Obj => &["obj"],
            Self::Ply | Self::PlyText => &["ply"],
            Self::Stl | Self::StlText => &["stl"],
            Self::Off => &["off", "coff"],
            Self::Collada => &["dae"],
            Self::Glb => &["glb"],
            Self::Gltf => &["gltf"],
            Self::BezierCurve => &["bzc"],
            Self::BezierSurface => &["bez"],
            Self::Json => &["json"],
        }
    }

    /// The usual extension, without a dot.
    pub fn extension(self) -> &'static str {
        self.extensions().first().copied().unwrap_or_default()
    }

    /// Whether [`crate::read`] gives it as a file's format.
    pub fn can_read(self) -> bool {
        !matches!(self, Self::Json | Self::PlyText | Self::StlText)
    }

    /// Whether [`crate::write`] writes it.
    pub fn can_write(self) -> bool {
        true
    }

    /// Whether the format has a place for this. An OBJ's object names become groups, which keep
    /// objects apart.
    pub(crate) fn keeps(self, part: Part) -> bool {
        match self {
            Self::Obj => part != Part::Creases,
            Self::Ply | Self::PlyText | Self::Off => {
                // Normals, and in an OFF texture coordinates, as far as corners of a vertex agree: that is
                // looked at in `losses`.
                !matches!(
                    part,
                    Part::Objects | Part::Groups | Part::Materials | Part::Smoothing | Part::Creases
                )
            }
            Self::Stl | Self::StlText => false,
            Self::Collada => !matches!(part, Part::Groups | Part::Smoothing | Part::Creases),
            Self::Glb | Self::Gltf => {
                !matches!(part, Part::Polygons | Part::Groups | Part::Smoothing | Part::Creases)
            }
            // They hold no meshes at all, which `losses` says once.
            Self::BezierCurve | Self::BezierSurface => true,
            Self::Json => matches!(part, Part::Polygons | Part::LooseVertices),
        }
    }

    /// Whether files of the format hold this property of a material.
    pub(crate) fn keeps_property(self, property: Property) -> bool {
        match self {
            Self::Obj => obj::mtl::keeps(property),
            Self::Collada => collada::keeps(property),
            Self::Glb | Self::Gltf => property == Property::BaseColor,
            // Faces keep the colour; formats without material names are reported for those.
            _ => property == Property::BaseColor,
        }
    }

    /// Whether it holds control points of Bezier curves or surfaces and no meshes.
    pub fn is_bezier(self) -> bool {
        matches!(self, Self::BezierCurve | Self::BezierSurface)
    }

    /// The format that files of this extension have, upper or lower case.
    pub fn from_extension(extension: &str) -> Option<Self> {
        let extension = extension.to_ascii_lowercase();
        Self::ALL.into_iter().find(|format| format.extensions().contains(&extension.as_str()))
    }

    /// The format of a file by its name alone.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::from_extension(name.rsplit_once('.')?.1)
    }

    /// The format of a file: by content where that is plain, else by extension.
    pub fn detect(file: &NamedBytes) -> Option<Self> {
        by_content(&file.bytes).or_else(|| Self::from_name(&file.name))
    }
}

/// Whether a file is a material library rather than a model: by its name, unless it is a model after all.
pub(crate) fn is_material_library(file: &NamedBytes) -> bool {
    file.name.rsplit_once('.').is_some_and(|(_, extension)| extension.eq_ignore_ascii_case("mtl"))
        && by_content(&file.bytes).is_none()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extensions_lead_to_what_can_be_read() {
        for format in Format::ALL {
            let found = Format::from_extension(format.extension());
            assert_eq!(found.map(Format::extension), Some(format.extension()));
            assert!(found.is_some_and(|found| found.can_read() || found == Format::Json));
            assert!(!format.name().is_empty());
        }
    }
}
