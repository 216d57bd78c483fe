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

# what an option cannot be, and a file in place of a folder, are the caller's mistakes
for number in nan inf -1 1e300 two; do
    expect 2 "expected a number from 0 to" "$grade" solution moved --require "$number"
done
expect 2 "expected a number from 1 to 600" "$grade" solution moved --time-limit nan
for seed in 99999999999999999999999 -1 abc 1.5 nan ""; do
    expect 2 "expected a whole number from 0 to 18446744073709551615" "$grade" solution moved --seed "$seed"
done
expect 0 "seed 18446744073709551615" "$grade" solution moved --seed 18446744073709551615
expect 2 "is a folder; expected the name of a file" "$grade" solution moved --json "$work"
expect 2 "a file is in its place; expected a folder" "$grade" solution moved --html "$work/a.json"
expect 2 "a file is in its place; expected a folder" "$grade" solution moved --keep "$work/a.json"
expect 2 "a file is in its place; expected a folder" "$grade" solution moved --html "$work/a.json/page"
mkfifo "$work/fifo.zip"
expect 2 "is neither a file nor a folder" timeout 20 "$grade" "$work/fifo.zip"
expect 2 "is no regular file; expected a scene" timeout 20 "$grade" picture /dev/zero
# who reads no further is no trouble of the machine
for _ in 1 2 3; do "$grade" describe 2>>"$work/unread" | head -1 >/dev/null; done
expect 0 "" test ! -s "$work/unread"

# colours for who wants them
if command -v script >/dev/null; then
    on_terminal() { TERM=xterm script -qec "$1 $grade solution moved --seed 5" /dev/null; }
    expect 0 $'\033[32m' on_terminal ""
    for without in NO_COLOR=1 TERM=dumb CLICOLOR=0; do
        expect 1 "" grep -q $'\033\[3' <(on_terminal "env $without")
    done
    expect 1 "" grep -q $'\033' <(on_terminal "env TERM=dumb")
fi

# a class: what is no class, and what no call can go on with
mkdir -p "$work/class/ada" "$work/class/bob"
cp solution/moved.cpp "$work/class/ada/"
cp starter/fragments/moved.cpp "$work/class/bob/"
for inside in class class/out class/ada/deeper; do
    expect 2 "is within $work/class" "$grade" class "$work/class" -o "$work/$inside"
done
expect 2 "s.tar.gz: is a file; expected a folder" "$grade" class "$work/s.tar.gz" -o "$work/graded"
expect 2 "a file is in its place; expected a folder" "$grade" class "$work/class" -o "$work/a.json"
expect 2 "expected a whole number" "$grade" class "$work/class" -o "$work/graded" --seed 1x
expect 0 "2 graded now" "$grade" class "$work/class" -o "$work/graded" --seed 5
for text in "" " 12x" "garbage" "12 13"; do
    printf '%s' "$text" >"$work/graded/seed"
    expect 2 "graded/seed: holds no seed" "$grade" class "$work/class" -o "$work/graded"
done
expect 0 "2 as before" "$grade" class "$work/class" -o "$work/graded" --seed 5
cp -r "$work/graded" "$work/later"
expect 0 "2 as before" "$grade" compare "$work/graded" "$work/later"
expect 2 "none: not there; expected a record" "$grade" compare "$work/graded" "$work/none"
expect 2 "there is no folder $work/none" "$grade" compare "$work/graded" "$work/later" --better "$work/none/x.csv"
rm -r "$work/class/bob"
expect 0 "1 as before" "$grade" class "$work/class" -o "$work/later"
expect 1 "bob: gone, was 0" "$grade" compare "$work/graded" "$work/later"
expect 0 "1 graded now" "$grade" class "$work/class" -o "$work/other" --seed 6
expect 2 "was graded with another seed" "$grade" merge "$work/whole" "$work/graded" "$work/other"

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
# on a page the call names whose fragment it is
"$grade" "$work/broken" moved --seed 5 --html "$work/page" >/dev/null 2>&1
expect 0 "--of $work/broken" cat "$work/page/index.html"

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
