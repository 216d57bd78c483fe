#!/usr/bin/env bash
# processor_test.sh BUILD: programs that are started on a lesser processor than they are built for say so and end with exit
# code 3, before anything else has run; those for the oldest processors run there. On the processors of qemu-user.
set -uo pipefail
build=$1
# shellcheck source=tests/expect.sh
. "$(dirname "$0")/expect.sh"
qemu=$(command -v qemu-x86_64-static || command -v qemu-x86_64) || { echo "skipped: qemu-user is missing"; exit 77; }
grep -q '^processor = "x86-64' "$build/toolchain.toml" || { echo "skipped: this build is not for x86-64"; exit 77; }
kind=$(sed -n 's/^processor = "\(.*\)"/\1/p' "$build/toolchain.toml")
picture=(scenes/penumbra.toml --size 24x24 --samples 4 -o "$work/a.exr")

# on PROCESSOR COMMAND...; what qemu lacks itself is no matter
on() { "$qemu" -cpu "$1" "${@:2}" 2> >(grep -v "^qemu.*warning" >&2); }
hash_of() { sed -n 's/^hash *//p'; }

# this build
case $kind in
    x86-64-v[34])
        sentence="This program is built for $kind processors, and this one is none."
        for processor in Nehalem qemu64; do
            expect 3 "$sentence" on $processor "$build/raytrace" "${picture[@]}"
            expect 3 "$sentence" on $processor "$build/raytrace" --help
            expect 3 "$sentence" on $processor "$build/grader/grade" solution phong
            expect 3 "$sentence" on $processor "$build/grader/grade" --version
        done
        # before the initialisers of libraries, which may call what this build has compiled
        cat >"$work/first.c" <<'END'
#include <unistd.h>
__attribute__((constructor)) static void first() { if (write(2, "initialised", 11) < 0) _exit(1); }
END
        if c++ -x c++ -shared -fPIC "$work/first.c" -o "$work/first.so"; then
            expect 0 "initialised" on max -E LD_PRELOAD="$work/first.so" "$build/grader/raytrace_baseline" --help
            expect 1 "" grep -q initialised <(on Nehalem -E LD_PRELOAD="$work/first.so" "$build/raytrace" --help 2>&1)
        fi
        # a grader that runs, whose fragments would not
        expect 3 "what fragments are linked with is built for $kind processors" \
            on Nehalem "$build/grader/grade_kit" --toolchain "$build/toolchain.toml" solution phong ;;
    *) echo "this processor is of no better kind than $kind: the programs of this build are not tested" ;;
esac

# a kit's
expect 3 "is built for x86-64-v2 processors, and this one is none" on qemu64 "$build/grader/raytrace_baseline" "${picture[@]}"
expect 3 "is built for x86-64-v2 processors, and this one is none" on qemu64 "$build/grader/grade_kit" --version
expect 0 "grade " on Nehalem "$build/grader/grade_kit" --version
here=$("$build/raytrace" "${picture[@]}" | hash_of)
expect 0 "hash     ${here:-none}" on Nehalem "$build/grader/raytrace_baseline" "${picture[@]}"

# what cmake takes
expect 1 "RT_MARCH: pentium is no kind of processor; expected native" cmake -S starter -B "$work/pentium" -DRT_MARCH=pentium

end
