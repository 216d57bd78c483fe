#!/usr/bin/env bash
# picture_watch_test.sh BUILD: a student's loop at the command line: grade picture, names of fragments, grade --watch, what
# has changed since the last run, Ctrl-C.
set -uo pipefail
build=$(cd "$1" && pwd)
# shellcheck source=tests/expect.sh
. "$(dirname "$0")/expect.sh"
"$build/grader/grade" hand-out "$work/kit" >/dev/null || exit 1
solution=$PWD/solution
cd "$work/kit" || exit 1

# a name that is none, a folder that is none, two folders
expect 2 "hit_spere: no fragment has this name, and there is no such folder; expected hit_sphere?" ./grade hit_spere
expect 2 "starters/: not there" ./grade starters/
expect 2 "one submission too many" ./grade starter grader
expect 2 "a kit grades folders" ./grade grader/x86_64-linux/librt.a
expect 2 "a kit is handed out by the project" ./grade hand-out "$work/again"
expect 0 "not started" ./grade hit_sphere
expect 0 "next: fill in starter/fragments/hit_sphere.cpp, then ./grade hit_sphere" ./grade hit_sphere
(cd starter && expect 0 "fill in fragments/hit_sphere.cpp" ../grade hit_sphere; exit "$failures") || failures=$((failures + 1))
ln -s "$work/kit/grade" "$work/link"
(cd / && expect 0 "fill in" "$work/link" hit_sphere; exit "$failures") || failures=$((failures + 1))

# gained, lost
expect 0 "0 of 100" ./grade
cp "$solution/phong.cpp" starter/fragments/
expect 0 "phong: passed, was not started (+3 points)" ./grade phong moved
expect 0 "next: fill in starter/fragments/shadow_ray.cpp" ./grade phong
sed -i 's|cosine / pi|cosine|' starter/fragments/phong.cpp
expect 0 "phong: failed, was passed (-3 points)" ./grade
expect 0 "phong: failed, was passed" cat build/report/index.html
# of one's own it is always the same: neither a seed nor what walls there are
expect 1 "" grep -q "^seed" <(./grade phong)
expect 0 "1/pi is missing" ./grade phong
expect 0 "next: mend starter/fragments/phong.cpp, then ./grade phong" ./grade phong
# what is wrong goes before what is blank
expect 0 "next: mend starter/fragments/phong.cpp, then ./grade phong" ./grade hit_sphere phong
cp "$solution/hit_quad.cpp" starter/fragments/
expect 0 "next: mend starter/fragments/phong.cpp, then ./grade phong" ./grade hit_quad
# the call that the hint shows, without typing it
expect 1 "must be" ./grade call phong
expect 1 "" grep -q "Since the last run" <(./grade phong)

# all anew, and kept for the next
expect 1 "" grep -q "as before" <(./grade --fresh phong)
expect 0 "checks as before" ./grade phong
# a file that is missing goes where the others are
mv starter/fragments/moved.cpp "$work/moved.cpp"
expect 0 "next: fill in starter/fragments/moved.cpp" ./grade moved
mv "$work/moved.cpp" starter/fragments/
# another map, which is right, is not what the solution gives
sed 's/u\.x/u.t/g; s/u\.y/u.x/g; s/u\.t/u.y/g' "$solution/uniform_disk.cpp" >starter/fragments/uniform_disk.cpp
expect 0 "another map is as good" ./grade call uniform_disk 'u = (0.3, 0.2)'

