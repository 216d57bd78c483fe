#!/usr/bin/env bash
# ./grade, ./check and .ci/run in a folder with an awkward name, where cmake, ninja, apt-get, sudo and the like are stand-ins
# that keep a log: nothing is installed or built.
# shellcheck disable=SC2016,SC2317  # what the stand-ins do; functions that expect calls
set -uo pipefail
exec </dev/null
source=$(cd "$(dirname "$0")/.." && pwd)
# shellcheck source=tests/expect.sh
. "$source/tests/expect.sh"
chmod 755 "$work"
tree="$work/Übung (1) & Lösung's" bin=$work/bin stub=$work/stub
build=$tree/build/release

# Only these programs are there, and the stand-ins.
mkdir -p "$bin"
for tool in bash cat chmod cp dirname df env find flock grep mkdir mktemp readlink rm script sed sh sleep tail touch tr wc; do
    ln -s "$(command -v $tool)" "$bin/$tool"
done

printf '#!/bin/sh\necho 2\n' >"$bin/nproc"
chmod 755 "$bin/nproc"

# stand_in NAME [IN]: a program that logs its call and does what stdin says
stand_in() {
    { printf '#!/usr/bin/env bash\necho "%s $*" >>"%s/log"\n' "$1" "$stub"; cat; } >"$work/made"
    chmod 755 "$work/made"
    mv "$work/made" "${2-$bin}/$1"
}

# Everything is installed, nothing is built, all goes well.
begin() {
    rm -rf "$tree" "$stub"
    mkdir -p "$tree/.ci" "$tree/grader" "$tree/starter/rt" "$stub" "$work/elsewhere"
    cp "$source/grade" "$source/check" "$tree"
    cp "$source/.ci/prepare.sh" "$source/.ci/run" "$tree/.ci"
    sed -i "s|</proc/loadavg|<'$stub/load'|" "$tree/.ci/prepare.sh"
    echo "0.24 0.20 0.18 1/200 9999" >"$stub/load"
    touch "$tree/assignment.toml"
    : >"$stub/missing"
    : >"$stub/log"
    chmod 777 "$stub"
    chmod 666 "$stub/log"
    stand_in dpkg-query <<<'for name in "${@:3}"; do
        if grep -qx "$name" "'"$stub"'/missing"; then echo -n "not-installed:$name "; else echo -n "installed:$name "; fi
    done'
    stand_in apt-get <<<'echo "Get:1 http://server stable InRelease"; echo "pmstatus:cmake:50.0:Unpacking"'
    stand_in sudo <<<'[ "$1" = true ] || exec "$@"'
    stand_in id <<<'echo ${STUB_USER:-0}'
    stand_in c++ <<<'cat >/dev/null'
    stand_in ninja <<<'for i in {1..260}; do echo c++; done'
    stand_in ctest <<<'echo "100% tests passed, 0 tests failed out of 80"'
    stand_in cmake <<<'if [ "$1" = --build ]; then . "'"$stub"'/build"; else . "'"$stub"'/configure"; fi'
    cat >"$stub/configure" <<'END'
        echo "-- Configuring done"
        mkdir -p build/release
        [ -e build/release/CMakeCache.txt ] ||
            printf 'CMAKE_GENERATOR:INTERNAL=Ninja\nCMAKE_HOME_DIRECTORY:INTERNAL=%s\n' "$PWD" >build/release/CMakeCache.txt
        touch build/release/build.ninja
END
    cat >"$stub/make_grader" <<'END'
        touch "$2/.ninja_log"
        mkdir -p "$2/grader"
        printf '#!/bin/sh\necho "graded $PWD: $*"\n' >"$2/grader/grade"
        cp "$2/grader/grade" "$2/grader/grade_studies"
        chmod 755 "$2/grader/grade" "$2/grader/grade_studies"
END
    steps 260
}

# steps N: the build takes so many
steps() {
    { echo "for i in {1..$1}; do echo \"[\$i/$1] Building CXX object a.o\"; done"; echo ". '$stub/make_grader'"; } >"$stub/build"
}
nothing_to_do() { echo 'echo "[0/2] Re-checking globbed directories..."; echo "ninja: no work to do."' >"$stub/build"; }

