//! The widths that are tested.

/// Calls a function at 64, 128, 256 and 1024 bits.
macro_rules! at_widths {
    ($function:ident($($argument:expr),*)) => {{
        $function::<1>($($argument),*);
        $function::<2>($($argument),*);
        $function::<4>($($argument),*);
        $function::<16>($($argument),*);
    }};
}
