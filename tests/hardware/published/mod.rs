//! The published datapath: hardware and golden model equal to the bit, figures of its errors, and what it is made of.
//!
//! Positions are moved in floating point, so hits may depend on the mode and rays may never end: both are measured here, not forbidden.
mod engines;
mod figures;
mod hardware;
mod scenes;
