#!/usr/bin/env bash
# A motion with stops and damping, from rest until it repeats to 1e-12, by the library, CVODE, diffsol, SciPy
# and closed-form slides in numba, one after the other in one run. It prints microseconds, the ratio to the
# library's time, and the relative error of the maximum displacement. It requires gcc with SUNDIALS for CVODE
# (Debian: libsundials-dev), and $PYTHON with scipy and numba; a missing one is omitted.
set -euo pipefail
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
ours=$(cargo bench -p stickslip-benches --features batch --bench sticking --no-run --message-format json 2>/dev/null |
    sed -n 's/.*"executable":"\([^"]*sticking-[^"]*\)".*/\1/p' | tail -n 1)
gcc -O3 benches/peers/sticking.c -o "$work/cvode" -lsundials_cvode -lsundials_nvecserial -lm ||
    echo "without CVODE: no SUNDIALS"
diffsol=target/peers/release/sticking
CARGO_TARGET_DIR=target/peers cargo build --quiet --release --manifest-path benches/peers/diffsol/Cargo.toml ||
    echo "without diffsol"

# Ω, α, ζ and the maximum displacement, from the two equations for the length of a slide and its end, solved
# at 40 digits.
for point in \
    '0.7 1.2 0.05 0.8155618393813455' '0.4 6 0.05 6.641909108352287' '0.15 3 0.05 2.1870119014886273'; do
    read -r omega alpha zeta reference <<<"$point"
    printf '\nΩ = %s, α = %s, ζ = %s: max x/B = %s\n' "$omega" "$alpha" "$zeta" "$reference"
    at=("$omega" "$alpha" "$zeta")
    {
        printf 'stickslip\t%s\n' "$("$ours" "${at[@]}" "$reference" 20000)"
        # At larger tolerances CVODE's own errors prevent the extrema from repeating.
        [ ! -x "$work/cvode" ] ||
            printf 'CVODE, Adams, 1e-12\t%s\n' "$("$work/cvode" "${at[@]}" 1e-12 "$reference" 10)"
        [ ! -x "$diffsol" ] ||
            printf 'diffsol 0.12.4, tsit45, 1e-10\t%s\n' "$("$diffsol" "${at[@]}" 1e-10 "$reference" 10)"
        "${PYTHON:-python3}" benches/peers/sticking.py "${at[@]}" 1e-10 "$reference"
    } | awk -F '\t' '
        NR == 1 { ours = $2 }
        { printf "%-36s %12.2f µs %10.1f x as long, error %s\n", $1, $2, $2 / ours, $3 }'
done
