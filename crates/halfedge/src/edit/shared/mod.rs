//! What several edits share.

mod blend;
mod directions;
mod face_sample;
mod followers;
mod rails;
mod region;
mod steps;
mod walls;

pub(crate) use blend::{Blend, between};
pub(crate) use directions::{counter_clockwise, miter};
pub(crate) use face_sample::numbers;
pub(crate) use followers::{Follower, Followers};
pub(crate) use rails::{Along, slide_along};
pub use rails::{Rail, SLIDE_AMOUNT_RANGE, check_amount};
pub(crate) use region::{follow_merged, merge_corners, outline};
pub use walls::Grouping;
pub(crate) use walls::{Walls, walls};
