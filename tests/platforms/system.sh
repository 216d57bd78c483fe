# Sourced by debian, kit and package: minimal Debian systems, and commands in them. Exit status 77: not on this machine.
# shellcheck shell=bash
project=$(dirname "$(dirname "$(dirname "$(readlink -f -- "${BASH_SOURCE[0]}")")")")

cannot() {
    printf 'skipped: %s\n' "$*" >&2
    exit 77
}

# require_means: what it takes to make such a system and to run something in it.
require_means() {
    [ "$(id -u)" = 0 ] || cannot "only root can make a Debian system and mount what it needs"
    unshare --mount --pid --fork true 2>/dev/null || cannot "namespaces cannot be made here"
}

# begin OPTION WORDS...: reads NAME [--system FOLDER] [OPTION FILE] for a script that has a usage(). Sets name, folder, given: the
# file, and work, a folder that goes at the end.
begin() {
    local option=$1
    shift
    name="" folder="" given=""
    while [ $# -gt 0 ]; do
        case $1 in
            -h | --help) usage; exit ;;
            --system) folder=$(readlink -m -- "${2:?a folder is missing}"); shift ;;
            "$option") given=$(readlink -e -- "${2:?its name is missing}"); shift ;;
            -*) name=""; break ;;
            *) name=$1 ;;
        esac
        shift
    done
    [ -n "$name" ] || { usage >&2; exit 2; }
    require_means
    work=$(mktemp -d)
    trap 'rm -rf --one-file-system "$work"' EXIT
    [ -n "$folder" ] || folder=$work/system
}

# make_system NAME FOLDER [PACKAGES]: Debian's minimal system of that name, unless there is one in the folder.
make_system() {
    if [ -e "$2/etc/debian_version" ]; then return; fi
    command -v debootstrap >/dev/null || cannot "there is no debootstrap here (apt-get install debootstrap)"
    mkdir -p "$2"
    if ! debootstrap --variant=minbase ${3:+--include="$3"} "$1" "$2" http://deb.debian.org/debian >"$2.log" 2>&1; then
        tail -n 5 "$2.log" >&2
        cannot "debootstrap could not make the system (above; whole in $2.log)"
    fi
    rm -f "$2.log"
}

# in_system FOLDER COMMAND...: as root, with the system as its root. It has processes and mounts of its own, which go when
# the command ends; network and devices are this machine's. Not chroot: there the kernel refuses user namespaces, and so
# no sandbox would be tested.
in_system() {
    local folder=$1
    shift
    [ ! -e /etc/resolv.conf ] || cp -L /etc/resolv.conf "$folder/etc/resolv.conf"
    # shellcheck disable=SC2016
    unshare --mount --pid --fork --kill-child bash -ec '
        mount --bind "$0" "$0"
        mount -t proc proc "$0/proc"
        mount --rbind /sys "$0/sys"
        mount --rbind /dev "$0/dev"
        cd "$0"
        pivot_root . .
        umount -l .
        env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 "$@"
        exit' "$folder" "$@"
}

# describe_system FOLDER: its name, and its compiler's
describe_system() {
    # shellcheck disable=SC2016
    in_system "$1" bash -c '. /etc/os-release; echo "$PRETTY_NAME, GCC $(g++ -dumpfullversion), $(nproc) processors"'
}

# timed COMMAND...: its user and system time go to the file $work/times, in seconds; stderr to stdout
timed() {
    local TIMEFORMAT='%U %S'
    { time "$@" </dev/null 2>&3; } 3>&1 2>"$work/times"
}
cpu_seconds() { awk '{ printf "%.1f", $1 + $2 }' "$work/times"; }
