//! Progress of the parts of an operation.

use crate::SurfaceError;
use halfedge::Progress;

/// Elements processed between two progress reports, which takes a few milliseconds.
const ELEMENTS_PER_REPORT: usize = 1 << 16;

/// Reports the progress of a part of an operation as a range of the whole.
pub(crate) struct Pace<'a, 'p> {
    progress: &'a mut Progress<'p>,
    from: f32,
    to: f32,
}

impl<'a, 'p> Pace<'a, 'p> {
    pub(crate) fn new(progress: &'a mut Progress<'p>) -> Self {
        Self { progress, from: 0.0, to: 1.0 }
    }

    /// The part of this range between two fractions of it.
    pub(crate) fn part(&mut self, from: f32, to: f32) -> Pace<'_, 'p> {
        let length = self.to - self.from;
        Pace { from: self.from + length * from, to: self.from + length * to, progress: &mut *self.progress }
    }

    /// Reports that this fraction of the range is done.
    ///
    /// # Errors
    /// [`SurfaceError::Cancelled`] if the callback cancels the operation.
    pub(crate) fn at(&mut self, fraction: f32) -> Result<(), SurfaceError> {
        match (self.progress)(self.from + (self.to - self.from) * fraction) {
            std::ops::ControlFlow::Continue(()) => Ok(()),
            std::ops::ControlFlow::Break(()) => Err(SurfaceError::Cancelled),
        }
    }

    /// Runs `body` on `0..count` in chunks, and reports before each.
    pub(crate) fn chunks(
        &mut self,
        count: usize,
        mut body: impl FnMut(std::ops::Range<usize>),
    ) -> Result<(), SurfaceError> {
        let mut start = 0;
        while start < count {
            self.at(start as f32 / count as f32)?;
            let end = count.min(start + ELEMENTS_PER_REPORT);
            body(start..end);
            start = end;
        }
        Ok(())
    }
}
