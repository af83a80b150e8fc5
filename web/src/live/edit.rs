//! The state of an edit that follows the pointer, and how the pointer and typed numbers set its amount.

use editor::ops::{Drag, Field, FieldKind, Unit};
use editor::{Command, CommandError, Facts, OpId};
use egui::Pos2;
use glam::{Mat3, Quat, Vec2, Vec3};
use halfedge::geometry::BitSet;
use serde_json::{Value, json};
use viewport::Camera;

use super::lock::{Lock, axes_of};
use super::place::SelectionPlace;
use super::pointer::{Sight, length_step, rounded};
use super::slide::Track;
use super::trail::Trail;
use super::typed::Typed;
use crate::session::form::{self, Filled};
use crate::transforming::{Orientation, Pivot, Settings, SnapTo};
use crate::units::{LengthUnit, Measure};
use crate::view::View;
use crate::view::ring::RingCut;

/// One notch of the wheel makes the soft selection's radius this much larger.
const RADIUS_PER_NOTCH: f32 = 1.15;
/// The steps that rotations, factors and fractions snap to.
const SNAP_DEGREES: f32 = 5.0;
const SNAP_FACTOR: f32 = 0.1;
const SNAP_FRACTION: f32 = 0.05;
const SNAP_SLIDE: f32 = 0.1;

/// What a live edit starts with.
#[derive(Clone, Debug)]
pub(crate) struct Start {
    pub id: OpId,
    /// The field that follows the pointer; the operation's first such field if there is none of this name.
    pub field: &'static str,
    pub lock: Lock,
    /// Where the pointer began; none to begin where it is seen first.
    pub from: Option<Pos2>,
    /// The point that stays under the pointer; none for the pivot.
    pub anchor: Option<Vec3>,
    /// The ring to cut, in place of those through the selection.
    pub ring: Option<RingCut>,
}

impl Start {
    /// An edit that begins where the pointer is.
    pub fn new(id: OpId, field: &'static str) -> Self {
        Self { id, field, lock: Lock::Free, from: None, anchor: None, ring: None }
    }

    /// A loop cut that slides along an edge of its ring.
    pub fn ring_cut(cut: RingCut) -> Self {
        Self { ring: Some(cut), ..Self::new(OpId::LoopCut, "") }
    }
}

/// A live edit in progress.
pub(crate) struct Live {
    pub id: OpId,
    pub field: &'static Field,
    pub drag: Drag,
    /// The numbers along the lock's axes; an amount that is one number is the first.
    pub value: Vec3,
    pub lock: Lock,
    pub typed: Typed,
    /// The operation's count that the wheel changes, by its field's name.
    pub count: Option<(&'static Field, u32)>,
    place: SelectionPlace,
    /// Where the 3D cursor is.
    cursor: Vec3,
    anchor: Vec3,
    /// What a slide goes along.
    track: Option<Track>,
    /// The direction in which vertices slide.
    pub(super) way: Vec3,
    /// The view when the edit began, whose axes it keeps.
    camera: Camera,
    /// The vertices that move, by index; found when the edit first snaps to others.
    pub(crate) moved: Option<BitSet>,
    /// Elements named in the command, where the vertices of the selection don't say enough.
    pub(crate) given: Filled,
    pub(super) trail: Trail,
    pub(crate) follows: bool,
    /// Whether the document shows the edit.
    pub(crate) in_document: bool,
    /// What it snaps to while a key is held.
    pub(crate) held_snap: Option<SnapTo>,
    /// Why the document does not show the edit.
    pub refused: Option<String>,
    /// What the edit has to say of what it shows.
    pub(crate) warnings: Vec<String>,
}

impl Live {
    pub(crate) fn new(
        start: &Start,
        place: SelectionPlace,
        [anchor, cursor]: [Vec3; 2],
        track: Option<Track>,
        (view, unit): (&View, LengthUnit),
    ) -> Option<Self> {
        let spec = start.id.spec();
        let field = spec.field(start.field).filter(|field| field.drag.is_some()).or(spec.dragged_field())?;
        let drag = field.drag?;
        let mut count = spec.fields.iter().find_map(|field| match (field.kind, field.default_value()) {
            (FieldKind::Integer { unit: Unit::Count, .. }, Some(value)) => {
                Some((field, value.as_u64()? as u32))
            }
            _ => None,
        });
        let mut given = Filled::new();
        if let Some(cut) = start.ring {
            given.insert("edge".to_owned(), cut.edge.into());
            count.iter_mut().for_each(|(_, count)| *count = cut.cuts);
        }
        Some(Self {
            id: start.id,
            field,
            drag,
            value: at_rest(drag),
            lock: start.lock,
            typed: Typed::new(measure_of(drag), unit),
            count,
            place,
            cursor,
            anchor: start.anchor.or(track.as_ref().map(|track| track.at)).unwrap_or(anchor),
            way: track.as_ref().map(Track::first_way).unwrap_or_default(),
            track,
            camera: view.camera,
            moved: None,
            given,
            trail: Trail::new(start.from),
            follows: true,
            in_document: false,
            held_snap: None,
            refused: None,
            warnings: Vec::new(),
        })
    }

