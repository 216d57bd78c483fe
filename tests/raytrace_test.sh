#!/bin/sh
# The command line of raytrace: exit codes, messages, files.
# raytrace_test.sh BUILD
raytrace=$1/raytrace
scene=scenes/white_ball.toml
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
status=0

# expect EXIT TEXT WORD...: raytrace WORD... ends with EXIT and says TEXT.
expect() {
    code=$1 text=$2
    shift 2
    "$raytrace" "$@" >"$work/said" 2>&1
    got=$?
    if [ $got != "$code" ] || ! { [ -z "$text" ] || grep -qF -e "$text" "$work/said"; }; then
        echo "raytrace $*: exit $got; expected exit $code and '$text' in:"
        cat "$work/said"
        status=1
    fi
}

small="--size 32x24 --samples 4"
# shellcheck disable=SC2086
{
    expect 0 "32 x 24 pixels, 4 samples a pixel" $scene -o "$work/a.exr" $small
    expect 0 "3 x 2 pixels" $scene -o "$work/crop.exr" $small --crop 5,6,3,2
    expect 0 "camera" $scene --plan
    expect 0 "hit_sphere " $scene --pixel 128,128
    expect 0 "camera_ray " $scene --pixel 128,128
    expect 0 "direct_light " scenes/penumbra.toml --pixel 90,120
    expect 0 "the picture is made without" $scene -o "$work/c.exr" $small --preview
    expect 0 "no tev at localhost:1: " $scene -o "$work/c.exr" $small --tev localhost:1
    expect 0 "hash  " $scene $small --tev localhost:1
    expect 0 "" $scene -o "$work/b.exr" $small --quiet
    expect 0 "a pixel" $scene -o "$work/c.exr" $small --time-limit 0.01
    expect 0 "1 sample a pixel" $scene -o "$work/c.exr" $small --time-limit 1e-9
    expect 0 "samples a pixel" $scene -o "$work/c.exr" $small --target-error 1
    expect 2 "scene is required"
    expect 2 "expected -o NAME.exr" $scene
    expect 2 "expected -o NAME.exr" $scene -o "$work/a.jpg"
    expect 2 "nowhere.toml:1:1: " nowhere.toml -o "$work/a.exr"
    expect 2 "--samples" $scene -o "$work/a.exr" --samples 0
    expect 2 "--size" $scene -o "$work/a.exr" --size 0x5
    expect 2 "--size" $scene -o "$work/a.exr" --size 65536x65536
    expect 2 "--crop: 0,0,300,10 is not within the image" $scene -o "$work/a.exr" --crop 0,0,300,10
    expect 2 "--pixel: 256,0 is not within the image" $scene --pixel 256,0
    expect 2 "--sampler" $scene -o "$work/a.exr" --sampler halton
    expect 2 "--seed" $scene -o "$work/a.exr" --seed -1
    expect 2 "--preview" $scene --preview=poster
    expect 2 "--tev: localhost is no address; expected HOST:PORT" $scene --tev localhost
    expect 2 "--tev: :1 is no address" $scene -o "$work/a.exr" --tev :1
    expect 2 "--time-limit" $scene -o "$work/a.exr" --time-limit 0
    expect 2 "--nonsense" $scene -o "$work/a.exr" --nonsense
    expect 3 "cannot be written" $scene -o "$work/no_such_folder/a.exr"
}
for bad in tests/bad_scenes/*.toml; do
    expect 2 "; expected " "$bad" -o "$work/bad.exr"
    grep -q '^tests/bad_scenes/[^:]*:[0-9]*:[0-9]*: ' "$work/said" || { echo "$bad: no line and column"; status=1; }
done

[ -s "$work/a.png" ] || { echo "there is no preview a.png beside a.exr"; status=1; }

# hash WORD...: that of the picture
hash() { "$raytrace" "$@" | sed -n 's/^hash *//p'; }
# shellcheck disable=SC2086
{
    one=$(hash $scene $small -o "$work/a.exr")
    [ -n "$one" ] || { echo "no hash"; status=1; }
    [ "$one" = "$(hash $scene $small -o "$work/b.exr" --threads 2)" ] || { echo "one seed, two images"; status=1; }
    [ "$one" != "$(hash $scene $small -o "$work/b.exr" --seed 1)" ] || { echo "two seeds, one image"; status=1; }
}
for word in scene samples seed sampler error cpu_seconds wall_seconds "Penumbra 0.1" "$scene"; do
    head -c 2000 "$work/a.exr" | grep -aqF "$word" || { echo "the EXR file does not say: $word"; status=1; }
done

# The handout shows what --pixel prints.
"$raytrace" scenes/gallery/cornell.toml --pixel 120,330 --samples 1 >"$work/trace"
awk '/--pixel 120,330/ { near = 1 } /^```/ && near { ++fences; next } fences == 1' handout.md >"$work/excerpt"
[ "$(wc -l <"$work/excerpt")" -gt 5 ] || { echo "the handout shows no trace"; status=1; }
while IFS= read -r line; do
    grep -qxF -e "$line" "$work/trace" || { echo "--pixel does not print the handout's line: $line"; status=1; }
done <"$work/excerpt"

# A time limit is kept within ten per cent, whatever samples the scene asks for.
# keeps SECONDS WORD...: raytrace WORD... --time-limit SECONDS; in one of three tries, for other programs may take the cores
keeps() {
    limit=$1
    shift
    for _ in 1 2 3; do
        "$raytrace" "$@" -o "$work/limit.exr" --time-limit "$limit" >"$work/said" || status=1
        sed -n 's/.* CPU, \([0-9.]*\) s wall/\1/p' "$work/said" |
            awk -v limit="$limit" '{ exit !($1 > 0.9 * limit && $1 < 1.1 * limit) }' && return
    done
    echo "$* --time-limit $limit: took"
    cat "$work/said"
    status=1
}
keeps 2 scenes/gallery/cornell.toml --size 100x100
keeps 2 scenes/gallery/cornell.toml --size 100x100 --samples 1000000
keeps 2 scenes/gallery/still_life.toml --size 60x40 --sampler stratified
keeps 2 scenes/penumbra.toml --target-error 1e-9
keeps 0.3 scenes/penumbra.toml --samples 1
expect 0 "after" scenes/gallery/cornell.toml -o "$work/c.exr" --size 1000x1000 --time-limit 0.1
grep -q "% of the picture; what is missing is black" "$work/said" || { echo "no word of what is missing"; status=1; }
[ -e "$work/bad.exr" ] && { echo "a bad scene left an image"; status=1; }
[ -n "$(find "$work" -name '*.tmp')" ] && { echo "a temporary file is left"; status=1; }

# Ctrl-C ends soon and keeps the passes that are whole.
"$raytrace" $scene -o "$work/long.exr" --size 32x24 --time-limit 60 --quiet &
job=$!
sleep 0.5
kill -INT $job
wait $job || { echo "after Ctrl-C: exit $?; expected 0"; status=1; }
[ -s "$work/long.exr" ] || { echo "Ctrl-C left no image"; status=1; }
exit $status
