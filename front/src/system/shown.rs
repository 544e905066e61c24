//! Which parts of a long answer are shown.

use super::described::Described;
use super::node::Number;
use crate::text::printable;

/// The most coordinates, elements, events and natural frequencies that a text lists without a choice.
pub const MOST_LISTED: usize = 24;

impl<F: Number> Described<F> {
    /// Chooses the coordinates that answers show, by their names with a comma between two; `all` are all of them, and those of
    /// `argument` are named in errors.
    ///
    /// # Errors
    /// Names a coordinate that the system does not have, or that is given twice.
    pub fn show(&mut self, argument: &str, names: &str) -> Result<(), String> {
        let place = |name: &str| self.coordinates.iter().position(|own| own == name);
        if names == "all" && place(names).is_none() {
            self.shown = Some((0..self.coordinates.len()).collect());
            return Ok(());
        }
        let mut places: Vec<usize> = Vec::new();
        for name in names.split(',').map(str::trim) {
            let wrong = |why: &str| format!("{argument} {}: {why}", printable(name));
            let Some(place) = place(name) else {
                let listed: Vec<&str> =
                    self.coordinates.iter().take(MOST_LISTED).map(String::as_str).collect();
                let more = if self.coordinates.len() > listed.len() { ", …" } else { "" };
                return Err(wrong(&format!("must be a coordinate: {}{more}", listed.join(", "))));
            };
            if places.contains(&place) {
                return Err(wrong("must be given once"));
            }
            places.push(place);
        }
        self.shown = Some(places);
        Ok(())
    }

    /// The places of the coordinates that answers show, in the order in which they were chosen.
    pub fn places(&self) -> impl Iterator<Item = usize> + Clone + '_ {
        let chosen = self.shown.as_deref();
        let count = chosen.map_or(self.coordinates.len(), <[usize]>::len);
        (0..count).filter_map(move |i| chosen.map_or(Some(i), |chosen| chosen.get(i).copied()))
    }

    /// The coordinates that a text lists, with their places: the chosen ones, or the first ones of many.
    pub fn listed(&self) -> impl Iterator<Item = (usize, &String)> + Clone {
        let most = if self.shown.is_some() { usize::MAX } else { MOST_LISTED };
        self.places().zip(self.shown(&self.coordinates)).take(most)
    }

    /// The entries of a list for these coordinates, which has one for each coordinate, or none at all.
    pub fn shown<'a, T>(&'a self, list: &'a [T]) -> impl Iterator<Item = &'a T> + Clone {
        self.places().filter_map(|place| list.get(place))
    }
}
