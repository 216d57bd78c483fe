#!/usr/bin/env bash
# stress_command_test.sh BUILD: `grade stress`: the solution passes all that is scored, and no family passes less than
# tests/extremes/reach.json says; a naive fragment, a blank and a crash cost their own families; exit codes.
set -uo pipefail
grade=$1/grader/grade
# shellcheck source=tests/expect.sh
. "$(dirname "$0")/expect.sh"

expect 0 "Ordinary scenes: " "$grade" stress solution --require --time-limit 60 --json "$work/a.json" --html "$work/page"
expect 0 '"schema": "penumbra/stress/v1"' cat "$work/a.json"
expect 0 "<svg class=\"errors\"" cat "$work/page/stress.html"
expect 0 "no family passes less" python3 - "$work/a.json" <<'END'
import json, sys
known = json.load(open("tests/extremes/reach.json"))["reach"]
for f in json.load(open(sys.argv[1]))["families"]:
    have, least = f["reach"], known[f["name"]]
    if least and (not have or have[0] > least[0] or have[1] < least[1]):
        sys.exit(f"{f['name']} passes {have}, before {least}; where that is right, edit tests/extremes/reach.json")
print("no family passes less than before")
END

# blanks are not run; what a fragment does costs its own families alone
expect 0 "not started" "$grade" stress starter --only mirror_length
expect 1 "0 of 1" "$grade" stress starter --only mirror_length --require
cp -r solution "$work/mine"
sed -i 's|return d - 2.0 \* dot(d, n) \* n;|if (d.x > 1e9) __builtin_trap(); return d - 2.0 * dot(d, n) * n;|; s|return d - 2 \* dot|if (d.x > 1e9) __builtin_trap(); return d - 2 * dot|' "$work/mine/mirror_direction.cpp"
sed -i 's|return point + time|if (velocity.x > 1e9) for (volatile int i = 0;; i = i) {} return point + time|' "$work/mine/moved.cpp"
expect 0 "1e-60 to 1e9" "$grade" stress "$work/mine" --only mirror_direction,moved,whitted --time-limit 1 --json "$work/b.json"
expect 0 "ended by" cat "$work/b.json"
expect 0 "ran longer than 1 s" cat "$work/b.json"
expect 0 "3 of 3 families" "$grade" stress "$work/mine" --only mirror_direction,moved,whitted --time-limit 1
sed -i 's|return point|return punkt|' "$work/mine/moved.cpp"
expect 0 "did not build" "$grade" stress "$work/mine" --only moved

# big counts, small here
expect 0 "closed mesh that get out: 0" "$grade" stress solution --only moved --long --rays 2e5
expect 0 "leave a sphere and meet it: 0" "$grade" stress solution --only moved --long --rays 2e5
expect 0 "leave a quad and meet it: 0" "$grade" stress solution --only moved --long --rays 2e5
expect 0 "leave a triangle and meet it: 0" "$grade" stress solution --only moved --long --rays 2e5
mkdir "$work/naive" && cp -r solution "$work/naive/solution"
patch -s -d "$work/naive" -p1 <tests/variants/naive/shadow_no_offset.patch
patch -s -d "$work/naive" -p1 <tests/variants/naive/triangle_moller_trumbore.patch
"$grade" stress "$work/naive/solution" --only moved --long --rays 2e5 --json "$work/e.json" >/dev/null 2>&1
expect 0 "[True, True, True, True]" python3 -c "import json; print([c['faults'] > 0 for c in json.load(open('$work/e.json'))['counts']])"

# the same again but for the times
"$grade" stress solution --only hit_sphere --json "$work/c.json" --jobs 1 >/dev/null 2>&1 && mv "$work/c.json" "$work/d.json"
"$grade" stress solution --only hit_sphere --json "$work/c.json" >/dev/null 2>&1
timeless() { grep -v '_seconds"\|"command"' "$1"; }
expect 0 "" diff <(timeless "$work/c.json") <(timeless "$work/d.json")

expect 2 "no family and no fragment" "$grade" stress solution --only mooved
expect 2 "there is no folder" "$grade" stress solution --json "$work/none/a.json"
expect 2 "not there" "$grade" stress "$work/none"
expect 2 "--jobs" "$grade" stress solution --jobs none
expect 3 "the grader failed" "$grade" stress solution --toolchain "$work/none.toml"
expect 0 "mesh_edges" "$grade" stress --list

end
