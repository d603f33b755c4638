//! Tables whose JSON, CSV and HTML come from the same values.
use serde_json::{Map, Number, Value, json};

/// A column.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// Its name in JSON and CSV.
    pub key: &'static str,
    /// Its heading on the page; empty leaves it out there.
    pub head: &'static str,
}

/// A table.
#[derive(Clone, Debug)]
pub struct Table {
    /// Its name in JSON, and of its CSV file.
    pub name: &'static str,
    /// Columns.
    pub columns: Vec<Column>,
    /// Rows: texts, numbers or null.
    pub rows: Vec<Vec<Value>>,
}

/// A real number as a value; what is not finite becomes null.
pub fn real(x: f64) -> Value {
    Number::from_f64(x).map_or(Value::Null, Value::Number)
}

/// A number for people: three to four digits.
pub fn short(x: f64) -> String {
    let size = x.abs();
    match size {
        _ if x == 0.0 => "0".to_owned(),
        _ if size >= 1000.0 => format!("{x:.0}"),
        _ if size >= 100.0 => format!("{x:.1}"),
        _ if size >= 1.0 => format!("{x:.2}"),
        _ if size >= 0.001 => format!("{x:.4}"),
        _ => format!("{x:.1e}"),
    }
}

/// A count for people: its digits in threes.
pub fn grouped(n: u64) -> String {
    let digits = n.to_string();
    let mut out = String::new();
    for (k, c) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) && digits.len() > 4 {
            out.push('\u{202f}');
        }
        out.push(c);
    }
    out
}

/// A value for people.
pub fn shown(v: &Value) -> String {
    match v {
        Value::Null => "–".to_owned(),
        Value::Number(n) if n.is_u64() => grouped(n.as_u64().unwrap_or(0)),
        Value::String(s) => s.clone(),
        Value::Number(n) if n.is_f64() => short(n.as_f64().unwrap_or(0.0)),
        other => other.to_string(),
    }
}

/// A value to the last digit, as in JSON; texts without quotes.
pub fn exact(v: &Value) -> String {
    match v {
        Value::Null => String::new(),
        Value::String(s) => s.clone(),
        other => other.to_string(),
    }
}

impl Table {
    /// An empty table of `(key, heading)` columns.
    pub fn new(name: &'static str, columns: &[(&'static str, &'static str)]) -> Self {
        let columns = columns.iter().map(|&(key, head)| Column { key, head }).collect();
        Self { name, columns, rows: Vec::new() }
    }

    /// Adds a row.
    ///
    /// # Panics
    /// If it has not a value a column.
    pub fn push(&mut self, row: Vec<Value>) {
        assert_eq!(row.len(), self.columns.len(), "{}: a value a column", self.name);
        self.rows.push(row);
    }

    /// An array of objects.
    pub fn json(&self) -> Value {
        let object = |row: &Vec<Value>| {
            let pairs = self.columns.iter().zip(row).map(|(c, v)| (c.key.to_owned(), v.clone()));
            Value::Object(pairs.collect::<Map<_, _>>())
        };
        self.rows.iter().map(object).collect()
    }

    /// CSV with a heading line; numbers with the digits of the JSON.
    ///
    /// # Panics
    /// Never: memory takes every write.
    pub fn csv(&self) -> Vec<u8> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(self.columns.iter().map(|c| c.key)).expect("memory takes every write");
        for row in &self.rows {
            writer.write_record(row.iter().map(exact)).expect("memory takes every write");
        }
        writer.into_inner().expect("memory takes every write")
    }

    /// What the template draws: headings, and of each value the short text, all digits, and whether it is a number.
    pub fn page(&self) -> Value {
        let shown_columns: Vec<usize> = (0..self.columns.len()).filter(|c| !self.columns[*c].head.is_empty()).collect();
        let numeric = |c: usize| self.rows.iter().all(|r| r[c].is_number() || r[c].is_null());
        let head: Vec<Value> = shown_columns
            .iter()
            .map(|c| json!({"text": self.columns[*c].head, "number": !self.rows.is_empty() && numeric(*c)}))
            .collect();
        let value = |c: usize, v: &Value| json!({"text": shown(v), "exact": exact(v), "number": v.is_number(), "right": numeric(c), "code": self.columns[c].key == "command"});
        let rows: Vec<Vec<Value>> =
            self.rows.iter().map(|r| shown_columns.iter().map(|c| value(*c, &r[*c])).collect()).collect();
        json!({"name": self.name, "head": head, "rows": rows})
    }
}
