#!/usr/bin/env bash
# Every tool that is installed solves the case file; then docs/figures/cases.svg is drawn, and the table of
# docs/comparison.md printed. $PYTHON has numpy, scipy, matplotlib,
# scikit-sundae, openseespy and stickslip; $SICONOS_PYTHON is one that
# finds Siconos (Debian: python3-siconos). About half an hour.
#
#     benches/peers/cases/run.sh [FOLDER FOR THE ANSWERS]
set -uo pipefail
cd "$(dirname "$0")/../../.."
here=benches/peers/cases
file=tests/data/cases.json
answers=${1:-$(mktemp -d)}
mkdir -p "$answers"
export OPENBLAS_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1
for tool in stickslip scipy cvode opensees; do
    "${PYTHON:-python3}" "$here/by_$tool.py" "$file" > "$answers/$tool.tsv" || echo "$tool: not run"
done
"${SICONOS_PYTHON:-/usr/bin/python3}" "$here/by_siconos.py" "$file" > "$answers/siconos.tsv" || echo "Siconos: not run"
cargo run --quiet --release --manifest-path benches/peers/diffsol/Cargo.toml cases "$file" > "$answers/diffsol.tsv" ||
    echo "diffsol: not run"
"${PYTHON:-python3}" "$here/draw.py" "$file" docs/figures/cases.svg "$answers"/*.tsv
