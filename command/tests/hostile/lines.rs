//! The drawing of command lines: an ordinary one, of which some values are replaced and to which some options are added.

use crate::generator::Random;
use std::path::Path;
use std::process::Command;
use std::sync::LazyLock;

/// Ordinary lines, from which others are made.
const ORDINARY: &[&str] = &[
    "response --omega 0.7 --alpha 2",
    "response --omega 0.3 --alpha 12 --damping-ratio 0.05",
    "response --mass 800kg --period 2.2s --friction-coefficient 0.05 --frequency 2Hz --base-acceleration 0.15g",
    "response --points points.csv",
    "border --omega 0.4",
    "border --mass 50 --stiffness 1000 --friction 5 --frequency 6",
    "steady --omega 0.4 --alpha 6",
    "steady --omega 0.5 --alpha 4 --damping-ratio 0.02 --static-friction-ratio 1.3",
    "steady --mass 50 --stiffness 877.3 --friction 5 --frequency 6.2832 --force 6",
    "attractors --omega 0.5 --alpha 4 --damping-ratio 0.02 --static-friction-ratio 1.5 --starts 9",
    "basins --omega 0.5 --alpha 4 --static-friction-ratio 1.5 --x0=-5:5:6 --v0=-5:5:6 --out basins.svg",
    "simulate --omega 0.5 --alpha 4 --cycles 3",
    "simulate --mass 50 --stiffness 1000 --friction 5 --frequency 2Hz --force 12 --rate 100Hz --duration 2s",
    "simulate --mass 2kg --stiffness 800N/m --friction 4N --static-friction 5N --force 12N --shape step --duration 2s",
    "simulate --mass 2kg --no-spring --friction 4N --force 12N --shape ramp --rise 0.5s --duration 2s --rate 20Hz",
    "simulate --mass 2kg --stiffness 450N/m --friction 3N --static-friction 4N --shape pull --speed 20mm/s --duration 2s",
    "simulate --no-spring --friction-coefficient 0.3 --slope 5deg --v0 2m/s --shape free --duration 1s",
    "response --mass 1kg --stiffness 100N/m --friction 0N --frequency 1Hz --force 3N",
    "border --mass 1kg --stiffness 100N/m --friction 0N --frequency 1Hz",
    "design force --omega 0.6",
    "design friction --mass 50 --stiffness 1000 --frequency 6 --force 12",
    "design friction --mass 1 --stiffness 1 --base-displacement 1 --over 0.5:2 --of displacement",
    "design bands --alpha 12 --from 0.1 --to 2",
    "design displacement --omega 1.5 --target 2",
    "design velocity --omega 1.5 --target 2",
    "design dissipation --mass 50t --stiffness 1000kN/m --frequency 6rad/s --force 12kN",
    "design stiffness --mass 50 --friction 5 --frequency 6 --force 12 --from 500 --to 1500",
    "identify --decay decay.csv",
    "identify curve.csv --mass 5kg --stiffness 20kN/m --force 100N",
    "identify --motion motion.csv --mass 2kg --stiffness 50N/m",
    "decay --x0 9.5",
    "decay --no-spring --friction-coefficient 0.3 --v0 2m/s",
    "decay --mass 1kg --stiffness 100N/m --friction 0N --damping-ratio 2% --x0 10mm",
    "decay --mass 50 --stiffness 1000 --friction 5 --x0 0.2 --out decay.svg",
    "record record.csv --mass 800kg --period 2.5s --friction-coefficient 0.06",
    "record record.csv --mass 800kg --period 2.5s --friction-coefficient 0.06 --out motion.csv --interval 0.01s",
    "record record.csv --mass 800kg --period 2.5s --friction-coefficient 0.06 --picture motion.svg",
    "record force.csv --mass 1kg --no-spring --friction 1N",
    "spectrum record.csv --period 0.1s:4s:5:log --friction-coefficient 0.05",
    "spectrum record.csv --period 0.1s:4s:5:log --friction-coefficient 0.05 --picture spectrum.svg",
    "pull --mass 2kg --stiffness 450N/m --friction 3N --static-friction-ratio 1.3 --speed 20mm/s",
    "system machine.toml --set bearing.friction=450N",
    "system machine.toml steady --set bearing.friction=450N",
    "system machine.toml simulate --until 2s --set bearing.friction=450N",
    "system machine.toml record record.csv --until 3s",
    "system machine.toml curve --frequency 1Hz:10Hz:5 --set bearing.friction=450N",
    "system machine.toml border --set roof.mass=500kg",
    "design friction --mass 50kg --stiffness 1kN/m --frequency 6rad/s --force 12N --target-amplitude 5mm",
    "design hold --mass 20kg --stiffness 20kN/m --friction 80N --base-displacement 10mm",
    "system machine.toml spectrum record.csv force.csv --set bearing.friction=300N:600N:3 --out grid.csv",
    "system machine.toml curve --frequency 1Hz:10Hz:5 --resolve --set bearing.friction=450N",
    "system machine.toml --picture machine.pdf",
    "record record.csv --mass 800kg --period 2.5s --friction-coefficient 0.06 --picture motion.pdf",
    "response-curve --omega 0.2:2:12 --alpha 1.2,2 --out curve.pdf",
    "verify --omega 0.7 --alpha 3",
    "sweep response --omega 0.5:2:7 --alpha 2,4 --out sweep.csv",
    "sweep steady --omega 0.5:2:5 --alpha 2,4",
    "map regime --omega 0.1:2:12 --alpha 0.5:8:9 --out map.svg",
    "map steady:max_displacement --omega 0.1:2:6 --alpha 0.5:8:5 --range 0:3 --out map.svg",
    "response-curve --omega 0.2:2:12 --alpha 1.2,2 --out curve.svg",
    "response-curve transmissibility --mass 800kg --period 2.2s --friction-coefficient 0.05 --base-acceleration 0.15g --frequency 0.3Hz:5Hz:12:log",
    "motion-plot --omega 0.15 --alpha 3 --out plot.svg",
    "motion-plot --mass 50t --stiffness 1kN/mm --friction 5kN --frequency 0.3Hz --force 12kN --out plot.svg",
];

