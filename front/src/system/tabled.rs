//! Motions under laws that are curves: by tables that are refined, with the digits that agree.

use super::built::NamedSystem;
use super::digits::{Nothing, Numbers, OfPassage, OfStates, OfSteady, extrapolated, told, told_of_steady};
use super::laws::{Law, Refined, set_points};
use super::proved::{Difference, Proved, ProvedSteady, Tabled};
use super::why::Why;
use serde::Serialize;
use stickslip::system::{Beyond, Error, Motion, State, Steady, System};

/// How often a range may be changed.
const MOST_RANGES: u32 = 64;
/// How often tables become finer where events differ.
const MOST_FINER: usize = 2;
/// By how much a table reaches beyond the motion.
const BEYOND: f64 = 1.25;
/// By how much the table of a steep law reaches beyond the motion.
const CLOSE: f64 = 1.05;
/// A table that reaches further than so many times the motion is made anew.
const TOO_FAR: f64 = 1.5;

/// What is known of an answer that was computed with tables of curves.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Digits {
    /// The finest tables.
    pub tables: Vec<OfTable>,
    /// How digits are known: `estimated`.
    digits: &'static str,
    /// Whether the last two tables have the same events.
    pub events_agree: bool,
    /// The largest estimated error of displacements and velocities, over the greatest of their kind.
    pub error: f64,
    /// A bound of the errors of displacements and velocities, where it says a digit of each at least.
    pub bound: Option<Proved>,
    /// A bound of a steady motion under loads, where dampers take more than laws fall and it says a digit of displacements at least.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub steady_bound: Option<ProvedSteady>,
}

/// A table.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OfTable {
    /// The element.
    pub name: String,
    /// Its pieces.
    pub pieces: usize,
    /// The force within which it is.
    pub within: f64,
    /// Whether that is proved, and not the greatest difference at 17 points of each piece.
    pub proved: bool,
}

/// An answer, with its digits where laws are curves.
type Known<T> = (T, Option<Digits>);

impl NamedSystem {
    /// The motion from a start to a time. Its numbers have the digits that are known, where laws are curves.
    ///
    /// # Errors
    /// As [`System::simulate`], or where a law has no table.
    pub fn simulate(&self, start: &State<f64>, until: f64) -> Result<Known<Motion<f64>>, Why> {
        self.asked(|system| system.simulate(start, until))
    }

    /// The motion that a start leads to. Its numbers have the digits that are known, where laws are curves.
    ///
    /// # Errors
    /// As [`System::steady`], or where a law has no table.
    pub fn steady(&self, start: &State<f64>) -> Result<Known<Steady<f64>>, Why> {
        let model = &self.described.model;
        let is_loaded =
            !model.harmonics.is_empty() || model.records.iter().any(|r| r.beyond == Beyond::Repeat);
        let (found, digits) =
            self.asked(|system| system.steady(start).map(|found| OfSteady { found, is_loaded }))?;
        Ok((found.found, digits))
    }

    /// The states at times that increase. Their numbers have the digits that are known, where laws are curves.
    ///
    /// # Errors
    /// As [`System::states`], or where a law has no table.
    pub fn states(&self, start: &State<f64>, times: &[f64]) -> Result<Vec<State<f64>>, Why> {
        if self.described.laws.is_empty() {
            return Ok(self.system.states(start, times)?);
        }
        let last = times.last().copied().unwrap_or(0.0);
        let ask = |system: &System<f64>| {
            let motion = system.simulate(start, last)?;
            system.states(start, times).map(|states| OfStates { states, motion })
        };
        Ok(self.asked(ask)?.0.states)
    }

    /// The end of a motion as it is typed for an argument of this name: a time, or a value that is passed first, `NAME = VALUE`, which is a
    /// displacement of a body, a contact or a stop, or with `NAME.velocity` a velocity. Its passages are events of the motions then. Without
    /// a text it is the end of the records.
    ///
    /// # Errors
    /// As [`NamedSystem::check_until`]; where there is no such name, or the value is not passed within the longest motion.
    pub fn until(&mut self, name: &str, typed: Option<&str>) -> Result<f64, String> {
        self.until_by(name, typed, Self::first_passage)
    }

    /// The first time at which a level is passed, and at most the latest.
    fn first_passage(&self, level: usize, latest: f64) -> Result<Option<f64>, Why> {
        let start = &self.described.start;
        if self.described.laws.is_empty() {
            return Ok(self.system.first_passage(start, level, latest)?);
        }
        let ask = |system: &System<f64>| {
            let time = system.first_passage(start, level, latest)?;
            let motion = time.map(|time| system.simulate(start, time)).transpose()?;
            Ok(OfPassage { time, motion })
        };
        Ok(self.asked(ask)?.0.time)
    }

