//! Days and times in words that sort: where the player is for what is read, in UTC for the names of files.

use jiff::Timestamp;
use jiff::tz::TimeZone;

/// What a file made at a Unix time is called by: `2026-01-31 23-59-58`, UTC.
pub fn stamp(unix_s: u64) -> String {
    said(unix_s, TimeZone::UTC, "%Y-%m-%d %H-%M-%S")
}

/// A Unix time by the player's clock: 2026-11-27 12:33:28.
pub fn moment(unix_s: u64) -> String {
    said(unix_s, TimeZone::system(), "%Y-%m-%d %H:%M:%S")
}

/// The day of a Unix time by the player's clock as year-month-day.
pub fn date(unix_s: u64) -> String {
    said(unix_s, TimeZone::system(), "%Y-%m-%d")
}

/// Empty for a time past the year 9999: a save says it that never was.
fn said(unix_s: u64, zone: TimeZone, format: &str) -> String {
    let seconds = i64::try_from(unix_s).ok();
    let time = seconds.and_then(|it| Timestamp::from_second(it).ok());
    time.map_or_else(String::new, |time| {
        time.to_zoned_datetime(zone).strftime(format).to_string()
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use super::*;

    #[test]
    fn a_stamp_is_right_over_leap_days_and_centuries() {
        assert_eq!(stamp(0), "1970-01-01 00-00-00");
        assert_eq!(stamp(951_868_799), "2000-02-29 23-59-59");
        assert_eq!(stamp(951_868_800), "2000-03-01 00-00-00");
        assert_eq!(stamp(4_107_542_400), "2100-03-01 00-00-00");
        assert_eq!(stamp(u64::MAX), "");
    }

    #[test]
    fn times_are_those_of_the_players_clock_over_a_day_s_end_and_in_summer() {
        let zone = |rules: &str| TimeZone::posix(rules).unwrap();
        let berlin = || zone("CET-1CEST,M3.5.0,M10.5.0/3");
        let said = |unix_s, zone| said(unix_s, zone, "%Y-%m-%d %H:%M:%S");
        assert_eq!(said(951_868_799, berlin()), "2000-03-01 00:59:59");
        assert_eq!(said(962_409_600, berlin()), "2000-07-01 02:00:00");
        assert_eq!(said(0, zone("EST5")), "1969-12-31 19:00:00");
    }
}
