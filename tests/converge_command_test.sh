#!/usr/bin/env bash
# converge_command_test.sh BUILD: `grade converge` on a tiny scene: files, slopes, a bias that is found and one that is
# not there, going on after an interruption, exit codes; `grade lesson` gives the handout's plots.
set -uo pipefail
grade=$1/grader/grade
# shellcheck source=tests/expect.sh
. "$(dirname "$0")/expect.sh"

sed 's/^size = .*/size = [24, 24]/' scenes/bench/soft_shadow.toml >"$work/tiny.toml"
few=(--samples "1,4,16,64" --replicates 4 --folder "$work/kept")

# all files, of the solution alone
expect 0 "random" "$grade" converge solution "$work/tiny.toml" "${few[@]}" --require --out "$work/report" \
    --json "$work/a.json" --csv "$work/a.csv"
expect 0 '"schema": "penumbra/convergence/v1"' cat "$work/a.json"
expect 0 "tiny,solution,sobol,64,4," cat "$work/a.csv"
expect 0 "![error of tiny against CPU seconds](tiny-seconds.svg)" cat "$work/report/converge.md"
expect 0 "</svg>" cat "$work/report/tiny-seconds.svg"
expect 0 "</svg>" cat "$work/report/tiny-rays.svg"
expect 0 "independent points have the slope -1/2, strata a steeper one, nothing is biased" python3 - "$work/a.json" <<'END'
import json, sys
scene = json.load(open(sys.argv[1]))["scenes"][0]
slope = {c["sampler"]: c["slope"]["value"] for c in scene["curves"]}
if abs(slope["random"] + 0.5) > 0.06 or slope["stratified"] > -0.55 or slope["sobol"] > -0.55:
    sys.exit(f"slopes {slope}")
if any(c.get("biased") for c in scene["curves"]):
    sys.exit("a bias of the solution")
rays = [level["rays"] for level in scene["curves"][1]["levels"]]
if not 3.9 < rays[3] / rays[2] < 4.1:
    sys.exit(f"rays {rays}")
print("independent points have the slope -1/2, strata a steeper one, nothing is biased")
END

# what is kept is not measured again: the same to the last digit of the times; --fresh is
expect 0 "random" "$grade" converge solution "$work/tiny.toml" "${few[@]}" --json "$work/b.json"
expect 0 "" diff <(grep -v '"command"' "$work/a.json") <(grep -v '"command"' "$work/b.json")
expect 0 "random" "$grade" converge solution "$work/tiny.toml" "${few[@]}" --fresh --json "$work/b.json"
expect 0 "" diff <(grep '"mse"' "$work/a.json") <(grep '"mse"' "$work/b.json")
expect 1 "cpu_seconds" diff <(grep '_seconds"' "$work/a.json") <(grep '_seconds"' "$work/b.json")

# stopped, and gone on with
timeout 1 "$grade" converge solution "$work/tiny.toml" --replicates 100 --samples 1,4,16,64,256,1024 \
    --folder "$work/stopped" >/dev/null 2>&1
expect 0 "random" "$grade" converge solution "$work/tiny.toml" --samples 1,4,16,64,256,1024 --budget 1 \
    --folder "$work/stopped"

# a lamp that shines from a quarter of itself is found; an estimate that is noisier, but right, is not
variant() {
    mkdir "$work/$1" && cp -r solution "$work/$1/solution"
    patch -s -d "$work/$1" -p1 <"tests/variants/$1/$2.patch"
}
variant wrong 46_light_from_its_corner
expect 0 "Biased: with" "$grade" converge "$work/wrong/solution" "$work/tiny.toml" "${few[@]}" --out "$work/wrong.out"
expect 0 "does not fall below a plateau of" cat "$work/wrong.out/converge.md"
expect 0 "random, right" cat "$work/wrong.out/tiny-seconds.svg"
expect 1 "Biased: with" "$grade" converge "$work/wrong/solution" "$work/tiny.toml" "${few[@]}" --require
variant right light_sample_near_half
expect 0 "error^2 at equal time" "$grade" converge "$work/right/solution" "$work/tiny.toml" "${few[@]}" --require

# what a fragment does costs the submission's curves alone
cp -r solution "$work/mine"
sed -i 's|// BEGIN SOLUTION|__builtin_trap();|' "$work/mine/light_sample.cpp"
expect 0 "breaks down: uniform, 1 samples: ended by" "$grade" converge "$work/mine" "$work/tiny.toml" "${few[@]}"
expect 1 "breaks down" "$grade" converge "$work/mine" "$work/tiny.toml" "${few[@]}" --require
sed -i 's|__builtin_trap|nothing_of_the_kind|' "$work/mine/light_sample.cpp"
expect 0 "Did not build" "$grade" converge "$work/mine" "$work/tiny.toml" "${few[@]}"
expect 0 "Nothing is filled in yet" "$grade" converge starter "$work/tiny.toml" "${few[@]}"

# a budget leaves out the last levels
expect 0 "random" "$grade" converge solution "$work/tiny.toml" --samples 1,4,16,64,256,1024,4096,16384 --budget 0.5 \
    --folder "$work/kept" --csv "$work/c.csv"
expect 1 "" grep -q ",16384," "$work/c.csv"

# usage
expect 2 "unknown_key.toml:" "$grade" converge solution tests/bad_scenes/unknown_key.toml
expect 2 "nan.toml:" "$grade" converge solution tests/bad_scenes/nan.toml
for bad in tests/bad_scenes/*.toml; do
    said=$("$grade" converge solution "$bad" 2>&1)
    code=$?
    if [ $code != 2 ] || ! [[ $said =~ ^tests/bad_scenes/[a-z_0-9]+\.(toml|obj):[0-9]+:[0-9]+:\ . ]]; then
        printf 'FAILED: %s: exit %s, expected 2 and file:line:column; it said:\n%s\n' "$bad" $code "$said"
        failures=$((failures + 1))
    fi
done
expect 2 "one submission too many" "$grade" converge solution starter "$work/tiny.toml"
expect 2 "not there" "$grade" converge "$work/none" "$work/tiny.toml"
expect 2 "there is no folder" "$grade" converge solution "$work/tiny.toml" --json "$work/none/a.json"
expect 2 "expected ascending numbers" "$grade" converge solution "$work/tiny.toml" --samples 4,1
expect 2 "--samplers" "$grade" converge solution "$work/tiny.toml" --samplers halton
expect 2 "none.toml" "$grade" converge solution "$work/none.toml"
expect 3 "the grader failed" "$grade" converge solution "$work/tiny.toml" --toolchain "$work/none.toml"

# the plots of the handout are what the command gives
expect 0 "N^-1.5" "$grade" lesson solution --out "$work/lesson"
for name in smooth peaked periodic; do
    expect 0 "" cmp "$work/lesson/lesson_$name.svg" "scenes/pictures/lesson_$name.svg"
done
expect 0 "not started" "$grade" lesson starter
expect 2 "not there" "$grade" lesson "$work/none"

end
