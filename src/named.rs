//! Enumerations whose variants have names.

/// An enumeration with the name of each variant beside it, and its method `name`, which the brackets describe;
/// with `displayed` its [`Display`](core::fmt::Display), too.
macro_rules! named {
    ($(#[$attribute:meta])* pub enum $type:ident [$(#[$about:meta])+] {
        $($(#[$of_variant:meta])* $variant:ident = $name:literal,)+
    }) => {
        $(#[$attribute])*
        pub enum $type {
            $($(#[$of_variant])* $variant,)+
        }

        impl $type {
            $(#[$about])+
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)+
                }
            }
        }
    };
    ($(#[$attribute:meta])* pub enum $type:ident displayed $($rest:tt)+) => {
        $crate::named::named! { $(#[$attribute])* pub enum $type $($rest)+ }

        /// Displays the name.
        impl core::fmt::Display for $type {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.pad(self.name())
            }
        }
    };
}
pub(crate) use named;
