//! Which boxes a traveller is in.

/// The boxes that a traveller is in, outermost first, by their numbers in the [`crate::Space`].
///
/// It has room for twice the greatest depth: where faces of boxes coincide, rounding may have one entered before the
/// other is left.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stack {
    boxes: [u8; Self::ROOM],
    len: u8,
}

impl Stack {
    /// Boxes that it holds at most.
    pub const ROOM: usize = 16;

    /// The boxes, outermost first.
    pub fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        self.as_bytes().iter().map(|number| usize::from(*number))
    }

    /// Their numbers as bytes.
    pub fn as_bytes(&self) -> &[u8] {
        &self.boxes[..usize::from(self.len)]
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        usize::from(self.len)
    }

    /// Whether the traveller is in none.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The innermost.
    pub fn innermost(&self) -> Option<usize> {
        self.as_bytes().last().map(|number| usize::from(*number))
    }

    /// Whether a box is among them.
    pub fn contains(&self, number: usize) -> bool {
        self.iter().any(|inside| inside == number)
    }

    /// Puts a box where its rank belongs, `rank` giving that of any box; outer boxes have lower ones. A full stack stays.
    pub(crate) fn insert(&mut self, number: usize, rank: impl Fn(usize) -> usize) {
        if self.len() == Self::ROOM {
            return;
        }
        let mut at = self.len();
        while at > 0 && rank(usize::from(self.boxes[at - 1])) > rank(number) {
            self.boxes[at] = self.boxes[at - 1];
            at -= 1;
        }
        self.boxes[at] = number as u8;
        self.len += 1;
    }

    /// Takes a box out, wherever it is.
    pub(crate) fn remove(&mut self, number: usize) {
        let found = self.iter().position(|inside| inside == number);
        if let Some(at) = found {
            self.boxes.copy_within(at + 1..usize::from(self.len), at);
            self.len -= 1;
            self.boxes[usize::from(self.len)] = 0;
        }
    }
}
