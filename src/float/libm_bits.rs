//! The bits of the crate `libm`, of which the bits of answers are made.
//!
//! Its version is a range, so that a tree with another crate that needs a later one resolves. Where a version changes a bit, this test fails: the lock file
//! then stays at the one before, or the change is taken over on purpose, with the tables of bits in `benches/`.

/// A sequence of numbers whose sizes spread evenly over powers of two from 2⁻⁶⁰ to 2⁶⁰ and whose signs alternate.
fn spread(count: u64) -> impl Iterator<Item = f64> {
    let mut state = 0_u64;
    (0..count).map(move |_| {
        // Steele, Lea and Flood's SplitMix64.
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        let exponent = 963 + (z >> 3) % 121;
        f64::from_bits((z & 1) << 63 | exponent << 52 | z >> 12)
    })
}

/// The bits of a function's values in one number: FNV-1a over them.
fn digest(values: impl Iterator<Item = u64>) -> u64 {
    values.fold(0xcbf2_9ce4_8422_2325, |hash, bits| (hash ^ bits).wrapping_mul(0x0000_0100_0000_01b3))
}

/// The digest of each function that answers are made of.
fn digests() -> [(&'static str, u64); 18] {
    const COUNT: u64 = 20_000;
    let pairs = || spread(COUNT).zip(spread(2 * COUNT).skip(COUNT as usize));
    let one = |of: fn(f64) -> f64| digest(spread(COUNT).map(|x| of(x).to_bits()));
    let two = |of: fn(f64, f64) -> f64| digest(pairs().map(|(x, y)| of(x, y).to_bits()));
    let one_single = |of: fn(f32) -> f32| digest(spread(COUNT).map(|x| of(x as f32).to_bits().into()));
    let two_single =
        |of: fn(f32, f32) -> f32| digest(pairs().map(|(x, y)| of(x as f32, y as f32).to_bits().into()));
    let near = |x: f64| x % 700.0;
    let exponential = digest(spread(COUNT).map(|x| libm::exp(near(x)).to_bits()));
    let less = digest(spread(COUNT).map(|x| libm::expm1(near(x)).to_bits()));
    [
        (
            "sincos",
            digest(spread(COUNT).map(libm::sincos).map(|(s, c)| s.to_bits().rotate_left(1) ^ c.to_bits())),
        ),
        ("sin", one(libm::sin)),
        ("cos", one(libm::cos)),
        ("tan", one(libm::tan)),
        ("atan2", two(libm::atan2)),
        ("hypot", two(libm::hypot)),
        ("log", one(|x| libm::log(x.abs()))),
        ("exp", exponential),
        ("expm1", less),
        ("fma", digest(pairs().map(|(x, y)| libm::fma(x, y, -x).to_bits()))),
        (
            "sincosf",
            digest(
                spread(COUNT)
                    .map(|x| libm::sincosf(x as f32))
                    .map(|(s, c)| (s.to_bits().rotate_left(1) ^ c.to_bits()).into()),
            ),
        ),
        ("sinf", one_single(libm::sinf)),
        ("cosf", one_single(libm::cosf)),
        ("tanf", one_single(libm::tanf)),
        ("atan2f", two_single(libm::atan2f)),
        ("hypotf", two_single(libm::hypotf)),
        ("expm1f", one_single(|x| libm::expm1f(x % 80.0))),
        ("expf", one_single(|x| libm::expf(x % 80.0))),
    ]
}
#[test]
fn the_functions_of_libm_have_their_bits() {
    let due: [(&str, u64); 18] = [
        ("sincos", 0x4d2a_f1c8_57ec_f9fd),
        ("sin", 0x3145_0637_c760_e470),
        ("cos", 0x4190_78ae_1056_3219),
        ("tan", 0x93b6_c541_334d_ac91),
        ("atan2", 0x138e_3778_b265_9746),
        ("hypot", 0xc5cb_4750_e982_a6fb),
        ("log", 0xa672_3d11_2377_0012),
        ("exp", 0x48f1_105f_a47f_9264),
        ("expm1", 0x9478_8cdb_f7ce_af5f),
        ("fma", 0x6ffd_7fcf_81e3_873b),
        ("sincosf", 0x96e4_a4a1_ec04_3f7c),
        ("sinf", 0x9196_791d_0343_fa48),
        ("cosf", 0x78c0_58db_da7b_53a2),
        ("tanf", 0x4193_3aea_1dc0_786e),
        ("atan2f", 0xc67c_40c8_4ae8_f89e),
        ("hypotf", 0x6eda_7e32_1a88_8a14),
        ("expm1f", 0xbe99_88d7_ae57_d7a6),
        ("expf", 0x449d_2c70_db78_4092),
    ];
    assert_eq!(digests(), due);
}
