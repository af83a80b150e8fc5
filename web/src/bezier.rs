//! The player of a Bezier curve or surface: its control points, how many levels of de Casteljau's
//! construction are drawn, and for which parameters.

use editor::{Bezier, Changes, Editor, Object, ObjectId};
use glam::Vec3;
use std::collections::HashMap;
use surface::bezier::{Curve, Patch};

/// A control point of the active object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ControlPoint {
    /// A control point of a curve, by its index from 0.
    Curve(usize),
    /// A control point of a surface.
    Patch {
        /// The index of the patch.
        patch: usize,
        /// The row, 0 to 3.
        row: usize,
        /// The point in the row, 0 to 3.
        column: usize,
    },
}

/// The player of the active Bezier object.
#[derive(Default)]
pub(crate) struct Player {
    object: Option<ObjectId>,
    pub controls: Controls,
    pub hovered: Option<ControlPoint>,
    /// The curves of all objects, as polylines.
    pub lines: HashMap<ObjectId, Vec<Vec3>>,
}

/// The settings of the player.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Controls {
    /// The parameter t of a curve, or u of a patch.
    pub t: f32,
    /// The parameter v of a patch.
    pub v: f32,
    /// The number of levels drawn of the construction; 0 draws only the control points.
    pub level: usize,
    /// Whether the whole curve is drawn, not only the part up to t.
    pub whole: bool,
    /// Whether a surface's control nets are drawn.
    pub nets: bool,
    pub playing: bool,
    /// The control point that spin boxes and Delete act on.
    pub chosen: Option<ControlPoint>,
    /// The patch that the construction is drawn on.
    pub patch: usize,
}

impl Default for Controls {
    fn default() -> Self {
        Self { t: 0.5, v: 0.5, level: 0, whole: true, nets: true, playing: false, chosen: None, patch: 0 }
    }
}

/// One thing to change about the player.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Setting {
    /// The parameter t of a curve, or u of a patch. Stops playing.
    T(f32),
    /// The parameter v of a patch. Stops playing.
    V(f32),
    /// The patch that the construction is drawn on, with no control point chosen.
    Patch(usize),
    /// The chosen control point.
    Chosen(Option<ControlPoint>),
}

impl Controls {
    /// Changes one thing.
    pub fn set(&mut self, setting: Setting) {
        match setting {
            Setting::T(t) => (self.t, self.playing) = (t, false),
            Setting::V(v) => (self.v, self.playing) = (v, false),
            Setting::Patch(patch) => (self.patch, self.chosen) = (patch, None),
            Setting::Chosen(point) => self.choose(point),
        }
    }

    /// Chooses a control point and its patch.
    pub fn choose(&mut self, point: Option<ControlPoint>) {
        self.chosen = point;
        if let Some(ControlPoint::Patch { patch, .. }) = point {
            self.patch = patch;
        }
    }
}

/// Above this many patches only one control net is drawn, as all of them would be an unreadable tangle of
/// lines.
const MAX_NETS: usize = 64;

/// A surface's construction has three levels along the rows and three along the resulting column.
pub(crate) const SURFACE_LEVELS: usize = 6;

/// The seconds that playing takes from one end of a curve to the other.
const PLAY_SECONDS: f32 = 4.0;

/// The active object, if it is a Bezier curve or surface.
pub(crate) fn active(editor: &Editor) -> Option<(&Object, &Bezier)> {
    let object = editor.document().active()?;
    Some((object, object.bezier()?))
}

/// All control points of an object.
pub(crate) fn control_points(bezier: &Bezier) -> Box<dyn Iterator<Item = Vec3> + '_> {
    match bezier {
        Bezier::Curve(curve) => Box::new(curve.points.iter().copied()),
        Bezier::Surface(patches) => {
            Box::new(patches.iter().flat_map(|patch| patch.rows.iter().flatten().copied()))
        }
    }
}

/// The position of a control point; none if it doesn't exist.
pub(crate) fn position(bezier: &Bezier, point: ControlPoint) -> Option<Vec3> {
    match (bezier, point) {
        (Bezier::Curve(curve), ControlPoint::Curve(at)) => curve.points.get(at).copied(),
        (Bezier::Surface(patches), ControlPoint::Patch { patch, row, column }) => {
            patches.get(patch)?.rows.get(row)?.get(column).copied()
        }
        _ => None,
    }
}

/// Whether a curve lies in the plane z = 0, like those of most files; edits then keep it there.
pub(crate) fn is_flat(curve: &Curve) -> bool {
    curve.points.iter().all(|point| point.z == 0.0)
}

