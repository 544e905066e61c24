//! `stickslip record FILE --describe`: what a file holds, without a machine.

use crate::args::RecordArgs;
use crate::bits::digits;
use crate::failure::Outcome;
use crate::figure::Target;
use crate::measured::{self, Fields};
use crate::under_record::drawn_load;
use crate::{motion_plot, output, rows};
use serde::Serialize;
use std::io::{BufReader, Cursor, Read, Write};
use std::path::Path;
use stickslip_draw::{Axis, Figure, Panel, Series, Style};
use stickslip_front::record::{Channel, describe};
use stickslip_front::text::printable;

/// A channel in JSON.
#[derive(Serialize)]
struct Entry<'a> {
    #[serde(flatten)]
    fields: Fields<'a>,
    /// In Hz.
    peak_frequency: Option<f64>,
    /// Their beginnings and ends in s.
    gaps: &'a [[f64; 2]],
}

#[derive(Serialize)]
struct Entries<'a> {
    channels: Vec<Entry<'a>>,
}

pub(crate) fn run(args: &RecordArgs, out: &mut impl Write) -> Outcome {
    let is_json = args.answer.format.is_json("record")?;
    args.look.needs("--picture", args.picture.as_deref())?;
    let target = Target::new("--picture", args.picture.as_deref(), args.overwrite, &args.look)?;
    let reader = args.answer.units.reader();
    let name = args.file.display().to_string();
    let options = measured::options(&args.load, &name, &reader);
    if let Some(text) = args.load.scale.as_ref().filter(|_| options.scale.is_none()) {
        return Err(format!(
            "--scale {text}: must be left out with --describe, unless it is such as 2.5 N/V"
        )
        .into());
    }
    // Standard input is read once.
    let mut kept = Vec::new();
    if args.file == Path::new("-") {
        rows::open(&args.file, &name)?.read_to_end(&mut kept)?;
    }
    let open = || -> Result<BufReader<Box<dyn Read + '_>>, String> {
        if args.file == Path::new("-") {
            return Ok(BufReader::new(Box::new(Cursor::new(kept.as_slice()))));
        }
        rows::open(&args.file, &name)
            .map(|file| BufReader::new(file as Box<dyn Read>))
            .map_err(|e| e.to_string())
    };
    let channels = describe(open, &options)?;
    if args.picture.is_some() {
        let file = args.file.file_name().unwrap_or_default().to_string_lossy();
        let title = format!("Record {file}");
        let panels: Vec<_> = channels.iter().map(|channel| panel(channel, args)).collect();
        target.draw(out, || Ok(Figure::new("record", title, "", panels).stacked()))?;
    }
    if is_json {
        fn entry(channel: &Channel) -> Entry<'_> {
            let Channel { record, summary, peak_frequency, gaps } = channel;
            Entry { fields: Fields(summary, record.after().name()), peak_frequency: *peak_frequency, gaps }
        }
        return output::json(&Entries { channels: channels.iter().map(entry).collect() }, out);
    }
    for channel in &channels {
        // The name of a channel is the file's.
        writeln!(out, "{}", printable(&channel.sentences(digits)))?;
    }
    Ok(())
}

/// The samples of a channel over time.
fn panel(channel: &Channel, args: &RecordArgs) -> Panel {
    let system = args.answer.units.reader().system();
    let (name, kind, load) = drawn_load(&channel.record, &system);
    let (first, last) = (channel.record.time(0), channel.record.end());
    let y =
        motion_plot::axis(&format!("{name} ({})", system.name(kind)), load.iter().map(|point| point.1), 0.08);
    let title = channel
        .summary
        .channel
        .as_ref()
        .map_or_else(|| name.to_owned(), |channel| printable(channel).into_owned());
    Panel::new(title, Axis::linear("time (s)", first, last), y, vec![Series::new("", Style::Line, 1, load)])
}
