#!/usr/bin/env bash
# Instructions a call of each kernel (a point, for batches), callees included, counted by valgrind's callgrind. Needs valgrind. One
# line a kernel. With --check: compared with benches/instructions.txt, and an error where one is more than 3 % above it.
set -euo pipefail
cd "$(dirname "$0")/.."
program() {
    cargo bench --features batch --bench "$1" --no-run --message-format json 2>/dev/null |
        sed -n "s/.*\"executable\":\"\([^\"]*$1-[^\"]*\)\".*/\1/p" | tail -n 1
}
count() { # FUNCTION PROGRAM KERNEL N: instructions inside FUNCTION
    valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect="$1" "$2" "$3" "$4" 2>&1 |
        sed -n 's/.*Collected : \([0-9]*\).*/\1/p'
}
report() { echo "$1 $(($2 / $3)).$(($2 * 10 / $3 % 10))"; } # KERNEL TOTAL CALLS

all() {
    closed=$(program instructions)
    "$closed" >&2
    for kernel in triple cycle; do
        report "$kernel-generic" "$(count "*kernels::$kernel*" "$closed" "$kernel-generic" 10000)" 10000
        report "$kernel-plain" "$(count "*plain::$kernel*" "$closed" "$kernel-plain" 10000)" 10000
    done
    exact=$(program exact_instructions)
    for kernel in steady-from-rest steady-beside-resonance steady-from-cycle twenty-slides; do
        case $kernel in
            steady-beside-resonance) function=steady_from_rest ;;
            *) function=${kernel//-/_} ;;
        esac
        report "$kernel" "$(count "*motions::$function*" "$exact" "$kernel" 2000)" 2000
    done
    batch=$(program batch_instructions)
    for kernel in batch-triple batch-triple-fixed batch-cycles batch-cycles-fixed batch-cycles-low; do
        # The difference of two numbers of rounds, so that start-up does not count.
        once=$(count "*" "$batch" "$kernel" 1)
        report "$kernel" $(($(count "*" "$batch" "$kernel" 5) - once)) $((4 * 12800))
    done
}

if [ "${1:-}" != --check ]; then
    all
    exit
fi
all | awk '
    NR == FNR { if ($1 !~ /^#/) kept[$1] = $2; next }
    !($1 in kept) { print $1, $2, "is not in benches/instructions.txt"; bad = 1; next }
    $2 > 1.03 * kept[$1] { print $1, $2, "is more than 3 % above", kept[$1]; bad = 1 }
    $2 < 0.97 * kept[$1] { print $1, $2, "is more than 3 % below", kept[$1] ": write it down"; bad = 1 }
    END { exit bad }' benches/instructions.txt -
