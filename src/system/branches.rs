//! The branches that a motion has met, in a bounded memory: the one that was left the longest time ago makes room.

use super::assembly::{Assembly, Rule};
use super::branch::Branch;
use super::mode::Mode;
use super::under::loaded;
use crate::float::Float;
use alloc::vec::Vec;

/// The memory of all branches in bytes: two thousand of two bodies, or sixty of thirty bodies with a contact each.
const MOST_BYTES: usize = 96 << 20;
/// The steps of a motion with blows in which nothing is faster than its end: its flights may be far shorter than it, and the rounding of a
/// guard is that of a whole step.
const PARTS: i32 = 256;
/// The most branches: they are looked for one by one.
const MOST_BRANCHES: usize = 1024;

/// A branch with the instant at which it was entered last, counted in branches that were entered.
struct Known<F> {
    branch: Branch<F>,
    entered: u64,
}

/// The branches of a motion.
pub(crate) struct Branches<F> {
    known: Vec<Known<F>>,
    current: usize,
    entered: u64,
    bytes: usize,
    /// The bound of every step.
    longest: F,
}

impl<F: Float> Branches<F> {
    /// No branches, whose steps will be at most this long.
    pub(crate) const fn new(longest: F) -> Self {
        Self { known: Vec::new(), current: 0, entered: 0, bytes: 0, longest }
    }

    /// The present branch.
    #[inline]
    pub(crate) fn current(&self) -> Option<&Branch<F>> {
        self.known.get(self.current).map(|known| &known.branch)
    }

    /// Makes the branch with these modes the present one.
    pub(crate) fn enter(&mut self, system: &Assembly<F>, modes: &[Mode]) {
        self.entered = self.entered.saturating_add(1);
        let known = self.known.iter().position(|known| known.branch.modes == modes);
        let place = known.unwrap_or_else(|| {
            let others = self.known.iter().map(|known| &known.branch);
            let has_blows = system.parts.iter().any(|part| matches!(part.rule, Rule::Hard { .. }));
            let free = if has_blows { self.longest / F::int(PARTS) } else { self.longest };
            let branch = Branch::new(&loaded(system, modes), modes, [self.longest, free], others);
            self.add(branch)
        });
        if let Some(known) = self.known.get_mut(place) {
            known.entered = self.entered;
        }
        self.current = place;
    }

    /// Keeps a branch: its place.
    fn add(&mut self, branch: Branch<F>) -> usize {
        // What has been asked of a branch since then is counted, too.
        let bytes =
            self.known.iter().map(|known| known.branch.bytes()).fold(branch.bytes(), usize::saturating_add);
        self.bytes = bytes;
        while self.known.len() >= MOST_BRANCHES || self.bytes > MOST_BYTES {
            let oldest = self.known.iter().enumerate().min_by_key(|(_, known)| known.entered);
            let Some((place, _)) = oldest else { break };
            let left = self.known.swap_remove(place);
            self.bytes = self.bytes.saturating_sub(left.branch.bytes());
        }
        self.known.push(Known { branch, entered: self.entered });
        self.known.len().saturating_sub(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::{Element, Harmonic, Kind, Law, Model, Signal, System};

    /// Sixty bodies with a contact each have more branches than there is room for; the latest stay, and one that was left out
    /// comes back as it was.
    #[test]
    fn the_memory_of_branches_is_bounded() {
        let n = 60;
        let diagonal = |x: f64| -> Vec<Vec<f64>> {
            (0..n).map(|i| (0..n).map(|j| if i == j { x } else { 0.0 }).collect()).collect()
        };
        let contact = |i: usize| Element {
            name: String::new(),
            direction: (0..n).map(|j| if i == j { 1.0 } else { 0.0 }).collect(),
            moves: Signal::constant(0.0),
            kind: Kind::Contact { law: Law::constant(1.0), peak: 1.0, normal: None },
        };
        let model = Model {
            mass: diagonal(1.0),
            damping: diagonal(0.1),
            // Each with each, so that the branches have the matrices of many entries.
            stiffness: (0..n).map(|i| (0..n).map(|j| if i == j { 1.0 } else { -1e-3 }).collect()).collect(),
            elements: (0..n).map(contact).collect(),
            ..Model::default()
        };
        let system = System::new(&model).unwrap().assembly;
        let mut branches = Branches::new(1.0);
        let modes = |k: usize| -> Vec<Mode> {
            (0..n)
                .map(|i| if i == k { Mode::Stuck } else { Mode::Slides { forward: true, piece: 0 } })
                .collect()
        };
        branches.enter(&system, &modes(0));
        let first = branches.current().unwrap().whole().clone();
        let mut most = 0;
        for k in 0..n {
            for forward in [true, false] {
                let mut modes = modes(k);
                modes[(k + 1) % n] = Mode::Slides { forward, piece: 0 };
                branches.enter(&system, &modes);
                assert_eq!(branches.current().unwrap().modes, modes);
                most = most.max(branches.bytes);
            }
        }
        let held: usize = branches.known.iter().map(|known| known.branch.bytes()).sum();
        assert_eq!(held, branches.bytes);
        assert!(most <= MOST_BYTES && branches.known.len() < 2 * n + 1, "{most} {}", branches.known.len());
        assert!(branches.known.iter().all(|known| known.branch.modes != modes(0)));
        branches.enter(&system, &modes(0));
        assert!(*branches.current().unwrap().whole() == first);
    }

    /// The matrices have no entry for a load that moves another load: a hundred times as many loads need a hundred times the memory.
    #[test]
    fn loads_need_memory_in_proportion() {
        let bytes = |count: usize| {
            let harmonic = |i: usize| Harmonic { frequency: 1.0 + i as f64, sin: vec![1.0], cos: vec![] };
            let model = Model {
                mass: vec![vec![1.0]],
                damping: vec![vec![0.1]],
                stiffness: vec![vec![1.0]],
                harmonics: (0..count).map(harmonic).collect(),
                ..Model::default()
            };
            let system = System::new(&model).unwrap().assembly;
            let mut branches = Branches::new(1.0);
            branches.enter(&system, &[]);
            branches.current().unwrap().bytes()
        };
        let (few, many) = (bytes(20), bytes(2000));
        assert!(many <= 100 * few && many >= 50 * few, "{few} {many}");
    }
}