# yours, the right one, the difference
expect 0 "of the pixels differ" ./grade picture scenes/phong.toml --mine phong -o "$work/a.png" --size 60x40
for file in a.png a_mine.exr a_right.exr a_difference.exr; do expect 0 "$file" ls "$work/$file"; done
expect 0 "the same, bit by bit" ./grade picture scenes/mirror.toml --mine phong -o "$work/b.png" --size 60x40
expect 0 "pictures/phong.png: yours" ./grade picture scenes/phong.toml --mine phong --size 60x40
expect 0 "/pictures/" grep pictures .gitignore
# beside the scenes lie the handout's
before=$(cat scenes/pictures/* | sha256sum)
(cd scenes && expect 0 "pictures/phong.png: yours" ../grade picture phong.toml --mine phong --size 60x40; exit "$failures") || failures=$((failures + 1))
expect 0 "$before" bash -c 'cat scenes/pictures/* | sha256sum'
expect 2 "moved: not started" ./grade picture scenes/phong.toml --mine moved -o "$work/c.png"
expect 2 "expected phong?" ./grade picture scenes/phong.toml --mine phon -o "$work/c.png"
expect 2 "none.toml" ./grade picture scenes/none.toml
expect 2 "expected --out NAME.png" ./grade picture scenes/phong.toml -o "$work/c.jpg"
expect 0 "the same, bit by bit" ./grade picture scenes/phong.toml -o "$work/c.png" --size 16x16 --mine phong "$solution"
sed -i 's|return glow|__builtin_trap(); return glow|' starter/fragments/phong.cpp
expect 1 "no picture of yours: ended by" ./grade picture scenes/phong.toml --mine phong -o "$work/d.png" --size 60x40
expect 0 "PNG" head -c 8 "$work/d.png"

# a loop that does not end is stopped soon, and its line is told; that of a crash as well
cat >starter/fragments/uniform_disk.cpp <<'END'
#include "rt/fragments.h"
namespace rt {
DiskSample uniform_disk(vec2 u) {
    vec2 p = 2.0 * u - vec2(1);
    while (dot(p, p) <= 2) p = 2.0 * u - vec2(1);
    return {p, 1 / pi};
}
}  // namespace rt
END
expect 1 "ran longer than 5 s" timeout 200 ./grade picture uniform_disk
expect 1 "uniform_disk.cpp:5: the loop here does not end" timeout 200 ./grade picture uniform_disk
expect 1 "uniform_disk.cpp:5: in the loop here its time ended" \
    timeout 200 ./grade picture scenes/depth_of_field.toml --mine uniform_disk -o "$work/e.png" --size 24x16 --samples 4
expect 1 "uniform_disk.cpp:5: the loop here does not end" timeout 200 ./grade call uniform_disk 'u = (0, 0)'
sed -i 's|while.*|p.x = *static_cast<volatile double*>(nullptr);|' starter/fragments/uniform_disk.cpp
expect 1 "uniform_disk.cpp:5: a null pointer is followed" ./grade call uniform_disk 'u = (0, 0)'
expect 1 "uniform_disk.cpp:5: a null pointer is followed" ./grade picture uniform_disk

# watch: a verdict, another one after an edit, and the end
./grade --watch phong >"$work/watched" 2>&1 &
watcher=$!
# shellcheck disable=SC2317  # expect calls it
waited() { for _ in $(seq 300); do grep -q "$1" "$work/watched" && return; sleep 0.1; done; return 1; }
expect 0 "" waited "crashed"
cp "$solution/phong.cpp" starter/fragments/
expect 0 "" waited "phong: passed, was crashed"
kill -INT $watcher
wait $watcher || { echo "FAILED: --watch ends with another code than 0 after Ctrl-C"; failures=$((failures + 1)); }

# Ctrl-C during a grading: the end soon, with 130; what is done stays done
cp "$solution"/*.cpp starter/fragments/
setsid ./grade --json "$work/part.json" >"$work/said" 2>&1 &
grading=$!
for _ in $(seq 300); do [ "$(find build/kept -name 'integrate*' 2>/dev/null | wc -l)" -gt 4 ] && break; sleep 0.1; done
kill -INT -- -$grading
code=0
wait $grading || code=$?
[ $code = 130 ] || { echo "FAILED: an interrupted grading ends with another code than 130"; failures=$((failures + 1)); }
expect 0 '"complete": false' grep complete "$work/part.json"
expect 0 "checks as before" ./grade

# another folder than one's own is graded behind what walls the machine has
cp -r starter/fragments "$work/other"
expect 0 "3 of 3" ./grade "$work/other" phong
expect 0 "$(if [ -x /usr/bin/bwrap ]; then echo bubblewrap; else echo "limits only"; fi)" ./grade "$work/other" phong
expect 0 "2 of 2 families" ./grade stress --only mirror_direction,moved

# other machines, other compilers
if command -v clang++ >/dev/null; then expect 0 "3 of 3" env CXX=clang++ ./grade phong --fresh; fi
expect 3 "there is no C++ compiler here" env PATH=/nonexistent "grader/$(uname -m)-linux/grade" phong
mv "grader/$(uname -m)-linux" grader/m68k-linux
expect 3 "expected one of: m68k-linux" ./grade phong
mv grader/m68k-linux "grader/$(uname -m)-linux"

# where nothing can be kept, it is graded all the same
if [ "$(id -u)" = 0 ]; then user=(setpriv --reuid=65534 --regid=65534 --clear-groups); else user=(); fi
chmod 755 "$work"
rm -rf build
chmod -R a-w .
expect 0 "3 of 3" env -u XDG_CACHE_HOME HOME=/nonexistent "${user[@]}" ./grade phong
expect 3 "Permission denied" env HOME=/nonexistent "${user[@]}" ./grade phong --html build/page
chmod -R u+w .

end
