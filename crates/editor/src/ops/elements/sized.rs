//! What edits with an amount share.

use crate::error::Problem;
use crate::ops::choice::choice;
use crate::ops::{Drag, Field, Suggestion, Unit, sentence_case};
use crate::script::json::shortest;
use halfedge::Mesh;
use halfedge::edit::{Grouping, SLIDE_AMOUNT_RANGE, SlidingEdit};

choice! {
    /// Whether faces that share an edge stay together.
    pub enum Mode {
        /// They stay together.
        Region = "region" "As one region",
        /// Each face is on its own.
        Individual = "individual" "Each on its own",
    }
}

impl From<Mode> for Grouping {
    fn from(mode: Mode) -> Self {
        match mode {
            Mode::Region => Self::Region,
            Mode::Individual => Self::Individual,
        }
    }
}

/// Gives what an edit created its size; notes where that was limited.
pub(super) fn set_size(
    mesh: &mut Mesh,
    live: &SlidingEdit,
    amount: f32,
    field: &str,
    notes: &mut Vec<String>,
) -> Result<(), Problem> {
    let used =
        live.slide.apply(mesh, amount).map_err(|refusal| Problem::field(field, refusal.to_string()))?;
    if used < amount {
        let (label, used) = (sentence_case(field), shortest(used));
        notes.push(format!("{label} was limited to {used}, because beyond that edges would reverse"));
    }
    Ok(())
}

/// The amount of a slide.
pub(super) const fn slide_amount(description: &'static str) -> Field {
    Field::number("amount", Unit::Fraction, SLIDE_AMOUNT_RANGE, description)
        .labelled("Amount (-1 to 1)")
        .suggest(Suggestion::Number(0.5))
        .drag(Drag::Slide)
}

/// Says why a slide by an amount other than zero has moved nothing.
pub(super) fn nothing_moved(moved: usize, amount: f32, why: &str) -> Option<String> {
    (moved == 0 && amount != 0.0).then(|| format!("Nothing moved: {why}"))
}
