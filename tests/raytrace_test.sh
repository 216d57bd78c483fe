#!/usr/bin/env bash
# The command line of raytrace: exit codes, messages, files.
# raytrace_test.sh BUILD
set -uo pipefail
build=$1 scene=scenes/white_ball.toml
# shellcheck source=tests/expect.sh
. "$(dirname "$0")/expect.sh"
raytrace() { "$build/raytrace" "$@"; }
failed() { echo "FAILED: $*"; failures=$((failures + 1)); }

small=(--size 32x24 --samples 4)
expect 0 "32 x 24 pixels, 4 samples a pixel" raytrace $scene -o "$work/a.exr" "${small[@]}"
expect 0 "1200 camera" raytrace scenes/camera.toml -o "$work/a.exr" --size 40x15 --samples 1
expect 0 "; 600 pixels are rendered twice" raytrace scenes/camera.toml -o "$work/a.exr" --size 40x15 --samples 1
expect 0 "3600 camera; 600 pixels are rendered twice" raytrace scenes/camera.toml -o "$work/a.exr" --size 40x30 --samples 2
expect 0 "3 x 2 pixels" raytrace $scene -o "$work/crop.exr" "${small[@]}" --crop 5,6,3,2
expect 0 "camera" raytrace $scene --plan
expect 0 "hit_sphere " raytrace $scene --pixel 128,128
expect 0 "camera_ray " raytrace $scene --pixel 128,128
expect 0 "direct_light " raytrace scenes/penumbra.toml --pixel 90,120
expect 0 "the picture is made without" raytrace $scene -o "$work/c.exr" "${small[@]}" --preview
expect 0 "no tev at localhost:1: " raytrace $scene -o "$work/c.exr" "${small[@]}" --tev localhost:1
expect 0 "hash  " raytrace $scene "${small[@]}" --tev localhost:1
expect 0 "" raytrace $scene -o "$work/b.exr" "${small[@]}" --quiet
expect 0 "a pixel" raytrace $scene -o "$work/c.exr" "${small[@]}" --time-limit 0.01
expect 0 "1 sample a pixel" raytrace $scene -o "$work/c.exr" "${small[@]}" --time-limit 1e-9
expect 0 "samples a pixel" raytrace $scene -o "$work/c.exr" "${small[@]}" --target-error 1
expect 2 "scene is required" raytrace
expect 2 "expected -o NAME.exr" raytrace $scene
expect 2 "expected -o NAME.exr" raytrace $scene -o "$work/a.jpg"
expect 2 "nowhere.toml:1:1: " raytrace nowhere.toml -o "$work/a.exr"
expect 2 "--samples" raytrace $scene -o "$work/a.exr" --samples 0
expect 2 "--size" raytrace $scene -o "$work/a.exr" --size 0x5
expect 2 "--size" raytrace $scene -o "$work/a.exr" --size 65536x65536
expect 2 "--crop: 0,0,300,10 is not within the image" raytrace $scene -o "$work/a.exr" --crop 0,0,300,10
expect 2 "--pixel: 256,0 is not within the image" raytrace $scene --pixel 256,0
expect 2 "--sampler" raytrace $scene -o "$work/a.exr" --sampler halton
expect 2 "--seed" raytrace $scene -o "$work/a.exr" --seed -1
expect 2 "--preview" raytrace $scene --preview=poster
expect 2 "--tev: localhost is no address; expected HOST:PORT" raytrace $scene --tev localhost
expect 2 "--tev: :1 is no address" raytrace $scene -o "$work/a.exr" --tev :1
expect 2 "--time-limit" raytrace $scene -o "$work/a.exr" --time-limit 0
expect 2 "--nonsense" raytrace $scene -o "$work/a.exr" --nonsense
expect 3 "cannot be written" raytrace $scene -o "$work/no_such_folder/a.exr"
for bad in tests/bad_scenes/*.toml; do
    expect 2 "; expected " raytrace "$bad" -o "$work/bad.exr"
    grep -q '^tests/bad_scenes/[^:]*:[0-9]*:[0-9]*: ' <(raytrace "$bad" -o "$work/bad.exr" 2>&1) ||
        failed "$bad: no line and column"
done

[ -s "$work/a.png" ] || failed "there is no preview a.png beside a.exr"

# hash_of WORD...: that of the picture
hash_of() { raytrace "$@" | sed -n 's/^hash *//p'; }
one=$(hash_of $scene "${small[@]}" -o "$work/a.exr")
[ -n "$one" ] || failed "no hash"
[ "$one" = "$(hash_of $scene "${small[@]}" -o "$work/b.exr" --threads 2)" ] || failed "one seed, two images"
[ "$one" != "$(hash_of $scene "${small[@]}" -o "$work/b.exr" --seed 1)" ] || failed "two seeds, one image"
for word in scene samples seed sampler error cpu_seconds wall_seconds "Penumbra 0.1" "$scene"; do
    head -c 2000 "$work/a.exr" | grep -aqF "$word" || failed "the EXR file does not say: $word"
done

# The handout shows what --pixel prints.
raytrace scenes/gallery/cornell.toml --pixel 120,330 --samples 1 >"$work/trace"
awk '/--pixel 120,330/ { near = 1 } /^```/ && near { ++fences; next } fences == 1' handout.md >"$work/excerpt"
[ "$(wc -l <"$work/excerpt")" -gt 5 ] || failed "the handout shows no trace"
while IFS= read -r line; do
    grep -qxF -e "$line" "$work/trace" || failed "--pixel does not print the handout's line: $line"
done <"$work/excerpt"

# A time limit is kept within ten per cent, whatever samples the scene asks for.
# keeps SECONDS WORD...: raytrace WORD... --time-limit SECONDS; in one of three tries, for other programs may take the cores
keeps() {
    limit=$1
    shift
    for _ in 1 2 3; do
        raytrace "$@" -o "$work/limit.exr" --time-limit "$limit" >"$work/said" || failed "exit $?"
        sed -n 's/.* CPU, \([0-9.]*\) s wall/\1/p' "$work/said" |
            awk -v limit="$limit" '{ exit !($1 > 0.9 * limit && $1 < 1.1 * limit) }' && return
    done
    failed "$* --time-limit $limit: took $(cat "$work/said")"
}
keeps 2 scenes/gallery/cornell.toml --size 100x100
keeps 2 scenes/gallery/cornell.toml --size 100x100 --samples 1000000
keeps 2 scenes/gallery/still_life.toml --size 60x40 --sampler stratified
keeps 2 scenes/penumbra.toml --target-error 1e-9
keeps 0.3 scenes/penumbra.toml --samples 1
expect 0 "% of the picture; what is missing is black" raytrace scenes/gallery/cornell.toml -o "$work/c.exr" --size 1000x1000 --time-limit 0.1
[ -e "$work/bad.exr" ] && failed "a bad scene left an image"
[ -n "$(find "$work" -name '*.tmp')" ] && failed "a temporary file is left"

# Ctrl-C ends soon and keeps the passes that are whole.
"$build/raytrace" $scene -o "$work/long.exr" --size 32x24 --time-limit 60 --quiet &
job=$!
sleep 0.5
kill -INT $job
wait $job || failed "after Ctrl-C: exit $?; expected 0"
[ -s "$work/long.exr" ] || failed "Ctrl-C left no image"

end
