//! Work that is done in parts, so that no call takes long: the page does one part in each frame.

/// How many more elements may be processed now. Work that shares a budget takes what it needs in turn.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Budget {
    left: usize,
}

impl Budget {
    /// A budget for everything that is left to do.
    pub const fn unlimited() -> Self {
        Self { left: usize::MAX }
    }

    /// A budget of this many elements.
    pub const fn new(elements: usize) -> Self {
        Self { left: elements }
    }

    /// The number of elements that may still be processed.
    pub fn left(&self) -> usize {
        self.left
    }

    /// Whether no more elements may be processed.
    pub fn is_spent(&self) -> bool {
        self.left == 0
    }

    /// Takes this many elements from the budget, or as many as are left; returns how many.
    pub fn take(&mut self, elements: usize) -> usize {
        let taken = elements.min(self.left);
        self.left -= taken;
        taken
    }

    /// Takes elements that cost so little that `per_one` of them count as one, at most as many as are left; returns how
    /// many.
    pub fn take_light(&mut self, elements: usize, per_one: usize) -> usize {
        self.take(elements.div_ceil(per_one)).saturating_mul(per_one).min(elements)
    }
}

/// Work that can be done in parts. What it reads must stay the same until it is done.
pub trait InParts {
    /// What it reads.
    type Input<'a>: Copy;
    /// The result.
    type Output;

    /// Continues until the budget is spent or the work done; returns the result once it is. A part may cost
    /// a little more than its budget where the work can't be interrupted.
    fn step(&mut self, input: Self::Input<'_>, budget: &mut Budget) -> Option<Self::Output>;

    /// Does all that is left.
    fn finish(mut self, input: Self::Input<'_>) -> Self::Output
    where
        Self: Sized,
    {
        loop {
            if let Some(output) = self.step(input, &mut Budget::unlimited()) {
                return output;
            }
        }
    }
}
