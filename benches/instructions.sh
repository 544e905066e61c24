#!/usr/bin/env bash
# Instructions a point of each kernel, generic against plain f64, counted by valgrind's callgrind.
# Needs valgrind. Prints one line a kernel: instructions a point.
set -euo pipefail
cd "$(dirname "$0")/.."
binary=$(cargo bench --bench instructions --no-run --message-format json 2>/dev/null |
    sed -n 's/.*"executable":"\([^"]*instructions[^"]*\)".*/\1/p' | tail -n 1)
"$binary" >&2
count() { # KERNEL N
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$binary" "$1" "$2" 2>&1 |
        sed -n 's/.*Collected : \([0-9]*\).*/\1/p'
}
for kernel in triple-generic triple-plain cycle-generic cycle-plain; do
    few=$(count "$kernel" 2000)
    many=$(count "$kernel" 12000)
    echo "$kernel $(((many - few) / 10000))"
done
for kernel in steady-from-rest steady-beside-resonance steady-from-cycle twenty-slides; do
    few=$(count "$kernel" 1000)
    many=$(count "$kernel" 3000)
    echo "$kernel $(((many - few) / 2000))"
done
