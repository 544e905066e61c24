//! Systems of several bodies with dry friction, laws of speed, elastic contacts and stops: their exact motion.
//!
//! `M q″ + C q′ + K q = f(t) − Σ b T`, where each element acts along a direction b with a force T that is linear as
//! long as the element does not change its mode. Between two events the motion is that of a linear equation, and each
//! event is found with a certificate that none came before: there is neither a step size nor a tolerance.
//!
//! ```
//! use stickslip::system::{EventKind, System};
//! // Two masses of 1 on springs of 1; the second slides on the ground with the friction 0.5.
//! let built = System::builder()
//!     .mass("first", 1.0)
//!     .mass("second", 1.0)
//!     .spring("ground", "first", 1.0)
//!     .spring("first", "second", 1.0)
//!     .contact("ground", "second", 0.5)
//!     .starts("first", 1.0, 0.0);
//! let motion = built.build()?.simulate(&built.start(), 3.0)?;
//! assert_eq!(motion.events.first().map(|e| e.kind), Some(EventKind::Stick));
//! # Ok::<(), stickslip::system::Error>(())
//! ```
//!
//! # Where is what
//!
//! `model.rs` is the description as it is given, `build.rs` builds it by the names of its bodies, `damping.rs` adds damping by modes, `assembly.rs` checks it and builds rows over the state,
//! `branch.rs` has the linear equation between two events and the proof of the certificate, `guard.rs` what ends it, `split.rs` the steps that its fast modes (`spectrum.rs`, `waves.rs`) do not shorten, `timeline.rs` has the samples of records in time, `first_passage.rs` the search for a
//! guard's first zero, `next_branch.rs` the choice of the next branch, `dependent.rs` what contacts with dependent directions
//! can hold, `blow.rs` what happens at stops with a restitution, `under.rs` the friction under their force, `massless.rs` and `tie.rs` what has no mass, `follow.rs` the motion from event to event, `follow/choose.rs` the choice of its branch, `events.rs` what watches it, `levels.rs` the passages of values, `mapped.rs` answers with other numbers in them, `precision.rs` thresholds that follow the precision,
//! `spring.rs` the springs with laws, `grid.rs` many systems on all cores, `motion.rs` its answers, `steady.rs` the long run, `self_excited.rs` that without a load, `sliding.rs` the stability of steady sliding, and `border.rs` the closed form for one contact.

mod assembly;
mod blow;
mod border;
mod branch;
mod branches;
mod build;
mod calm;
mod damping;
mod dependent;
mod drift;
mod equation;
mod error;
mod events;
mod few;
mod first_passage;
mod fixed_point;
mod follow;
mod following;
mod forced;
mod given;
#[cfg(feature = "rayon")]
mod grid;
mod guard;
mod joints;
mod kept;
mod levels;
mod mapped;
mod massless;
mod matrix;
mod mode;
mod model;
mod modes;
mod monotone;
mod motion;
mod next_branch;
mod period_map;
mod pieces;
mod precision;
mod propagator;
#[cfg(feature = "mp")]
mod proved;
mod rate;
mod self_excited;
mod sliding;
mod spectrum;
mod split;
mod spring;
mod steady;
mod tie;
mod timeline;
mod under;
mod waves;

use crate::float::Float;
use alloc::vec::Vec;
use assembly::Assembly;
use core::ops::ControlFlow;
use drift::Drift;
use follow::Follower;
use given::{finite, vector};
use motion::{Observer, Passage, state};

pub use border::{Border, Cycle};
pub use build::Builder;
pub use error::Error;
pub use events::{Event, EventKind};
#[cfg(feature = "rayon")]
pub use grid::solve_each;
pub use model::{
    Base, Beyond, Element, Harmonic, Kind, Law, Level, Model, Moved, MovedBy, Normal, Record, Signal, State,
};
pub use motion::{ElementMotion, Motion};
pub use sliding::{GREATEST_COEFFICIENT, Sliding, SlidingThreshold};
pub use steady::{Steady, SteadyKind};

