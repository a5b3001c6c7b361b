//! The items of a long list that have room: those that are not as expected before all others.

/// The indices of what is shown, ascending: at most `most`, and what is `odd` first of all.
pub(crate) fn at_most<T>(items: &[T], most: usize, odd: impl Fn(&T) -> bool) -> Vec<usize> {
    let (mut kept, others): (Vec<usize>, Vec<usize>) = (0..items.len()).partition(|&i| odd(&items[i]));
    kept.extend(others);
    kept.truncate(most);
    kept.sort_unstable();
    kept
}

/// The part of a list that a table shows: all that is odd, above everything else, and as much of the rest as has room.
pub(crate) struct Shown<'a, T> {
    pub(crate) items: Vec<&'a T>,
    /// The number left out, none of them odd.
    pub(crate) left_out: usize,
}

impl<'a, T> Shown<'a, T> {
    /// At most `most` of `items`, or more if more are odd.
    pub(crate) fn new(items: impl IntoIterator<Item = &'a T>, most: usize, odd: impl Fn(&T) -> bool) -> Self {
        let (mut shown, others): (Vec<&T>, Vec<&T>) = items.into_iter().partition(|item| odd(item));
        let room = most.saturating_sub(shown.len()).min(others.len());
        shown.extend(&others[..room]);
        Self { items: shown, left_out: others.len() - room }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_odd(n: &u32) -> bool {
        n % 2 == 1
    }

    #[test]
    fn what_is_odd_has_room_before_all_others_and_keeps_its_place() {
        assert_eq!(at_most(&[0, 2, 4, 5, 6, 7], 3, is_odd), [0, 3, 5]);
        assert_eq!(at_most(&[1, 3, 5, 7], 3, is_odd), [0, 1, 2]);
        assert_eq!(at_most(&[0, 1], 3, is_odd), [0, 1]);
    }

    #[test]
    fn a_table_never_leaves_out_what_is_odd_and_counts_the_rest() {
        let of = |items: &[u32], most| {
            let shown = Shown::new(items, most, is_odd);
            (shown.items.into_iter().copied().collect::<Vec<_>>(), shown.left_out)
        };
        assert_eq!(of(&[0, 2, 1, 4, 3], 4), (vec![1, 3, 0, 2], 1));
        assert_eq!(of(&[1, 3, 0, 5], 2), (vec![1, 3, 5], 1));
        assert_eq!(of(&[2, 4], 2), (vec![2, 4], 0));
    }
}
