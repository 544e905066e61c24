//! The value of a file whose numbers are as they are typed.
//!
//! A number of JSON in memory is a double. One that a double does not have becomes its text, which the fields of quantities take, too.

use super::decimal::is_of_a_double;
use super::file::{is_json, parsed};
use super::unique::Unique;
use serde_json::Value;
use toml::de::{DeTable, DeValue};

/// The value of a file's text, as [`parsed`], with texts in place of the numbers that are no shortest text of a double.
///
/// # Errors
/// As [`parsed`].
pub fn parsed_as_typed(text: &str, name: &str) -> Result<Value, String> {
    let mut value = parsed(text, name)?;
    if is_json(text) {
        return serde_json::from_str(&quoted(text))
            .map(|Unique(value)| value)
            .map_err(|e| format!("{name}: {e}"));
    }
    let table = DeTable::parse(text).map_err(|e| format!("{name}: {}", e.message()))?;
    as_in_table(&mut value, table.get_ref());
    Ok(value)
}

/// A text of JSON with quotation marks about its numbers that a double does not have.
fn quoted(text: &str) -> String {
    let mut result = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let length = match first {
            '"' => of_string(rest),
            '-' | '0'..='9' => rest
                .find(|c: char| !matches!(c, '0'..='9' | '+' | '-' | '.' | 'e' | 'E'))
                .unwrap_or(rest.len()),
            other => other.len_utf8(),
        };
        let (token, others) = rest.split_at(length);
        let is_text = first == '-' || first.is_ascii_digit();
        let mark = if is_text && !is_of_a_double(token) { "\"" } else { "" };
        result.extend([mark, token, mark]);
        rest = others;
    }
    result
}

/// The length of the text in quotation marks at the beginning.
fn of_string(text: &str) -> usize {
    let mut is_escaped = false;
    let end = text.char_indices().skip(1).find(|(_, c)| {
        let is_end = *c == '"' && !is_escaped;
        is_escaped = *c == '\\' && !is_escaped;
        is_end
    });
    end.map_or(text.len(), |(place, _)| place.saturating_add(1))
}

fn as_in_table(value: &mut Value, table: &DeTable<'_>) {
    for (name, typed) in table {
        if let Some(value) = value.get_mut(name.get_ref().as_ref()) {
            as_in_toml(value, typed.get_ref());
        }
    }
}

/// Puts the texts of numbers into a value of TOML.
fn as_in_toml(value: &mut Value, typed: &DeValue<'_>) {
    match typed {
        DeValue::Float(number) if !is_of_a_double(number.as_str()) => {
            *value = Value::String(number.as_str().to_owned());
        }
        DeValue::Array(list) => {
            let values = value.as_array_mut().into_iter().flatten();
            values.zip(list.iter()).for_each(|(value, typed)| as_in_toml(value, typed.get_ref()));
        }
        DeValue::Table(table) => as_in_table(value, table),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn numbers_that_a_double_does_not_have_are_texts() {
        let json = r#"{"a": [0.1, 0.12345678901234567890, -1e-300, 25, 1e22], "b\"1": "2.00000000000000000001", "c": {"d": 3.0000000000000001}}"#;
        let due = json!({
            "a": [0.1, "0.12345678901234567890", "-1e-300", 25, 1e22],
            "b\"1": "2.00000000000000000001",
            "c": {"d": "3.0000000000000001"},
        });
        assert_eq!(parsed_as_typed(json, "x").unwrap(), due);
        let toml = "a = [0.1, 0.123_456_789_012_345_678_90, -1e-300, 25]\n[[c]]\nd = 3.0000000000000001 # 3.0000000000000002\n[c.e]\nf = \"1\"\n";
        let due = json!({
            "a": [0.1, "0.12345678901234567890", "-1e-300", 25],
            "c": [{"d": "3.0000000000000001", "e": {"f": "1"}}],
        });
        assert_eq!(parsed_as_typed(toml, "x").unwrap(), due);
        // What is wrong is said as without more digits.
        for wrong in ["{\"a\": 1, \"a\": 2}", "a = ", "a = inf"] {
            assert_eq!(parsed_as_typed(wrong, "x"), parsed(wrong, "x"));
            assert!(parsed(wrong, "x").is_err());
        }
    }
}
