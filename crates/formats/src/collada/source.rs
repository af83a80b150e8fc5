//! Sources: arrays of numbers, and the accessors that group them.

use super::numbers::{Number, numbers};
use super::xml::{Document, Node};
use crate::notes::{Fault, Notes};
use halfedge::words::counted;

/// Values in groups, one group for each index.
pub(super) struct Source<T = f32> {
    values: Vec<T>,
    /// The number of groups.
    pub count: usize,
    /// Where the first group starts.
    offset: usize,
    stride: usize,
    /// Where in a group its components are.
    components: Vec<usize>,
}

impl<T: Number> Source<T> {
    /// The source of this reference, whose groups should have `wanted` components. `owner` is what the
    /// source belongs to, for notes.
    ///
    /// # Errors
    /// In words, where there is no such source or its numbers can't be read.
    pub(super) fn read(
        document: &Document,
        reference: &str,
        wanted: usize,
        owner: &str,
        notes: &mut Notes,
    ) -> Result<Self, String> {
        let missing = || format!("source {}", document.why_missing(reference));
        let source = document.target(reference).filter(|node| node.name == "source").ok_or_else(missing)?;
        let accessor = document.path(source, &["technique_common", "accessor"]);
        let array = accessor
            .and_then(|accessor| document.target(accessor.attribute("source")?))
            .filter(|array| is_array(array))
            .or_else(|| document.children(source).find(|child| is_array(child)))
            .ok_or_else(|| format!("source \"{reference}\" has no numbers"))?;
        let layout = Layout::of(document, accessor, wanted);
        let count =
            |name: &str| accessor.and_then(|accessor| accessor.number(name)).filter(|&count| count > 0);
        // Which reading of commas is right follows from the number of values.
        let expected =
            array.number("count").or_else(|| Some(layout.offset + count("count")? * layout.stride));
        let read = numbers::<T>(array.text(), expected);
        read.note_commas(notes).map_err(|why| format!("the numbers of source \"{reference}\" have {why}"))?;
        if read.unreadable == read.values.len() && read.unreadable > 0 {
            return Err(format!("none of the numbers of source \"{reference}\" can be read"));
        }
        if read.unreadable > 0 {
            let unreadable = counted(read.unreadable, "value", "values");
            notes.fault(
                Fault::Attribute,
                format!("{owner}: {unreadable} of source \"{reference}\" can't be read"),
            );
        }
        let available = layout.groups(read.values.len());
        let count = count("count").map_or(available, |count| count.min(available));
        let Layout { offset, stride, components } = layout;
        Ok(Self { values: read.values, count, offset, stride, components })
    }

    /// The components of a group; those that it doesn't have are 0. None beyond the last group.
    pub(super) fn get<const N: usize>(&self, index: usize) -> Option<[T; N]> {
        if index >= self.count {
            return None;
        }
        let start = self.offset.checked_add(index.checked_mul(self.stride)?)?;
        let mut group = [T::default(); N];
        for (value, place) in group.iter_mut().zip(&self.components) {
            *value = *self.values.get(start.checked_add(*place)?)?;
        }
        Some(group)
    }

    /// The number of components in a group.
    pub(super) fn width(&self) -> usize {
        self.components.len()
    }

    /// All numbers of a group, for sources of matrices.
    pub(super) fn group(&self, index: usize) -> Option<&[T]> {
        let start = self.offset.checked_add(index.checked_mul(self.stride)?)?;
        self.values.get(start..start.checked_add(self.stride)?)
    }
}

fn is_array(node: &Node) -> bool {
    matches!(node.name, "float_array" | "int_array" | "bool_array")
}

/// How an accessor groups an array.
struct Layout {
    offset: usize,
    stride: usize,
    components: Vec<usize>,
}

/// The most numbers in a group that are looked at.
const MAX_STRIDE: usize = 1 << 16;

impl Layout {
    /// The layout of groups that should have `wanted` components.
    fn of(document: &Document, accessor: Option<&Node>, wanted: usize) -> Self {
        let number = |name: &str| accessor.and_then(|accessor| accessor.number(name));
        let params: Vec<&Node> = accessor
            .into_iter()
            .flat_map(|accessor| document.children_named(accessor, "param"))
            .take(MAX_STRIDE)
            .collect();
        // A "float3" stands for a whole group.
        let is_group = |param: &&Node| {
            param.attribute("type").is_some_and(|kind| kind.ends_with(|c: char| c.is_ascii_digit()))
        };
        let params: Vec<&str> = match params.as_slice() {
            [one] if is_group(one) => Vec::new(),
            params => params.iter().map(|param| param.attribute("name").unwrap_or_default()).collect(),
        };
        // Without names, all parameters count.
        let all_unnamed = params.iter().all(|name| name.is_empty());
        let mut components: Vec<usize> = (0..params.len())
            .filter(|&i| all_unnamed || params.get(i).is_some_and(|name| !name.is_empty()))
            .collect();
        let needed = components.last().map_or(0, |last| last + 1);
        // Some programs leave the stride out.
        let stride = match number("stride").filter(|&stride| stride > 0) {
            Some(stride) => stride.max(needed).min(MAX_STRIDE),
            None if params.is_empty() => wanted,
            None => needed.max(1),
        };
        if params.is_empty() {
            components = (0..stride).collect();
        }
        let names = components.iter().filter_map(|&i| params.get(i).copied());
        if let Some(order) = order_of_names(names) {
            components = order.into_iter().filter_map(|place| components.get(place).copied()).collect();
        }
        components.truncate(wanted);
        Self { offset: number("offset").unwrap_or(0), stride, components }
    }

    /// How many groups an array of this length has; the last one may end after its last component.
    fn groups(&self, length: usize) -> usize {
        let needed = self.components.iter().max().map_or(1, |last| last + 1);
        let available = length.saturating_sub(self.offset);
        if available < needed { 0 } else { (available - needed) / self.stride + 1 }
    }
}

/// The order of components by their names, where those are a known set in another order: "Z", "X", "Y".
fn order_of_names<'a>(names: impl Iterator<Item = &'a str>) -> Option<Vec<usize>> {
    let names: Vec<String> = names.map(str::to_ascii_uppercase).collect();
    let known = ["XYZ", "RGBA", "RGB", "STP", "ST", "UVW", "UV", "XY"];
    let known = known.iter().find(|known| {
        known.len() == names.len()
            && known.chars().all(|letter| names.iter().any(|name| name.chars().eq([letter])))
    })?;
    known.chars().map(|letter| names.iter().position(|name| name.chars().eq([letter]))).collect()
}
