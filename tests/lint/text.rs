//! What a reviewer of the emitted text would send back: choices without parentheses, registers of a loop without a comment, nets under two names,
//! nets that nothing reads, files of the generator, and a top that grows.
use super::configs::all;
use super::no_problems;
use reliefrtl::config::Config;
use reliefrtl::emit;
use reliefrtl::units::traversal::traverse;
use std::collections::{BTreeMap, BTreeSet};

/// Lines of `traverse` in the configuration of `tests/data/default-8b845fe.toml`, at most.
const MOST_LINES: usize = 700;

const OPERATORS: &[&str] =
    &["|", "&", "^", "+", "-", "*", "<<", ">>", ">>>", "<", "<=", ">", ">=", "==", "!=", "&&", "||"];

/// A part of an expression: what stands between parentheses, braces and commas.
#[derive(Default)]
struct Part {
    choices: u32,
    operators: u32,
}

/// Statements in which a choice stands in a choice, or beside an operator, without parentheses.
fn bare_choices(code: &str) -> Vec<String> {
    code.split(';').filter(|s| s.contains(" ? ") && has_bare_choice(s)).map(|s| s.trim().to_string()).collect()
}

fn has_bare_choice(statement: &str) -> bool {
    let spaced: String =
        statement.chars().flat_map(|c| if "(){}[],?".contains(c) { vec![' ', c, ' '] } else { vec![c] }).collect();
    let mut open = vec![Part::default()];
    let mut bad = false;
    for token in spaced.split_whitespace() {
        // The first `<=` outside of parentheses stores.
        let stores = token == "<=" && open.len() == 1;
        let part = open.last_mut().expect("the statement itself");
        match token {
            "," | "=" => *part = Part::default(),
            _ if stores => *part = Part::default(),
            "?" => part.choices += 1,
            _ if OPERATORS.contains(&token) => part.operators += 1,
            _ => {}
        }
        bad |= part.choices > 1 || (part.choices > 0 && part.operators > 0);
        match token {
            "(" | "{" | "[" => open.push(Part::default()),
            ")" | "}" | "]" if open.len() > 1 => drop(open.pop()),
            _ => {}
        }
    }
    bad
}

/// A file's code, without comments.
fn code(text: &str) -> String {
    text.lines().map(|l| l.split_once("//").map_or(l, |(code, _)| code)).fold(String::new(), |all, l| all + l + "\n")
}

/// The name that a line declares as an inner net, and what follows it.
fn declared(line: &str) -> Option<(&str, &str)> {
    let rest = line.strip_prefix("  wire ").or_else(|| line.strip_prefix("  reg "))?.trim_start();
    let rest = if rest.starts_with('[') { rest.split_once("] ")?.1.trim_start() } else { rest };
    let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(rest.len());
    Some((&rest[..end], rest[end..].trim()))
}

fn is_name(text: &str) -> bool {
    !text.is_empty() && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// Nets that are declared and read by nothing; `read` are words that a file has more often than writing them takes.
fn unread(code: &str) -> Vec<String> {
    let mut words: BTreeMap<&str, usize> = BTreeMap::new();
    code.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).for_each(|w| *words.entry(w).or_default() += 1);
    let nets = code.lines().filter_map(declared).filter(|(name, _)| !name.starts_with("unused_"));
    // Declared with its value; or declared and driven; and read.
    nets.filter(|(name, rest)| words[name] < if rest.starts_with('=') { 2 } else { 3 }).map(|n| n.0.into()).collect()
}

/// Nets that are another net under a second name.
fn second_names(code: &str) -> Vec<String> {
    let twin = |line: &str| {
        declared(line)
            .is_some_and(|(_, rest)| rest.strip_prefix("= ").is_some_and(|v| is_name(v.trim_end_matches(';'))))
    };
    let wire = |line: &str| {
        let (to, from) = line.strip_prefix("  assign ")?.trim_end_matches(';').split_once(" = ")?;
        let inner = code.lines().filter_map(declared).any(|(name, _)| name == to);
        (inner && is_name(from)).then_some(())
    };
    code.lines().filter(|l| twin(l) || wire(l).is_some()).map(|l| l.trim().to_string()).collect()
}

/// The heading over the state of a loop.
const STATE: &str = "// ---- state registers";

/// State of a loop that is declared without saying what it is.
fn without_comment(text: &str) -> Vec<String> {
    let lines: Vec<&str> = text.lines().collect();
    let Some(start) = lines.iter().position(|l| l.contains(STATE)) else { return vec![] };
    let state = (start + 1..lines.len()).take_while(|k| !lines[*k].is_empty());
    let said = |k: usize| lines[k].contains("  // ") || lines[k - 1].trim_start().starts_with("// ");
    state.filter(|k| declared(lines[*k]).is_some() && !said(*k)).map(|k| lines[k].trim().to_string()).collect()
}

