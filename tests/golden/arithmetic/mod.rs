//! Arithmetic: the golden model against oracles, and the units of arithmetic against the golden model, in all engines.
mod div_table;
mod float_choices;
mod float_engines;
mod float_oracle;
mod levels;
mod reciprocal_table;
mod softfloat;
