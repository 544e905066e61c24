//! The numbers and the packed streams of a page.

use flate2::Compression;
use flate2::write::ZlibEncoder;
use std::io::{self, Write as _};

/// A number to a thousandth of its unit, without an exponent, which PDF does not know.
pub(super) fn number(value: f32) -> String {
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text.is_empty() || text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// A stream of bytes as an object, with further entries.
pub(super) fn packed(content: &[u8], entries: &str) -> io::Result<Vec<u8>> {
    let mut packed = ZlibEncoder::new(Vec::new(), Compression::default());
    packed.write_all(content)?;
    let packed = packed.finish()?;
    let mut object =
        format!("<</Length {}/Filter/FlateDecode{entries}>>\nstream\n", packed.len()).into_bytes();
    object.extend(packed);
    object.extend(b"\nendstream");
    Ok(object)
}