/// Nets that no assignment drives, so an instance does, declared without saying what they are.
fn unsaid_outputs(text: &str) -> Vec<String> {
    let code = code(text);
    let assigned: BTreeSet<&str> =
        code.lines().filter_map(|l| l.trim_start().strip_prefix("assign ")?.split([' ', '[']).next()).collect();
    let lines: Vec<&str> = text.lines().collect();
    let bare = |k: usize| !lines[k].contains("//") && !lines[k - 1].trim_start().starts_with("//");
    let open = |k: usize| {
        let line = lines[k].strip_prefix("  wire ").filter(|l| !l.contains(" ="))?;
        let name = line.split("//").next()?.trim().trim_end_matches(';').rsplit(' ').next()?;
        (!assigned.contains(name) && bare(k)).then(|| lines[k].trim().to_string())
    };
    (1..lines.len()).filter_map(open).collect()
}

/// Names of files of the generator.
fn generator_files(text: &str) -> Vec<String> {
    let ends = |rest: &str| !rest.starts_with(|c: char| c.is_ascii_alphanumeric() || c == '_' || c == '(');
    text.lines()
        .filter(|l| l.match_indices(".rs").any(|(at, s)| ends(&l[at + s.len()..])))
        .map(str::to_string)
        .collect()
}

#[test]
fn nothing_is_left_that_a_reviewer_would_send_back() {
    let mut problems = Vec::new();
    let (mut registers, mut loops) = (0, 0);
    for e in all() {
        for (path, text) in &e.files {
            let mut say = |what: &str, found: Vec<String>| {
                problems.extend(found.iter().map(|line| format!("{}: {path}: {what}: {line}", e.label)));
            };
            say("a file of the generator", generator_files(text));
            if !path.ends_with(".v") {
                continue;
            }
            let code = code(text);
            loops += usize::from(text.contains(STATE));
            registers += text.lines().filter(|l| l.contains("_q;") && l.contains("// ")).count();
            say("a choice without parentheses", bare_choices(&code));
            say("a net that nothing reads", unread(&code));
            say("a net under a second name", second_names(&code));
            say("a register without a comment", without_comment(text));
            say("an output of an instance without a comment", unsaid_outputs(text));
        }
    }
    no_problems(&problems);
    assert!(loops > 100, "only {loops} modules have state: is its heading another one now?");
    assert!(registers > 1000, "only {registers} registers have a comment");
}

#[test]
fn the_top_stays_short() {
    let config = Config::from_toml(include_str!("../data/default-8b845fe.toml"), "default-8b845fe.toml").unwrap();
    let top = traverse(&config.design()).module;
    let text = &emit::rtl(&config, &[top])["rtl/traverse.v"];
    let lines = text.lines().count();
    assert!(lines <= MOST_LINES, "{lines} lines, and {MOST_LINES} are allowed");
}

#[test]
fn the_rules_find_what_they_are_for() {
    for bad in ["x = a ? b : c ? d : e;", "q <= a == b ? c : d;", "x = {a ? b : c | d};", "x = a & b ? c : d;"] {
        assert_eq!(bare_choices(bad).len(), 1, "{bad}");
    }
    for good in ["x = a ? b : (c ? d : e);", "q <= (a == b) ? c : (d + e);", "x = {a ? b : c, d | e};", "x = a | b;"] {
        assert_eq!(bare_choices(good), [""; 0], "{good}");
    }
    assert_eq!(unread("  wire a = b;\n  wire [3:0] c;\n  unit u (.x(c));\n"), ["a", "c"]);
    assert_eq!(unread("  wire a = b;\n  wire c;\n  unit u (.x(c), .y(a), .z(c));\n"), [""; 0]);
    assert_eq!(
        second_names("  wire a = b;\n  wire c;\n  wire e = f[0];\n  assign c = d;\n  assign out = c;\n").len(),
        2
    );
    let state = "  // ---- state registers, written at the end of the module\n  reg a;  // said\n  // said before\n  reg b;\n  reg c;\n\n  reg d;\n";
    assert_eq!(without_comment(state), ["reg c;"]);
    let outputs =
        "module m (\n);\n  wire a;\n  wire b;  // said\n  // said\n  wire [3:0] c;\n  wire d;\n  assign d = a;\n";
    assert_eq!(unsaid_outputs(outputs), ["wire a;"]);
    assert_eq!(generator_files("// add.rs\n.rst(rst), .rs(x)\n").len(), 1);
}
