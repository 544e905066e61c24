//! Matrices in files that SciPy and NumPy wrote (`stored/write.py`), and wrong files.

use crate::place::place;
use serde_json::{Value, json};
use std::path::Path;
use stickslip_front::system::{NamedSystem, parsed};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/systems/stored");

/// The system of five coordinates with a matrix in a field.
fn with(field: &str, value: Value, folder: &Path) -> Result<NamedSystem, String> {
    let mass: Vec<Vec<f64>> = (0..5).map(|i| (0..5).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    let mut file = json!({ "mass": mass });
    file[field] = value;
    NamedSystem::new(&file, [], folder, None)
}

fn stiffness(value: Value) -> Vec<Vec<f64>> {
    let found = with("stiffness", value.clone(), Path::new(FOLDER));
    found.unwrap_or_else(|e| panic!("{value}: {e}")).described.model.stiffness
}

fn by(of: impl Fn(i32, i32) -> i32) -> Vec<Vec<f64>> {
    (0..5).map(|i| (0..5).map(|j| f64::from(of(i, j))).collect()).collect()
}

fn chain(diagonal: i32, beside: i32) -> Vec<Vec<f64>> {
    by(|i, j| match (i - j).abs() {
        0 => diagonal,
        1 => beside,
        _ => 0,
    })
}

#[test]
fn files_of_matrix_market_have_the_matrices_of_scipy() {
    for file in ["k_coordinate.mtx", "k_symmetric.mtx", "k_array.mtx"] {
        assert_eq!(stiffness(json!(file)), chain(2, -1), "{file}");
    }
    for file in ["g_array.mtx", "g_coordinate.mtx"] {
        assert_eq!(stiffness(json!({ "file": file })), by(|i, j| 10 * i + j), "{file}");
    }
    assert_eq!(stiffness(json!("skew.mtx")), by(|i, j| 9 * (i - j)));
    // M, C and K from files alone, with damping by modes and the names of coordinates.
    let text = r#"
        mass = "k_array.mtx"
        stiffness = "k_symmetric.mtx"
        damping = { file = "skew.mtx", ratio = "50 %" }
        coordinates = ["a", "b", "c", "d", "e"]
    "#;
    let value = parsed(text, "x").unwrap();
    let found = NamedSystem::new(&value, [], Path::new(FOLDER), None).unwrap().described;
    assert_eq!((found.model.mass, found.coordinates.len()), (chain(2, -1), 5));
    // K = M, so that ω = 1 in each mode and C = 2 ζ K beside the gyroscopic part.
    let due = by(|i, j| 9 * (i - j));
    for (i, row) in found.model.damping.iter().enumerate() {
        for (j, x) in row.iter().enumerate() {
            assert!((x - due[i][j] - chain(2, -1)[i][j]).abs() < 1e-12);
        }
    }
}

#[cfg(feature = "npz")]
#[test]
fn files_of_numpy_have_its_arrays() {
    let g = by(|i, j| 10 * i + j);
    for file in ["g_csr.npz", "g_csc.npz", "g_coo.npz", "one.npz", "g.npy"] {
        assert_eq!(stiffness(json!(file)), g, "{file}");
    }
    for (array, due) in
        [("K", chain(2, -1)), ("M", chain(4, 1)), ("G", g.clone()), ("ints", g.clone()), ("small", g)]
    {
        assert_eq!(stiffness(json!({ "file": "model.npz", "array": array })), due, "{array}");
    }
    let flags = by(|i, j| i32::from(10 * i + j > 3));
    assert_eq!(stiffness(json!({ "file": "model.npz", "array": "flags" })), flags);
    for (value, due) in [
        (
            json!("model.npz"),
            "stiffness: model.npz: has the arrays G, K, M, flags, ints, small, wide, z: must name one, such as array = \"G\"",
        ),
        (
            json!({ "file": "model.npz", "array": "k" }),
            "stiffness.file: model.npz: has no array k. Did you mean",
        ),
        (
            json!({ "file": "model.npz", "array": "wide" }),
            "stiffness.file: model.npz: array wide: has 5 rows and 3 columns, must have 5 of both",
        ),
        (
            json!({ "file": "model.npz", "array": "z" }),
            "stiffness.file: model.npz: array z: has the type <c16, must have f4, f8, integers or bool",
        ),
        (
            json!({ "file": "g.npy", "array": "K" }),
            "stiffness.file: g.npy: must have no array: a file .npy is one matrix",
        ),
        (json!("g_dia.npz"), "stiffness: g_dia.npz: has the format dia, must have csr, csc or coo"),
    ] {
        let found = with("stiffness", value.clone(), Path::new(FOLDER)).unwrap_err();
        assert!(found.starts_with(due), "{value}: {found}");
    }
}

#[cfg(not(feature = "npz"))]
#[test]
fn files_of_numpy_are_named_where_they_are_not_read() {
    let found = with("stiffness", json!("one.npz"), Path::new(FOLDER)).unwrap_err();
    assert_eq!(
        found,
        "stiffness: one.npz: must be a file .mtx here: the command reads .npy and .npz, and in Python NumPy does"
    );
}

#[test]
fn wrong_files_are_named_with_their_line_and_value() {
    let own = place("x");
    let folder = own.parent().unwrap();
    let head = "%%MatrixMarket matrix coordinate real general";
    std::fs::write(folder.join("small.mtx"), format!("{head}\n4 4 1\n1 1 1\n")).unwrap();
    std::fs::write(folder.join("text.mtx"), format!("{head}\n5 5 1\n1 1 x\n")).unwrap();
    std::fs::write(folder.join("infinite.mtx"), format!("{head}\n5 5 2\n1 1 1\n2 1 inf\n")).unwrap();
    std::fs::write(folder.join("binary.mtx"), [b'%', 0xff, b'\n']).unwrap();
    std::fs::write(folder.join("large.mtx"), format!("{head}\n9000000 9000000 0\n")).unwrap();
    for (value, due) in [
        (json!("small.mtx"), "stiffness: small.mtx: has 4 rows and 4 columns, must have 5 of both"),
        (json!("text.mtx"), "stiffness: text.mtx: line 3: x: must be a finite number"),
        (json!("infinite.mtx"), "stiffness: infinite.mtx: line 4: inf: must be a finite number"),
        (json!("binary.mtx"), "stiffness: binary.mtx: line 1: stream did not contain valid UTF-8"),
        (json!("large.mtx"), "stiffness: large.mtx: has 9000000 rows, must be ≥ 1 and ≤ "),
        (json!({ "file": "small.mtx", "array": "K" }), "stiffness.file: small.mtx: must have no array"),
        (json!({ "file": "small.mtx", "arry": "K" }), "stiffness.arry is unknown. Did you mean array?"),
        (json!({ "array": "K" }), "stiffness.file is missing"),
        (json!("."), "stiffness: .: must be rows of numbers, or the name of a file .mtx, .npy or .npz"),
        (json!("none.mtx"), "stiffness: none.mtx: "),
        (json!({}), "stiffness.file is missing"),
        (json!(3), "stiffness 3: must be a list"),
    ] {
        for field in ["stiffness", "damping"] {
            // A table of damping may have other fields, too.
            if field == "damping" && value.is_object() {
                continue;
            }
            let found = with(field, value.clone(), folder).unwrap_err();
            assert!(found.starts_with(&due.replace("stiffness", field)), "{value}: {found}");
            assert!(!found.contains('\n'));
        }
    }
    let both = json!({ "file": "small.mtx", "matrix": [[1]] });
    assert_eq!(with("damping", both, folder).unwrap_err(), "damping.matrix: must be left out beside file");
    let list = json!({ "mass": "small.mtx", "stiffness": [[1]] });
    let found = NamedSystem::new(&list, [], folder, None).unwrap_err();
    assert_eq!(found, "stiffness: has 1 rows, must have 4");
    let light = json!({ "mass": "text.mtx" });
    let found = NamedSystem::new(&light, [], folder, None).unwrap_err();
    assert_eq!(found, "mass: text.mtx: line 3: x: must be a finite number");
}

/// Every byte of every file, changed: each is read or refused by one line.
#[test]
fn damaged_files_are_refused() {
    let own = place("x");
    let folder = own.parent().unwrap();
    let (mut read, mut refused) = (0, 0);
    for file in ["k_array.mtx", "g_coordinate.mtx", "g_csr.npz", "g_coo.npz", "one.npz", "g.npy"] {
        let whole = std::fs::read(Path::new(FOLDER).join(file)).unwrap();
        for place in 0..whole.len() {
            for by in [1, 0x80, 0xff] {
                let mut bytes = whole.clone();
                bytes[place] ^= by;
                if by == 0xff {
                    bytes.truncate(place);
                }
                std::fs::write(folder.join(file), bytes).unwrap();
                match with("stiffness", json!(file), folder) {
                    Ok(_) => read += 1,
                    Err(why) => {
                        assert!(why.starts_with("stiffness: ") && !why.contains('\n'), "{file}: {why}");
                        refused += 1;
                    }
                }
            }
        }
    }
    assert!(read > 100 && refused > 1000, "{read} {refused}");
}

#[cfg(feature = "mp")]
#[test]
fn decimals_of_files_have_all_of_their_digits() {
    use stickslip_front::system::WideSystem;
    let own = place("x");
    let folder = own.parent().unwrap();
    let digits = "1.2345678901234567890123456789012345678";
    let text = format!("%%MatrixMarket matrix array real general\n1 1\n{digits}\n");
    std::fs::write(folder.join("digits.mtx"), text).unwrap();
    let value = json!({"mass": [[1]], "stiffness": "digits.mtx"});
    let go_on = || std::ops::ControlFlow::Continue(());
    let found = stickslip::float::with_bits(128, || {
        let wide = WideSystem::new(&value, &[], folder, None, go_on).unwrap();
        wide.named().described.model.stiffness[0][0] == digits.parse::<stickslip::float::Widest>().unwrap()
    });
    assert!(found.unwrap());
}