/// A checked system, ready to move.
#[derive(Debug, Clone)]
pub struct System<F> {
    assembly: Assembly<F>,
}

impl<F: Float> System<F> {
    /// Checks a model.
    ///
    /// # Errors
    /// [`Error`], which names the part and the condition: numbers are finite, matrices square, M symmetric and positive
    /// definite, laws begin at 0 and increase, frictions are ≥ 0, stiffnesses > 0, peaks ≥ 1, restitutions from 0 to 1.
    pub fn new(model: &Model<F>) -> Result<Self, Error> {
        Assembly::new(model).map(|assembly| Self { assembly })
    }

    /// This system, whose fast modes shorten its steps, and whose steps are products with matrices of all entries: for the comparison with
    /// steps that they do not shorten, and with those of large systems.
    #[doc(hidden)]
    #[must_use]
    pub const fn by_short_steps(mut self) -> Self {
        self.assembly.shortcuts = false;
        self
    }

    /// This system, whose motions are followed as long as `keep_going` returns [`ControlFlow::Continue`]; they ask it at least
    /// once in 512 steps. Otherwise they end with [`Error::Interrupted`].
    ///
    /// ```
    /// use core::ops::ControlFlow;
    /// use stickslip::system::{Error, Harmonic, Model, State, System};
    /// let one = || vec![vec![1.0]];
    /// let harmonics = vec![Harmonic { frequency: 1.0, sin: vec![1.0], cos: vec![] }];
    /// let model = Model { mass: one(), damping: vec![vec![0.0]], stiffness: one(), harmonics, ..Model::default() };
    /// let system = System::new(&model)?.while_allowed(|| ControlFlow::Break(()));
    /// assert_eq!(system.simulate(&State::rest(1), 1e4), Err(Error::Interrupted));
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub const fn while_allowed(mut self, keep_going: fn() -> ControlFlow<()>) -> Self {
        self.assembly.keep_going = keep_going;
        self
    }

    /// This system, whose motions end with [`Error::LeavesLaw`] where the speed of the contact at this place, or the size of the stretch of
    /// the spring with a law, exceeds a limit: its law is not known beyond.
    ///
    /// ```
    /// use stickslip::system::{Element, Error, Kind, Model, Signal, State, System};
    /// // A mass of 1 on a spring with T = y, which is known up to 2, leaves the origin with the velocity 3.
    /// let kind = Kind::Spring { points: vec![(-2.0, -2.0), (2.0, 2.0)] };
    /// let spring = Element { name: "spring".into(), direction: vec![1.0], moves: Signal::constant(0.0), kind };
    /// let one = |x: f64| vec![vec![x]];
    /// let model = Model { mass: one(1.0), damping: one(0.0), stiffness: one(0.0), elements: vec![spring], ..Model::default() };
    /// let system = System::new(&model)?.stopping_beyond(0, 2.0);
    /// let start = State { velocity: vec![3.0], ..State::rest(1) };
    /// // sin t = 2/3
    /// assert!(system.simulate(&start, 0.72).is_ok());
    /// assert!(matches!(system.simulate(&start, 0.74), Err(Error::LeavesLaw { element: 0, .. })));
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn stopping_beyond(mut self, element: usize, limit: F) -> Self {
        if let Some(part) = self.assembly.parts.get_mut(element) {
            part.limit = Some(limit);
        }
        self
    }

