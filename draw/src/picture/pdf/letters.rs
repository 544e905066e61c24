//! The letters of a page: glyphs of an embedded part of DejaVu Sans with their meaning, so that a text is found and copied.
//!
//! PDF 32000-1:2008, 9.4 (text), 9.7 (composite fonts), 9.9 (font programs), 9.10.3 (from glyphs to Unicode).

use super::objects::{number, packed};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io;
use subsetter::GlyphRemapper;

/// The entries that a section of a table of meanings has at most.
const SECTION: usize = 100;

/// The glyphs that a page uses, by numbers of their own, with what they mean.
pub(super) struct Letters {
    font: &'static [u8],
    numbers: GlyphRemapper,
    meanings: BTreeMap<u16, String>,
}

impl Letters {
    pub(super) fn new() -> Self {
        Self { font: dejavu::sans::regular(), numbers: GlyphRemapper::new(), meanings: BTreeMap::new() }
    }

    /// The number of a glyph that stands for this text.
    pub(super) fn number(&mut self, glyph: u16, text: &str) -> u16 {
        let number = self.numbers.remap(glyph);
        if !text.is_empty() {
            self.meanings.entry(number).or_insert_with(|| text.to_owned());
        }
        number
    }

    pub(super) fn is_empty(&self) -> bool {
        self.meanings.is_empty()
    }

    /// The units of the font in its size.
    pub(super) fn units(&self) -> f32 {
        f32::from(self.at(b"head", 18).unwrap_or(1000).max(1))
    }

    /// A number of two bytes in a table of the font.
    fn at(&self, table: &[u8; 4], offset: usize) -> Option<u16> {
        let bytes =
            |from: usize| self.font.get(from..from.checked_add(2)?)?.try_into().ok().map(u16::from_be_bytes);
        let row = self
            .font
            .get(12..)?
            .chunks_exact(16)
            .take(usize::from(bytes(4)?))
            .find(|row| row.starts_with(table))?;
        let place = u32::from_be_bytes(row.get(8..12)?.try_into().ok()?);
        bytes(usize::try_from(place).ok()?.checked_add(offset)?)
    }

    /// The width of a glyph in thousandths of the size; the last one of the table is that of all that follow.
    fn width(&self, glyph: u16) -> f32 {
        let last = self.at(b"hhea", 34).unwrap_or(1).saturating_sub(1);
        let width = self.at(b"hmtx", 4 * usize::from(glyph.min(last))).unwrap_or_default();
        1000.0 * f32::from(width) / self.units()
    }

    /// The objects of the font, the first of which has this number.
    pub(super) fn objects(&self, first: usize) -> io::Result<Vec<Vec<u8>>> {
        let program = subsetter::subset(self.font, 0, &self.numbers).map_err(io::Error::other)?;
        let widths: Vec<_> = self.numbers.remapped_gids().map(|glyph| number(self.width(glyph))).collect();
        let name = "/SLIPST+DejaVuSans";
        let [inner, metrics, file, meanings] = [1, 2, 3, 4].map(|more| first.saturating_add(more));
        Ok(vec![
            format!(
                "<</Type/Font/Subtype/Type0/BaseFont{name}/Encoding/Identity-H/DescendantFonts[{inner} 0 R]/ToUnicode {meanings} 0 R>>"
            )
            .into_bytes(),
            format!(
                "<</Type/Font/Subtype/CIDFontType2/BaseFont{name}/CIDSystemInfo<</Registry(Adobe)/Ordering(Identity)/Supplement 0>>\
                 /FontDescriptor {metrics} 0 R/CIDToGIDMap/Identity/W[0[{}]]>>",
                widths.join(" ")
            )
            .into_bytes(),
            // The measures of DejaVu Sans 2.37 in thousandths of its size.
            format!(
                "<</Type/FontDescriptor/FontName{name}/Flags 4/FontBBox[-1021 -463 1793 1232]/ItalicAngle 0/Ascent 928\
                 /Descent -236/CapHeight 729/StemV 90/FontFile2 {file} 0 R>>"
            )
            .into_bytes(),
            packed(&program, &format!("/Length1 {}", program.len()))?,
            packed(self.meanings().as_bytes(), "")?,
        ])
    }

    /// The table from the numbers of the glyphs to Unicode.
    fn meanings(&self) -> String {
        let mut table = "/CIDInit/ProcSet findresource begin\n12 dict begin\nbegincmap\n\
             /CIDSystemInfo<</Registry(Adobe)/Ordering(UCS)/Supplement 0>>def\n/CMapName/Adobe-Identity-UCS def\n/CMapType 2 def\n\
             1 begincodespacerange\n<0000><ffff>\nendcodespacerange\n"
            .to_owned();
        let all: Vec<_> = self.meanings.iter().collect();
        for part in all.chunks(SECTION) {
            let _ = writeln!(table, "{} beginbfchar", part.len());
            for (number, text) in part {
                let text: String = text.encode_utf16().map(|unit| format!("{unit:04x}")).collect();
                let _ = writeln!(table, "<{number:04x}><{text}>");
            }
            table.push_str("endbfchar\n");
        }
        table.push_str("endcmap\nCMapName currentdict/CMap defineresource pop\nend\nend");
        table
    }
}
