//! Names in the emitted text: the parts that `docs/glossary.md` refuses stand in none that is declared.
use super::configs::all;
use super::no_problems;

/// The refused parts, each with what is right instead.
fn rules() -> Vec<(String, String)> {
    let text = include_str!("../../docs/glossary.md");
    let table =
        text.lines().skip_while(|l| !l.starts_with("Parts of the names")).skip_while(|l| !l.starts_with("| not"));
    let rows = table.skip(2).take_while(|l| l.starts_with('|'));
    rows.map(|row| {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
        (cells[0].trim_matches('`').to_owned(), cells[1].to_owned())
    })
    .collect()
}

/// The name that a line declares: a net, a port, or an instance.
fn declared(line: &str) -> Option<&str> {
    let code = line.split("//").next().unwrap_or_default().trim_start();
    if let Some((_, instance)) = code.split_once(" u_").filter(|_| code.trim_end().ends_with('(')) {
        return instance.split_whitespace().next();
    }
    let rest = ["input", "output", "wire", "reg", "genvar", "integer"].iter().find_map(|k| code.strip_prefix(k))?;
    let rest = rest.trim_start().trim_start_matches("wire ").trim_start_matches("reg ").trim_start();
    let rest = if rest.starts_with('[') { rest.split_once(']').map_or("", |(_, after)| after) } else { rest };
    let name = rest.trim_start().split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).next()?;
    (!name.is_empty()).then_some(name)
}

/// What is wrong with one file: line number and finding.
fn problems_of(text: &str, rules: &[(String, String)]) -> Vec<(usize, String)> {
    let find = |(i, line): (usize, &str)| -> Vec<(usize, String)> {
        let parts: Vec<&str> = declared(line).unwrap_or_default().split('_').collect();
        let broken = rules.iter().filter(|(word, _)| parts.contains(&word.as_str()));
        broken.map(|(word, right)| (i + 1, format!("not \"{word}\" but {right}: {}", line.trim()))).collect()
    };
    text.lines().enumerate().flat_map(find).collect()
}

#[test]
fn no_part_of_a_name_is_refused() {
    let rules = rules();
    assert!(rules.len() >= 25, "{rules:?}");
    let (mut bad, mut names) = (Vec::new(), 0);
    for e in all() {
        for (path, text) in e.files.iter().filter(|(path, _)| path.starts_with("rtl/") && path.ends_with(".v")) {
            names += text.lines().filter_map(declared).count();
            bad.extend(problems_of(text, &rules).into_iter().map(|(line, what)| format!("{path}:{line}: {what}")));
        }
    }
    println!("{names} declarations, {} rules", rules.len());
    assert!(names > 10_000, "{names}");
    bad.sort();
    bad.dedup();
    no_problems(&bad);
}

#[test]
fn the_rules_find_what_they_are_for() {
    let rules = rules();
    for (word, _) in &rules {
        let lines = [
            format!("  wire [W-1:0] s3_{word} = a;"),
            format!("  reg {word}_q;"),
            format!("  input  wire [3:0]  x_{word},  // it"),
            format!("  ) u_{word}_x ("),
            format!("  relief_lzc #(.W(8)) u_{word} ("),
        ];
        lines.iter().for_each(|l| assert_eq!(problems_of(l, &rules).len(), 1, "{l}"));
        assert_eq!(problems_of(&format!("  wire s0_{word}x;  // {word}"), &rules), []);
    }
}
