//! The command line.
fn main() {
    std::process::exit(reliefrtl::cli::main());
}
