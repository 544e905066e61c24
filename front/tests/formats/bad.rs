//! Bad files: one line each, with the file, the line and the value.

use super::read_text;

fn error(text: &[u8]) -> String {
    let error = read_text(text, |_| {}).unwrap_err();
    assert!(!error.contains('\n'), "{error}");
    error
}

const PEER: &str = "A\nB\nACCELERATION TIME SERIES IN UNITS OF G\n";

#[test]
fn bad_files_are_refused_by_line_and_value() {
    let due = "must state the number of samples and the step: NPTS= 4000, DT= .005 SEC";
    for (text, said) in [
        (format!("{PEER}NPTS= 3, DT= .01 SEC\n1 2\n"), "file: NPTS = 3, but the file has 2 samples".to_owned()),
        (
            format!("{PEER}NPTS= 3, DT= .01 SEC\n1 2 3\n4\n"),
            "file line 6: NPTS = 3, but more samples follow".to_owned(),
        ),
        (
            format!("{PEER}NPTS= 3, DT= .01 SEC\n1 0.1234560.234567\n"),
            "file line 5: 0.1234560.234567: must be a number: NPTS = 3, and 0 samples were read".to_owned(),
        ),
        (
            format!("{PEER}NPTS= 3, DT= .01 SEC\n1\nNaN 2\n"),
            "file line 6: NaN: must be a number: NPTS = 3, and 1 samples were read".to_owned(),
        ),
        (format!("{PEER}NPTS= 3\n1 2 3\n"), format!("file line 4: {due}")),
        (format!("{PEER}1 2 3\n"), format!("file line 4: {due}")),
        (
            format!("{PEER}NPTS= 3, DT= ,01 SEC\n1 2 3\n"),
            format!("file line 4: DT = : must be a number > 0, of seconds: {due}"),
        ),
        (
            format!("{PEER}NPTS= 3, DT= 10 FEET\n1 2 3\n"),
            "file line 4: DT [feet]: must be a time (s, ms), but “feet” is not a known unit".to_owned(),
        ),
        (
            "A\nB\nVELOCITY TIME SERIES IN UNITS OF CM/S\nNPTS= 2, DT= .01\n1 2\n".to_owned(),
            "file line 3: VELOCITY: must be an acceleration".to_owned(),
        ),
        (
            "A\nB\nACCELERATION TIME SERIES IN UNITS OF COUNTS\nNPTS= 2, DT= .01\n1 2\n".to_owned(),
            "file line 3: unit [COUNTS]: must be an acceleration (g, m/s^2, mm/s^2), but “COUNTS” is not a known unit"
                .to_owned(),
        ),
        ("time[s],acc[g]\n0,1\n2,1\n1,1\n".to_owned(), "file line 4: time step = -1 s: must be ≥ 0 s".to_owned()),
        ("time[s],acc[g]\n0,1\n1,NaN\n".to_owned(), "file line 3: acceleration: NaN: must be a number".to_owned()),
        ("time[s],acc[g]\n0,1\n1,1,2\n".to_owned(), "file line 3: 3 fields, must be 2 as above. A decimal needs a point, because commas separate fields".to_owned()),
        (
            "time[s],acc[furlong]\n0,1\n".to_owned(),
            "file: column acc [furlong]: must be an acceleration (g, m/s^2, mm/s^2), but “furlong” is not a known unit"
                .to_owned(),
        ),
        ("time[s],acc[g]\n".to_owned(), "file: record: the number of samples = 0 must be ≥ 2".to_owned()),
        ("0 1\n1 2\n".to_owned(), "file: states no unit. Give it by --record-units, such as g".to_owned()),
        (
            "0 1 2\n1 2 3\n".to_owned(),
            "file: has 3 columns without names. Choose one by --column, such as 3, or all, row by row. It is read with \
             --column 2 --record-units g, if this is its unit"
                .to_owned(),
        ),
        ("".to_owned(), "file: has no samples".to_owned()),
        ("acc[g]\n0\u{0}\n".to_owned(), "file line 2: must be text, but has a zero byte".to_owned()),
        (
            "time[s],vel[m/s]\n0,1\n1,1\n".to_owned(),
            "file: a column of the load is missing in the header “time[s],vel[m/s]”. Name one of acceleration, force, \
             foot-displacement, damped-foot-displacement, such as acceleration[g]. Its line 2 has 2 numbers"
                .to_owned(),
        ),
        (
            "time[s],acc x[g],acc y[g]\n0,1,2\n1,1,2\n".to_owned(),
            "file: has the columns acc x, acc y. Choose one by --column".to_owned(),
        ),
    ] {
        assert_eq!(error(text.as_bytes()), said, "{text}");
    }
    let long = vec![b'1'; (1 << 24) + 2];
    assert_eq!(error(&long), "file line 1: must be shorter than 16 MiB");
    let words = "x y ".repeat(1 << 15);
    let said = "file line 1: must be a row of numbers, or a line of text shorter than 64 KiB";
    assert_eq!(error(words.as_bytes()), said);
}

