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
    expect 0 "shape 0 of material white" $scene --pixel 128,128
    expect 0 "" $scene -o "$work/b.exr" $small --quiet
    expect 0 "samples a pixel" $scene -o "$work/c.exr" $small --time-limit 0.01
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
    expect 2 "--nonsense" $scene -o "$work/a.exr" --nonsense
    expect 3 "cannot be written" $scene -o "$work/no_such_folder/a.exr"
}
for bad in tests/bad_scenes/*.toml; do
    expect 2 "; expected " "$bad" -o "$work/bad.exr"
    grep -q '^tests/bad_scenes/[^:]*:[0-9]*:[0-9]*: ' "$work/said" || { echo "$bad: no line and column"; status=1; }
done

[ -s "$work/a.png" ] || { echo "there is no preview a.png beside a.exr"; status=1; }
cmp -s "$work/a.exr" "$work/b.exr" || { echo "one seed, two images"; status=1; }
[ -e "$work/bad.exr" ] && { echo "a bad scene left an image"; status=1; }
[ -n "$(find "$work" -name '*.tmp')" ] && { echo "a temporary file is left"; status=1; }

# Ctrl-C ends after the pass and keeps what is there.
"$raytrace" $scene -o "$work/long.exr" --size 32x24 --time-limit 60 --quiet &
job=$!
sleep 0.5
kill -INT $job
wait $job || { echo "after Ctrl-C: exit $?; expected 0"; status=1; }
[ -s "$work/long.exr" ] || { echo "Ctrl-C left no image"; status=1; }
exit $status
