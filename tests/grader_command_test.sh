#!/usr/bin/env bash
# grader_command_test.sh BUILD: exit codes and files of the program grade: 0 graded, 1 below --require, 2 usage, 3 the
# machine.
set -uo pipefail
grade=$1/grader/grade
# shellcheck source=tests/expect.sh
. "$(dirname "$0")/expect.sh"

expect 0 "2 of 2" "$grade" solution moved --seed 5 --json "$work/a.json" --html "$work/page"
expect 0 '"schema": "penumbra/result/v2"' cat "$work/a.json"
expect 0 "data:image/png;base64," cat "$work/page/index.html"
# one of a scene with a tree, drawn by one thread in the sandbox
expect 1 "" grep "No picture" "$work/page/index.html"
expect 0 "with the fragments that were graded" cat "$work/page/index.html"
expect 0 "not started" "$grade" starter moved
expect 1 "0 of 2" "$grade" starter moved --require 0.5
expect 0 "2 of 2" "$grade" solution moved --require 2

tar -C solution -czf "$work/s.tar.gz" moved.cpp
expect 0 "2 of 2" "$grade" "$work/s.tar.gz" moved
printf 'no archive' >"$work/s.zip"
expect 2 "s.zip: cannot be unpacked" "$grade" "$work/s.zip"
expect 2 "not there" "$grade" "$work/none"
mkdir "$work/empty"
expect 2 "holds no fragment" "$grade" "$work/empty"
expect 2 "mooved: no fragment has this name, and there is no such folder; expected moved?" "$grade" solution mooved
expect 2 "one submission too many" "$grade" solution tests/example
expect 2 "--jobs" "$grade" solution --jobs none
# a submission may have the name of a command
expect 2 "compare: no fragment has this name, and there is no such folder" "$grade" picture scenes/gallery/gloss.toml compare
expect 2 "there is no folder" "$grade" solution --json "$work/none/a.json"
expect 2 "none.toml" "$grade" solution moved --html "$work/page" --picture "$work/none.toml"
expect 3 "the grader failed" "$grade" solution moved --toolchain "$work/none.toml"

# where the paths of a wrong picture part: the first line that differs is the fragment's own
mkdir "$work/dim"
sed 's/squared \/ (cosine/2 * squared \/ (cosine/' solution/light_sample.cpp >"$work/dim/light_sample.cpp"
expect 0 "of 6" "$grade" "$work/dim" light_sample --seed 5 --html "$work/dim/page"
expect 0 "Where a path parts" cat "$work/dim/page/index.html"
parting=$(sed -n '/^yours:/,/^<\/pre>/p' "$work/dim/page/index.html" | grep -o 'density [0-9.]*' | head -2 | cut -d' ' -f2 | paste -sd' ')
read -r yours right <<<"$parting"
expect 0 "2.000" awk -v yours="$yours" -v right="$right" 'BEGIN { printf "%.3f\n", yours / right }'

# the same seed gives the same record, but for the times
"$grade" solution moved --seed 5 --json "$work/b.json" --html "$work/page" >/dev/null 2>&1
timeless() { grep -v '_seconds"\|"command"\|"date"' "$1"; }
expect 0 "" diff <(timeless "$work/a.json") <(timeless "$work/b.json")

# the compiler's warnings, what sanitizers say, and the simplest call that goes wrong
moved() { printf '#include "rt/fragments.h"\nnamespace rt {\nvec3 moved(vec3 point, vec3 velocity, Real time) {\n%s\n}\n}\n' "$1"; }
mkdir "$work/broken"
moved 'int unused; return point + velocity * moved(velocity, point, time + 1);' >"$work/broken/moved.cpp"
expect 0 "moved.cpp:4:5: warning: unused variable" "$grade" "$work/broken" moved
if "$grade" solution moved --seed 5 | grep -q "bubblewrap"; then
    expect 0 "the function calls itself without end" "$grade" "$work/broken" moved
fi
moved '(void)velocity; return point + vec3(time);' >"$work/broken/moved.cpp"
expect 0 "the answer is the same whatever \`velocity\` is" "$grade" "$work/broken" moved --seed 5 --json "$work/c.json"
expect 0 "./grade call moved " cat "$work/c.json"
expect 0 "moved(vec3(" cat "$work/c.json"

# a sandbox is stated, and so is its absence
expect 0 "the code is its owner's" "$grade" solution moved --trusted

# known variants: really graded, kept, gone on with, and reported
calibrate=("$grade" calibrate mirror_direction --folder "$work/calibration" --gradings 1 --draws 1000 --replicates)
expect 0 "gradings of variants, 0 off" "$grade" calibrate --fast mirror_direction
expect 0 "shard 1/2 is done" "${calibrate[@]}" 64 --shard 1/2
expect 0 "wrong variants failed, real gradings" "${calibrate[@]}" 64 --out "$work/report"
expect 0 "was measured 64 times or more" cat "$work/report/calibration.md"
# more of what is there: only what lacks is measured
expect 0 "was measured 128 times or more" "${calibrate[@]}" 128
# how far it is, where there is no terminal either
expect 0 "1 of " bash -c 'exec "$@" >/dev/null' - "${calibrate[@]}" 128 --report
expect 0 "What was to be shown" cat "$work/report/calibration.md"
expect 0 "</svg>" cat "$work/report/calibration.svg"
expect 2 "expected one like 2/4" "$grade" calibrate --shard 5/4
expect 2 "no variant and no fragment has such a name" "$grade" calibrate nothing_of_the_kind

end