# in_it COMMAND...: with the stand-ins, in the folder
in_it() { (cd "$tree" && env -i PATH="$bin" TMPDIR="$work" TERM=xterm "$@"); }
as_user() { in_it STUB_USER=1000 "$@"; }
# on_terminal INPUT COMMAND: as a terminal shows it, with ~ for the start of a line anew
on_terminal() { printf '%b' "$1" | in_it script -qec "${*:2}" /dev/null | tr '\r' '~' | sed 's/\x1b\[K//g; s/~$//'; return "${PIPESTATUS[1]}"; }
# no WORDS COMMAND...: that the output does not hold
no() { ! "${@:2}" 2>&1 | grep -F -- "$1"; }
called() { grep -qF -- "$1" "$stub/log"; }
not_called() { ! grep -F -- "$1" "$stub/log"; }
lines() { echo "$("$@" 2>&1 >/dev/null | wc -l) lines"; }

# help: no packages, no build
begin
echo cmake >"$stub/missing"
expect 0 "[FRAGMENT...] [OPTIONS]" in_it ./grade --help
expect 0 "picture SCENE" as_user ./grade stress -h
expect 0 "ctest" in_it ./check --help
expect 0 "" test ! -s "$stub/log"
begin
expect 0 "graded" in_it ./grade
nothing_to_do
: >"$stub/log"
expect 0 "graded $tree: stress --help" in_it ./grade stress --help
expect 0 "graded $tree: stress --help" in_it ./grade help stress
expect 0 "" test ! -s "$stub/log"

# the second program: built when it is asked for
begin
expect 0 "graded" in_it ./grade
expect 0 "" not_called grade_studies
expect 0 "graded $tree: stress solution" in_it ./grade stress solution
expect 0 "" called "cmake --build $build --target grade handout_page grade_studies"
rm "$build/grader/grade_studies"
expect 0 "in a second program, which is built first" in_it ./grade stress solution
rm "$build/grader/grade_studies"
expect 0 "graded $tree: lesson --help" in_it ./grade lesson --help

# what is graded, from wherever it is called
expect 0 "graded $tree: " in_it ./grade
expect 0 "graded $tree: a b.zip --seed 3" in_it ./grade "a b.zip" --yes --seed 3
ln -sf "$tree/grade" "$work/elsewhere/link"
ln -sf ../elsewhere/link "$work/stub/chained link"
expect 0 "graded $work: hand-in" in_it env -C "$work" CDPATH="$work" ./elsewhere/link hand-in
expect 0 "graded $work/elsewhere: hand-in" in_it env -C "$work/elsewhere" "../stub/chained link" hand-in
expect 0 "graded $work: hand-in" in_it env -C "$work" PATH="$work/elsewhere:$bin" link hand-in

begin
expect 0 "graded $work: hand-in" in_it env -C "$work" "$tree/grade" hand-in
expect 0 "" test -e "$build/build.ninja"

# the first build, without a terminal: a line at each tenth, on stderr alone
begin
expect 0 "Building, the first time: 260 steps, about 3 minutes." in_it ./grade
begin
echo "8.15 5.20 2.18 9/200 9999" >"$stub/load"
expect 0 "260 steps, about 16 minutes beside what else runs on this machine." in_it ./grade
begin
rm "$stub/load"
expect 0 "260 steps, about 3 minutes." in_it ./grade
begin
expect 0 "12 lines" lines in_it ./grade
begin
expect 0 "building: 130 of 260, " in_it ./grade
begin
expect 0 "only graded" echo "only $(in_it ./grade 2>/dev/null)"
# on a terminal: one line that goes
begin
steps 40
expect 0 "~building: 2 of 40, about 30 s left~" on_terminal "" ./grade
begin
steps 40
expect 0 "2" grep -c "" <(on_terminal "" ./grade)
# a later one
nothing_to_do
expect 0 "0 lines" lines in_it ./grade
expect 0 "says:graded" echo "says:$(on_terminal "" ./grade)"
steps 3
expect 0 "0 lines" lines in_it ./grade
expect 0 "building: 1 of 3, a few seconds left~" on_terminal "" ./grade
expect 0 "building: 3 of 3~graded" on_terminal "" ./grade
expect 0 "1" grep -c "" <(on_terminal "" ./grade)
# a slow one is not silent for longer than 15 s
echo 'echo "[1/3] Building a.o"; sleep 16; echo "[2/3] Building b.o"' >"$stub/build"
expect 0 "building: 1 of 3, a few seconds left" in_it ./grade
begin
{ cat "$stub/configure"; echo sleep 16; } >"$stub/slowly"
mv "$stub/slowly" "$stub/configure"
expect 0 "configuring: 1" in_it ./grade

