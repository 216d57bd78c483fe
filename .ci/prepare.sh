# Sourced by ./grade, ./check and .ci/run: installs and builds what they need. `root` is the project's folder; `yes` is
# not empty when nobody is to be asked. Exit status 3: this machine cannot do it.
# shellcheck shell=bash

# Debian's and Ubuntu's names. Elsewhere, CMake says what it misses; vcpkg.json lists the same libraries.
packages="cmake g++ ninja-build bubblewrap libarchive-dev libboost-math-dev libcli11-dev libfmt-dev libglm-dev
    libopenexr-dev libpng-dev libtbb-dev libtinyobjloader-dev libtomlplusplus-dev nlohmann-json3-dev"
test_packages="catch2 clang patch python3 shellcheck valgrind"
mitsuba_packages="python3-venv"

# install_packages NAME...: those that are missing, after asking.
install_packages() {
    command -v dpkg-query >/dev/null && command -v apt-get >/dev/null || return 0
    local name missing="" sudo="" answer=""
    for name; do
        dpkg-query -W -f='${Status}' "$name" 2>/dev/null | grep -q 'ok installed' || missing="$missing $name"
    done
    [ -n "$missing" ] || return 0

    [ "$(id -u)" = 0 ] || sudo="sudo "
    local install="${sudo}apt-get install -y --no-install-recommends$missing"
    echo "Missing packages:$missing" >&2
    if [ -z "$yes" ] && [ -t 0 ]; then
        read -r -p "Install them now? [y/N] " answer
        case $answer in [yY]*) ;; *) echo "Then type: $install" >&2; exit 3 ;; esac
    elif [ -z "$yes" ] && [ -n "$sudo" ]; then
        echo "To install them, type: $install" >&2
        exit 3
    fi
    if [ -n "$sudo" ] && ! command -v sudo >/dev/null; then
        echo "There is no sudo here. As root, type: ${install#sudo }" >&2
        exit 3
    fi

    echo "Installing them..." >&2
    local log
    log=$(mktemp)
    export DEBIAN_FRONTEND=noninteractive
    # word splitting is meant: both are commands
    # shellcheck disable=SC2086
    if ! { ${sudo}apt-get update && $install; } >"$log" 2>&1; then
        tail -n 15 "$log" >&2
        echo "The packages could not be installed (above). Is there a network? The command was: $install" >&2
        exit 3
    fi
    rm -f "$log"
}

# build_release TARGET [CMAKE OPTIONS...]: configures, the first time or with options, and builds; silent unless it fails,
# but for progress of the first time on a terminal.
build_release() {
    local folder=$root/build/release target=$1
    shift
    mkdir -p "$folder"
    if { [ $# -gt 0 ] || ! [ -f "$folder/build.ninja" ]; } &&
        ! (cd "$root" && cmake --preset release "$@") >"$folder.log" 2>&1; then
        grep -A 6 'CMake Error' "$folder.log" >&2 || cat "$folder.log" >&2
        echo "The project cannot be configured (above; all of it is in $folder.log)." >&2
        exit 3
    fi
    if [ -t 1 ] && ! [ -e "$folder/.built-$target" ]; then
        cmake --build "$folder" --target "$target" || exit 3
    elif ! cmake --build "$folder" --target "$target" >"$folder.log" 2>&1; then
        cat "$folder.log" >&2
        exit 3
    fi
    touch "$folder/.built-$target"
}