/// The number of levels of the construction beyond the control points.
pub(crate) fn levels(bezier: &Bezier) -> usize {
    match bezier {
        Bezier::Curve(curve) => curve.points.len().saturating_sub(1),
        Bezier::Surface(_) => SURFACE_LEVELS,
    }
}

/// The largest number of lines drawn of a construction: more would hide each other.
const MAX_LINES: usize = 4000;

/// The largest number of points drawn of a single level that is too large to draw whole: computing each
/// takes time.
const MAX_POINTS_OF_LEVEL: usize = 1000;

/// The largest number of a curve's control points drawn; of more, evenly spaced ones are drawn.
const MAX_CONTROL_POINTS: usize = 2000;

/// The part of a curve that is drawn: all of a small one, a sample of a large one.
pub(crate) struct Drawn {
    /// One control point in this many is drawn.
    pub stride: usize,
    /// The first level drawn of the construction; the last is the player's level.
    pub level: usize,
    /// One point in this many is drawn of that level; 1 if several levels are drawn.
    pub level_stride: usize,
}

impl Drawn {
    /// The part drawn of a curve with `count` control points while the player is at `level`.
    pub(crate) fn of(count: usize, level: usize) -> Self {
        let points = |level: usize| count.saturating_sub(level);
        let (mut first, mut lines) = (level, points(level));
        while first > 1 && lines + points(first - 1) <= MAX_LINES {
            first -= 1;
            lines += points(first);
        }
        let level_stride =
            if level > 0 && lines > MAX_LINES { lines.div_ceil(MAX_POINTS_OF_LEVEL) } else { 1 };
        Self { stride: count.div_ceil(MAX_CONTROL_POINTS).max(1), level: first, level_stride }
    }

    /// A sentence on what is left out; none if everything is drawn.
    pub(crate) fn left_out(&self, level: usize) -> Option<String> {
        let mut said = Vec::new();
        if self.stride > 1 {
            said.push(format!("one control point in {}", self.stride));
        }
        if self.level_stride > 1 {
            said.push(format!("one point in {} of level {level}", self.level_stride));
        } else if self.level > 1 {
            said.push(format!("levels {} to {level}", self.level));
        }
        (!said.is_empty()).then(|| format!("Too many points to draw them all; shown: {}.", said.join(", ")))
    }
}

impl Player {
    /// Follows the document; starts over if another object is active.
    pub fn follow(&mut self, editor: &Editor, changes: &Changes) {
        for id in changes.bezier.iter().chain(changes.objects.iter().map(|(id, _)| id)) {
            let curve = editor.document().object(*id).and_then(|object| object.bezier()?.curve());
            match curve {
                Some(curve) => self.lines.insert(*id, curve.polyline(1.0)),
                None => self.lines.remove(id),
            };
        }
        let object = active(editor).map(|(object, _)| object.id());
        if object != self.object {
            let lines = std::mem::take(&mut self.lines);
            let Controls { whole, nets, .. } = self.controls;
            let controls = Controls { whole, nets, ..Controls::default() };
            *self = Self { object, lines, controls, hovered: None };
        }
        let Some((_, bezier)) = active(editor) else { return };
        self.controls.level = self.controls.level.min(levels(bezier));
        self.controls.patch = self.controls.patch.min(bezier.patches().len().saturating_sub(1));
        self.controls.chosen = self.controls.chosen.filter(|point| position(bezier, *point).is_some());
        self.hovered = self.hovered.filter(|point| position(bezier, *point).is_some());
    }

    /// Draws one more level of the construction; after the last, none.
    pub fn next_level(&mut self, bezier: &Bezier) {
        let last = levels(bezier);
        self.controls.level = if self.controls.level < last { self.controls.level + 1 } else { 0 };
    }

    /// Starts or stops moving along the curve.
    pub fn play(&mut self, bezier: &Bezier) {
        self.controls.playing = !self.controls.playing;
        // Without any level of the construction, nothing visible would move.
        if self.controls.playing && self.controls.level == 0 {
            self.controls.level = levels(bezier);
        }
    }

    /// Advances the parameters while playing; returns whether it is playing.
    pub fn advance(&mut self, seconds: f32) -> bool {
        if self.controls.playing {
            let t = self.controls.t + seconds / PLAY_SECONDS;
            self.controls.t = if t > 1.0 { 0.0 } else { t };
        }
        self.controls.playing
    }