# warnings and errors, whole and without the commands; exit code 3; the next call goes on
begin
cat >"$stub/build" <<'END'
printf -- '-- A target\n  of two lines\n\n'
echo "[1/2] Building CXX object a.o"
printf '/a/a.cpp:3:1: warning: unused\n    3 | int a\n\n      | ^\n'
printf 'FAILED: b.o \n/usr/bin/c++ -DMANY_WORDS -c b.cpp\nb.cpp:1:1: error: no\n-- noise\nninja: build stopped: subcommand failed.\n'
exit 1
END
expect 3 $'about 3 minutes.\n/a/a.cpp:3:1: warning: unused\n    3 | int a\n\n      | ^\nFAILED: b.o \nb.cpp:1:1: error: no\nThe build failed (above).' in_it ./grade
expect 3 $'warning: unused' on_terminal "" ./grade
steps 3
expect 0 "graded" in_it ./grade
expect 0 "1" grep -c "cmake --preset" "$stub/log"

# a mistake in the assignment is no failure of the machine
begin
cat >"$stub/build" <<'END'
printf 'FAILED: blank.cpp %0300d\n/usr/bin/make_blanks\nassignment.toml:22:12: unknown\nninja: build stopped: subcommand failed.\n' 0
exit 1
END
expect 2 $'00\nassignment.toml:22:12: unknown' in_it ./grade
expect 0 "" no "$(printf '%0100d' 0)" in_it ./grade
expect 0 "" no "The build failed" in_it ./grade

# two at once: the second waits for the first
begin
echo 'sleep 17; echo first >>"'"$stub"'/log"; exit 1' >"$stub/build"
in_it ./grade >"$work/first" 2>&1 &
for _ in {1..100}; do if called "cmake --build"; then break; fi; sleep 0.1; done
steps 3
expect 0 "waiting for another build here: 1" in_it ./grade
expect 0 $'\nfirst\ncmake --build' grep -e "first" -e "cmake --build" "$stub/log"
wait

# interrupted
begin
echo 'echo "[1/9] Building a.o"; sleep 60' >"$stub/build"
interrupt() {
    set -m
    (cd "$tree" && exec env -i PATH="$bin" ./grade) &
    local group=$!
    for _ in {1..100}; do if called "$1"; then break; fi; sleep 0.1; done
    sleep 0.3
    kill -INT -- -"$group"
    wait "$group"
    local code=$?
    set +m
    return "$code"
}
expect 130 "Interrupted" interrupt "cmake --build"
steps 9
expect 0 "graded" in_it ./grade
begin
cp "$stub/configure" "$stub/configure_well"
{ cat "$stub/configure_well"; echo 'echo half >>build/release/CMakeCache.txt; sleep 60'; } >"$stub/configure"
expect 130 "Interrupted" interrupt "cmake --preset"
expect 0 "half" cat "$build/CMakeCache.txt"
cp "$stub/configure_well" "$stub/configure"
expect 0 "graded" in_it ./grade
expect 1 "" grep half "$build/CMakeCache.txt"
# once it is done it is not done again
: >"$stub/log"
expect 0 "graded" in_it ./grade
expect 0 "" not_called "cmake --preset"

# a configuration that failed, and one of another place or generator
begin
cp "$stub/configure" "$stub/configure_well"
cat >"$stub/configure" <<'END'
printf -- '-- noise\nCMake Error at x:3:\n  whole\n\n  all\n-- more noise\n'
exit 1
END
expect 3 $'CMake Error at x:3:\n  whole\n\n  all\nThe project could not be configured' in_it ./grade
expect 0 "" no noise in_it ./grade
echo 'echo "CMake Error: No CMAKE_CXX_COMPILER could be found."; exit 1' >"$stub/configure"
expect 3 "There is no C++ compiler here that works." in_it ./grade
echo 'echo "CMake Error: Cannot write: No space left on device"; exit 1' >"$stub/configure"
expect 3 "The disk is full" in_it ./grade
rm "$bin/df"
stand_in df <<<'echo Avail; echo 12'
echo 'echo "The C++ compiler is not able to compile a simple test program."; exit 1' >"$stub/configure"
expect 3 "The disk is full" in_it ./grade
ln -sf "$(command -v df)" "$bin/df"
cp "$stub/configure_well" "$stub/configure"
expect 0 "graded" in_it ./grade
for stale in "CMAKE_HOME_DIRECTORY:INTERNAL=.*/CMAKE_HOME_DIRECTORY:INTERNAL=\/other" "=Ninja/=Unix Makefiles"; do
    sed -i "s/$stale/" "$build/CMakeCache.txt"
    expect 0 "graded" in_it ./grade
    expect 0 "CMAKE_HOME_DIRECTORY:INTERNAL=$tree" cat "$build/CMakeCache.txt"
    expect 0 "=Ninja" cat "$build/CMakeCache.txt"
