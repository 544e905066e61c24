//! The library behind the page in the browser: a question as JSON goes in, its answer as JSON comes out.
//!
//! A question is an object with the field `ask`, the name of one of [`QUESTIONS`], and with `inputs`, the typed values of a
//! machine by their keywords, in `units` or else in SI. The answer is `{"ok": …}`, or `{"error": "…"}` with a line of the
//! library. Numbers are those of the library at f64, written with as many digits as identify them.

mod answer;
mod asked;
mod curve;
mod design;
mod drift;
mod limits;
mod map;
mod motion;
mod record;
mod system;

use asked::Asked;
use serde_json::{Value, json};
use std::cell::RefCell;

/// What a question is answered by.
type Answer = fn(&Asked<'_>) -> Result<Value, String>;

/// The questions by their names.
pub const QUESTIONS: [(&str, Answer); 11] = [
    ("answer", answer::answer),
    ("curve", curve::curve),
    ("motion", motion::motion),
    ("map", map::map),
    ("limits", limits::limits),
    ("design", design::design),
    ("record", record::record),
    ("record-table", record::table),
    ("spectrum", record::spectrum),
    ("system", system::system),
    ("system-curve", system::curve),
];

/// The answer to a question, as text.
#[must_use]
pub fn answered(question: &str) -> String {
    let found = serde_json::from_str::<Value>(question).map_err(|e| e.to_string()).and_then(|question| {
        let name = question.get("ask").and_then(Value::as_str).unwrap_or_default();
        let (_, answer) = QUESTIONS
            .into_iter()
            .find(|(own, _)| *own == name)
            .ok_or_else(|| format!("ask {name}: is unknown"))?;
        answer(&Asked(&question))
    });
    match found {
        Ok(answer) => json!({ "ok": answer }),
        Err(error) => json!({ "error": error }),
    }
    .to_string()
}

thread_local! {
    /// The text of the question, then that of its answer.
    static TEXT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Room for a question of so many bytes; the page writes it there.
#[allow(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn question(length: usize) -> *mut u8 {
    TEXT.with_borrow_mut(|text| {
        *text = vec![0; length];
        text.as_mut_ptr()
    })
}

/// Answers the question, and returns the length of the answer in bytes.
#[allow(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn ask() -> usize {
    let question = TEXT.take();
    let answer = answered(&String::from_utf8_lossy(&question)).into_bytes();
    let length = answer.len();
    TEXT.set(answer);
    length
}

/// The place of the answer.
#[allow(unsafe_code, reason = "a name for the page")]
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> *const u8 {
    TEXT.with_borrow(|text| text.as_ptr())
}