    /// The lines along which vertices slide.
    pub fn rails(&self) -> &[[Vec3; 2]] {
        self.track.as_ref().map_or(&[], |track| &track.rails)
    }

    /// Whether it moves the selection.
    pub fn is_move(&self) -> bool {
        (self.id, self.drag) == (OpId::Transform, Drag::Offset)
    }

    /// The name in the bar and the messages.
    pub fn label(&self) -> &'static str {
        match (self.id, self.drag) {
            (OpId::Transform, Drag::Offset) => "Move",
            (OpId::Transform, Drag::Rotation) => "Rotate",
            (OpId::Transform, Drag::Factors) => "Scale",
            _ => self.id.spec().label,
        }
    }

    /// The directions of x, y and z for the lock.
    pub(crate) fn axes(&self, settings: &Settings) -> Mat3 {
        axes_of(self.lock.orientation(settings.orientation), self.place.normal, &self.camera)
    }

    /// The axis of a rotation.
    fn axis(&self, settings: &Settings) -> Vec3 {
        match self.lock {
            Lock::Free => -self.camera.axes()[2].as_vec3(),
            Lock::Along(axis, _) | Lock::Across(axis, _) => self.axes(settings).col(axis.min(2)),
        }
    }

    pub(crate) fn command(&self, settings: &Settings) -> Result<Command, CommandError> {
        let mut filled = form::initial(self.id.spec(), &Facts::default());
        let value: Value = match self.drag {
            Drag::Offset => json!((self.axes(settings) * self.value).to_array()),
            Drag::Rotation => json!({ "axis": self.axis(settings).to_array(), "degrees": self.value.x }),
            Drag::Factors => json!(self.value.to_array()),
            Drag::Distance | Drag::Width | Drag::Fraction | Drag::Slide => json!(self.value.x),
        };
        filled.insert(self.field.name.to_owned(), value);
        if let Some((field, count)) = self.count {
            filled.insert(field.name.to_owned(), count.into());
        }
        match self.id {
            OpId::Transform => self.fill_transform(settings, &mut filled),
            OpId::SlideVertices => {
                filled.insert("direction".to_owned(), json!(self.way.to_array()));
            }
            _ => {}
        }
        filled.extend(self.given.clone());
        Ok(form::command(self.id, &filled)?.mirrored(settings.symmetry))
    }

    fn fill_transform(&self, settings: &Settings, filled: &mut Filled) {
        if self.drag != Drag::Offset {
            match settings.pivot {
                Pivot::Middle => {}
                Pivot::Individual => drop(filled.insert("individual".to_owned(), true.into())),
                pivot => {
                    let point = self.place.pivot(pivot, self.cursor).to_array();
                    filled.insert("pivot".to_owned(), json!(point));
                }
            }
        }
        let turned =
            self.lock != Lock::Free && self.lock.orientation(settings.orientation) != Orientation::Global;
        if self.drag == Drag::Factors && turned {
            let (axis, radians) = Quat::from_mat3(&self.axes(settings)).to_axis_angle();
            let orientation = json!({ "axis": axis.to_array(), "degrees": radians.to_degrees() });
            filled.insert("orientation".to_owned(), orientation);
        }
        if let Some(radius) = settings.soft_radius.filter(|_| settings.soft) {
            filled.insert("falloff".to_owned(), radius.into());
        }
    }

    /// Whether the amount changes anything.
    pub(crate) fn does_something(&self) -> bool {
        self.drag == Drag::Fraction || self.value != at_rest(self.drag)
    }

    /// Sets the amount from the pointer, or from what is typed.
    pub(crate) fn update(&mut self, settings: &Settings, view: &View, snap: Snap) {
        if !self.typed.is_empty() {
            self.follows = false;
            return self.set_typed();
        }
        self.follows = true;
        let Some(from) = self.trail.from else { return };
        let [from, at] = [from, self.trail.at].map(|place| view.local(place));
        let (sight, by) = (self.sight(view), at - from);
        let step = length_step(sight.units_per_point());
        let snapped = |value: f32, step: f32| if snap.is_round() { rounded(value, step) } else { value };
        let value = match self.drag {
            Drag::Offset => {
                let axes = self.axes(settings);
                let offset = match snap {
                    Snap::To(target) => self.lock.limited(axes.transpose() * (target - self.anchor)),
                    _ => sight.offset(self.lock, axes, from, at),
                };
                if !offset.is_finite() {
                    return;
                }
                if snap == Snap::Grid {
                    let place = self.anchor + axes * offset;
                    let on_grid = Vec3::from(place.to_array().map(|number| rounded(number, step)));
                    self.lock.limited(axes.transpose() * (on_grid - self.anchor))
                } else {
                    Vec3::from(offset.to_array().map(|number| snapped(number, step)))
                }
            }
            Drag::Rotation => Vec3::X * snapped(self.trail.turned, SNAP_DEGREES),
            Drag::Factors => self.factors(snapped(sight.factor(from, at), SNAP_FACTOR)),
            Drag::Distance => Vec3::X * snapped(sight.along(self.place.normal, by), step),
            Drag::Width => Vec3::X * snapped(by.length() * sight.units_per_point(), step),
            Drag::Slide => {
                let Some(track) = &self.track else { return };
                let (amount, way) = track.amount(sight, by);
                let amount = snapped(amount, SNAP_SLIDE);
                self.way = way.unwrap_or(self.way);
                Vec3::X * amount
            }
            Drag::Fraction => Vec3::X * snapped(0.5 + sight.fraction(self.place.edge, by), SNAP_FRACTION),
        };
        self.set_value(value);
    }

