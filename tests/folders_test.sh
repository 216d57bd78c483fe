#!/usr/bin/env bash
# folders_test.sh BUILD [--build]: folders with odd names, copied and moved ones, and the surroundings of a process: TMPDIR, HOME,
# locale, umask, line ends of a working copy. What is wrong with them is said, with exit code 3, or does not matter; it is never
# a verdict on a submission. With --build also the whole project, copied with its build into a folder with an odd name
# and built there, which takes ten minutes of one processor.
set -uo pipefail
build=$(cd "$1" && pwd)
project=$PWD grade=$build/grader/grade
if [ "${2-}" = --mounts ]; then
    # in a mount namespace: where nothing can be started from /tmp and /var/tmp
    failures=0 work=$PENUMBRA_WORK
    # shellcheck source=tests/expect.sh
    . <(sed '/^work=/d; /^trap/d; /^failures=/d' tests/expect.sh)
    noexec=$build/noexec
    mkdir -p "$noexec"
    mount -t tmpfs -o noexec tmpfs "$noexec" || exit 77
    expect 0 "3 of 3" env TMPDIR="$noexec" "$grade" solution phong
    expect 0 "0" echo "$(find "$noexec" -type f | wc -l)"
    mount -t tmpfs -o noexec tmpfs /tmp
    mount -t tmpfs -o noexec tmpfs /var/tmp
    expect 0 "3 of 3" env TMPDIR="$noexec" HOME=/nowhere "$grade" solution phong
    expect 0 "" test -z "$(find "$build/grader" -maxdepth 1 -name 'grade-*')"
    mount --bind "$build/grader" "$build/grader" && mount -o remount,bind,ro "$build/grader"
    expect 3 "there is no folder for temporary files; expected one in TMPDIR" env TMPDIR="$noexec" HOME=/nowhere "$grade" solution phong
    expect 3 "$noexec: mounted noexec: no program runs there" env TMPDIR="$noexec" HOME=/nowhere "$grade" stress solution --only phong
    exit "$failures"
fi
# shellcheck source=tests/expect.sh
. "$(dirname "$0")/expect.sh"
odd="$work/Übung (1) & Lösung's \$HOME"
mkdir "$odd"

# a kit in such a folder, wherever it is called from, and moved
expect 0 "$odd/kit" "$grade" hand-out "$odd/kit"
cp solution/phong.cpp "$odd/kit/starter/fragments"
expect 0 "3 of 3" "$odd/kit/grade" phong
expect 0 "3 of 3" env -C "$odd/kit" ./grade starter phong --html "a & b's page" --json "$odd/the record.json"
expect 0 '"schema"' cat "$odd/the record.json"
expect 0 "</html>" cat "$odd/kit/a & b's page/index.html"
expect 0 "the same, bit by bit" env -C "$odd/kit" ./grade picture scenes/phong.toml --mine phong -o "$odd/my picture.png" --size 16x16
mv "$odd/kit" "$odd/ä kit"
expect 0 "3 of 3" "$odd/ä kit/grade" phong
ln -s "$odd/ä kit/grade" "$work/call it"
expect 0 "3 of 3" "$work/call it" phong

# submissions with such names
cp -r solution "$odd/Grüße, & more"
expect 0 "3 of 3" "$grade" "$odd/Grüße, & more" phong --html "$odd/page" --json "$odd/a.json"
tar -C solution -czf "$odd/it's (mine).tar.gz" phong.cpp
expect 0 "3 of 3" "$grade" "$odd/it's (mine).tar.gz" phong
cp -r solution "$work/"$'\xff'
expect 0 "3 of 3" "$grade" "$work/"$'\xff' phong --html "$odd/page" --json "$odd/a.json"
expect 0 "hash" "$build/raytrace" scenes/phong.toml --size 8x8 -o "$odd/a b.exr"

# a build that has been copied or moved does not grade with the files of the first one
mkdir -p "$work/copy/build/release/grader"
cp "$grade" "$work/copy/build/release/grader"
expect 3 "not there; expected grade in the folder where it was built" "$work/copy/build/release/grader/grade" solution phong
cp "$build/toolchain.toml" "$work/copy/build/release"
expect 3 "was built as part of $build and has been moved or copied" "$work/copy/build/release/grader/grade" solution phong
expect 0 "--html" "$work/copy/build/release/grader/grade" --help
ln -s "$build" "$work/linked"
expect 0 "3 of 3" "$work/linked/grader/grade" solution phong
sed "s|^compiler = .*|compiler = \"/usr/bin/none++\"|" "$build/toolchain.toml" >"$work/no_compiler.toml"
expect 3 "/usr/bin/none++: the compiler of the build is not there" "$grade" solution phong --toolchain "$work/no_compiler.toml"
sed "s|^includes = \[\"[^\"]*|includes = [\"$work/gone|" "$build/toolchain.toml" >"$work/no_headers.toml"
expect 3 "rt/fragments.h: not there" "$grade" solution phong --toolchain "$work/no_headers.toml"