    /// The answer to a question, with tables that are refined where laws are curves.
    fn asked<T: Numbers>(&self, ask: impl Fn(&System<f64>) -> Result<T, Error>) -> Result<Known<T>, Why> {
        let laws = &self.described.laws;
        if laws.is_empty() {
            return Ok((ask(&self.system)?, None));
        }
        let mut ranges: Vec<f64> = laws.iter().map(|law| law.reach).collect();
        // Ranges that the motion has left.
        let mut left = vec![0.0; laws.len()];
        for _ in 0..MOST_RANGES {
            let tables = laws.iter().zip(&ranges).map(|(law, &reach)| law.refined(reach));
            let tables = tables.collect::<Result<Vec<_>, _>>().map_err(Why::Law)?;
            let ends = ranges.clone();
            let at = |fineness: usize| {
                ask(&self.with_tables(&tables, Some(fineness), &ends)?).map_err(Why::Engine)
            };
            let leaves = |why: Why, ranges: &mut [f64], left: &mut [f64]| match why {
                Why::Engine(Error::LeavesLaw { element, .. }) => {
                    let own = laws.iter().position(|law| law.element == element);
                    match own.and_then(|own| Some((own, ranges.get_mut(own)?, left.get_mut(own)?))) {
                        Some((own, range, left)) => {
                            *left = *range;
                            *range = laws.get(own).map_or(*range, |law| law.further(*range));
                            Ok(())
                        }
                        None => Err(why),
                    }
                }
                why => Err(why),
            };
            // A few pieces tell how far the motion goes.
            let scout = match self.with_tables(&tables, None, &ends).and_then(|system| Ok(ask(&system)?)) {
                Ok(found) => found,
                Err(why) => {
                    leaves(why, &mut ranges, &mut left)?;
                    continue;
                }
            };
            let shorter = |_: &Law, reach: f64, left: f64, range: f64| {
                let due = BEYOND * reach.max(left);
                (reach > 0.0 && range > TOO_FAR * due).then_some(due)
            };
            if shorten(laws, &mut ranges, &left, &scout, shorter) {
                continue;
            }
            let all = at(0).and_then(|coarsest| Ok((coarsest, at(1)?, at(2)?)));
            let (mut coarsest, mut coarse, mut fine) = match all {
                Ok(all) => all,
                Err(why) => {
                    leaves(why, &mut ranges, &mut left)?;
                    continue;
                }
            };
            let mut fineness = 2;
            for finer in (3_usize..).take(MOST_FINER) {
                if coarse.is_like(&fine) {
                    break;
                }
                (coarsest, coarse, fine, fineness) = (coarse, fine, at(finer)?, finer);
            }
            // A table is as fine as its law is large at its end, so that a steep law must end where the motion does.
            let shorter = |law: &Law, reach: f64, left: f64, range: f64| {
                let due = CLOSE * reach.max(left);
                (due > 0.0 && due < range && law.is_steep(due, range)).then_some(due)
            };
            if shorten(laws, &mut ranges, &left, &fine, shorter) {
                continue;
            }
            let events_agree = coarse.is_like(&fine);
            let nothing = Nothing::new(&self.described.model, fine.span());
            let (answer, error) = extrapolated(&coarsest, &coarse, &fine, nothing);
            let points: Vec<_> = tables.iter().map(|of| of.table(fineness)).collect();
            let of_tables = laws.iter().zip(&tables).zip(&points).map(|((law, of), table)| {
                let (within, proved) = of.error(table);
                let name = self.described.name_of(law.element).to_owned();
                OfTable { name, pieces: table.len().saturating_sub(1), within, proved }
            });
            let tables: Vec<OfTable> = of_tables.collect();
            let tabled = laws.iter().zip(&tables).zip(points.iter().zip(&ranges));
            let tabled = tabled.map(|((law, of), (points, &range))| {
                let (element, within) = (law.element, if of.proved { of.within } else { f64::INFINITY });
                let reach = fine.reach(element).unwrap_or(f64::INFINITY);
                Tabled { element, points, within, reach, range }
            });
            let tabled: Vec<_> = tabled.collect();
            let difference = || Difference::new(&self.described.model, &tabled);
            let bound = fine.duration().and_then(|time| told(difference()?.after(time)?, &fine, &answer));
            let steady_bound = fine.steady().zip(answer.steady()).and_then(|(fine, answer)| {
                told_of_steady(difference()?.over_period(fine.period)?, &fine.motion, &answer.motion)
            });
            return Ok((
                answer,
                Some(Digits { tables, digits: "estimated", events_agree, error, bound, steady_bound }),
            ));
        }
        Err(Why::Law("the motion leaves every table of its laws".to_owned()))
    }

    /// The system with one of the tables of each law, or with a few pieces, and an end where the table ends.
    fn with_tables(
        &self,
        tables: &[Refined<'_>],
        fineness: Option<usize>,
        ranges: &[f64],
    ) -> Result<System<f64>, Why> {
        let mut model = self.described.model.clone();
        for (law, of) in self.described.laws.iter().zip(tables) {
            if let Some(element) = model.elements.get_mut(law.element) {
                set_points(
                    &mut element.kind,
                    fineness.map_or_else(|| of.scout(), |fineness| of.table(fineness)),
                );
            }
        }
        let mut system = self.described.moving(&model).map_err(Why::Engine)?.while_allowed(self.keep_going);
        for (law, &range) in self.described.laws.iter().zip(ranges) {
            system = system.stopping_beyond(law.element, range);
        }
        Ok(system)
    }
}

/// Ends tables nearer where `shorter` says so, by how far a motion goes and how far it has gone before: whether there is such a table.
fn shorten<T: Numbers>(
    laws: &[Law],
    ranges: &mut [f64],
    left: &[f64],
    found: &T,
    shorter: impl Fn(&Law, f64, f64, f64) -> Option<f64>,
) -> bool {
    let mut is_new = false;
    for ((law, range), &left) in laws.iter().zip(ranges).zip(left) {
        let reach = found.reach(law.element).unwrap_or(0.0);
        if let Some(due) = shorter(law, reach, left, *range) {
            (*range, is_new) = (due, true);
        }
    }
    is_new
}
