//! Days and times in words that sort, UTC.

use time::OffsetDateTime;

/// What a file made at a Unix time is called by: `2026-01-31 23-59-58`, UTC.
pub fn stamp(unix_s: u64) -> String {
    let (hours, minutes, seconds) = (unix_s / 3600 % 24, unix_s / 60 % 60, unix_s % 60);
    format!("{} {hours:02}-{minutes:02}-{seconds:02}", date(unix_s))
}

/// The same to be read, as it could not be in a file's name: 2026-11-27 12:33:28.
pub fn moment(unix_s: u64) -> String {
    let (hours, minutes, seconds) = (unix_s / 3600 % 24, unix_s / 60 % 60, unix_s % 60);
    format!("{} {hours:02}:{minutes:02}:{seconds:02}", date(unix_s))
}

/// The day of a Unix time as year-month-day, UTC. Empty for a time past the year 9999: a save says it that never was.
pub fn date(unix_s: u64) -> String {
    let seconds = i64::try_from(unix_s).ok();
    let time = seconds.and_then(|it| OffsetDateTime::from_unix_timestamp(it).ok());
    time.map_or_else(String::new, |time| {
        let (year, month, day) = time.to_calendar_date();
        format!("{year:04}-{:02}-{day:02}", u8::from(month))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_are_right_over_leap_days_and_centuries() {
        assert_eq!(date(0), "1970-01-01");
        assert_eq!(date(951_782_400), "2000-02-29");
        assert_eq!(date(951_868_800), "2000-03-01");
        assert_eq!(date(1_798_761_599), "2026-12-31");
        assert_eq!(date(4_107_542_400), "2100-03-01");
        assert_eq!(date(253_402_300_799), "9999-12-31");
        assert_eq!(date(u64::MAX), "");
    }

    #[test]
    fn a_stamp_tells_day_and_time() {
        assert_eq!(stamp(951_868_799), "2000-02-29 23-59-59");
        assert_eq!(stamp(0), "1970-01-01 00-00-00");
        assert_eq!(moment(951_868_799), "2000-02-29 23:59:59");
    }
}
