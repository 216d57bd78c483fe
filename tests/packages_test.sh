#!/usr/bin/env bash
# What ./grade installs, and how it says that it cannot; then ./check and .ci/run.
# shellcheck disable=SC2016,SC2317  # what the stand-ins do; functions that expect calls
set -uo pipefail
# shellcheck source=tests/stand_ins.sh
. "$(dirname "$0")/stand_ins.sh"

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
