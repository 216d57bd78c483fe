#!/bin/sh
# A picture has the same bits however it is made: fragments inlined or linked as objects; 1, 2, 3, 7 or 16 threads; GCC or
# Clang; without optimisation or with all of it; for this processor, for the oldest ones that a kit is for, or for 64-bit ARM.
# one_hash_test.sh BUILD [--built | --levels]: --built takes the renderers that the build has made and no others; with
# --levels also -O2, -O0 and -O2 by Clang, and x86-64-v3, which take minutes to build
#
# 64-bit ARM takes qemu-user-static, g++-aarch64-linux-gnu, and its libraries in a folder of their own, whose name is in
# PENUMBRA_ARM64_SYSROOT. (As packages of this system they would drive out its own.) On Debian 12, with debootstrap:
#
#     debootstrap --foreign --arch=arm64 --variant=minbase --include=libcli11-dev,libfmt-dev,libglm-dev,libopenexr-dev,\
#         libpng-dev,libtbb-dev,libtinyobjloader-dev,libtomlplusplus-dev,libstdc++-12-dev bookworm FOLDER
#     for package in FOLDER/var/cache/apt/archives/*.deb; do dpkg-deb -x $package FOLDER; done
build=$1
scenes="scenes/gallery/cornell.toml scenes/gallery/still_life.toml scenes/gallery/motion.toml scenes/gallery/candle.toml
    scenes/whitted_1980.toml"
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT

# renderer COMPILER FOLDER OPTIONS...: builds the renderer, once, and adds it to the list
renderer() {
    compiler=$1 folder=$build/$2
    shift 2
    if ! { cmake -S starter -B "$folder" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DFRAGMENTS="$PWD/solution" "$@" &&
        cmake --build "$folder" -j "$(nproc)"; } >"$work/log" 2>&1; then
        tail -n 30 "$work/log"
        echo "the renderer does not build with $compiler $*"
        exit 1
    fi
    renderers="$renderers $folder/raytrace"
}

renderers="$build/raytrace $build/raytrace_linked $build/grader/raytrace_baseline"
levels=${2-}

add_compilers() {
    # Debug and RelWithDebInfo have neither -O3 nor the instructions of this machine alone.
    renderer c++ gcc_O0 -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DRT_INLINE=OFF
    if [ "$levels" = --levels ]; then
        renderer c++ gcc_O2 -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O2
        ! grep -q '^processor = "x86-64-v4"' "$build/toolchain.toml" || renderer c++ gcc_v3 -DRT_MARCH=x86-64-v3
    fi
    if command -v clang++ >/dev/null; then
        renderer clang++ clang
        if [ "$levels" = --levels ]; then
            renderer clang++ clang_O0 -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DRT_INLINE=OFF
            renderer clang++ clang_O2 -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O2
        fi
    else
        echo "clang++ is missing: GCC alone is tested; apt-get install clang for both"
    fi
}

add_arm() {
    sysroot=${PENUMBRA_ARM64_SYSROOT-}
    qemu=$(command -v qemu-aarch64-static || command -v qemu-aarch64 || true)
    if [ -z "$sysroot" ] || [ -z "$qemu" ] || ! command -v aarch64-linux-gnu-g++ >/dev/null; then
        echo "64-bit ARM is not tested; that takes PENUMBRA_ARM64_SYSROOT, qemu-user and aarch64-linux-gnu-g++: the head of this script"
    else
        renderer aarch64-linux-gnu-g++ aarch64_O3 -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 \
            -DCMAKE_LIBRARY_ARCHITECTURE=aarch64-linux-gnu -DCMAKE_SYSROOT="$sysroot" -DCMAKE_FIND_ROOT_PATH_MODE_PACKAGE=ONLY -DRT_INLINE=OFF
        mkdir "$work/aarch64_O3"
        printf '#!/bin/sh\nexec "%s" -L "%s" "%s/raytrace" "$@"\n' "$qemu" "$sysroot" "$folder" >"$work/aarch64_O3/raytrace"
        chmod +x "$work/aarch64_O3/raytrace"
        renderers="${renderers% *} $work/aarch64_O3/raytrace"
    fi
}

if [ "$levels" != --built ]; then
    add_compilers
    add_arm
fi

status=0
pictures=0
for scene in $scenes; do
    first=""
    for renderer in $renderers; do
        case $renderer in
            "$build/raytrace") threads_of_it="1 2 3 7 16" ;;
            *_O*) threads_of_it=7 ;;
            *) threads_of_it="1 7" ;;
        esac
        for threads in $threads_of_it; do
            "$renderer" "$scene" -o "$work/image.exr" --size 48x48 --samples 20 --threads "$threads" >"$work/said" || exit 1
            hash=$(sed -n 's/^hash *//p' "$work/said")
            [ -n "$hash" ] || exit 1
            echo "$scene $(basename "$(dirname "$renderer")")/$(basename "$renderer") $threads threads: $hash"
            [ "${first:=$hash}" = "$hash" ] || status=1
            pictures=$((pictures + 1))
        done
    done
done
[ $status = 0 ] || echo "the hashes of one scene differ"
[ $status != 0 ] || echo "$pictures pictures, one hash for each scene"
exit $status
