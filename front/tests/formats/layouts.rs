//! Files in the layouts of agencies and of columns, written from drawn samples.

use proptest::prelude::*;

/// What is drawn of a file.
#[derive(Debug, Clone)]
pub(crate) struct Drawn {
    /// The digits of the samples, from −9999999 to 9999999.
    pub(crate) digits: Vec<i32>,
    /// Lines end as in DOS, with its end of file after the last.
    pub(crate) dos: bool,
    pub(crate) blank_lines: bool,
    pub(crate) trailing_text: bool,
    /// Negative numbers touch the ones before them.
    pub(crate) glued: bool,
    pub(crate) per_line: usize,
    /// The step in ms.
    pub(crate) step: u32,
    /// Which of the forms of a header, unit or delimiter.
    pub(crate) form: usize,
}

pub(crate) fn drawn() -> impl Strategy<Value = Drawn> {
    let digits = prop::collection::vec(-9_999_999..=9_999_999i32, 2..60);
    let flags = (any::<bool>(), any::<bool>(), any::<bool>(), any::<bool>());
    (digits, flags, 1..9usize, 1..50u32, 0..1000usize).prop_map(|(digits, flags, per_line, step, form)| {
        let (dos, blank_lines, trailing_text, glued) = flags;
        Drawn { digits, dos, blank_lines, trailing_text, glued, per_line, step, form }
    })
}

/// A file, and what must be read of it.
#[derive(Debug)]
pub(crate) struct Written {
    pub(crate) text: String,
    /// The samples in m/s², and their unit there.
    pub(crate) samples: Vec<f64>,
    pub(crate) factor: f64,
    pub(crate) step: f64,
    pub(crate) kind: &'static str,
    pub(crate) column: Option<&'static str>,
    pub(crate) unit: Option<&'static str>,
    pub(crate) time_step: Option<String>,
}

pub(crate) const G: f64 = 9.80665;

/// The units of headers, and their value in m/s².
const UNITS: [(&str, f64); 10] = [
    ("G", G),
    ("g", G),
    ("GAL", 0.01),
    ("gal", 0.01),
    ("CM/S/S", 0.01),
    ("cm/sec2", 0.01),
    ("m/s^2", 1.0),
    ("M/S**2", 1.0),
    ("mm/s/s", 0.001),
    ("in/s^2", 0.0254),
];

impl Drawn {
    fn unit(&self) -> (&'static str, f64) {
        UNITS[self.form % UNITS.len()]
    }

    /// One of some texts.
    fn one_of(&self, texts: &[&str]) -> String {
        texts[self.form / 7 % texts.len()].to_owned()
    }

    fn seconds(&self) -> f64 {
        format!("{}e-3", self.step).parse().unwrap()
    }

    /// The samples as Fortran writes them: `-.1234567E-02`.
    fn fortran(&self) -> Vec<String> {
        self.digits
            .iter()
            .map(|digits| {
                let sign = if *digits < 0 { "-" } else { "" };
                let letter = if self.form.is_multiple_of(3) { "D" } else { "E" };
                format!("{sign}.{:07}{letter}-0{}", digits.unsigned_abs(), digits.unsigned_abs() % 4)
            })
            .collect()
    }

    fn decimals(&self) -> Vec<String> {
        self.digits.iter().map(|digits| format!("{:.3}", f64::from(*digits) / 1e4)).collect()
    }

    fn lines_of(&self, words: &[String], width: usize) -> Vec<String> {
        let line = |words: &[String]| {
            words.iter().fold(String::new(), |line, word| {
                let gap = if self.glued && word.starts_with('-') && !line.is_empty() {
                    0
                } else {
                    width.saturating_sub(word.len()).max(1)
                };
                line + &" ".repeat(gap) + word
            })
        };
        words.chunks(self.per_line).map(line).collect()
    }