    /// This system on a base that moves, so that its motions have [`Motion::max_absolute_acceleration`], and its states
    /// [`State::absolute_acceleration`].
    ///
    /// # Errors
    /// [`Error`] where the influence has another length than the coordinates, a list is longer than that of the loads, or a
    /// number is not finite.
    ///
    /// ```
    /// use stickslip::system::{Base, Harmonic, Model, Signal, State, System};
    /// // A mass of 1 on a spring of 4, on a base with the acceleration sin t: the load is −sin t.
    /// let load = Harmonic { frequency: 1.0, sin: vec![-1.0], cos: vec![] };
    /// let (mass, damping, stiffness) = (vec![vec![1.0]], vec![vec![0.0]], vec![vec![4.0]]);
    /// let model = Model { mass, damping, stiffness, harmonics: vec![load], ..Model::default() };
    /// let acceleration = Signal { sin: vec![1.0], ..Signal::constant(0.0) };
    /// let base = Base { influence: vec![1.0], acceleration };
    /// // x = −(sin t)/3, and x″ + sin t = 4/3 sin t.
    /// let start = State { velocity: vec![-1.0 / 3.0], ..State::rest(1) };
    /// let motion = System::new(&model)?.with_base(&base)?.simulate(&start, 7.0)?;
    /// let most: f64 = motion.max_absolute_acceleration[0];
    /// assert!((most - 4.0 / 3.0).abs() < 1e-14);
    /// # Ok::<(), stickslip::system::Error>(())
    /// ```
    pub fn with_base(mut self, base: &Base<F>) -> Result<Self, Error> {
        self.assembly.base = self.assembly.rows_of_base(base)?;
        Ok(self)
    }

    /// The number of coordinates.
    #[must_use]
    pub const fn coordinates(&self) -> usize {
        self.assembly.n
    }

    /// The exact motion from a start at time 0 until a time.
    ///
    /// # Errors
    /// [`Error`] where the start or the time is not valid, or the motion cannot be followed.
    pub fn simulate(&self, start: &State<F>, until: F) -> Result<Motion<F>, Error> {
        let mut follower = self.follower(start, until)?;
        let first = follower.z.clone();
        let mut observer = Observer::new(&self.assembly, &first);
        follower.run(until, &mut observer)?;
        Ok(observer.finish(&self.assembly, &first, &follower))
    }

    /// The first time after the start, and at most the latest, at which the quantity of a level passes its value; none where there is no such
    /// time or no such level.
    ///
    /// # Errors
    /// As [`System::simulate`].
    ///
    /// ```
    /// use stickslip::system::{Level, Model, State, System};
    /// // A mass of 1 under a force of 2 is at 9 after 3.
    /// let zero = || vec![vec![0.0]];
    /// let level = Level { name: "end".into(), displacement: vec![1.0], velocity: vec![], value: 9.0 };
    /// let model = Model {
    ///     mass: vec![vec![1.0]],
    ///     damping: zero(),
    ///     stiffness: zero(),
    ///     constant: vec![2.0],
    ///     levels: vec![level],
    ///     ..Model::default()
    /// };
    /// assert_eq!(System::new(&model)?.first_passage(&State::rest(1), 0, 10.0)?, Some(3.0));
    /// # Ok::<(), stickslip::system::Error>(())
    /// ```
    pub fn first_passage(&self, start: &State<F>, level: usize, latest: F) -> Result<Option<F>, Error> {
        let mut passage = Passage::new(&self.assembly, level);
        if level < self.assembly.levels.len() {
            self.follower(start, latest)?.run(latest, &mut passage)?;
        }
        Ok(passage.time())
    }

