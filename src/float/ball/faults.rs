//! Faults put into the error bounds, one at a time.
//!
//! Each call of [`super::bound`] adds the parts of one bound. Here one part of one call is left out or
//! halved. A test that compares balls with values at more bits must detect each such fault; otherwise it
//! would not detect a mistake in the bound.

use super::Radius;
use core::panic::Location;
use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;

/// One part of one bound.
pub(super) type BoundPart = (&'static str, u32, usize);

/// The change made to a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Fault {
    LeftOut,
    Halved,
}

thread_local! {
    static FAULT: Cell<Option<(BoundPart, Fault)>> = const { Cell::new(None) };
    static SEEN: RefCell<BTreeSet<BoundPart>> = const { RefCell::new(BTreeSet::new()) };
}

pub(super) fn injected<const N: usize>(parts: [Radius; N], at: &'static Location<'static>) -> [Radius; N] {
    let fault = FAULT.get();
    let mut index = 0;
    parts.map(|part| {
        let here = (at.file(), at.line(), index);
        index += 1;
        match fault {
            None => {
                SEEN.with_borrow_mut(|seen| seen.insert(here));
                part
            }
            Some((faulty, Fault::LeftOut)) if faulty == here => Radius::ZERO,
            Some((faulty, Fault::Halved)) if faulty == here => part.scaled(-1),
            Some(_) => part,
        }
    })
}

/// The parts of all bounds that `run` meets.
pub(super) fn parts_of(run: impl FnOnce()) -> BTreeSet<BoundPart> {
    SEEN.with_borrow_mut(BTreeSet::clear);
    run();
    SEEN.with_borrow(Clone::clone)
}

/// Runs a computation with one part of one bound made too small.
pub(super) fn with_fault<T>(part: BoundPart, fault: Fault, run: impl FnOnce() -> T) -> T {
    FAULT.set(Some((part, fault)));
    let result = run();
    FAULT.set(None);
    result
}
