# Sourced by ./grade, ./check and .ci/run: installs and builds what they need. `root` is the project's folder; `yes` is
# not empty when nobody is to be asked. All that is said goes to stderr. Exit status 3: this machine cannot do it.
# shellcheck shell=bash

# Debian's and Ubuntu's names; behind the colon the program or header by which it is found elsewhere. vcpkg.json lists the
# same libraries.
packages="cmake:cmake g++:c++ ninja-build:ninja bubblewrap: libarchive-dev:archive.h libboost-math-dev:boost/math/distributions.hpp
    libcli11-dev:CLI/CLI.hpp libfmt-dev:fmt/core.h libglm-dev:glm/glm.hpp libopenexr-dev:OpenEXR/ImfHeader.h
    libpng-dev:png.h libtbb-dev:tbb/tbb.h libtinyobjloader-dev:tiny_obj_loader.h libtomlplusplus-dev:toml++/toml.h
    nlohmann-json3-dev:nlohmann/json.hpp"
[ -x /usr/bin/ld.gold ] || packages+=" mold:"  # a fast linker; Debian 13 has no gold
test_packages="catch2: clang:clang++ clang-format: flake8: patch:patch python3:python3 python3-jsonschema: shellcheck: valgrind:"
mitsuba_packages="python3-venv:"
page_packages="chromium:chromium pandoc:pandoc python3-jsonschema:"  # pages in a browser, the handout as one, schemas
tidy_packages="clang-tidy:clang-tidy"
class_packages="munge: parallel: slurm-wlm:"  # a class on several machines
compiler=${CXX:-c++}

build=$root/build/release
processors=$(nproc)

# --- What is said

terminal=""
if [ -t 2 ] && [ "${TERM:-dumb}" != dumb ]; then terminal=1; fi
shown="" milestone="" said_at=$SECONDS

# say TEXT: a line.
say() {
    clear_line
    printf '%s\n' "$*" >&2
    said_at=$SECONDS
}
clear_line() {
    [ -z "$shown" ] || printf '\r\033[K' >&2
    shown=""
}

# progress TEXT [MILESTONE]: how far it is. On a terminal in one line, which changes and goes; elsewhere in a line at each
# new milestone and after 15 seconds of silence.
progress() {
    if [ -n "$terminal" ]; then
        printf '\r\033[K%s' "$1" >&2
        shown=1
    elif [ "${2-$milestone}" != "$milestone" ] || [ $((SECONDS - said_at)) -ge 15 ]; then
        say "$1"
        milestone=${2-$milestone}
    fi
}

# in_words SECONDS
in_words() {
    if [ "$1" -lt 10 ]; then echo "a few seconds"
    elif [ "$1" -lt 50 ]; then echo "about $((($1 + 9) / 10 * 10)) s"
    elif [ "$1" -lt 90 ]; then echo "about a minute"
    else echo "about $((($1 + 30) / 60)) minutes"; fi
}

# give_up TEXT...
give_up() {
    say "$@"
    exit 3
}

interrupted() {
    trap '' INT
    [ -z "${from-}" ] || cat <&"$from" >/dev/null  # until those that were at work have ended
    say "Interrupted. The next call goes on from here."
    exit 130
}
trap interrupted INT

# follow FUNCTION COMMAND...: calls the function with each line of the command's output, and with none after each second
# without one. Its status is the command's; `output` is for the function to keep what matters.
follow() {
    local on_line=$1 line="" rest="" status command
    shift
    output="" milestone="" said_at=$SECONDS
    exec {from}< <(exec "$@" 2>&1 </dev/null)
    command=$!
    while true; do
        status=0
        IFS= read -r -t 1 -u "$from" line || status=$?
        if [ $status = 0 ]; then
            "$on_line" "$rest$line"
            rest=""
        elif [ $status -gt 128 ]; then
            rest+=$line
            "$on_line"
        else
            break
        fi
    done
    [ -z "$rest$line" ] || "$on_line" "$rest$line"
    exec {from}<&-
    from=""
    clear_line
    wait "$command"
}

