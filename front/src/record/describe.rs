//! What a file holds, without a machine: its channels with their units, steps and peaks, gaps, and the frequency at which
//! each has the greatest Fourier amplitude.

use super::samples::Samples;
use super::{Options, Reading, Summary, found};
use std::f64::consts::TAU;
use std::io::BufRead;
use stickslip::motion::record::Record;

/// The most samples of a transform; of more no spectrum is told.
const MOST: usize = 1 << 22;
/// A step that is so many times the median is a gap.
const GAP: f64 = 1.5;

/// A channel of a file.
#[derive(Debug, Clone)]
pub struct Channel {
    /// The record in the system of the reader.
    pub record: Record<f64>,
    /// What was read.
    pub summary: Summary,
    /// The frequency in Hz at which the Fourier amplitude of the samples without their mean is greatest; none of a constant.
    pub peak_frequency: Option<f64>,
    /// The beginnings and the ends, in s, of steps that are longer than half again the median step.
    pub gaps: Vec<[f64; 2]>,
}

impl From<Reading<f64>> for Channel {
    fn from(Reading { record, summary, .. }: Reading<f64>) -> Self {
        Self { peak_frequency: peak_frequency(&record), gaps: gaps(&record), record, summary }
    }
}

impl Channel {
    /// The description in sentences, with numbers written by `number`.
    pub fn sentences(&self, number: impl Fn(f64) -> String) -> String {
        let frequency = self
            .peak_frequency
            .map(|peak| format!(" Its Fourier amplitude is greatest at {} Hz.", number(peak)));
        let gaps: Vec<String> = self
            .gaps
            .iter()
            .take(5)
            .map(|[from, to]| format!("{} s to {} s", number(*from), number(*to)))
            .collect();
        let gaps = match (self.gaps.len(), gaps.as_slice()) {
            (0, _) => " It has no gaps.".to_owned(),
            (1, [one]) => format!(" It has a gap from {one}."),
            (many, some) => format!(" It has {many} gaps, such as from {}.", some.join(", ")),
        };
        self.summary.sentence(&number) + &frequency.unwrap_or_default() + &gaps
    }
}

/// The channels of a file, each of which is read from its beginning: `open` opens it.
///
/// # Errors
/// As for [`read`](super::read), of the first channel that is not read.
pub fn describe<R: BufRead>(
    open: impl Fn() -> Result<R, String>,
    options: &Options<'_>,
) -> Result<Vec<Channel>, String> {
    let read = |options: &Options<'_>, channels: &mut Vec<String>| {
        let mut samples = Samples::<f64>::new(options.reader);
        let found = found(open()?, options, &mut samples, channels)?;
        samples.finish(found, options)
    };
    let mut names = Vec::new();
    match read(options, &mut names) {
        Ok(reading) => return Ok(vec![Channel::from(reading)]),
        Err(error) if options.column.is_some() || names.len() < 2 => return Err(error),
        Err(_) => {}
    }
    // Channels of one name are told apart by their places.
    let is_unique = names.iter().all(|name| names.iter().filter(|other| *other == name).count() == 1);
    let chosen = names.iter().enumerate().map(|(place, name)| match is_unique {
        true => name.clone(),
        false => place.saturating_add(1).to_string(),
    });
    chosen
        .map(|column| {
            let options = Options { column: Some(&column), ..*options };
            read(&options, &mut Vec::new()).map(Channel::from)
        })
        .collect()
}

/// The beginnings and the ends, in s, of the steps of a record that are longer than half again their median.
#[must_use]
pub fn gaps(record: &Record<f64>) -> Vec<[f64; 2]> {
    if record.step().is_some() {
        return Vec::new();
    }
    let times = |place: usize| [record.time(place), record.time(place.saturating_add(1))];
    let all: Vec<[f64; 2]> = (0..record.samples().len().saturating_sub(1)).map(times).collect();
    let mut steps: Vec<f64> = all.iter().map(|[from, to]| to - from).filter(|step| *step > 0.0).collect();
    steps.sort_by(f64::total_cmp);
    let median = steps.get(steps.len().div_euclid(2)).copied().unwrap_or(f64::INFINITY);
    all.into_iter().filter(|[from, to]| to - from > GAP * median).collect()
}

