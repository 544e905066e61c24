//! The inputs of property tests, which are the same in every run.

use proptest::prelude::ProptestConfig;
use proptest::test_runner::RngSeed;

/// A property test of this many cases.
///
/// The environment variable `PROPTEST_RNG_SEED` draws other inputs, as `.ci/slow properties` does. No failure is stored:
/// the same seed finds it again, and a find becomes a test of its own.
pub(crate) fn cases(count: u32) -> ProptestConfig {
    let given = ProptestConfig::with_cases(count);
    let rng_seed = match given.rng_seed {
        // The environment names none.
        RngSeed::Random => RngSeed::Fixed(1),
        seed @ RngSeed::Fixed(_) => seed,
    };
    ProptestConfig { rng_seed, failure_persistence: None, ..given }
}
