//! Days and times in words that sort, UTC: the standard library knows no other.

/// What a file made at a Unix time is called by: `2026-01-31 23-59-58`, UTC.
pub fn stamp(unix_s: u64) -> String {
    let (hours, minutes, seconds) = (unix_s / 3600 % 24, unix_s / 60 % 60, unix_s % 60);
    format!("{} {hours:02}-{minutes:02}-{seconds:02}", date(unix_s))
}

/// The day of a Unix time as year-month-day, UTC, by Howard Hinnant's `civil_from_days`.
/// Empty for a time past the year 9999: a save says it that never was.
pub fn date(unix_s: u64) -> String {
    if unix_s >= 253_402_300_800 {
        return String::new();
    }
    let days = (unix_s / 86_400) as i64 + 719_468;
    let era = days.div_euclid(146_097);
    let day_of_era = days.rem_euclid(146_097);
    let year_of_era =
        (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted_month = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * shifted_month + 2) / 5 + 1;
    let month = if shifted_month < 10 {
        shifted_month + 3
    } else {
        shifted_month - 9
    };
    let year = year_of_era + era * 400 + i64::from(month <= 2);
    format!("{year:04}-{month:02}-{day:02}")
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
    }
}
