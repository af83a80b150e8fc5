//! Flip, collapse and the other small ones on cases worked out by hand.
