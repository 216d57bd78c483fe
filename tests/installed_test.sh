#!/usr/bin/env bash
# cmake --install: what runs from a folder that its users cannot write to, each with a cache of their own.
# installed_test.sh BUILD
set -uo pipefail
# shellcheck source=tests/expect.sh
. "$(dirname "$0")/expect.sh"
build=$1 prefix=$work/usr home=$work/home
chmod 755 "$work"

# whatever the umask of who installs
(umask 077 && cmake --install "$build" --prefix "$prefix" >"$work/said" 2>&1) || { cat "$work/said"; exit 1; }
expect 0 "" test -f "$prefix/share/doc/penumbra/copyright"
expect 0 "lib/penumbra/grade" readlink "$prefix/bin/grade"
touch "$work/now"

mkdir -p "$home" "$work/mine/fragments"
cp solution/moved.cpp "$work/mine/fragments"
python3 -c 'import shutil, sys; shutil.make_archive(sys.argv[1], "zip", sys.argv[1])' "$work/mine"
as=()
if [ "$(id -u)" = 0 ]; then
    chmod 644 "$work/mine.zip"
    chown 65534:65534 "$home"
    as=(setpriv --reuid=65534 --regid=65534 --clear-groups)
fi
# shellcheck disable=SC2317  # called by expect
by_user() { "${as[@]}" env -u XDG_CACHE_HOME HOME="$home" "$prefix/bin/grade" "$@"; }
expect 0 "passed              2 of 2" by_user "$work/mine.zip" moved --seed 1
expect 0 "fragments.h.gch" find "$home/.cache/penumbra" -name fragments.h.gch
expect 2 "no submission; expected a folder" by_user
expect 2 "a kit is handed out by the project" by_user hand-out "$home/kit"
# root could write there
expect 0 "passed              2 of 2" env HOME="$work/other" "$prefix/bin/grade" "$work/mine.zip" moved --seed 1
expect 0 "" test -z "$(find "$prefix" -newer "$work/now")"

# Below /usr, which all steps read, is only a link to it; the reference's objects are nobody's to include.
(DESTDIR="$work/root" cmake --install "$build" --prefix /usr >"$work/said" 2>&1) || { cat "$work/said"; failures=1; }
expect 0 "../../opt/penumbra/grade" readlink "$work/root/usr/bin/grade"
expect 0 "" test ! -e "$work/root/usr/lib"
expect 0 "passed              2 of 2" env HOME="$work/other" "$work/root/usr/bin/grade" "$work/mine.zip" moved --seed 1
below=/usr/share/doc
mkdir "$work/thief"
printf 'asm(".globl x\\nx: .incbin \\"%s/grader/%s-linux/reference/moved.o\\"");\n' "$below" "$(uname -m)" |
    cat - solution/moved.cpp >"$work/thief/moved.cpp"
# shellcheck disable=SC2016,SC2317
in_usr() {
    unshare --mount --map-root-user sh -c 'mount --bind "$1" "$2" && shift 2 && exec "$@"' sh "$work/root/opt/penumbra" \
        "$below" "$below/grade" "$work/thief" moved --seed 1
}
if unshare --mount --map-root-user true 2>/dev/null; then
    expect 0 "file not found" in_usr
fi

# over what is there
(cmake --install "$build" --prefix "$prefix" >"$work/said" 2>&1) || { cat "$work/said"; failures=1; }
expect 0 "passed              2 of 2" by_user "$work/mine.zip" moved --seed 1
end
