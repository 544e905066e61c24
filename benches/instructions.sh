#!/usr/bin/env bash
# Instructions a point inside each kernel (callees included, the loop around it not), generic against plain f64,
# counted by valgrind's callgrind. Needs valgrind. Prints one line a kernel.
set -euo pipefail
cd "$(dirname "$0")/.."
points=10000
binary=$(cargo bench --bench instructions --no-run --message-format json 2>/dev/null |
    sed -n 's/.*"executable":"\([^"]*instructions[^"]*\)".*/\1/p' | tail -n 1)
"$binary" >&2
for kernel in triple-generic triple-plain cycle-generic cycle-plain; do
    case $kernel in
        *-generic) function="*kernels::${kernel%-generic}*" ;;
        *) function="*plain::${kernel%-plain}*" ;;
    esac
    total=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect="$function" \
        "$binary" "$kernel" $points 2>&1 | sed -n 's/.*Collected : \([0-9]*\).*/\1/p')
    echo "$kernel $((total / points)).$((total * 10 / points % 10))"
done
# The exact motion: the difference of two numbers of points, the loop around them included.
count() { # KERNEL N
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$binary" "$1" "$2" 2>&1 |
        sed -n 's/.*Collected : \([0-9]*\).*/\1/p'
}
for kernel in steady-from-rest steady-beside-resonance steady-from-cycle twenty-slides; do
    few=$(count "$kernel" 2000)
    many=$(count "$kernel" 6000)
    echo "$kernel $(((many - few) / 4000))"
done
