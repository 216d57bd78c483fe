#!/usr/bin/env bash
# arithmetic_test.sh BUILD: the grader refuses to grade, with exit code 3 and the reason, under contraction, flushed
# denormals and fast-math; a fragment that changes the arithmetic of its program costs itself alone.
set -uo pipefail
build=$1
grade=$build/grader/grade
# shellcheck source=tests/expect.sh
. "$(dirname "$0")/expect.sh"

# self_test COMPILER OPTIONS...: prints what the self-test finds in a program that is compiled so
cat >"$work/main.cpp" <<'END'
#include <cstdio>
#include "arithmetic/self_test.h"
int main() { std::puts(grade::arithmetic_fault().c_str()); }
END
self_test() {
    local compiler=$1
    shift
    "$compiler" -std=c++20 -O3 -ffp-contract=off "$@" -Igrader grader/arithmetic/self_test.cpp "$work/main.cpp" -o "$work/test" && "$work/test"
}
for compiler in g++ clang++; do
    command -v $compiler >/dev/null || continue
    [ "$(self_test $compiler)" = "" ] || { echo "FAILED: plain $compiler has a fault"; failures=$((failures + 1)); }
    [ "$(self_test $compiler -O0)" = "" ] || { echo "FAILED: $compiler -O0 has a fault"; failures=$((failures + 1)); }
    if grep -q '\bfma\b' /proc/cpuinfo; then expect 0 "fused" self_test $compiler -mfma -ffp-contract=fast; fi
    expect 0 "ignored" self_test $compiler -ffinite-math-only
    expect 0 "flushed" self_test $compiler -ffast-math
done

# this very build, with one option more
for option in -ffast-math -ffp-contract=fast -Ofast; do
    sed "s|^compile = \[|&\"$option\", |; s|\"-ffp-contract=off\", ||" "$build/toolchain.toml" >"$work/toolchain.toml"
    expect 3 "refuses to grade, since $option" "$grade" solution moved --toolchain "$work/toolchain.toml"
done
sed 's|"-ffp-contract=off", ||' "$build/toolchain.toml" >"$work/toolchain.toml"
expect 3 "refuses to grade, since the missing -ffp-contract=off" "$grade" solution moved --toolchain "$work/toolchain.toml"

# a process whose denormals are flushed, as a library linked with fast-math does it
if grep -q '\bsse\b' /proc/cpuinfo; then
    echo '__attribute__((constructor)) static void flush() { __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040); }' >"$work/flush.c"
    g++ -x c++ -shared -fPIC -w "$work/flush.c" -o "$work/flush.so"
    asan=$(ldd "$grade" | awk '/libasan/ { print $3 }')  # where the build has it, it wants to be the first
    expect 3 "denormal numbers are flushed" env LD_PRELOAD="$asan $work/flush.so" "$grade" solution moved
    expect 3 "denormal numbers are flushed" env LD_PRELOAD="$asan $work/flush.so" "$grade" stress solution --only moved

    cp -r solution "$work/mine"
    sed -i 's|^namespace rt {|&\nstatic const int flushed = (__builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() \| 0x8040), 0);|' "$work/mine/moved.cpp"
    expect 0 "changes the arithmetic of its program" "$grade" "$work/mine" moved mirror_direction --seed 1
    expect 0 "passed" "$grade" "$work/mine" mirror_direction --seed 1
fi

end
