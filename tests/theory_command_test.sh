#!/usr/bin/env bash
# theory_command_test.sh BUILD: `grade theory` is off without points; a new file, answers that are right, wrong and missing, mistakes
# in the file; exit codes.
set -uo pipefail
grade=$1/grader/grade
# shellcheck source=tests/expect.sh
. "$(dirname "$0")/expect.sh"

expect 2 "this course has no theory part" "$grade" theory

mkdir -p "$work/starter" "$work/of_ada"
{ cat assignment.toml && printf '\n[theory]\npoints = 16\n'; } >"$work/assignment.toml"
sed "s|^source = .*|source = \"$work\"|" "$1/toolchain.toml" >"$work/toolchain.toml"
theory=("$grade" --toolchain "$work/toolchain.toml" theory)
mine=$work/starter/theory.toml

expect 2 "starter/theory.toml:1:1: cannot be read" "${theory[@]}"
expect 2 "--name: is empty; expected your name" "${theory[@]}" --name ""
expect 0 "answer the questions there" "${theory[@]}" --name "Ada Lovelace"
expect 2 "is there already" "${theory[@]}" --name "Ada Lovelace"
expect 1 "0 of 8 right, 0 of 16 points: Ada Lovelace" "${theory[@]}"

# Snell's law by awk, from the number of the question
ior=$(sed -n 's/.*glass of index \([0-9.]*\) .*/\1/p' "$mine")
angle=$(awk -v n="$ior" 'BEGIN { print atan2(1, sqrt(n * n - 1)) * 180 / atan2(0, -1) }')
sed -i "s/^#critical_angle =.*/critical_angle = $angle/" "$mine"
expect 1 "1 of 8 right, 2 of 16 points" "${theory[@]}"
expect 1 "right. Snell" "${theory[@]}"
cp "$mine" "$work/of_ada/"
expect 1 "1 of 8 right, 2 of 16 points" "${theory[@]}" "$work/of_ada"
sed -i 's/^critical_angle = .*/critical_angle = 1/' "$mine"
expect 1 "wrong. With other numbers" "${theory[@]}"
radians=$(awk -v a="$angle" 'BEGIN { print a * atan2(0, -1) / 180 }')
sed -i "s/^critical_angle = .*/critical_angle = $radians/" "$mine"
expect 1 "[degrees]: wrong. That is the angle in radians" "${theory[@]}"
sed -i 's/^critical_angle = .*/critical_angle = asin(1 \/ 1.5)/' "$mine"
expect 2 "an answer is a number, worked out: 41.8" "${theory[@]}"
sed -i 's/^critical_angle = .*/critical_angel = 1/' "$mine"
expect 2 "expected critical_angle?" "${theory[@]}"

end
