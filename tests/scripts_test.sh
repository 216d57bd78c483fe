#!/usr/bin/env bash
# What ./grade says and builds, the first time and later.
# shellcheck disable=SC2016,SC2317  # what the stand-ins do; functions that expect calls
set -uo pipefail
# shellcheck source=tests/stand_ins.sh
. "$(dirname "$0")/stand_ins.sh"

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

end
