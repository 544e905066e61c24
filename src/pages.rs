//! The code on the pages README.md and docs/, run as documentation tests.

macro_rules! pages {
    ($($name:ident: $page:literal,)*) => {
        $(#[doc = include_str!($page)] struct $name;)*
    };
}

pages! {
    Readme: "../README.md",
    Design: "../docs/design.md",
    NumberTypes: "../docs/number-types.md",
    Displacement: "../docs/theory/displacement.md",
    Velocity: "../docs/theory/velocity.md",
    DenHartog: "../docs/theory/den-hartog.md",
    Border: "../docs/theory/border.md",
    SixReversals: "../docs/theory/six-reversals.md",
    Dissipation: "../docs/theory/dissipation.md",
    Stability: "../docs/theory/stability.md",
    Damping: "../docs/theory/damping.md",
    ExactMotion: "../docs/theory/exact-motion.md",
    StaticFriction: "../docs/theory/static-friction.md",
}

#[cfg(all(feature = "batch", feature = "dual"))]
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
