//! The code on the pages README.md and docs/, run as documentation tests.

macro_rules! pages {
    ($($name:ident: $page:literal,)*) => {
        $(#[doc = include_str!($page)] struct $name;)*
    };
}

pages! {
    Readme: "../README.md",
    NumberTypes: "../docs/development/number-types.md",
    Displacement: "../docs/development/theory/displacement.md",
    Velocity: "../docs/development/theory/velocity.md",
    DenHartog: "../docs/development/theory/den-hartog.md",
    Border: "../docs/development/theory/border.md",
    SixReversals: "../docs/development/theory/six-reversals.md",
    Dissipation: "../docs/development/theory/dissipation.md",
    Stability: "../docs/development/theory/stability.md",
    Damping: "../docs/development/theory/damping.md",
    ExactMotion: "../docs/development/theory/exact-motion.md",
    StaticFriction: "../docs/development/theory/static-friction.md",
}

#[cfg(feature = "identify")]
pages! {
    Recipes: "../docs/development/recipes.md",
    Identify: "../docs/identify.md",
}

#[cfg(all(feature = "batch", feature = "dual", feature = "system"))]
pages! {
    Rust: "../docs/rust.md",
}

#[cfg(feature = "mp")]
pages! {
    Precision: "../docs/precision.md",
}

#[cfg(all(feature = "dual", feature = "random"))]
pages! {
    Uncertainty: "../docs/uncertainty.md",
}