done
# what is built for a processor that has more than this one is configured anew, with what was chosen
if grep -q ^flags /proc/cpuinfo; then
    : >"$stub/log"
    grep -m 1 ^flags /proc/cpuinfo | sed 's/.*: //' >"$build/instructions"
    expect 0 "graded" in_it ./grade
    expect 0 "" not_called "cmake --preset"
    echo "no_such_instruction" >>"$build/instructions"
    expect 0 "graded" in_it ./grade
    expect 0 "" called "cmake --preset release"
    : >"$stub/log"
    echo RT_MARCH:STRING=x86-64-v3 >>"$build/CMakeCache.txt"
    sed -i "s/CMAKE_HOME_DIRECTORY:INTERNAL=.*/CMAKE_HOME_DIRECTORY:INTERNAL=\/other/" "$build/CMakeCache.txt"
    expect 0 "graded" in_it ./grade
    expect 0 "" called "cmake --preset release -DRT_MARCH=x86-64-v3"
    rm "$build/instructions"
fi
echo 'echo "a.cpp: fatal error: error writing to /tmp/a.s: No space left on device"; exit 1' >"$stub/build"
expect 3 "The disk is full" in_it ./grade

# a folder that cannot be written
begin
touch "$tree/build"
expect 3 "build/release cannot be written: Not a directory" in_it ./grade
expect 3 "build/release cannot be written: Not a directory" in_it ./check
expect 0 "" test ! -s "$stub/log"
begin
expect 0 "graded" in_it ./grade
anyone() { if [ "$(command id -u)" = 0 ]; then setpriv --reuid 65534 --clear-groups -- "$@"; else "$@"; fi; }
chmod -R a-w "$tree"
: >"$stub/log"
expect 0 "1 lines" echo "$(in_it "$(command -v setpriv)" --version | grep -c "") lines"
reader() { (cd "$tree" && anyone env -i PATH="$bin" STUB_USER=65534 "$@"); }
expect 0 "graded" reader ./grade
expect 0 "0 lines" lines reader ./grade
expect 0 "" test ! -s "$stub/log"
expect 3 "build/release cannot be written: Permission denied" reader ./check
touch -d "+1 minute" "$tree/assignment.toml"
expect 0 "The grader is older than assignment.toml" reader ./grade
chmod -R u+w "$tree"
rm "$build/grader/grade"
chmod -R a-w "$tree"
expect 3 "build/release cannot be written: Permission denied" reader ./grade
chmod -R u+w "$tree"
# that another user has built
begin
expect 0 "graded" in_it ./grade
chmod 777 "$build"
chmod 444 "$build/.ninja_log"
rm "$build/.lock"
expect 0 "0 lines" lines reader ./grade
chmod -R u+w "$tree"

# packages: root without a terminal installs
begin
printf 'cmake\nlibglm-dev\n' >"$stub/missing"
expect 0 "Missing packages: cmake libglm-dev" in_it ./grade
expect 0 "" called "apt-get -o APT::Status-Fd=1 -o DPkg::Lock::Timeout=300 install -y --no-install-recommends cmake libglm-dev"
expect 0 "Installing 2 packages, about 20 s." in_it ./grade
expect 0 "installing: setting up, 50 %" in_it ./grade
expect 0 "only graded" echo "only $(in_it ./grade 2>/dev/null)"
# root with one is asked
: >"$stub/log"
expect 3 "Then type: apt-get update && apt-get install -y --no-install-recommends cmake libglm-dev" on_terminal 'n\n' ./grade
expect 3 "Then type: apt-get update" on_terminal '\0004' ./grade
expect 0 "" not_called apt-get
expect 0 "graded" on_terminal 'y\n' ./grade
expect 0 "" called apt-get
: >"$stub/log"
expect 0 "graded" on_terminal "" ./grade --yes
expect 0 "" called apt-get
# a user is told the command, and installs with --yes
: >"$stub/log"
expect 3 "To install them, type: sudo apt-get update && sudo apt-get install -y --no-install-recommends cmake" as_user ./grade
expect 0 "" not_called "apt-get"
expect 0 "graded" as_user ./grade --yes
expect 0 "" called "sudo env LC_ALL=C DEBIAN_FRONTEND=noninteractive apt-get"
stand_in sudo <<<'exit 1'
: >"$stub/log"
expect 3 "You may not use sudo here. As root, type: apt-get update && apt-get install" as_user ./grade --yes
rm "$bin/sudo"
expect 3 "There is no sudo here. As root, type: apt-get update && apt-get install" as_user ./grade --yes
expect 3 "There is no sudo here. As root, type: apt-get update && apt-get install" as_user ./grade
expect 0 "" not_called "apt-get"