# quietly TEXT COMMAND...: keeps the output.
quietly() {
    local doing=$1 began=$SECONDS
    shift
    quiet_line() {
        [ $# = 0 ] || output+=$1$'\n'
        progress "$doing: $((SECONDS - began)) s"
    }
    follow quiet_line "$@"
}

# --- Packages

# install_packages NAME:PROOF...: those that are missing, after asking.
install_packages() {
    local name
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        # elsewhere CMake judges the libraries
        for name in cmake ninja "${compiler%% *}"; do
            command -v "$name" >/dev/null || give_up "$(missing_elsewhere)"
        done
        return
    fi
    local installed missing="" count=0 sudo="" answer=""
    installed=" $(dpkg-query -W -f='${db:Status-Status}:${Package} ' "${@%%:*}" 2>/dev/null)" || true
    for name in "${@%%:*}"; do
        [[ $installed == *" installed:$name "* ]] || missing+=" $name" count=$((count + 1))
    done
    [ -n "$missing" ] || return 0

    [ "$(id -u)" = 0 ] || sudo="sudo "
    local install="apt-get install -y --no-install-recommends$missing"
    local by_root="As root, type: apt-get update && $install"
    say "Missing packages:$missing"
    [ -z "$sudo" ] || command -v sudo >/dev/null || give_up "There is no sudo here. $by_root"
    if [ -z "$yes" ] && [ -t 0 ] && [ -t 2 ]; then
        read -r -p "Install them now? [y/N] " answer || echo >&2
        [[ $answer == [yY]* ]] || give_up "Then type: ${sudo}apt-get update && $sudo$install"
    elif [ -z "$yes" ] && { [ -n "$sudo" ] || [ -t 0 ]; }; then
        give_up "To install them, type: ${sudo}apt-get update && $sudo$install"
    fi
    [ -z "$sudo" ] || sudo true || give_up "You may not use sudo here. $by_root"

    say "Installing $count package$([ $count = 1 ] || echo s), $(in_words $((10 + 5 * count)))."
    apt update || true  # one source that fails need not matter
    # shellcheck disable=SC2086
    if { [[ $output == *"Failed to fetch"* ]] && ! [[ $output =~ (Get|Hit):[0-9] ]]; } || ! apt ${install#apt-get }; then
        local log=""
        log=$(mktemp -t penumbra-apt.XXXXXX) && printf '%s' "$output" >"$log"
        printf '%s' "$output" | grep '^[EW]: ' | tail -n 5 >&2 || true
        case $output in
            *resolv* | *onnect* | *unreachable*) say "There is no network here, or the server of packages does not answer." ;;
            *"Could not get lock"* | *"Unable to acquire"*) say "Another apt is still at work. Try again when it is done." ;;
            *"No space left"* | *"enough free space"*) say "The disk is full." ;;
        esac
        give_up "The packages could not be installed (log: $log). By hand: ${sudo}apt-get update && $sudo$install"
    fi
}

# apt WORDS...: apt-get for install_packages; waits for another one.
apt() {
    local what=$1 deadline=$((SECONDS + 300)) doing="asking the servers"
    apt_line() {
        local phase percent
        IFS=: read -r phase _ percent _ <<<"${1-}"
        case ${1-} in
            dlstatus:*) [ "$what" = update ] || doing="fetching, ${percent%.*} %" ;;
            pmstatus:*) doing="setting up, ${percent%.*} %" ;;
            "Waiting for cache lock"*) doing="waiting for another apt to finish" phase=lock ;;
            *) output+=${1+$1$'\n'} phase=$milestone ;;
        esac
        progress "installing: $doing" "$phase"
    }
    while true; do
        if follow apt_line ${sudo:+sudo} env LC_ALL=C DEBIAN_FRONTEND=noninteractive \
            apt-get -o APT::Status-Fd=1 -o DPkg::Lock::Timeout=300 "$@"; then return 0; fi
        [[ $output == *"Could not get lock"* ]] && [ $SECONDS -lt $deadline ] || return 1
        progress "installing: waiting for another apt to finish" lock
        sleep 3
    done
}

# missing_elsewhere: where there is no apt-get, what is not found, by name.
missing_elsewhere() {
    local item names=""
    # shellcheck disable=SC2086
    set -- $packages
    for item; do
        case ${item#*:} in
            *.h | *.hpp | "") ;;
            *) command -v "${item#*:}" >/dev/null || names+=" ${item%%:*}" ;;
        esac
    done
    # shellcheck disable=SC2086
    names+=$(for item; do
        case $item in *.h | *.hpp) printf '#if !__has_include(<%s>)\n@ %s\n#endif\n' "${item#*:}" "${item%%:*}" ;; esac
    done | $compiler -E -x c++ - 2>/dev/null | sed -n 's/^@//p' | tr -d '\n') || names+=", perhaps libraries"
    [ -z "$names" ] || echo "Not found:$names. There is no apt-get here; these are Debian's names, and vcpkg.json lists the libraries."
}

# --- The build

# can_build: whether there is a folder for it.
can_build() {
    obstacle=$({
        mkdir -p "$build" && echo >"$build/.writable" && rm -f "$build/.writable"
        for file in "$build"/.ninja_* "$build/.lock"; do [ ! -e "$file" ] || : >>"$file"; done
    } 2>&1) && [ -z "$obstacle" ]
}

cannot_build() { give_up "$build cannot be written: ${obstacle##*: }. A copy of this folder, elsewhere, can be built."; }

# use_as_it_is PROGRAM: what has been built where nothing can be.
use_as_it_is() {
    [ -x "$1" ] && ! built_elsewhere || cannot_build
    local newer
    newer=$(find "$root/grader" "$root/starter/rt" "$root/assignment.toml" -newer "$1" -print -quit)
    [ -z "$newer" ] || say "The grader is older than ${newer#"$root/"}, and $build cannot be written: it grades as it is."
}

