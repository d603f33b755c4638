//! The report on a tiny selection: page, JSON and CSV hold the same numbers, and a resumed run writes the same bytes.
use reliefrtl::config::Config;
use reliefrtl::report::page::{Extent, Output, Plan, Work, cells, files, write};
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;

fn run(plan: &Plan, dir: &Path) -> (Output, Work) {
    let (cells, work) = cells(plan, dir, &|_, _| {}).unwrap();
    let files = files(plan, &cells, "reliefrtl report").unwrap();
    write(dir, &files).unwrap();
    (files, work)
}

fn text<'a>(files: &'a Output, name: &str) -> &'a str {
    let (_, bytes) = files.iter().find(|f| f.0 == name).unwrap_or_else(|| panic!("no {name}"));
    std::str::from_utf8(bytes).unwrap()
}

/// The text of a JSON value as the CSV has it.
fn plain(v: &Value) -> String {
    match v {
        Value::Null => String::new(),
        Value::String(s) => s.clone(),
        other => other.to_string(),
    }
}

/// Numbers of the HTML table with this id, in order, all digits.
fn page_numbers(html: &str, id: &str) -> Vec<String> {
    let table = html.split(&format!("<table id=\"{id}\">")).nth(1).unwrap_or_else(|| panic!("no table {id}"));
    let table = table.split("</table>").next().unwrap();
    table.split("data-v=\"").skip(1).map(|s| s.split('"').next().unwrap().to_owned()).collect()
}

#[test]
fn page_json_and_csv_hold_the_same_numbers_and_a_resumed_run_the_same_bytes() {
    let plan = Plan::new(&Config::default(), Extent::Tiny, None).unwrap();
    let dir = tempfile::tempdir().unwrap();
    let (first, work) = run(&plan, dir.path());
    assert_eq!((work.measured, work.taken), (plan.cells.len(), 0));
    let json: Value = serde_json::from_str(text(&first, "report.json")).unwrap();
    for name in ["cells", "pareto", "steps", "published"] {
        let mut csv = csv::Reader::from_reader(text(&first, &format!("{name}.csv")).as_bytes());
        let keys: Vec<String> = csv.headers().unwrap().iter().map(str::to_owned).collect();
        let rows: Vec<csv::StringRecord> = csv.records().map(Result::unwrap).collect();
        let objects = json[name].as_array().unwrap();
        assert_eq!(rows.len(), objects.len(), "{name}");
        assert!(name == "published" || !rows.is_empty(), "{name} is empty");
        for (row, object) in rows.iter().zip(objects) {
            keys.iter().zip(row).for_each(|(k, v)| assert_eq!(plain(&object[k]), v, "{name}.{k}"));
        }
    }
    let html = text(&first, "report.html");
    let mut numbers = 0;
    for id in ["worst", "pareto", "series", "steps", "histogram", "matrix", "maps", "bilinear"] {
        // The page leaves no column with a number out, so that all of a table's numbers stand there in the order of the JSON.
        let values = json[id].as_array().unwrap().iter().flat_map(|row| row.as_object().unwrap().values());
        let expected: Vec<String> = values.filter(|v| v.is_number()).map(plain).collect();
        assert_eq!(page_numbers(html, id), expected, "{id}");
        numbers += expected.len();
    }
    assert!(numbers > 200, "{numbers} numbers compared");
    for word in ["http://", "https://", "src=\"/"] {
        assert!(!html.contains(word), "the page needs nothing from outside: {word}");
    }

    // Stopped in the middle: some cells are there, one is half a file, one is of another model.
    let stored =
        || -> BTreeSet<_> { std::fs::read_dir(dir.path().join("cells")).unwrap().map(|f| f.unwrap().path()).collect() };
    let names = stored();
    let bytes: Vec<Vec<u8>> = names.iter().map(|p| std::fs::read(p).unwrap()).collect();
    let mut paths = names.iter();
    std::fs::remove_file(paths.next().unwrap()).unwrap();
    std::fs::write(paths.next().unwrap(), b"{\"spec\":").unwrap();
    let other = paths.next().unwrap();
    let probe = std::fs::read_to_string(other).unwrap().replace("\"probe\":\"", "\"probe\":\"0");
    std::fs::write(other, probe).unwrap();
    let (again, work) = run(&plan, dir.path());
    assert_eq!((work.measured, work.taken), (3, plan.cells.len() - 3));
    assert!(first == again, "a resumed run writes other bytes");
    assert_eq!(stored(), names);
    assert_eq!(names.iter().map(|p| std::fs::read(p).unwrap()).collect::<Vec<_>>(), bytes);
}

#[test]
fn what_has_no_datapath_is_listed_with_its_reason() {
    let mut c = Config::default();
    // Sixteen-bit heights are exact in no format of ten fraction bits.
    c.traverse.height_bits = 16;
    let plan = Plan::new(&c, Extent::Tiny, None).unwrap();
    let refused = plan.not_legal.iter().find(|r| r.design.starts_with("watertight 7/7")).expect("7/7 is refused");
    assert!(refused.reason.contains("height_bits"), "{}", refused.reason);
    let listed: BTreeSet<usize> = plan.cells.iter().map(|c| c.2).collect();
    assert_eq!(listed.len() + plan.not_legal.len(), plan.designs.len(), "every design is measured or refused");
}
