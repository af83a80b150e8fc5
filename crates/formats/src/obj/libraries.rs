//! The material libraries of an OBJ.

use super::detect::is_obj;
use super::mtl;
use crate::file::{NamedBytes, base_name};
use crate::format::reading::Source;
use crate::model::material::Materials;
use crate::model::paint::unpainted;
use crate::report::{ImportReport, first_few};
use crate::text::encoding::decode;
use halfedge::words::counted;
use std::collections::HashSet;

/// The names of the files that an OBJ or a material library refers to: its libraries or its images.
pub(crate) fn companions(file: &NamedBytes) -> Vec<String> {
    if file.has_extension("mtl") && !is_obj(&file.bytes) {
        return mtl::image_names(file);
    }
    let (text, _) = decode(&file.bytes);
    let mut names = Vec::new();
    for rest in text.split(['\n', '\r']).filter_map(|line| line.trim_start().strip_prefix("mtllib")) {
        // One name with blanks, or several.
        names.push(rest.to_owned());
        names.extend(rest.split_whitespace().map(str::to_owned));
    }
    names
}

/// Whether one of the `mtllib` statements names this file. A statement names one file, with or without blanks,
/// or several.
fn mentions(named: &[String], library: &str) -> bool {
    let base = |path: &str| base_name(path).to_lowercase();
    let library = base(library);
    named
        .iter()
        .any(|line| base(line) == library || line.split_whitespace().any(|name| base(name) == library))
}

/// The materials of the libraries that belong to an OBJ: those that it names, or all that came with it if
/// it names none of them.
pub(crate) fn read(named: &[String], source: &Source, report: &mut ImportReport) -> Materials {
    let libraries = || source.companions.iter().filter(|file| file.has_extension("mtl"));
    let mentioned: Vec<_> = libraries().filter(|library| mentions(named, &library.name)).collect();
    let used = if mentioned.is_empty() { libraries().collect() } else { mentioned };
    let mut materials = Materials::default();
    for library in &used {
        let mut notes = ImportReport::default();
        let more = mtl::read(library, source.files, &mut notes);
        report.info(format!(
            "Colours of {} read from {}",
            counted(more.list.len(), "material", "materials"),
            library.name
        ));
        report.append(notes);
        for name in materials.add(more) {
            report.warn(format!(
                "Material {name} of {} left out: an earlier library has a different one of that name",
                library.name
            ));
        }
    }
    if used.is_empty() && !named.is_empty() {
        report.info(format!(
            "The colours of its materials are in {}, which was not given, so its name is not kept either: open both \
             files together to have them",
            named.join(", ")
        ));
    }
    materials
}

/// The materials that faces use, by name, with their images.
pub(crate) fn in_use(given: Materials, names: &[String], report: &mut ImportReport) -> Materials {
    let names: HashSet<&str> = names.iter().map(String::as_str).collect();
    let is_used = |name: &str| !name.is_empty() && names.contains(name);
    let (list, mut unused): (Vec<_>, Vec<_>) =
        given.list.into_iter().partition(|material| is_used(&material.name));
    // Materials that only stand for a colour of another one are in the colours of faces.
    unused.retain(|material| unpainted(&material.name).is_none());
    let mut used = Materials::default();
    used.add(Materials { list, images: given.images });
    if let Some(parameters) = mtl::statement_counts(used.list.iter()) {
        report.info(format!(
            "Properties of materials besides their colours are not shown, but kept and written when saved as OBJ: \
             {parameters}"
        ));
    }
    if !unused.is_empty() {
        let names: Vec<&str> = unused.iter().map(|material| material.name.as_str()).collect();
        report.info(format!("Materials that no face uses are left out: {}", first_few(&names, 6)));
    }
    used
}
