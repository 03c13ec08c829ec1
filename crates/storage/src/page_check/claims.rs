//! Notes which pages have been named, with a bit for each.

use std::ops::Range;

/// A set of pages that each may be put into once.
pub(crate) struct Claims {
    words: Vec<u64>,
}

impl Claims {
    /// None of `pages` pages.
    pub(crate) fn new(pages: u64) -> Self {
        Self {
            words: vec![0; pages.div_ceil(64) as usize],
        }
    }

    /// Puts in every page of a range; false if one was in already or is beyond the last.
    pub(crate) fn claim(&mut self, pages: Range<u64>) -> bool {
        let mut at = pages.start;
        while at < pages.end {
            let end = pages.end.min((at / 64 + 1) * 64);
            let ones = u64::MAX >> (64 - (end - at));
            let mask = ones << (at % 64);
            let Some(word) = self.words.get_mut((at / 64) as usize) else {
                return false;
            };
            if *word & mask != 0 {
                return false;
            }
            *word |= mask;
            at = end;
        }
        true
    }

    /// Puts in every page of another set; false if one was in already.
    pub(crate) fn join(&mut self, other: &Self) -> bool {
        let mut words = self.words.iter_mut().zip(&other.words);
        words.all(|(word, more)| {
            let apart = *word & more == 0;
            *word |= more;
            apart
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_is_claimed_once() {
        let mut claims = Claims::new(200);
        assert!(claims.claim(0..1));
        assert!(claims.claim(60..190));
        assert!(claims.claim(3..3));
        for taken in [0..1, 0..4, 59..61, 64..128, 189..190, 100..101] {
            assert!(!claims.claim(taken.clone()), "{taken:?}");
        }
        assert!(claims.claim(190..200));
        assert!(!claims.claim(250..260));
    }

    #[test]
    fn sets_are_joined_if_they_have_nothing_in_common() {
        let [mut claims, mut more] = [Claims::new(200), Claims::new(200)];
        assert!(claims.claim(0..65) && more.claim(65..130));
        assert!(claims.join(&more));
        assert!(!claims.claim(129..130) && !claims.join(&more));
        assert!(claims.claim(130..131));
    }
}
