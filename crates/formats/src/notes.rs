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

impl Notes {
    /// Adds a fault: the element and what is wrong, as in "node \"a\": its matrix has 15 numbers". A colon stands before
    /// it, so a reason follows in brackets.
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
                report.warn(format!("{}{text}", fault.head()));
            }
            if texts.len() > FAULTS_SHOWN {
                let more = counted(texts.len() - FAULTS_SHOWN, "fault", "faults");
                report.warn(format!("{}{more} more of this kind", fault.head()));
            }
        }
    }
}