# apt: no network, another one at work, a full disk, a source that fails
begin
echo cmake >"$stub/missing"
stand_in apt-get <<<'echo "W: Failed to fetch http://server  Temporary failure resolving server"'
expect 3 "There is no network here" in_it ./grade
expect 0 "" not_called install
expect 0 "Temporary failure resolving" in_it bash -c 'cat "$(./grade 2>&1 | sed -n "s/.*(log: \([^)]*\)).*/\1/p")"'
stand_in apt-get <<<'case $* in *update) echo "Hit:1 http://server"; echo "E: Failed to fetch http://other"; exit 100 ;; esac'
expect 0 "graded" in_it ./grade
stand_in apt-get <<<'case $* in *install*) echo "E: Unable to acquire the dpkg frontend lock"; exit 100 ;; esac'
expect 3 "Another apt is still at work." in_it ./grade
stand_in apt-get <<<'case $* in *install*) echo "E: You don'\''t have enough free space in /var"; exit 100 ;; esac'
expect 3 "The disk is full." in_it ./grade
stand_in apt-get <<<'[ -e "'"$stub"'/locked" ] || { touch "'"$stub"'/locked"; echo "E: Could not get lock /var/lib/apt/lists/lock."; exit 100; }'
expect 0 "installing: waiting for another apt to finish" in_it ./grade
rm "$stub/locked"
stand_in apt-get <<<'echo "Waiting for cache lock: Could not get lock. It is held by process 3 (apt)..."'
expect 0 "installing: waiting for another apt to finish" in_it ./grade

# no apt-get
begin
rm "$bin/apt-get" "$bin/cmake" "$bin/ninja"
expect 3 "Not found: cmake ninja-build" in_it ./grade
expect 3 "vcpkg.json" as_user ./grade
begin
rm "$bin/apt-get" "$bin/dpkg-query"
expect 0 "graded" in_it ./grade
begin
rm "$bin/apt-get" "$bin/dpkg-query"
echo 'echo "CMake Error: no fmt"; exit 1' >"$stub/configure"
stand_in c++ <<<'grep -A 1 "has_include(<\(fmt/core.h\|glm/glm.hpp\)>" | grep @'
expect 3 "Not found: libfmt-dev libglm-dev." in_it ./grade

# ./check and .ci/run
begin
expect 0 "100% tests passed" in_it ./check --yes -R "a sphere"
expect 0 "" called "ctest --preset release --parallel 3 -R a sphere"
expect 0 "100% tests passed" in_it ./check --yes
expect 0 "" called "ctest --preset release --parallel 3 --label-exclude long"
expect 0 "100% tests passed" in_it ./check --yes --long
expect 0 "" grep -x "ctest --preset release --parallel 3" "$stub/log"
expect 0 "" called "cmake --preset release -DBUILD_TESTING=ON"
expect 0 "" called "cmake --build $build --target all"
mkdir -p "$tree/build/mitsuba/bin" "$tree/build/pages/bin"
stand_in python3 "$tree/build/mitsuba/bin" <<<'exit 0'
stand_in python3 "$tree/build/pages/bin" <<<'exit 0'
ci_run() { in_it .ci/run 2>&1 | tail -n 1; }
expect 0 "100% tests passed" ci_run
stand_in python3 "$tree/build/mitsuba/bin" <<<'exit 1'
stand_in python3 <<<'exit 0'
stand_in pip "$tree/build/mitsuba/bin" <<<'echo "Could not find mitsuba"; exit 1'
expect 3 $'Could not find mitsuba\nmitsuba numpy could not be installed' in_it .ci/run

end