    /// The whole text.
    fn joined(&self, head: Vec<String>, data: Vec<String>) -> String {
        let mut all = head;
        for (place, line) in data.into_iter().enumerate() {
            if self.blank_lines && place % 3 == 1 {
                all.push("  ".to_owned());
            }
            all.push(line);
        }
        if self.trailing_text {
            all.extend(["".to_owned(), "END OF RECORD".to_owned()]);
        }
        let end = if self.dos { "\r\n" } else { "\n" };
        let end_of_file = if self.dos { "\u{1a}" } else { "" };
        all.join(end) + end + end_of_file
    }
}

fn numbers(words: &[String]) -> Vec<f64> {
    words.iter().map(|word| word.replace('D', "E").parse().unwrap()).collect()
}

fn lines(text: &str) -> Vec<String> {
    text.lines().map(str::to_owned).collect()
}

pub(crate) fn peer(drawn: &Drawn) -> Written {
    let (words, count, step) = (drawn.fortran(), drawn.digits.len(), drawn.seconds());
    let (unit, factor) = drawn.unit();
    let counted = drawn.one_of(&[
        &format!("NPTS=  {count}, DT=   {step} SEC"),
        &format!("NPTS=  {count}, dt=  {step}"),
        &format!("{count}    {step}    NPTS, DT"),
        &format!("NPTS={count}, DT={step}SEC,"),
        &format!("NPTS= {count}, DT= {} MSEC", drawn.step),
        &format!("NPTS= {count}, DT (SEC)= {step}"),
    ]);
    let series = if drawn.form.is_multiple_of(2) { "SERIES" } else { "HISTORY" };
    let more = drawn.one_of(&["", ". FILTER POINTS: HP=0.1 Hz LP=33.0 Hz", " "]);
    let head = lines(&format!(
        "PEER STRONG MOTION DATABASE RECORD\nEXAMPLE 1/1/00, STATION ONE, 090\nACCELERATION TIME {series} IN UNITS OF {unit}{more}\n{counted}"
    ));
    let data = drawn.lines_of(&words, 15);
    let text = drawn.joined(head, data);
    let step = if counted.contains("MSEC") { f64::from(drawn.step) / 1000.0 } else { step };
    Written { samples: numbers(&words), factor, step, kind: "PEER", ..empty(text) }
}

fn empty(text: String) -> Written {
    Written {
        text,
        samples: Vec::new(),
        factor: 1.0,
        step: 0.0,
        kind: "columns",
        column: None,
        unit: None,
        time_step: None,
    }
}

pub(crate) fn knet(drawn: &Drawn) -> Written {
    // A whole number of seconds.
    let rate = [1u32, 2][drawn.form % 2];
    let digits: Vec<i32> = drawn.digits[..drawn.digits.len() / 2 * 2].to_vec();
    let head = lines(&format!(
        "Origin Time       2000/01/01 00:00:00\nLat.              40.0\nStation Code      EXA001\nSampling Freq(Hz) {rate}Hz\nDuration Time(s)  {}\nDir.              N-S\nScale Factor      3920(gal)/6182761\nMax. Acc. (gal)   1.0\nMemo.             ",
        digits.len() as u32 / rate
    ));
    let words: Vec<String> = digits.iter().map(i32::to_string).collect();
    let text = drawn.joined(head, drawn.lines_of(&words, 9));
    let samples = numbers(&words).iter().map(|count| count * (3920.0 / 6_182_761.0)).collect();
    Written { samples, factor: 0.01, step: 1.0 / f64::from(rate), kind: "K-NET", ..empty(text) }
}

pub(crate) fn esm(drawn: &Drawn) -> Written {
    let (words, (unit, factor)) = (drawn.decimals(), drawn.unit());
    let head = lines(&format!(
        "EVENT_NAME: EXAMPLE\nSAMPLING_INTERVAL_S: {}\nNDATA: {}\nSTREAM: HNE\nUNITS: {unit}\nDATABASE_VERSION: DYNA 1.0\nDATA_TYPE: ACCELERATION\nUSER1: words, 1.0 2.0",
        drawn.seconds(),
        words.len()
    ));
    let text = drawn.joined(head, words.clone());
    Written { samples: numbers(&words), factor, step: drawn.seconds(), kind: "ESM", ..empty(text) }
}