    /// The motion that a start leads to in the long run, at phase 0 of the harmonic loads and at the beginning of records that repeat
    /// themselves.
    ///
    /// It is found by Newton's method from some followed periods, and accepted where the period map closes to rounding
    /// with the events of the motion that was followed, and where small disturbances do not grow; at once where no two motions of the system move
    /// apart, or no event can come any more. Without loads the motion
    /// is self-excited, and its period is found with it, or it comes to rest. An undamped vibration that no contact stops is never
    /// forgotten, so that a start that has it does not settle.
    ///
    /// # Errors
    /// As [`System::simulate`]; also where a period of the loads has more than 250,000 steps, or the loads have no common period, or a record does not
    /// repeat itself.
    pub fn steady(&self, start: &State<F>) -> Result<Steady<F>, Error> {
        if self.assembly.records.iter().any(|record| !record.repeats()) {
            let condition = "must repeat themselves: a steady motion has the period of a load";
            return Err(Error::Unsupported { name: "records".into(), condition });
        }
        let records = self.assembly.records.iter().map(|record| F::int(2) * F::pi() / record.length());
        let frequencies: Vec<F> = self.assembly.frequencies.iter().copied().chain(records).collect();
        if frequencies.is_empty() {
            let all: Vec<usize> = (0..self.assembly.parts.len()).collect();
            let mut frequencies = self.natural_frequencies(&[]);
            frequencies.extend(self.natural_frequencies(&all));
            let (longest, others) = self_excited::natural_periods(&frequencies, self.steps_per_time());
            self.check_carried(longest)?;
            return self_excited::self_excited(
                &self.assembly,
                longest,
                &others,
                self.follower(start, longest)?,
            );
        }
        let period = forced::common_period(&frequencies)?;
        self.check_carried(period)?;
        // The longest own vibration, free or with all elements at rest.
        let slowest = || {
            let all: Vec<usize> = (0..self.assembly.parts.len()).collect();
            let own = self.natural_frequencies(&[]).into_iter().chain(self.natural_frequencies(&all));
            let own = own.filter(|omega| *omega > F::int(0));
            own.reduce(|a, b| if b < a { b } else { a }).map(|omega| F::int(2) * F::pi() / omega)
        };
        forced::steady(&self.assembly, period, slowest, self.follower(start, period)?)
    }

    /// Refuses what is prescribed to travel and pulls on a spring for ever.
    fn check_carried(&self, period: F) -> Result<(), Error> {
        if Drift::new(&self.assembly, period).carries(&self.assembly) {
            return Ok(());
        }
        let condition = "must come back, or take along what is on springs with it: prescribe its displacement, or its velocity";
        Err(Error::Unsupported { name: "moved".into(), condition })
    }

    /// The least load at which the only contact never sticks, for a system with one contact and one harmonic load.
    ///
    /// # Errors
    /// [`Error`] where the system has other elements or loads, or is undamped at a resonance.
    pub fn border(&self) -> Result<Border<F>, Error> {
        border::border(&self.assembly)
    }

    /// The cycle of two reversals a period in closed form, for a system with one contact and one harmonic load; none where
    /// the load is too weak for such a cycle to exist at all.
    ///
    /// # Errors
    /// As [`System::border`].
    pub fn cycle(&self) -> Result<Option<Cycle<F>>, Error> {
        border::cycle(&self.assembly)
    }

    /// The states of the exact motion at times that increase, with the forces of all elements, and on a base the absolute
    /// accelerations.
    ///
    /// # Errors
    /// As [`System::simulate`]; also where a time is below the one before it.
    pub fn states(&self, start: &State<F>, times: &[F]) -> Result<Vec<State<F>>, Error> {
        let last = times.last().copied().unwrap_or(F::int(0));
        let mut follower = self.follower(start, last)?;
        let mut before = F::int(0);
        times
            .iter()
            .map(|&time| {
                given::at_least("time", time, before)?;
                before = time;
                follower.run(time, &mut ())?;
                Ok(state(&self.assembly, &follower))
            })
            .collect()
    }

    /// The motion at its start, which is checked.
    fn follower(&self, start: &State<F>, until: F) -> Result<Follower<'_, F>, Error> {
        let n = self.assembly.n;
        vector("start: displacement", &start.displacement, n)?;
        vector("start: velocity", &start.velocity, n)?;
        if start.force.len() > self.assembly.parts.len() {
            let (found, expected) = (start.force.len(), self.assembly.parts.len());
            return Err(Error::Length { name: "start: force".into(), found, expected });
        }
        start.force.iter().try_for_each(|&x| finite("start: force", x).map(|_| ()))?;
        given::at_least("time", until, F::int(0))?;
        Follower::new(&self.assembly, start, until)
    }
}
