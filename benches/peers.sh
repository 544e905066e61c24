#!/usr/bin/env bash
# The same closed forms in C (plain, and vectorised with the vector functions of the mathematics library),
# numpy and numba, compared with the library over the same points in one run. It requires gcc; numpy and numba
# take part if $PYTHON has them. It prints nanoseconds per point and the ratio to plain C, each the best of
# many runs.
set -euo pipefail
cd "$(dirname "$0")/.."
n=${1:-10000} # few, so that the best of many runs is one that nothing interrupted
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
ours=$(cargo bench -p stickslip-benches --features rayon --bench peers --no-run --message-format json 2>/dev/null |
    sed -n 's/.*"executable":"\([^"]*peers-[^"]*\)".*/\1/p' | tail -n 1)
gcc -O2 -march=native benches/peers/closed_forms.c -o "$work/scalar" -lm
gcc -O3 -march=native -ffast-math -fopenmp-simd -DVECTOR benches/peers/closed_forms.c -o "$work/vector" -lmvec -lm

for least in 0.5 0.35; do
    "$ours" points "$work/points" "$n" "$least"
    printf '\n%s points, frequency ratios from %s to 2.5\n' "$n" "$least"
    {
        "$work/scalar" "$work/points"
        "$work/vector" "$work/points"
        "${PYTHON:-python3}" benches/peers/closed_forms.py "$work/points" 2>/dev/null || true
        "$ours" "$work/points"
    } | awk -F '\t' '
        { split($2, name, ","); kernel = name[1] }
        kernel ~ /^all/ { kernel = "five" } # which of ours includes the five
        !(kernel in plain) { plain[kernel] = $3 }
        { printf "%-34s %-18s %9.2f ns %8.2f x as fast as plain C\n", $1, $2, $3, plain[kernel] / $3 }'
done

printf '\nThreads, one and all in turn\n'
"$ours" threads 10000000 | awk -F '\t' '
    { split($2, name, ",") }
    !(name[1] in one) { one[name[1]] = $3 }
    { printf "%-34s %-26s %9.2f ns %8.2f x as fast as one\n", $1, $2, $3, one[name[1]] / $3 }'
