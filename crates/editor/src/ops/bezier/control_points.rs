//! What the operations on Bezier objects share.

use crate::bezier::Bezier;
use crate::document::Object;
use crate::error::Problem;
use crate::history::Change;
use crate::ops::Place;
use std::sync::Arc;
use surface::bezier::Curve;

/// The object that the command is for, with its control points.
pub(super) fn object<'a>(place: &Place<'a>) -> Result<(&'a Object, &'a Bezier), Problem> {
    let object = place.object()?;
    match object.bezier() {
        Some(bezier) => Ok((object, bezier)),
        None => Err(Problem::new(format!(
            "{} is a mesh; this op is for Bezier curves and surfaces",
            object.name()
        ))
        .advise("Open a Bezier curve (.bzc) or surface (.bez) first.")),
    }
}

/// The object that the command is for, where it is a curve.
pub(super) fn curve<'a>(place: &Place<'a>) -> Result<(&'a Object, &'a Curve), Problem> {
    match object(place)? {
        (object, Bezier::Curve(curve)) => Ok((object, curve)),
        (object, Bezier::Surface(_)) => Err(Problem::new(format!(
            "{} is a Bezier surface, whose patches have 16 control points each; this operation is for curves",
            object.name()
        ))
        .advise("This works only on Bezier curves; the active object is a surface.")),
    }
}

/// Refuses an index of a control point that a curve doesn't have.
pub(super) fn check_point(index: u32, curve: &Curve, field: &str) -> Result<usize, Problem> {
    let count = curve.points.len();
    let at = index as usize;
    if at < count {
        return Ok(at);
    }
    let range =
        if count == 1 { "the only one is 0".to_owned() } else { format!("they go from 0 to {}", count - 1) };
    Err(Problem::field(field, format!("there is no control point {index}; {range}")))
}

/// The changes that give an object other control points, and the mesh that shows them; none where
/// they are the same.
pub(super) fn put(object: &Object, bezier: Bezier) -> Result<Vec<Change>, Problem> {
    let mut changes = Vec::new();
    if object.bezier() == Some(&bezier) {
        return Ok(changes);
    }
    if let Bezier::Surface(_) = bezier {
        changes.push(Change::Mesh(
            object.id(),
            Arc::new(bezier.preview().map_err(|error| Problem::new(error.to_string()))?),
        ));
    }
    changes.push(Change::Bezier(object.id(), Some(Arc::new(bezier))));
    Ok(changes)
}

/// [`put`] for a curve.
pub(super) fn put_curve(object: &Object, curve: Curve) -> Result<Vec<Change>, Problem> {
    put(object, Bezier::Curve(curve))
}