const NUMBERS: &[&str] = &[
    "0",
    "-0",
    "5e-324",
    "1e-310",
    "1e-300",
    "1e-100",
    "1e-20",
    "1e-9",
    "1e-6",
    "1e-3",
    "0.02",
    "0.1",
    "0.2",
    "0.25",
    "0.3333333333333333",
    "0.5",
    "0.7",
    "0.9999999999",
    "1",
    "1.0000000000000002",
    "1.0000001",
    "1.3",
    "2",
    "3",
    "4.5",
    "7",
    "10",
    "13",
    "100",
    "4000",
    "1e4",
    "1e5",
    "1e6",
    "1e9",
    "1e15",
    "1e20",
    "1e100",
    "1e300",
    "1.7976931348623157e308",
    "-1",
    "-1e-9",
    "-1e300",
    "inf",
    "-inf",
    "nan",
    "",
    " ",
    "1e",
    "e5",
    "0x10",
    "1,5",
    "１",
    "1e400",
    "999999999999",
    "18446744073709551615",
    "18446744073709551616",
];

const UNITS: &[&str] = &[
    "", "", "", "", "", "", "kg", "t", "lb", "N", "kN", "kips", "lbf", "m", "mm", "in", "s", "ms", "h", "Hz",
    "rpm", "g", "m/s^2", "%", "deg", "rad/s", "N/m", "N/mm", "N*s/m", "kg*m", "parsec", "B",
];

const WORDS: &[&str] = &[
    "record.csv",
    "force.csv",
    "motion.csv",
    "curve.csv",
    "decay.csv",
    "points.csv",
    "empty.csv",
    "wide.csv",
    "steep.csv",
    "missing.csv",
    "/dev/zero",
    "/dev/null",
    ".",
    "-",
    "out.svg",
    "out.csv",
    "out.jsonl",
    "no/folder.svg",
    "steady",
    "regime",
    "margin",
    "limits",
    "stops",
    "max_displacement",
    "steady:stick_fraction",
    "force",
    "absolute",
    "json",
    "csv",
    "jsonl",
    "text",
    "N,mm",
    "kip,in",
    "kN,m",
    "lbf,ft",
    "1/1",
    "2/3",
    "0/0",
    "100x100",
    "900x500",
    "10000x10000",
    "1x1",
    "omega,alpha",
    "x",
    "displacement",
    "absolute-displacement",
    "transmitted-force",
    "acceleration",
    "units",
    "names",
];

/// Two masses, of which one slides.
const MACHINE: &str = include_str!("../machine.toml");

/// Writes the files that lines name.
pub(crate) fn write_files(folder: &Path) {
    let rows = |header: &str, row: &dyn Fn(u32) -> String, count: u32| {
        let rows: Vec<String> = (0..count).map(row).collect();
        format!("{header}\n{}\n", rows.join("\n"))
    };
    let wave = |i: u32| f64::from(i * i % 37) / 37.0 - 0.5;
    let files = [
        (
            "record.csv",
            rows("time[s],acceleration[g]", &|i| format!("{},{}", 0.02 * f64::from(i), wave(i)), 200),
        ),
        ("force.csv", rows("time[s],force[N]", &|i| format!("{},{}", f64::from(i), 3.0 * wave(i)), 9)),
        ("steep.csv", "time[s],force[N]\n0,0\n1e-300,1e300\n1,-1e300\n1e9,5e-324\n".to_owned()),
        ("wide.csv", "time[s],acceleration[m/s^2]\n-1e15,1\n1e15,1\n".to_owned()),
        ("empty.csv", String::new()),
        ("points.csv", "omega,alpha\n0.5,3\n1e-6,2\n0.7,1e300\n1,1\n".to_owned()),
        ("decay.csv", "peak[mm]\n40\n33\n27\n22\n18\n".to_owned()),
        (
            "motion.csv",
            rows(
                "time[s],force[N],displacement[mm]",
                &|i| format!("{},{},{}", 0.05 * f64::from(i), 3.0 * wave(i), 9.0 * wave(i + 3)),
                60,
            ),
        ),
        (
            "curve.csv",
            rows(
                "frequency[Hz],amplitude[mm]",
                &|i| format!("{},{}", 5 + i, 10.0 / (1.0 + wave(i).abs())),
                12,
            ),
        ),
    ];
    std::fs::write(folder.join("machine.toml"), MACHINE).unwrap();
    for (name, text) in files {
        std::fs::write(folder.join(name), text).unwrap();
    }
}

