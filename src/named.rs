//! Enumerations whose variants have names.

use alloc::borrow::ToOwned;
use alloc::string::String;
use core::fmt;

/// The error for a text that names nothing of its kind.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct UnknownName {
    /// The unknown name.
    pub name: String,
    /// The names that there are.
    pub choices: &'static [&'static str],
}

impl fmt::Display for UnknownName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "name = {} must be one of {}", self.name, self.choices.join(", "))
    }
}

impl core::error::Error for UnknownName {}

impl UnknownName {
    /// The place of a name among the choices.
    pub(crate) fn place(name: &str, choices: &'static [&'static str]) -> Result<usize, Self> {
        let found = choices.iter().position(|choice| *choice == name);
        found.ok_or_else(|| Self { name: name.to_owned(), choices })
    }
}

/// An enumeration with the name of each variant beside it, which it displays and is parsed from. Its method `name` is the
/// crate's own, or with `[name]` that of the programs of this repository, too, and then hidden from the reference.
macro_rules! named {
    ($(#[$attribute:meta])* pub enum $type:ident [name] { $($variants:tt)+ }) => {
        $crate::named::named! { @of (#[doc(hidden)] pub) $(#[$attribute])* pub enum $type { $($variants)+ } }
    };
    ($(#[$attribute:meta])* pub enum $type:ident { $($variants:tt)+ }) => {
        $crate::named::named! { @of (pub(crate)) $(#[$attribute])* pub enum $type { $($variants)+ } }
    };
    (@of ($(#[$hidden:meta])? $seen:vis) $(#[$attribute:meta])* pub enum $type:ident {
        $($(#[$of_variant:meta])* $variant:ident = $name:literal,)+
    }) => {
        $(#[$attribute])*
        pub enum $type {
            $($(#[$of_variant])* $variant,)+
        }

        impl $type {
            /// The name, as [`Display`](core::fmt::Display) prints it.
            $(#[$hidden])?
            #[must_use]
            $seen const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)+
                }
            }
        }

        /// Displays the name.
        impl core::fmt::Display for $type {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.pad(self.name())
            }
        }

        /// Parses the name.
        impl core::str::FromStr for $type {
            type Err = $crate::named::UnknownName;

            fn from_str(name: &str) -> Result<Self, $crate::named::UnknownName> {
                let choices: &'static [&'static str] = &[$($name),+];
                let place = $crate::named::UnknownName::place(name, choices)?;
                let found = [$(Self::$variant),+].get(place).copied();
                found.ok_or_else(|| $crate::named::UnknownName { name: name.into(), choices })
            }
        }
    };
}
pub(crate) use named;
