//! Notes about a document, gathered while it is read.
//!
//! Many elements may have the same fault, and instances of a geometry repeat its faults: the report names
//! each once, and only the first few of each kind.

use crate::report::ImportReport;
use halfedge::words::counted;
use std::collections::HashSet;

/// How many faults of a kind the report shows; the rest it counts.
const FAULTS_SHOWN: usize = 6;

/// How many notes about nothing lost the report shows.
const INFOS_SHOWN: usize = 24;

/// What a fault affects.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Fault {
    /// Something in the scene is left out.
    Scene,
    /// Faces are left out.
    Faces,
    /// An attribute of a mesh is left out, or is not what the file says.
    Attribute,
    /// A material lacks something.
    Material,
}

impl Fault {
    const ALL: [Self; 4] = [Self::Scene, Self::Faces, Self::Attribute, Self::Material];

    /// What a sentence about it begins with.
    fn head(self) -> &'static str {
        match self {
            Self::Scene => "Left out: ",
            Self::Faces => "Faces left out: ",
            Self::Attribute => "Mesh changed: ",
            Self::Material => "Material ",
        }
    }
}

/// Notes for the import report.
#[derive(Default)]
pub(crate) struct Notes {
    met: HashSet<(Option<Fault>, String)>,
    faults: Vec<(Fault, String)>,
    /// What changes nothing about the meshes, in sentences.
    infos: Vec<String>,
}

/// A fault with one colon at most, since its kind stands before another. The reason of what is behind the colon
/// follows in brackets.
fn with_one_colon(text: &str) -> String {
    let Some((element, fault)) = text.split_once(": ") else { return text.to_owned() };
    match fault.split_once(": ") {
        Some((fault, reason)) => format!("{element}: {fault} ({})", reason.replace(": ", ", ")),
        None => text.to_owned(),
    }
}

impl Notes {
    /// Adds a fault: a clause that begins with the element it is about.
    pub(crate) fn fault(&mut self, fault: Fault, text: impl Into<String>) {
        let text = text.into();
        if self.met.insert((Some(fault), text.clone())) {
            self.faults.push((fault, text));
        }
    }

    /// Adds a sentence, once.
    pub(crate) fn info(&mut self, text: impl Into<String>) {
        let text = text.into();
        if self.met.insert((None, text.clone())) {
            self.infos.push(text);
        }
    }

    /// How many faults there are.
    pub(crate) fn count(&self) -> usize {
        self.faults.len()
    }

    /// The first fault, for where nothing else is left.
    pub(crate) fn first_fault(&self) -> Option<&str> {
        self.faults.first().map(|(_, text)| text.as_str())
    }

    /// Adds everything to the report.
    pub(crate) fn report(&self, report: &mut ImportReport) {
        self.infos.iter().take(INFOS_SHOWN).for_each(|info| report.info(info));
        if self.infos.len() > INFOS_SHOWN {
            report.info(format!("{} more", counted(self.infos.len() - INFOS_SHOWN, "note", "notes")));
        }
        for fault in Fault::ALL {
            let texts: Vec<&String> =
                self.faults.iter().filter(|(kind, _)| *kind == fault).map(|(_, text)| text).collect();
            for text in texts.iter().take(FAULTS_SHOWN) {
                let head = fault.head();
                let text = if head.contains(':') { with_one_colon(text) } else { (*text).clone() };
                report.warn(format!("{head}{text}"));
            }
            if texts.len() > FAULTS_SHOWN {
                let more = counted(texts.len() - FAULTS_SHOWN, "fault", "faults");
                report.warn(format!("{}{more} more of this kind", fault.head()));
            }
        }
    }
}
