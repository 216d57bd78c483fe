# Sourced by tests of ./grade, ./check and .ci/run: a folder with an awkward name, where cmake, ninja, apt-get, sudo and the
# like are stand-ins that keep a log: nothing is installed or built.
# shellcheck shell=bash disable=SC2016,SC2034  # what the stand-ins do; what the tests use
exec </dev/null
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
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