pub(crate) fn cwb(drawn: &Drawn) -> Written {
    let words = drawn.decimals();
    let mut drawn = drawn.clone();
    // The samples are not counted, so that no text may follow them.
    drawn.trailing_text = false;
    let step = drawn.seconds();
    let head = lines(&format!(
        "#Earthquake Information\n#StationCode: EXA\n#RecordLength(sec): {}\n#SampleRate(Hz): {}\n#AmplitudeUnit:  gal. DCoffset(corr)\n#DataSequence: Time U(+); N(+); E(+)\n#Data: 4F10.3 ",
        step * words.len() as f64,
        1.0 / step
    ));
    let row = |(place, word): (usize, &String)| {
        format!("{:10.3} {:>10} {word:>10} {:>10}", place as f64 * step, "1.0", "-2.5")
    };
    let text = drawn.joined(head, words.iter().enumerate().map(row).collect());
    Written { samples: numbers(&words), factor: 0.01, step, kind: "CWB", column: Some("n"), ..empty(text) }
}

pub(crate) fn cosmos(drawn: &Drawn) -> Written {
    let words = if drawn.form.is_multiple_of(2) { drawn.fortran() } else { drawn.decimals() };
    let (unit, factor) = drawn.unit();
    let is_second = (drawn.form / 5).is_multiple_of(2);
    let step = drawn.seconds();
    let mut header = vec!["-999.000000".to_owned(); 100];
    header[33] = if is_second { step.to_string() } else { drawn.step.to_string() };
    let real: Vec<String> =
        header.chunks(5).map(|row| row.iter().map(|word| format!("{word:>15}")).collect()).collect();
    let integers = vec!["    -999".repeat(10); 10];
    let mut all = lines(
        "Corrected acceleration    (Format v01.20 with 13 text lines)\nRecord of Example Earthquake\nSta Chan   2: 90 deg",
    );
    all.push(" 100 Integer-header values follow on  10 lines, Format= (10I8)".to_owned());
    all.extend(integers);
    all.push(" 100 Real-header values follow on  20 lines, Format= (5F15.6)".to_owned());
    all.extend(real);
    all.push("   1 Comment line(s) follow, each starting with a \"|\":".to_owned());
    all.push("| 1.0 2.0".to_owned());
    let seconds = (step * words.len() as f64).round();
    let parts = drawn.one_of(&["(04)", " (4)", ""]);
    all.push(format!(
        "{} acceleration pts, approx  {seconds} secs, units={unit}{parts},Format=(8F15.6)",
        words.len()
    ));
    let mut data = drawn.lines_of(&words, 15);
    data.push("End-of-data for chan  2 acceleration".to_owned());
    let text = drawn.joined(all, data);
    // The step is number 34, in ms or in s: whichever agrees with the duration.
    let step = if is_second { step } else { f64::from(drawn.step) / 1000.0 };
    Written { samples: numbers(&words), factor, step, kind: "COSMOS", ..empty(text) }
}

