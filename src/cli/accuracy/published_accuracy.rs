//! `reliefrtl accuracy --scenes`: wrong texels and position errors on the published scenes, in floating and in fixed point.
use crate::cli::args::Cli;
use crate::cli::output::{spinner, table};
use crate::config::Config;
use crate::error::Result;
use crate::project::{Found, Rate, published_rates};
use std::path::Path;

/// Prints the rates.
///
/// # Errors
/// A scene that can't be read; a configuration that is not legal at a size.
pub fn run(cli: &Cli, c: &Config, dir: &Path) -> Result<()> {
    let bar = spinner(cli, "measuring");
    let rates = published_rates(c, dir, &|what| bar.set_message(what))?;
    bar.finish_and_clear();
    if cli.json {
        println!("{}", serde_json::to_string_pretty(&rates).expect("plain data"));
        return Ok(());
    }
    let head = [
        "datapath",
        "texels",
        "wrong texels",
        "%",
        "given up",
        "uv error p99, texel",
        "largest",
        "of ray",
        "its u v du dv (hex)",
    ];
    print!("{}", table(&head, &rates.iter().map(line).collect::<Vec<_>>()));
    let worst: Vec<Vec<String>> = rates
        .iter()
        .filter_map(|r| {
            let w = r.worst_wrong.as_ref()?;
            let of = format!("{} of {}", r.wrong, r.rays);
            let margin = format!("{:.1e}", w.value);
            Some(vec![r.datapath.clone(), r.texels.to_string(), of, margin, place(w), w.words.join(" ")])
        })
        .collect();
    if !worst.is_empty() {
        println!("\nthe wrong texel farthest from another decision, of each:");
        print!("{}", table(&["datapath", "texels", "wrong", "margin", "ray", "u v du dv (hex)"], &worst));
    }
    println!(
        "\nrocks, stones, four, saints as published, three views each, every {} pixels each way; `trace` shows a ray again",
        c.view.stride
    );
    Ok(())
}

fn place(f: &Found) -> String {
    format!("{} {} @{}", f.scene, f.view, f.ray)
}

fn line(r: &Rate) -> Vec<String> {
    let far = r.uv_largest.as_ref();
    vec![
        r.datapath.clone(),
        r.texels.to_string(),
        format!("{} of {}", r.wrong, r.rays),
        format!("{:.4}", r.wrong_percent),
        r.given_up.to_string(),
        format!("{:.2e}", r.uv_p99),
        far.map_or(String::new(), |f| format!("{:.2e}", f.value)),
        far.map_or(String::new(), place),
        far.map_or(String::new(), |f| f.words.join(" ")),
    ]
}