/// The frequency in Hz of the greatest Fourier amplitude, of the samples at equal steps on their straight lines, without their
/// mean, and followed by zeros up to a power of two; none of a constant, of fewer than four samples, or of more than four
/// million.
#[must_use]
pub fn peak_frequency(record: &Record<f64>) -> Option<f64> {
    let count = record.samples().len();
    if !(4..=MOST).contains(&count) {
        return None;
    }
    let steps = count.saturating_sub(1) as f64;
    let step = record.step().unwrap_or((record.end() - record.time(0)) / steps);
    let samples: Vec<f64> = match record.step() {
        Some(_) => record.samples().to_vec(),
        None => super::process::on_lines(record, step, count),
    };
    let mean = samples.iter().sum::<f64>() / count as f64;
    let mut points: Vec<[f64; 2]> = samples.iter().map(|sample| [sample - mean, 0.0]).collect();
    let scale = points.iter().fold(0.0f64, |most, [re, _]| most.max(re.abs()));
    if scale <= 1e-12 * mean.abs() {
        return None;
    }
    // Of few points four times as many, so that the peak lies closer to a frequency of the grid.
    let size = count.next_power_of_two().saturating_mul(if count <= MOST >> 4 { 4 } else { 1 });
    points.resize(size, [0.0; 2]);
    let points = transformed(points);
    let square = |[re, im]: &[f64; 2]| (re / scale).powi(2) + (im / scale).powi(2);
    let half = points.iter().take(size.div_euclid(2).saturating_add(1)).enumerate().skip(1);
    let (place, _) = half.max_by(|(_, a), (_, b)| square(a).total_cmp(&square(b)))?;
    Some(place as f64 / (size as f64 * step))
}

/// The Fourier transform of points, whose number is a power of two: of the even ones, of the odd ones, and their sums.
fn transformed(points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let size = points.len();
    let bits = size.trailing_zeros();
    let mut all: Vec<[f64; 2]> = (0..size)
        .map(|place| {
            let reversed = place.reverse_bits().checked_shr(usize::BITS.saturating_sub(bits)).unwrap_or(0);
            points.get(reversed).copied().unwrap_or_default()
        })
        .collect();
    let mut part = 1usize;
    while part < size {
        let angle = -TAU / (2.0 * part as f64);
        let turns: Vec<(f64, f64)> = (0..part).map(|place| (angle * place as f64).sin_cos()).collect();
        for block in all.chunks_mut(part.saturating_mul(2)) {
            let (first, second) = block.split_at_mut(part);
            for ((a, b), (sin, cos)) in first.iter_mut().zip(second).zip(&turns) {
                let [re, im] = *b;
                let turned = [re * cos - im * sin, re * sin + im * cos];
                let [x, y] = *a;
                *a = [x + turned[0], y + turned[1]];
                *b = [x - turned[0], y - turned[1]];
            }
        }
        part = part.saturating_mul(2);
    }
    all
}

#[cfg(test)]
mod tests {
    use super::transformed;
    use std::f64::consts::TAU;

    /// The transform is the sum that defines it.
    #[test]
    fn a_transform_is_its_sum() {
        for size in [1usize, 2, 8, 64] {
            let points: Vec<[f64; 2]> =
                (0..size).map(|i| [(i as f64 * 1.3).sin(), (i as f64 * 0.7).cos()]).collect();
            for (k, own) in transformed(points.clone()).into_iter().enumerate() {
                let mut due = [0.0; 2];
                for (i, [re, im]) in points.iter().enumerate() {
                    let (sin, cos) = (-TAU * (i * k) as f64 / size as f64).sin_cos();
                    due[0] += re * cos - im * sin;
                    due[1] += re * sin + im * cos;
                }
                // Each of the sums has as many roundings as it has terms, of numbers up to 1.
                let off = 4.0 * (size as f64) * f64::EPSILON * size as f64;
                assert!((own[0] - due[0]).abs() <= off && (own[1] - due[1]).abs() <= off, "{size} {k}");
            }
        }
    }
}
