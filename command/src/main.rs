//! The program `stickslip`.

use std::process::ExitCode;

fn main() -> ExitCode {
    stickslip_cli::main()
}
