//! Text for C.

use std::ffi::{CStr, c_char};

/// Copies `text` into the `capacity` bytes at `into`, cut at a whole character and always ended by a zero.
///
/// # Safety
/// `into` is null or points to `capacity` writable bytes.
pub(crate) unsafe fn put(text: &str, into: *mut c_char, capacity: usize) {
    if into.is_null() || capacity == 0 {
        return;
    }
    let most = if text.len() < capacity { text.len() } else { capacity - 1 };
    let end = (0..=most).rev().find(|&end| text.is_char_boundary(end)).unwrap_or(0);
    // SAFETY: end < capacity bytes are written and one zero; the regions cannot overlap, for `text` is ours.
    unsafe {
        std::ptr::copy_nonoverlapping(text.as_ptr().cast(), into, end);
        *into.add(end) = 0;
    }
}

/// The text at `text`, if there is one in UTF-8.
///
/// # Safety
/// `text` is null or ends with a zero, and lives as long as what is returned.
pub(crate) unsafe fn get<'a>(text: *const c_char) -> Option<&'a str> {
    if text.is_null() {
        return None;
    }
    // SAFETY: not null, and the caller's promise.
    unsafe { CStr::from_ptr(text) }.to_str().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_cut_at_a_character_and_ended() {
        for (capacity, kept) in [(1, ""), (2, "a"), (3, "a"), (4, "aµ"), (9, "aµb")] {
            let mut bytes = [b'x'; 9];
            // SAFETY: nine bytes are there, and a zero is among them afterwards.
            let back = unsafe {
                put("aµb", bytes.as_mut_ptr().cast(), capacity);
                get(bytes.as_ptr().cast())
            };
            assert_eq!(back, Some(kept), "{capacity}");
        }
        // SAFETY: null is allowed.
        unsafe { put("text", std::ptr::null_mut(), 5) };
        // SAFETY: null is allowed.
        assert_eq!(unsafe { get(std::ptr::null()) }, None);
    }
}
