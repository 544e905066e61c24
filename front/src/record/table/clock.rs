//! Times of a clock: `2020-01-31T23:59:59.250Z`, with a blank or without a date.

/// The nanoseconds of a day.
const DAY: i128 = 86_400_000_000_000;

/// The nanoseconds of an instant of ISO 8601, from the beginning of the year 0 or of the day.
pub(in crate::record) fn instant(text: &str) -> Option<i128> {
    let text = text.trim().trim_end_matches(['Z', 'z']);
    let (date, time) = text.split_once(['T', ' ']).unwrap_or(("", text));
    let day = if date.is_empty() { 0 } else { day(date)? };
    let mut parts = time.trim().splitn(3, ':');
    let whole = |part: Option<&str>, below: i128| {
        let part = part.filter(|part| part.len() == 2)?;
        part.parse::<i128>().ok().filter(|value| (0..below).contains(value))
    };
    let (hour, minute) = (whole(parts.next(), 24)?, whole(parts.next(), 60)?);
    let (second, fraction) = parts
        .next()
        .map_or(Some(("00", "")), |seconds| seconds.split_once(['.', ',']).or(Some((seconds, ""))))?;
    let second = whole(Some(second), 61)?;
    if fraction.len() > 9 || !fraction.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let nanoseconds = format!("{fraction:0<9}").parse::<i128>().ok()?;
    let seconds = hour.checked_mul(3600)?.checked_add(minute.checked_mul(60)?)?.checked_add(second)?;
    let of_day = seconds.checked_mul(1_000_000_000)?.checked_add(nanoseconds)?;
    day.checked_mul(DAY)?.checked_add(of_day)
}

/// The days from 1 March of the year 0 to a date such as 2020-01-31 or 2020/01/31.
fn day(date: &str) -> Option<i128> {
    let mut parts = date.splitn(3, ['-', '/']);
    let mut part = |digits: usize| {
        let part = parts.next().filter(|part| part.len() == digits)?;
        part.parse::<i128>().ok().filter(|value| *value >= 0)
    };
    let (year, month, day) = (part(4)?, part(2)?, part(2)?);
    if !(1..=12).contains(&month) || !(1..=31).contains(&day) {
        return None;
    }
    // Years begin in March, so that the leap day is the last one.
    let (year, month) =
        if month < 3 { (year.checked_sub(1)?, month.checked_add(9)?) } else { (year, month.checked_sub(3)?) };
    let leaps = year.div_euclid(4).checked_sub(year.div_euclid(100))?.checked_add(year.div_euclid(400))?;
    let before = month.checked_mul(153)?.checked_add(2)?.div_euclid(5);
    year.checked_mul(365)?.checked_add(leaps)?.checked_add(before)?.checked_add(day)
}

/// The seconds of a difference, as a decimal.
pub(super) fn seconds(nanoseconds: i128) -> String {
    let sign = if nanoseconds < 0 { "-" } else { "" };
    let size = nanoseconds.unsigned_abs();
    format!("{sign}{}.{:09}", size.div_euclid(1_000_000_000), size.rem_euclid(1_000_000_000))
}

#[cfg(test)]
mod tests {
    use super::{instant, seconds};

    #[test]
    fn instants_are_counted_over_days_and_leap_days() {
        let between = |a: &str, b: &str| seconds(instant(b).unwrap() - instant(a).unwrap());
        assert_eq!(between("2020-02-28T23:59:59.5", "2020-03-01T00:00:00Z"), "86400.500000000");
        assert_eq!(between("1899-12-31 00:00:00", "2000-01-01 00:00:00"), "3155760000.000000000");
        assert_eq!(between("12:00:00,25", "11:59"), "-60.250000000");
        for wrong in ["", "1", "12:60", "2020-13-01T00:00:00", "2020-01-01", "12:00:00.1234567890", "1:00:00"]
        {
            assert_eq!(instant(wrong), None, "{wrong}");
        }
    }
}