# built_elsewhere: a folder that has been moved or copied, or is of another generator.
built_elsewhere() {
    [ -e "$build/CMakeCache.txt" ] &&
        [ "$(grep -cxF -e "CMAKE_HOME_DIRECTORY:INTERNAL=$root" -e CMAKE_GENERATOR:INTERNAL=Ninja "$build/CMakeCache.txt")" != 2 ]
}

# built_for_another: whether the build makes use of instructions that this processor lacks.
built_for_another() {
    local there="" name
    [ -e "$build/instructions" ] && there=$(grep -m 1 ^flags /proc/cpuinfo 2>/dev/null) || return 1
    for name in $(<"$build/instructions"); do
        [[ "$there " == *" $name "* ]] || return 0
    done
    return 1
}

disk_is_full() {
    [[ $output == *"No space left on device"* ]] || [ "$(df --output=avail "$build" | tail -n 1)" -lt 1000 ]
}

# build_release TARGET... [-- CMAKE OPTIONS]: configures where that is to be done, and builds.
build_release() {
    local targets=()
    while [ $# -gt 0 ] && [ "$1" != -- ]; do targets+=("$1"); shift; done
    exec {lock}>>"$build/.lock"
    flock -n "$lock" || quietly "waiting for another build here" flock "$lock" || true
    if [ $# -gt 0 ] || [ ! -e "$build/build.ninja" ] || [ -e "$build/.configuring" ] ||
        built_elsewhere || built_for_another; then
        configure "${@:2}"
    fi

    local at=0 total=0 began=$SECONDS skip="" aside="" load=0 left
    # a step takes 1.5 s of one processor, whose time is shared with what else runs: in hundredths of a second
    read -r load _ 2>/dev/null </proc/loadavg || true
    local step=$((150 * (processors + ${load%.*}) / processors / processors))
    if [ ! -e "$build/.ninja_log" ]; then
        total=$(ninja -C "$build" -t commands "${targets[@]}" 2>/dev/null | wc -l) || total=0
        left=$(in_words $((total * step / 100)))
        [ "$step" -lt $((300 / processors)) ] || left+=" beside what else runs on this machine"
        say "Building, the first time: $total steps, $left."
    fi
    NINJA_STATUS='[%f/%t] ' follow build_line cmake --build "$build" --target "${targets[@]}" && exec {lock}>&- && return
    ! disk_is_full || give_up "The disk is full, so the build failed."
    [[ $output =~ assignment\.toml:[0-9]+:[0-9]+: ]] && exit 2  # said above; whoever wrote it mends it
    give_up "The build failed (above). The next call goes on from here; after rm -r $build it starts afresh."
}

# The counts of ninja become progress; warnings and errors are shown as they are, without the commands.
build_line() {
    if [[ ${1-} =~ ^\[([0-9]+)/([0-9]+)\]\ (Re-)? ]]; then
        [ -z "${BASH_REMATCH[3]}" ] || return 0
        at=${BASH_REMATCH[1]} total=${BASH_REMATCH[2]} aside=""
    elif [ $# -gt 0 ]; then
        output+=$1$'\n'
        case $1 in
            "-- "*) aside=1 ;;  # a message that may go on in the next lines
            "ninja: no work to do." | "ninja: build stopped:"*) ;;
            "CMake "*) aside="" ;;&
            FAILED:*) set -- "${1:0:100}" ;;&  # of dozens of files the first
            *) [ -n "$skip$aside" ] || say "$1" ;;
        esac
        [[ $1 == FAILED:* ]] && skip=1 || skip=""
        return 0
    fi
    # what was forecast, until dozens of steps have shown better
    local text="building: $((SECONDS - began)) s" tenth=$milestone
    local left=$(((total - at) * (step / 5 + SECONDS - began) / (20 + at)))
    [ "$total" = 0 ] || text="building: $at of $total"
    [ "$at" = "$total" ] || text+=", $(in_words $left) left"
    [ "$total" -lt 20 ] || tenth=$((10 * at / total))
    progress "$text" "$tenth"
}

# configure [CMAKE OPTIONS]: what failed or was interrupted half way starts afresh.
configure() {
    # what was chosen, as flags.cmake has it, goes along
    local march=""
    march=$(sed -n 's/^RT_MARCH:STRING=/-DRT_MARCH=/p' "$build/CMakeCache.txt" 2>/dev/null) || true
    if [ -e "$build/.configuring" ] || built_elsewhere; then rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles"; fi
    touch "$build/.configuring"
    if quietly "configuring" env -C "$root" cmake --preset release ${march:+"$march"} "$@"; then
        rm "$build/.configuring"
        return
    fi
    if [[ $output == *"CMake Error"* ]]; then
        printf '%s' "$output" | sed -n '/CMake Error/,$ { /^-- /! p }' >&2
    else
        printf '%s' "$output" >&2
    fi
    ! disk_is_full || give_up "The disk is full, so the project could not be configured."
    case $output in
        *CMAKE_CXX_COMPILER* | *"simple test program"*) say "There is no C++ compiler here that works." ;;
        *) command -v apt-get >/dev/null || missing_elsewhere >&2 ;;
    esac
    give_up "The project could not be configured (above)."
}