    /// Sets the amount, within the range of its field.
    fn set_value(&mut self, value: Vec3) {
        self.value = match self.field.range() {
            Some(range) => Vec3::X * range.nearest(value.x.into()) as f32,
            None => value,
        };
    }

    pub(crate) fn sight<'a>(&self, view: &'a View) -> Sight<'a> {
        Sight { camera: &view.camera, size: view.size(), anchor: self.anchor }
    }

    fn factors(&self, factor: f32) -> Vec3 {
        self.lock.fill(Vec3::ONE, |_, _| factor)
    }

    fn set_typed(&mut self) {
        let rest = at_rest(self.drag);
        let first = self.typed.value(0).unwrap_or(rest.x);
        self.set_value(match self.drag {
            Drag::Offset => self.lock.fill(rest, |_, at| self.typed.value(at).unwrap_or_default()),
            Drag::Factors => self.factors(first),
            Drag::Width | Drag::Fraction | Drag::Slide | Drag::Distance | Drag::Rotation => Vec3::X * first,
        });
    }

    /// The degrees about the axis of a rotation for a step of the pointer.
    pub(super) fn turn(&self, settings: &Settings, view: &View, from: Vec2, to: Vec2) -> f32 {
        if self.drag == Drag::Rotation { self.sight(view).turn(self.axis(settings), from, to) } else { 0.0 }
    }

    /// What the command depends on.
    pub(crate) fn amount(&self) -> (Vec3, Vec3, Lock, Option<u32>) {
        (self.value, self.way, self.lock, self.count.map(|(_, count)| count))
    }

    /// Turns the wheel: a count, or the radius of the soft selection.
    pub fn turn_wheel(&mut self, notches: i32, settings: &mut Settings, view: &View) {
        if let Some((field, count)) = &mut self.count {
            let Some(range) = field.range() else { return };
            let wanted = range.nearest(f64::from(*count) + f64::from(notches));
            *count = wanted as u32;
        } else if let Some(radius) = &mut settings.soft_radius {
            let unit = self.sight(view).units_per_point();
            *radius = (*radius * RADIUS_PER_NOTCH.powi(notches)).clamp(unit, unit * 1e5);
        }
    }

    /// Sets the amount, which then no longer follows the pointer.
    pub fn set_amount(&mut self, value: Vec3) {
        self.follows = false;
        self.typed.clear();
        self.set_value(value);
    }

    /// Sets the amount back to that with which the edit began.
    pub fn set_to_rest(&mut self) {
        self.set_amount(at_rest(self.drag));
    }

    /// Sets the count.
    pub fn set_count(&mut self, to: u32) {
        self.count.iter_mut().for_each(|(_, count)| *count = to);
    }

    /// Sets the lock after an axis key.
    pub(crate) fn press_axis(&mut self, axis: usize, plane: bool, settings: &Settings) {
        self.lock = self.lock.after_key(axis, plane, settings.orientation);
        self.typed.limit(self.number_count());
        self.trail.forget_rest();
    }

    /// Limits the edit to an axis, as its key does.
    pub fn lock_axis(&mut self, axis: usize, settings: &Settings, view: &View) {
        if self.takes_lock() {
            self.press_axis(axis, false, settings);
            self.update(settings, view, Snap::default());
        }
    }
}

/// What the amount snaps to.
#[derive(Clone, Copy, Default, PartialEq)]
pub(crate) enum Snap {
    #[default]
    Nothing,
    /// Round amounts.
    Steps,
    /// Round places of what is moved, and round amounts otherwise.
    Grid,
    /// This point.
    To(Vec3),
}

impl Snap {
    fn is_round(self) -> bool {
        matches!(self, Self::Steps | Self::Grid)
    }
}

/// What the numbers of an amount measure.
pub(crate) fn measure_of(drag: Drag) -> Measure {
    match drag {
        Drag::Offset | Drag::Distance | Drag::Width => Measure::Length,
        Drag::Rotation => Measure::Angle,
        Drag::Factors | Drag::Fraction | Drag::Slide => Measure::Factor,
    }
}

/// The amount that changes nothing; a split begins in the middle.
fn at_rest(drag: Drag) -> Vec3 {
    match drag {
        Drag::Fraction => Vec3::X * 0.5,
        Drag::Factors => Vec3::ONE,
        Drag::Distance | Drag::Width | Drag::Slide | Drag::Offset | Drag::Rotation => Vec3::ZERO,
    }
}
