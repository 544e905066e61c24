#!/usr/bin/env bash
# Instructions per call of each kernel (per point for batches), including callees, counted by valgrind's
# callgrind: one line per kernel, after a line with the conditions. It requires valgrind. With --check, the
# counts are compared with benches/instructions.txt, and a deviation of more than 3 % or a missing kernel is
# an error. With another compiler, libraries or valgrind than in that file, 25 % are allowed, because their
# code differs while that of the library does not.
set -euo pipefail
[ "${1:-}" = --one ] || cd "$(dirname "$0")/.."
program() {
    cargo bench -p stickslip-benches --features batch --bench "$1" --no-run --message-format json 2>/dev/null |
        sed -n "s/.*\"executable\":\"\([^\"]*$1-[^\"]*\)\".*/\1/p" | tail -n 1
}
collected() { # [OPTION] PROGRAM KERNEL N: instructions of the whole program
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$@" 2>&1 | sed -n 's/.*Collected : \([0-9]*\).*/\1/p'
}
count() { # FUNCTION PROGRAM KERNEL N: instructions inside FUNCTION
    collected --toggle-collect="$1" "${@:2}"
}
conditions() {
    echo "# $(rustc --version | cut -d ' ' -f 1,2), $(uname -m), glibc $(getconf GNU_LIBC_VERSION | cut -d ' ' -f 2), $(valgrind --version)"
}
report() { echo "$1 $(($2 / $3)).$(($2 * 10 / $3 % 10))"; } # KERNEL TOTAL CALLS

one() { # KIND PROGRAM KERNEL: the line of one kernel
    local kind=$1 program=$2 kernel=$3 once function=${3//-/_}
    case $kind in
        closed)
            # The difference of two numbers of points removes the start-up, but not the loop over the points.
            once=$(collected "$program" "$kernel" 10000)
            report "$kernel" $(($(collected "$program" "$kernel" 20000) - once)) 10000
            ;;
        exact)
            [ "$kernel" != steady-beside-resonance ] || function=steady_from_rest
            report "$kernel" "$(count "*motions::$function*" "$program" "$kernel" 2000)" 2000
            ;;
        stops) report "$kernel" "$(count '*motions::steady_with_damping*' "$program" "$kernel" 20)" 20 ;;
        map) report "$kernel" "$(count '*steady_map*' "$program" "$kernel" 5000)" 5000 ;;
        batch)
            # The difference of two numbers of rounds removes the start-up.
            once=$(collected "$program" "$kernel" 1)
            report "$kernel" $(($(collected "$program" "$kernel" 2) - once)) 128000
            ;;
    esac
}

all() { # as many kernels at a time as there are processors
    local closed exact batch
    closed=$(program instructions)
    exact=$(program exact_instructions)
    batch=$(program batch_instructions)
    {
        printf "closed $closed %s\n" triple five cycle cycle-low response {cycle,response}-static-friction damped{,-low} amplitude-damped-low
        printf "exact $exact %s\n" steady-from-rest steady-beside-resonance steady-from-cycle twenty-slides
        printf "stops $exact steady-with-stops-%s\n" {0.7-1.2,0.4-6,0.15-3,0.9-1.1}-{0,0.05}
        printf "map $exact steady-map\n"
        printf "batch $batch %s\n" batch-{triple,peaks,cycles}{,-fixed,-low} batch-{triple,peaks}-damped{,-low}
    } | xargs -P "$(nproc)" -L 1 benches/instructions.sh --one
}

if [ "${1:-}" = --one ]; then
    one "${@:2}"
    exit
fi
if [ "${1:-}" != --check ]; then
    conditions
    # In the order of the file so far, with new kernels last.
    all | awk 'NR == FNR { place[$1] = NR; next } { print ($1 in place ? place[$1] : NR + 1000), $0 }' benches/instructions.txt - |
        sort -n | cut -d ' ' -f 2-
    exit
fi
kept=$(head -n 1 benches/instructions.txt)
off=3
if [ "$(conditions)" != "$kept" ]; then
    off=25
    echo "counted with ${kept#\# }, here is $(conditions | cut -c 3-): $off % are allowed"
fi
all | awk -v off=$off '
    NR == FNR { if ($1 !~ /^#/) kept[$1] = $2; next }
    { counted[$1] = $2 }
    !($1 in kept) { print $1, $2, "is not in benches/instructions.txt"; bad = 1; next }
    $2 > (1 + off / 100) * kept[$1] { print $1, $2, "is more than", off, "% above", kept[$1]; bad = 1 }
    $2 < (1 - off / 100) * kept[$1] { print $1, $2, "is more than", off, "% below", kept[$1] ": write it down"; bad = 1 }
    END {
        for (kernel in kept) if (!(kernel in counted)) { print kernel, "was not counted"; bad = 1 }
        print length(counted), "kernels counted"
        exit bad
    }' benches/instructions.txt -
