//! Whether simulators and other tools are asked: a missing one fails a test unless `RELIEFRTL_NO_SIMULATORS=1`.

/// True if tests go without; it is said where the test's output is.
pub fn skip() -> bool {
    let skip = std::env::var("RELIEFRTL_NO_SIMULATORS").is_ok_and(|v| v == "1");
    if skip {
        println!("skipped: RELIEFRTL_NO_SIMULATORS=1");
    }
    skip
}