    /// Whether a control point belongs to a curve, or to the patch that the construction is drawn on.
    pub fn is_on_patch(&self, point: ControlPoint) -> bool {
        match point {
            ControlPoint::Curve(_) => true,
            ControlPoint::Patch { patch, .. } => patch == self.controls.patch,
        }
    }

    /// The patch whose net is the only one drawn, because the surface has too many; none if all nets or no
    /// nets are drawn.
    pub fn only_net(&self, bezier: &Bezier) -> Option<usize> {
        (self.controls.nets && bezier.patches().len() > MAX_NETS).then_some(self.controls.patch)
    }

    /// The patches whose nets are drawn, with their indices.
    pub fn nets<'a>(&self, patches: &'a [Patch]) -> impl Iterator<Item = (usize, &'a Patch)> {
        let all = self.controls.nets && patches.len() <= MAX_NETS;
        let one = self.controls.nets.then_some(self.controls.patch);
        patches.iter().enumerate().filter(move |(at, _)| all || one == Some(*at))
    }

    /// The control points that are drawn and can be picked.
    pub fn points(&self, bezier: &Bezier) -> Vec<(ControlPoint, Vec3)> {
        match bezier {
            Bezier::Curve(curve) => {
                let stride = Drawn::of(curve.points.len(), 0).stride;
                let is_drawn = |at: usize| {
                    at.is_multiple_of(stride) || self.controls.chosen == Some(ControlPoint::Curve(at))
                };
                let points = curve.points.iter().enumerate().filter(|(at, _)| is_drawn(*at));
                points.map(|(at, &point)| (ControlPoint::Curve(at), point)).collect()
            }
            Bezier::Surface(patches) => {
                let mut points = Vec::new();
                for (patch, net) in self.nets(patches) {
                    for (row, line) in net.rows.iter().enumerate() {
                        let own = line.iter().enumerate();
                        points
                            .extend(own.map(|(column, &p)| (ControlPoint::Patch { patch, row, column }, p)));
                    }
                }
                points
            }
        }
    }

    /// The player's state, as in `state().view.bezier`.
    pub fn state(&self) -> serde_json::Value {
        let chosen = self.controls.chosen.map(|point| match point {
            ControlPoint::Curve(at) => serde_json::json!({ "point": at }),
            ControlPoint::Patch { patch, row, column } => {
                serde_json::json!({ "patch": patch, "row": row, "column": column })
            }
        });
        serde_json::json!({
            "t": self.controls.t,
            "v": self.controls.v,
            "level": self.controls.level,
            "whole": self.controls.whole,
            "nets": self.controls.nets,
            "playing": self.controls.playing,
            "patch": self.controls.patch,
            "chosen": chosen,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_made_in_one_frame_all_hold() {
        let mut controls = Controls { playing: true, ..Controls::default() };
        let point = ControlPoint::Patch { patch: 3, row: 1, column: 2 };
        for setting in [Setting::Chosen(Some(point)), Setting::T(0.25), Setting::V(0.75)] {
            controls.set(setting);
        }
        let wanted = Controls { t: 0.25, v: 0.75, patch: 3, chosen: Some(point), ..Controls::default() };
        assert_eq!(controls, wanted);
    }

    #[test]
    fn small_curves_are_drawn_whole_and_large_ones_are_sampled() {
        for (count, level) in [(1, 0), (4, 3), (60, 59), (2000, 1)] {
            let drawn = Drawn::of(count, level);
            assert_eq!((drawn.stride, drawn.level, drawn.level_stride), (1, level.min(1), 1));
            assert_eq!(drawn.left_out(level), None);
        }
        for (count, level) in [(2001, 0), (20_000, 7), (20_000, 19_999), (1_000_000, 500_000), (300, 299)] {
            let drawn = Drawn::of(count, level);
            let lines: usize = (drawn.level..=level).map(|l| (count - l).div_ceil(drawn.level_stride)).sum();
            assert!(level == 0 || lines <= MAX_LINES, "{lines} lines");
            assert!(count.div_ceil(drawn.stride) <= MAX_CONTROL_POINTS);
            assert!(drawn.left_out(level).is_some());
            assert_eq!(drawn.left_out(level).is_some_and(|said| said.contains("level")), level > 0);
        }
        assert_eq!(
            Drawn::of(20_000, 19_999).left_out(19_999).as_deref(),
            Some("Too many points to draw them all; shown: one control point in 10, levels 19912 to 19999.")
        );
    }
}
