#!/usr/bin/env bash
# Instructions a call of each kernel, callees included, counted by valgrind's callgrind. Needs valgrind. One line a kernel.
set -euo pipefail
cd "$(dirname "$0")/.."
program() {
    cargo bench --bench "$1" --no-run --message-format json 2>/dev/null |
        sed -n "s/.*\"executable\":\"\([^\"]*$1-[^\"]*\)\".*/\1/p" | tail -n 1
}
count() { # FUNCTION PROGRAM KERNEL N: instructions inside FUNCTION
    valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect="$1" "$2" "$3" "$4" 2>&1 |
        sed -n 's/.*Collected : \([0-9]*\).*/\1/p'
}
report() { echo "$1 $(($2 / $3)).$(($2 * 10 / $3 % 10))"; } # KERNEL TOTAL CALLS

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
