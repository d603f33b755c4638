//! `reliefrtl config`: the configuration as it stands, with comments, or its schema.
use super::args::{Cli, ConfigArgs};
use super::load::load;
use crate::config::Config;
use crate::error::{Error, Result};

/// Runs `config`.
pub fn run(cli: &Cli, a: &ConfigArgs) -> Result<()> {
    if a.schema {
        let text = serde_json::to_string_pretty(&Config::schema()).expect("a schema is plain data");
        println!("{text}");
        return Ok(());
    }
    let c = load(cli)?;
    if cli.json {
        println!("{}", serde_json::to_string_pretty(&c).expect("a configuration is plain data"));
        return Ok(());
    }
    if !a.print {
        return Err(Error::input("config needs --print (the configuration) or --schema (its JSON schema)"));
    }
    print!("{}", c.to_commented_toml());
    Ok(())
}
