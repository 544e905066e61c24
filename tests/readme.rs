//! What README.md shows is what the command prints.
#![cfg(feature = "cli")]

use assert_cmd::Command;

/// The transcripts of README.md: the arguments after `-- ` and the output shown.
fn transcripts() -> Vec<(String, String)> {
    let prompt = "$ cargo run --release --features cli -- ";
    let blocks = include_str!("../README.md").split("```console\n").skip(1);
    blocks
        .filter_map(|block| block.split("```").next()?.strip_prefix(prompt)?.split_once('\n'))
        .map(|(arguments, output)| (arguments.to_owned(), output.to_owned()))
        .collect()
}

#[test]
fn every_transcript_is_the_output() {
    let transcripts = transcripts();
    assert!(transcripts.len() >= 2);
    for (arguments, output) in transcripts {
        let mut command = Command::cargo_bin("stickslip").unwrap();
        command.args(arguments.split_whitespace()).assert().success().stdout(output);
    }
}
