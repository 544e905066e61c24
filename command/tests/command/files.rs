//! Files of the command: rows as they are computed, interrupts that keep them, and no file for two arguments.

use crate::command_line::{listens, refused, stdout};
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// The command on one thread, in a folder.
fn start(arguments: &str, folder: &Path) -> Child {
    Command::new(assert_cmd::cargo::cargo_bin!("stickslip"))
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .env("RAYON_NUM_THREADS", "1")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

/// Waits for something that the command does while it runs.
fn seen<T>(child: &mut Child, mut look: impl FnMut() -> Option<T>) -> T {
    let begin = Instant::now();
    loop {
        if let Some(found) = look() {
            return found;
        }
        assert!(child.try_wait().unwrap().is_none(), "the command is over");
        assert!(begin.elapsed() < Duration::from_secs(300), "nothing happens");
        thread::sleep(Duration::from_millis(5));
    }
}

#[cfg(unix)]
fn interrupt(child: &mut Child) {
    listens(child);
    let signal = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(signal.success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
}

/// A row of this sweep takes about a second, because its motion has 100,000 stops a cycle. Each row is in the
/// file before the next one but one, and an interrupt keeps it, so that every run goes on.
#[cfg(unix)]
#[test]
fn slow_rows_are_kept_as_they_are_computed() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("rows.csv");
    let lines = || fs::read_to_string(&file).map_or(0, |text| text.matches('\n').count());
    let sweep = "sweep steady --omega 4e-6:5e-6:40 --alpha 2:3:10 --out rows.csv";
    let mut before = 1;
    for line in [sweep.to_owned(), format!("{sweep} --resume"), format!("{sweep} --resume")] {
        let mut child = start(&line, folder.path());
        let now = seen(&mut child, || Some(lines()).filter(|count| *count > before));
        assert!(now <= before + 2, "{line}: {} rows came at once", now - before);
        interrupt(&mut child);
        before = lines();
        let text = fs::read_to_string(&file).unwrap();
        assert!(before >= now && text.ends_with('\n') && text.starts_with("omega,"), "{line}: {text}");
    }
}

/// The points take about a second each, so that the interrupt does not wait for one.
#[cfg(unix)]
#[test]
fn an_interrupted_picture_leaves_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let count = || fs::read_dir(folder.path()).unwrap().count();
    for end in ["csv", "svg"] {
        let map = format!("map stops --omega 4e-6:5e-6:40 --alpha 2:3:10 --out map.{end}");
        let mut child = start(&map, folder.path());
        seen(&mut child, || (count() > 0).then_some(()));
        thread::sleep(Duration::from_millis(300));
        interrupt(&mut child);
        assert_eq!(count(), 0, "{map}");
    }
}

#[test]
fn one_file_is_not_two_arguments() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let (rows, new) = (place("rows.csv"), place("new.csv"));
    let basins = "basins --omega 0.573 --alpha 3.92 --damping-ratio 0.005 --static-friction-ratio 1.87 \
                  --x0 -1:1:2 --v0 -1:1:2";
    stdout(&format!("{basins} --rows {rows}"));
    let kept = fs::read(&rows).unwrap();
    let dotted = place("./rows.csv");
    let mut names = vec![rows.clone(), dotted];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(&rows, place("link.csv")).unwrap();
        fs::hard_link(&rows, place("hard.csv")).unwrap();
        std::os::unix::fs::symlink(folder.path(), place("again")).unwrap();
        names.extend([place("link.csv"), place("hard.csv"), place("again/rows.csv")]);
    }
    for name in &names {
        let line = format!("{basins} --rows {rows} --resume --out {name} --overwrite");
        refused(&line, &["--rows", &rows, "--out", name, "must be two different files"]);
        assert!(fs::read(&rows).unwrap() == kept, "{name}");
    }
    // A file that does not exist yet.
    refused(&format!("{basins} --rows {new} --out {}", place("./new.csv")), &["must be two different files"]);
    assert!(!Path::new(&new).exists());
    stdout(&format!("{basins} --rows {rows} --resume --out {new}"));
    assert!(fs::read(&rows).unwrap() == kept && Path::new(&new).exists());
}