/// What leads on is tried on the first lines of the file.
#[test]
fn errors_lead_to_the_options_that_read_the_file() {
    let eight: String = (0..6).map(|i| format!("{i} 2 -1 0 5 2 1 3\n")).collect();
    let decreasing: String = (0..6).map(|i| format!("{} 2 -1\n", -i)).collect();
    for (text, said) in [
        (
            decreasing,
            "It is read with --column 3 --time-step 0.01s --record-units g, if these are its step and unit",
        ),
        (
            format!("Example of a program\nwith 8 numbers\n1 2\nwords\n{eight}"),
            "It is read with --column 2 --record-units g, if this is its unit",
        ),
        (
            format!("Example\n{}", eight.replace("3 2", "-3 2")),
            "It is read with --column all --time-step 0.01s --record-units g, if these are its step and unit",
        ),
        ("1;2\n3;4\n5;6\n".to_owned(), "states no unit. Give it by --record-units, such as g"),
        (
            "Time,Out,Channel B\n0,1,2\n1,2,3\n2,3,4\n".to_owned(),
            "It is read with --column 2 --record-units g",
        ),
        ("B\n1\n2\n3\n".to_owned(), "--column 1 --time-step 0.01s --record-units g, if these are"),
        ("words only\nand npts\n".to_owned(), "line 2: must state the number of samples"),
        (
            "p,q\nwords,peer\nx,y\n".to_owned(),
            "None of its first lines begins with a number, and “peer” is a word of PEER",
        ),
    ] {
        let error = error(text.as_bytes());
        assert!(error.contains(said), "{error}\n{text}");
    }
    assert_eq!(
        error(b"PK\x03\x04\0\0"),
        "file: is a zip archive or a workbook of Excel: unpack it, or save it as CSV"
    );
    let mini_seed = [b"000001D ".as_slice(), &[0; 56]].concat();
    assert!(
        error(&mini_seed).starts_with("file: is miniSEED or SEED, whose samples are counts without a unit")
    );
}

/// What can be read in two ways is refused, and no option is suggested that would read other numbers.
#[test]
fn what_may_be_two_things_is_refused() {
    for (text, said) in [
        ("time[s]\tforce[N]\n0\t999.5\n1\t1,000\n", "1,000: has the sign “,”, and a number in line 2 “.”"),
        (
            "time[s],a1[g],time[s],a2[g]\n0,1,0,10\n1,2,5,20\n",
            "has several columns of time: time, time. Choose one by",
        ),
        ("Zeit [s];Gewicht [g]\n0;1\n1;2\n", "its unit is that of a mass"),
        ("Sample rate: 10,000 Hz\nForce [N]\n1.5\n2.5\n", "time"),
    ] {
        let error = error(text.as_bytes());
        assert!(error.contains(said), "{text}: {error}");
    }
    let error = error(b"time[ms],acc[m/seg2]\n0,1\n10,2\n20,4\n");
    assert!(error.ends_with("“m/seg2” is not a known unit"), "{error}");
}