/// The options of a command, from its help, and whether each takes a value.
fn options(command: &str) -> Vec<(String, bool)> {
    let program = assert_cmd::cargo::cargo_bin!("stickslip");
    let output = Command::new(program).args(command.split(' ')).arg("--help").output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    let option = |line: &str| {
        let (option, rest) = line.trim_start().strip_prefix("--")?.split_once(' ')?;
        Some((format!("--{option}"), rest.starts_with('<')))
    };
    text.lines().filter(|line| line.starts_with("      --")).filter_map(option).collect()
}

/// The words of a line that name its command.
fn command(line: &str) -> String {
    let count = if line.starts_with("design") { 2 } else { 1 };
    line.split(' ').take(count).collect::<Vec<_>>().join(" ")
}

/// The options of the command of each ordinary line.
static OPTIONS: LazyLock<Vec<Vec<(String, bool)>>> =
    LazyLock::new(|| ORDINARY.iter().map(|line| options(&command(line))).collect());

/// A line's source of random numbers.
pub(crate) struct Lines(Random);

impl Lines {
    pub(crate) fn new(seed: u64, place: u64) -> Self {
        let first = Random(seed).bits().wrapping_add(place);
        Self(Random(seed ^ first.wrapping_mul(0x2545_f491_4f6c_dd1d)))
    }

    fn below(&mut self, count: usize) -> usize {
        self.0.below(count as u64) as usize
    }

    fn of<'a>(&mut self, some: &[&'a str]) -> &'a str {
        some[self.below(some.len())]
    }

    /// A number of any size, round or with many digits, with or without a unit.
    fn number(&mut self) -> String {
        let digits = match self.below(4) {
            0 => format!(
                "{:e}",
                10f64.powf(self.below(40) as f64 / 2.0 - 10.0) * (1.0 + self.below(1000) as f64 / 1000.0)
            ),
            1 => format!("{}", (self.below(4000) as f64) / 1000.0),
            _ => self.of(NUMBERS).to_owned(),
        };
        format!("{digits}{}", self.of(UNITS))
    }

    fn value(&mut self) -> String {
        match self.below(12) {
            0 => format!("{}:{}", self.number(), self.number()),
            1 => {
                let count = self.of(&["2", "5", "0", "1", "40", "1000000", "99999999999999"]);
                let scale = self.of(&["", "", ":log", ":lin"]);
                format!("{}:{}:{count}{scale}", self.number(), self.number())
            }
            2 => format!("{},{}", self.number(), self.number()),
            3 | 4 => self.of(WORDS).to_owned(),
            _ => self.number(),
        }
    }

    /// A value with the unit of another, so that it is read.
    fn alike(&mut self, old: &str) -> String {
        let unit = old.trim_start_matches(|c: char| c.is_ascii_digit() || "+-.e:,".contains(c));
        let plain = self.of(NUMBERS);
        match self.below(6) {
            0 => self.value(),
            // The same value, by a factor of up to a thousand.
            1..=3 => match old[..old.len() - unit.len()].parse::<f64>() {
                Ok(number) => {
                    let factor = 10f64.powf(self.below(61) as f64 / 10.0 - 3.0);
                    format!("{:e}{unit}", number * factor)
                }
                Err(_) => self.value(),
            },
            _ if old.contains(':') && self.below(2) == 0 => {
                let low = self.of(NUMBERS);
                format!("{low}{unit}:{plain}{unit}:{}", self.of(&["2", "7", "12"]))
            }
            _ => format!("{plain}{unit}"),
        }
    }

    /// A command line, word by word.
    pub(crate) fn line(&mut self) -> Vec<String> {
        let place = self.below(ORDINARY.len());
        let mut words: Vec<String> = ORDINARY[place].split(' ').map(str::to_owned).collect();
        let values: Vec<usize> = (1..words.len()).filter(|&i| words[i - 1].starts_with("--")).collect();
        if !values.is_empty() {
            for _ in 0..self.below(2) + 1 {
                let at = values[self.below(values.len())];
                words[at] = self.alike(&words[at].clone());
            }
        }
        let options = &OPTIONS[place];
        for _ in 0..self.below(4).saturating_sub(1) {
            let (option, has_value) = options[self.below(options.len())].clone();
            if words.contains(&option) {
                continue;
            }
            if has_value {
                let value = self.value();
                words.push(format!("{option}={value}"));
            } else {
                words.push(option);
            }
        }
        words
    }
}
