//! The golden traversal against exact arithmetic, and the parts that it is made of.
mod bilinear;
mod border;
mod hard;
mod oracle;
mod parts;
mod traverse;
