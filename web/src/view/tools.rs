//! Taking tools, and cancelling what they do.

use super::{Gesture, Tool, View};

impl View {
    /// Cancels the drag in progress; returns whether there was one.
    pub fn cancel_gesture(&mut self) -> bool {
        let going = !matches!(
            self.gesture,
            Gesture::None
                | Gesture::Live { .. }
                | Gesture::Slide
                | Gesture::Orbit
                | Gesture::Pan
                | Gesture::Zoom
                | Gesture::Ended
        );
        if going {
            self.gesture = Gesture::Ended;
        }
        let was_looking = !self.regions.is_empty();
        self.regions.clear();
        was_looking || going
    }

    /// Takes a tool, or puts it away.
    pub fn switch_tool(&mut self, tool: Tool) {
        self.tool = if self.tool == tool { Tool::Orbit } else { tool };
        self.ring.typed = 0;
    }
}
