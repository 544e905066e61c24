//! Bad arguments: one line that names the argument, its value and the inequality.

use crate::command_line::refused;

#[test]
fn bad_input_is_one_line_with_argument_value_and_inequality() {
    for (args, parts) in [
        ("response --omega 0 --alpha 2", vec!["--omega 0", "Ω = 0", "> 0"]),
        ("response --omega -1.5 --alpha 2", vec!["--omega -1.5", "> 0"]),
        ("response --omega nan --alpha 2", vec!["--omega nan", "NaN", "finite"]),
        ("response --omega 1.5 --alpha inf", vec!["--alpha inf", "finite"]),
        ("response --omega 1.5 --alpha -2", vec!["--alpha -2", "> 0"]),
        ("response --omega 1.5 --alpha 0", vec!["--alpha 0", "> 0"]),
        ("response --omega 1e-320 --alpha 2", vec!["--omega 1e-320", "≥"]),
        ("response --omega 1e300 --alpha 2", vec!["--omega 1e300", "≤"]),
        ("response --omega abc --alpha 2", vec!["--omega abc", "number"]),
        ("response --omega 1.5", vec!["--alpha is missing"]),
        ("response --mass 0 --stiffness 1 --friction 1 --frequency 1 --force 1", vec!["--mass 0", "> 0"]),
        (
            "response --mass 1 --stiffness nan --friction 1 --frequency 1 --force 1",
            vec!["--stiffness nan", "finite"],
        ),
        (
            "response --mass 1 --stiffness 1 --friction -1 --frequency 1 --force 1",
            vec!["--friction -1", "> 0"],
        ),
        (
            "response --mass 1 --stiffness 1 --friction 1 --frequency 0 --force 1",
            vec!["--frequency 0", "> 0"],
        ),
        ("response --mass 1 --stiffness 1 --friction 1 --frequency 1 --force=-1", vec!["--force -1", "> 0"]),
        (
            "response --mass 1 --stiffness 1 --friction 1 --frequency 1 --base-motion -1",
            vec!["--foot-displacement -1", "> 0"],
        ),
        ("response --mass 1 --stiffness 1 --friction 1 --frequency 1", vec!["--force", "missing"]),
        ("response --mass 1 --friction 1 --frequency 1 --force 1", vec!["--stiffness", "missing"]),
        (
            "response --mass 1e-300 --stiffness 1e300 --friction 1 --frequency 1 --force 1",
            vec!["--mass 1e-300", "Ω"],
        ),
        (
            "response --mass 1 --stiffness 1 --omega 1 --friction 1 --frequency 1 --force 1",
            vec!["--omega, --frequency and --stiffness: give two of the three"],
        ),
        #[cfg(not(feature = "mp"))]
        ("response --omega 1 --alpha 2 --bits 256", vec!["--bits 256", "mp"]),
        #[cfg(feature = "mp")]
        ("response --omega 1 --alpha 2 --bits 0", vec!["'0'", "--bits", "≥ 1"]),
        ("response --omega 1.5 --alpha 2.5 --format csv", vec!["--points"]),
        ("response --points no-such-file.csv", vec!["no-such-file.csv"]),
        ("response --points - --x0 2", vec!["--x0"]),
        ("response --points - --format json", vec!["jsonl"]),
        ("response --omega 1 --alpha 2 --units kN", vec!["--units", "kN"]),
        ("border --omega -1", vec!["--omega -1", "> 0"]),
        ("border", vec!["--omega is missing"]),
        ("frobnicate", vec!["frobnicate"]),
    ] {
        refused(args, &parts);
    }
}
