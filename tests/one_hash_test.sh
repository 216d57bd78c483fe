#!/bin/sh
# A picture has the same bits however it is made: fragments inlined or linked as objects, 1, 2 or 7 threads, GCC or Clang.
# one_hash_test.sh BUILD
build=$1
scenes="scenes/gallery/cornell.toml scenes/gallery/still_life.toml scenes/gallery/motion.toml scenes/gallery/candle.toml"
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT

renderers="$build/raytrace $build/raytrace_linked"
if command -v clang++ >/dev/null; then
    if ! { cmake -S starter -B "$build/clang" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DFRAGMENTS="$PWD/solution" &&
        cmake --build "$build/clang"; } >"$work/log" 2>&1; then
        tail -n 30 "$work/log"
        echo "the renderer does not build with clang++"
        exit 1
    fi
    renderers="$renderers $build/clang/raytrace"
else
    echo "clang++ is missing: GCC alone is tested; apt-get install clang for both"
fi

status=0
for scene in $scenes; do
    first=""
    for renderer in $renderers; do
        for threads in 1 2 7; do
            "$renderer" "$scene" -o "$work/image.exr" --size 48x48 --samples 20 --threads "$threads" --quiet || exit 1
            hash=$(sha256sum <"$work/image.exr" | cut -c 1-16)
            echo "$scene $(basename "$(dirname "$renderer")")/$(basename "$renderer") $threads threads: $hash"
            [ "${first:=$hash}" = "$hash" ] || status=1
        done
    done
done
[ $status = 0 ] || echo "the hashes of one scene differ"
exit $status
