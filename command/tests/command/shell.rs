//! The command's documentation of itself: help, completions, manual pages, colours, and the quiet options.

use crate::command_line::{refused, stdout, stickslip};
use crate::place::place;

const COMMANDS: [&str; 16] = [
    "response",
    "border",
    "steady",
    "simulate",
    "design",
    "decay",
    "verify",
    "figure",
    "figures",
    "sweep",
    "map",
    "identify",
    "response-curve",
    "motion-plot",
    "completions",
    "man",
];

#[test]
fn help_lists_the_commands_the_units_and_the_exit_statuses() {
    let help = stdout("--help");
    for due in ["Exit status:", "130", "Units:", "B = r_y/k", "NO_COLOR", "--quiet"].iter().chain(&COMMANDS) {
        assert!(help.contains(due), "{due} in {help}");
    }
    for command in COMMANDS {
        let help = stdout(&format!("help {command}"));
        assert!(help.contains("Examples:\n  stickslip "), "{command}: {help}");
    }
}

/// The parser accepts every line of the examples: it would refuse an unknown argument before its value.
#[test]
fn the_examples_in_help_are_understood() {
    let mut tried = 0;
    for command in COMMANDS {
        let help = stdout(&format!("help {command}")).replace("\\\n", " ");
        for line in help.lines().filter_map(|l| l.strip_prefix("  stickslip ")) {
            let arguments = line.split(['>', '<', '|']).next().unwrap();
            let output = stickslip(&format!("{arguments} --help")).output().unwrap();
            assert!(output.status.success(), "{line}: {}", String::from_utf8_lossy(&output.stderr));
            let unknown = stickslip(&format!("{arguments} --nonesuch")).output().unwrap();
            let message = String::from_utf8(unknown.stderr).unwrap();
            assert!(message.contains("--nonesuch"), "{line}: {message}");
            tried += 1;
        }
    }
    assert!(tried > 30, "{tried}");
}

#[test]
fn completions_know_the_commands_and_the_figures() {
    for (shell, own) in [
        ("bash", "complete -F _stickslip"),
        ("zsh", "#compdef stickslip"),
        ("fish", "complete -c stickslip"),
        ("elvish", "edit:completion:arg-completer[stickslip]"),
        ("powershell", "Register-ArgumentCompleter"),
    ] {
        let script = stdout(&format!("completions {shell}"));
        for due in COMMANDS.iter().chain(&["base-acceleration", own]) {
            assert!(script.contains(due), "{shell}: {due}");
        }
        // The other shells do not complete the values of positional arguments.
        if ["bash", "zsh"].contains(&shell) {
            assert!(script.contains("multipliers"), "{shell}");
        }
    }
    refused("completions tcsh", &["'tcsh'", "possible values: bash"]);
}

/// The completion script works in the shell itself.
#[cfg(unix)]
#[test]
fn bash_completes_an_argument() {
    let script = r#"
        source <("$1" completions bash)
        COMP_WORDS=(stickslip response --om); COMP_CWORD=2
        _stickslip stickslip --om response
        echo "${COMPREPLY[@]}""#;
    let command = assert_cmd::cargo::cargo_bin!("stickslip");
    let found = std::process::Command::new("bash").args(["-c", script, "bash"]).arg(command).output();
    let found = found.expect("this test needs bash");
    assert_eq!(String::from_utf8(found.stdout).unwrap().trim(), "--omega", "{:?}", found.stderr);
}

#[test]
fn every_command_has_a_manual_page() {
    let page = stdout("man");
    assert!(page.contains(".TH stickslip 1") && page.contains("Exit status"), "{page}");
    let folder = place("man1");
    assert_eq!(stdout(&format!("man --out {}", folder.display())), "");
    let design = ["design-force", "design-bands", "design-stiffness"];
    for command in COMMANDS.iter().chain(&design) {
        let page = std::fs::read_to_string(folder.join(format!("stickslip-{command}.1"))).unwrap();
        assert!(page.contains(&format!(".TH stickslip-{command} 1")), "{command}");
    }
    assert_eq!(std::fs::read_to_string(folder.join("stickslip.1")).unwrap(), page);
    refused("man --out /dev/null/pages", &["--out /dev/null/pages"]);
}

/// Output to a program has no colours. `CLICOLOR_FORCE` simulates a terminal in this test, and `NO_COLOR`
/// takes precedence.
#[test]
fn colours_are_for_terminals() {
    for arguments in ["response --omega 0.4 --alpha 6", "steady --omega 0.4 --alpha 6", "--help"] {
        let output = |variables: &[(&str, &str)]| {
            let mut command = stickslip(arguments);
            command.envs(variables.iter().copied());
            String::from_utf8(command.assert().success().get_output().stdout.clone()).unwrap()
        };
        let plain = output(&[]);
        assert!(!plain.contains('\u{1b}'), "{plain}");
        let coloured = output(&[("CLICOLOR_FORCE", "1")]);
        assert!(coloured.contains("\u{1b}["), "{coloured}");
        assert_eq!(output(&[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")]), plain);
    }
    let error = stickslip("response").env("CLICOLOR_FORCE", "1").assert().code(2);
    let error = String::from_utf8(error.get_output().stderr.clone()).unwrap();
    assert!(error.starts_with("\u{1b}[1m\u{1b}[31mstickslip:\u{1b}[0m --omega"), "{error:?}");
}

#[test]
fn quiet_leaves_the_answers_and_the_errors() {
    for arguments in ["response --omega 1.5 --alpha 2.5", "sweep border --omega 0.5:2:5", "verify"] {
        assert_eq!(stdout(&format!("{arguments} --quiet")), stdout(arguments));
        assert_eq!(stdout(&format!("-q {arguments}")), stdout(arguments));
    }
    refused("response --omega 0 --alpha 2 -q", &["--omega 0", "> 0"]);
}

/// On a terminal, which `script` provides, a sweep shows its progress unless it is silenced.
#[cfg(target_os = "linux")]
#[test]
fn progress_is_shown_on_a_terminal_and_can_be_silenced() {
    let command = assert_cmd::cargo::cargo_bin!("stickslip").display();
    let shown = |option: &str| {
        let line = format!("'{command}' sweep border --omega 0.5:2:5 --outputs omega {option} > /dev/null");
        // A terminal without a name shows no progress.
        let mut script = std::process::Command::new("script");
        let found = script.args(["-qec", &line, "/dev/null"]).env("TERM", "xterm").output().unwrap();
        assert!(found.status.success(), "{found:?}");
        String::from_utf8(found.stdout).unwrap()
    };
    assert!(shown("").contains("/5 points"), "{:?}", shown(""));
    assert_eq!(shown("--quiet"), "");
}
