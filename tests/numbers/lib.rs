//! Nothing: this package has tests alone. `cargo package --workspace` takes no package without a target of its own.
