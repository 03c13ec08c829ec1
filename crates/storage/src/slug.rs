//! Directory names that every file system can hold, made from any world's name.

/// Names that Windows keeps for devices, in lower case.
const RESERVED: [&str; 6] = ["con", "prn", "aux", "nul", "conin", "conout"];
/// The folder of rooms in a directory of worlds, which no world has for its own.
pub const ROOMS_FOLDER: &str = "rooms";
/// The longest slug before a suffix; short, for systems that bound whole paths.
const MAX_SLUG_BYTES: usize = 32;

/// The directory name for a world's name: lower-case ASCII letters, digits and
/// single dashes between them, 1 to 40 of them. Different names can give one slug;
/// the saves directory makes it unique with a number.
pub fn slug_of(name: &str) -> String {
    slug_or(name, "world")
}

/// The same for something else than a world: `other` takes the place of that word.
pub(crate) fn slug_or(name: &str, other: &str) -> String {
    let mut slug = String::new();
    for c in name.chars() {
        if c.is_ascii_alphanumeric() {
            slug.push(c.to_ascii_lowercase());
        } else if !slug.is_empty() && !slug.ends_with('-') {
            slug.push('-');
        }
    }
    slug.truncate(MAX_SLUG_BYTES);
    let slug = slug.trim_end_matches('-');
    if slug.is_empty() {
        other.to_owned()
    } else if is_reserved(slug) || slug == ROOMS_FOLDER {
        format!("{slug}-{other}")
    } else {
        slug.to_owned()
    }
}

/// The slug with a number: `foo`, `foo-2`, `foo-3` and so on.
pub(crate) fn numbered(slug: &str, number: u32) -> String {
    if number <= 1 {
        slug.to_owned()
    } else {
        format!("{slug}-{number}")
    }
}

/// Whether some systems keep a name for a device, so that no file may have it, whatever its ending.
pub fn is_reserved_name(name: &str) -> bool {
    is_reserved(&name.to_ascii_lowercase())
}

fn is_reserved(slug: &str) -> bool {
    let port = slug
        .strip_prefix("com")
        .or_else(|| slug.strip_prefix("lpt"));
    RESERVED.contains(&slug)
        || port.is_some_and(|rest| rest.len() == 1 && rest.as_bytes()[0].is_ascii_digit())
}

#[cfg(test)]
mod tests {
    #![allow(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        reason = "tests fail by panicking"
    )]

    use super::*;
    use proptest::prelude::*;

    #[test]
    fn slugs_read_like_the_name() {
        let cases = [
            ("My World", "my-world"),
            ("../../etc", "etc"),
            ("a..b", "a-b"),
            ("Żółw 7", "w-7"),
            ("世界", "world"),
            ("...", "world"),
            ("CON", "con-world"),
            ("com1", "com1-world"),
            ("LPT9", "lpt9-world"),
            ("com10", "com10"),
            ("console", "console"),
            ("nul.txt", "nul-txt"),
            ("Rooms", "rooms-world"),
        ];
        for (name, slug) in cases {
            assert_eq!(slug_of(name), slug, "{name}");
        }
        assert_eq!(numbered("a", 1), "a");
        assert_eq!(numbered("a", 2), "a-2");
    }

    proptest! {
        #[test]
        fn every_slug_is_safe_everywhere(name in any::<String>()) {
            let slug = slug_of(&name);
            prop_assert!((1..=40).contains(&slug.len()));
            prop_assert!(slug.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-'));
            prop_assert!(!slug.starts_with('-') && !slug.ends_with('-') && !slug.contains("--"));
            prop_assert!(!is_reserved(&slug));
        }
    }
}
