//! What an embedded page shows: with `?embed` in its address the viewport alone, and the parts that `&panels=` names.

use crate::platform::Platform;

/// The parts of the page around the viewport.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Parts {
    pub menu: bool,
    pub tools: bool,
    pub lists: bool,
    pub inspector: bool,
    pub status: bool,
}

/// The names of the parts in the address.
pub(crate) const NAMES: [&str; 5] = ["menu", "tools", "lists", "inspector", "status"];

impl Default for Parts {
    /// All of them.
    fn default() -> Self {
        Self { menu: true, tools: true, lists: true, inspector: true, status: true }
    }
}

impl Parts {
    /// The parts that the page's address asks for, and the names in it that mean nothing.
    pub fn of(platform: &dyn Platform) -> (Self, Vec<String>) {
        if !is_embedded(platform) {
            return (Self::default(), Vec::new());
        }
        let asked = platform.parameter("panels").unwrap_or_default();
        let words: Vec<&str> = asked.split([',', ' ']).filter(|word| !word.is_empty()).collect();
        let [menu, tools, lists, inspector, status] = NAMES.map(|name| words.contains(&name));
        let unknown = words.into_iter().filter(|word| !NAMES.contains(word)).map(str::to_owned);
        (Self { menu, tools, lists, inspector, status }, unknown.collect())
    }
}

/// Whether the page is embedded in another one, as its address says.
pub(crate) fn is_embedded(platform: &dyn Platform) -> bool {
    platform.parameter("embed").is_some()
}