pub(crate) fn geonet(drawn: &Drawn) -> Written {
    let words: Vec<String> =
        drawn.digits.iter().map(|digits| format!("{:.1}", f64::from(digits % 20_000) / 10.0)).collect();
    let (count, step) = (words.len(), drawn.seconds());
    let others = if drawn.form.is_multiple_of(2) { 0 } else { count };
    let mut quiet = drawn.clone();
    quiet.trailing_text = false;
    let component = |name: &str, sign: &str| {
        let mut head = lines(&format!(
            "Corrected accelerogram 20160214_001343_NBLC_20 GNS Science\nSite NBLC      43 30 25S\nNew Brighton Library\nInstrument Cusp_323\nResolution: 18-bit\nAccelerogram\n11 km east\n2016 February 14\nEpicentre  43 29 50S\nNumber of points  {count}\nUnits\nData is filtered\nComponent {name}\nAcceleration:  Peak  -2080.5 mm/s/s at  23.28 s     RMS   145.65 mm/s/s\nVelocity\nDisplacement"
        ));
        head.extend(vec![
            "    2016       2      14       0      13     430       0       0    2016       2"
                .to_owned();
            3
        ]);
        head.push(format!(
            "{count:8}{:8}{:8}{count:8}{others:8}{others:8}{:8}{:8}{:8}{:8}",
            0, 0, 0, 0, 13, 25845
        ));
        head.push(
            "   200.0    0.70    0.00   0.000  0.0000   0.000   0.000   1.000     0.0    0.00".to_owned(),
        );
        head.push(
            "  43.507 172.731  43.497 172.755    5.70    0.00    0.00    0.00      0.      0.".to_owned(),
        );
        head.push(format!(
            "  131.92    0.00    0.00  131.92{step:8}{step:8}      0.      0.      0.  9806.6"
        ));
        head.extend(vec![
            "    0.00    0.00    0.00    0.00   0.000    0.00    0.00    0.00    0.00   0.000"
                .to_owned();
            3
        ]);
        let mut own = words.clone();
        if !sign.is_empty() {
            own.fill("77.7".to_owned());
        }
        let fields = |words: &[String]| -> Vec<String> {
            words.chunks(10).map(|row| row.iter().map(|word| format!("{word:>8}")).collect()).collect()
        };
        let mut data = fields(&own);
        for _ in 0..2 {
            data.extend(fields(&vec!["-1234.56".to_owned(); others]));
        }
        quiet.joined(head, data).replace('\u{1a}', "")
    };
    let text = component("N32E", "x") + &component("S58E", "") + &component("Up", "x");
    Written {
        samples: numbers(&words),
        factor: 0.001,
        step,
        kind: "GeoNet",
        column: Some("s58e"),
        ..empty(text)
    }
}

/// Columns of times and accelerations.
pub(crate) fn columns(drawn: &Drawn) -> Written {
    let (words, (unit, factor), step) = (drawn.decimals(), drawn.unit(), drawn.seconds());
    let mut drawn = drawn.clone();
    drawn.trailing_text = false;
    let delimiters = [",", ";", "\t", "  ", ", ", " , "];
    let delimiter = delimiters[drawn.form / 3 % delimiters.len()];
    let has_comma = delimiter == ";" && drawn.glued;
    let decimal = |text: String| if has_comma { text.replace('.', ",") } else { text };
    let row = |(place, word): (usize, &String)| {
        let time = format!("{:.3}", place as f64 * step);
        decimal(time) + delimiter + &decimal(word.clone())
    };
    let head = match drawn.form % 5 {
        0 => format!("Time (s){delimiter}Acc ({unit})"),
        1 => format!("# a comment\ntime[s]{delimiter}acceleration[{unit}]"),
        2 => format!("A title\n\nTime{delimiter}Acceleration\n(s){delimiter}({unit})"),
        3 => format!("% t (s){delimiter}acc ({unit})"),
        _ => "# a comment".to_owned(),
    };
    let unit = (drawn.form % 5 == 4).then_some(unit);
    let text = drawn.joined(lines(&head), words.iter().enumerate().map(row).collect()).replace('\u{1a}', "");
    Written { samples: numbers(&words), factor, step, unit, ..empty(text) }
}

/// Samples without times and names, in one column or row by row.
pub(crate) fn samples(drawn: &Drawn) -> Written {
    let words = drawn.decimals();
    let mut drawn = drawn.clone();
    (drawn.trailing_text, drawn.glued) = (false, false);
    let text = drawn.joined(Vec::new(), drawn.lines_of(&words, 10));
    let (unit, factor) = drawn.unit();
    let column = (drawn.per_line > 1).then_some("all");
    let step = drawn.seconds();
    Written {
        samples: numbers(&words),
        factor,
        step,
        unit: Some(unit),
        time_step: Some(format!("{step} s")),
        column,
        ..empty(text)
    }
}
