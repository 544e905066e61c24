#!/usr/bin/env bash
# Every tool that is installed solves the case file; then docs/figures/cases.svg is drawn, and the table of docs/development/comparison.md
# printed. $PYTHON has numpy, scipy, matplotlib, scikit-sundae, openseespy and stickslip; $SICONOS_PYTHON is one that finds Siconos
# (Debian: python3-siconos). It takes about ten minutes of processor time.
#
#     benches/peers/cases/run.sh [FOLDER FOR THE ANSWERS]
set -euo pipefail
cd "$(dirname "$0")/../../.."
here=benches/peers/cases
file=tests/data/cases.json
answers=${1:-$(mktemp -d)}
mkdir -p "$answers"
export OPENBLAS_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1
solve() { # NAME COMMAND…
    "${@:2}" "$file" > "$answers/$1.tsv" || { echo "$1: not run" && rm "$answers/$1.tsv"; }
}
for tool in stickslip scipy cvode opensees; do
    solve "$tool" "${PYTHON:-python3}" "$here/by_$tool.py"
done
solve siconos "${SICONOS_PYTHON:-/usr/bin/python3}" "$here/by_siconos.py"
CARGO_TARGET_DIR=target/peers solve diffsol cargo run --quiet --release --manifest-path benches/peers/diffsol/Cargo.toml cases
"${PYTHON:-python3}" "$here/draw.py" "$file" docs/figures/cases.svg "$answers"/*.tsv
