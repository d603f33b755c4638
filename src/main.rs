//! The command line.
fn main() {
    // A reader that has seen enough (`| head`) is no reason for a backtrace.
    let report = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        let text = panic.payload().downcast_ref::<String>().map_or("", String::as_str);
        if text.contains("failed printing to stdout") {
            let broken = text.contains("Broken pipe");
            if !broken {
                eprintln!("reliefrtl: cannot write to standard output: {text}");
            }
            std::process::exit(if broken { 0 } else { reliefrtl::error::exit::USAGE });
        }
        report(panic);
    }));
    std::process::exit(reliefrtl::cli::main());
}