# temporary files: another place where TMPDIR is none
: >"$work/file"
for place in "$work/missing" "$work/file" "" "$odd" "."; do
    expect 0 "3 of 3" env TMPDIR="$place" "$grade" solution phong
done
expect 0 "3 of 3" env TMPDIR="$odd" "$grade" solution phong --trusted
expect 0 "$work/again" env TMPDIR="$odd" "$grade" hand-out "$work/again"
if unshare --user --map-root-user --mount true 2>/dev/null; then
    PENUMBRA_WORK=$work unshare --user --map-root-user --mount "$0" "$build" --mounts
    code=$?
    rmdir "$build/noexec" 2>/dev/null
    [ $code = 77 ] || failures=$((failures + code))
else
    echo "no mount namespaces here: noexec is not tested"
fi

# no home, another language, files for oneself alone
expect 0 "3 of 3" env -u HOME -u XDG_CACHE_HOME "$grade" solution phong
expect 0 "3 of 3" env HOME=/nowhere "$odd/ä kit/grade" phong
expect 0 "3 of 3" env -i "$grade" solution phong
german=(LC_ALL=de_DE.UTF-8 LANGUAGE=de)
if localedef -i de_DE -f UTF-8 "$work/de_DE.UTF-8" 2>/dev/null; then german+=(LOCPATH="$work"); fi
# shellcheck disable=SC2086,SC2317  # words; expect calls them
in_language() { env $language "$@"; }
# shellcheck disable=SC2317
private() { (umask 077 && "$@"); }
for language in "${german[*]}" LC_ALL=C; do
    expect 0 "3 of 3" in_language "$grade" "$odd/Grüße, & more" phong --json "$work/a.json"
    expect 0 "hash" in_language "$build/raytrace" scenes/phong.toml --size 8x8 -o "$work/a.exr"
    expect 0 "3 of 3" in_language "$odd/ä kit/grade" phong
    sed 's/phong(/phonk(/' solution/phong.cpp >"$work/broken.cpp"
    mkdir -p "$work/broken"
    mv "$work/broken.cpp" "$work/broken/phong.cpp"
    expect 0 "error: no function phong is defined here" in_language "$grade" "$work/broken" phong
done
expect 0 "$work/private" private "$grade" hand-out "$work/private"
cp solution/phong.cpp "$work/private/starter/fragments"
expect 0 "3 of 3" private "$work/private/grade" phong --html "$work/private page"
expect 0 "3 of 3" private "$grade" solution phong

# working copies where git makes CRLF of line ends: of the project as it is committed, and of what is handed out
if git clone -q -c core.autocrlf=true --depth 1 "file://$project" "$work/cloned" 2>/dev/null; then
    expect 1 "" env -C "$work/cloned" grep -rlI $'\r' grade check .ci tests/expect.sh starter solution scenes
    expect 0 "clean" echo "clean$(git -C "$work/cloned" status --porcelain)"
    git -C "$work/again" init -q
    git -C "$work/again" -c core.autocrlf=true add .
    rm "$work/again/grade"
    git -C "$work/again" -c core.autocrlf=true checkout -q -- grade
    expect 1 "" grep $'\r' "$work/again/grade"
else
    echo "no clone of a repository here: line ends are not tested"
fi

# the whole of it
if [ "${2-}" = --build ]; then
    whole="$odd/Ganz & (gar)"
    mkdir -p "$whole/build/release"
    tar -C "$project" --exclude ./build --exclude ./.git -cf - . | tar -C "$whole" -xf -
    cp -r "$build/." "$whole/build/release"
    expect 3 "has been moved or copied" "$whole/build/release/grader/grade" solution phong
    sed -i 's/name = "phong", points = 3/name = "phong", points = 7/' "$whole/assignment.toml"
    cp solution/moved.cpp "$whole/starter/fragments"
    expect 0 "7 of 7" env -C "$work" "$whole/grade" "$whole/solution" phong
    expect 0 "2 of 2" env -C "$work" "$whole/grade" "$whole/starter" moved
    expect 0 "$odd/handed out" "$whole/grade" hand-out "$odd/handed out"
    cp solution/phong.cpp "$odd/handed out/starter/fragments"
    expect 0 "7 of 7" "$odd/handed out/grade" phong
    expect 0 "Linking" cmake --build "$whole/build/release" --target raytrace
    expect 0 "hash" "$whole/build/release/raytrace" scenes/phong.toml --size 8x8 -o "$work/a.exr"
fi

end
