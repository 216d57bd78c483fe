#!/usr/bin/env bash
# On a full disk: an error that names it, exit code 3, nothing half written, and no verdict on the submission.
#
#     tests/full_disk_test.sh BUILD
#
# In a mount namespace of its own; skipped (exit code 77) where there is none.
set -u
build=$1
if [ -z "${PENUMBRA_FULL_DISK:-}" ]; then
    unshare --user --map-root-user --mount true 2>/dev/null || { echo "skipped: no mount namespaces here"; exit 77; }
    PENUMBRA_FULL_DISK=1 exec unshare --user --map-root-user --mount "$0" "$@"
fi
# shellcheck source=tests/expect.sh
. "$(dirname "$0")/expect.sh"
disk=$work/disk
mkdir "$disk"
mount -t tmpfs -o size=64k tmpfs "$disk" || { echo "skipped: no tmpfs here"; exit 77; }
trap 'umount "$disk"; rm -rf "$work"' EXIT
raytrace=$build/raytrace grade=$build/grader/grade

expect 3 "No space left on device" "$raytrace" scenes/whitted.toml -o "$disk/a.exr"
dd if=/dev/zero of="$disk/filler" bs=1k count=60 2>/dev/null
expect 3 "a.json: cannot be written" "$grade" solution moved --json "$disk/a.json"
if [ -e "$disk/a.json" ]; then expect 0 '"complete": false' cat "$disk/a.json"; fi
rm -f "$disk/a.json"
expect 3 "index.html: cannot be written" "$grade" solution moved --html "$disk/page"
if [ -e "$disk/page/index.html" ]; then expect 0 "This grading is not complete" cat "$disk/page/index.html"; fi  # the page of before all work
rm -f "$disk/page/index.html"
# a class goes on where there is room again
mkdir -p "$work/class/alice" && cp solution/moved.cpp "$work/class/alice"
expect 3 "cannot be written" "$grade" class "$work/class" -o "$disk/out" --seed 1
mount -o remount,size=8m "$disk"
expect 0 "1 submission, 1 graded" "$grade" class "$work/class" -o "$disk/out" --seed 1
rm -rf "$disk/out"
mount -o remount,size=64k "$disk"
expect 3 "s.json: cannot be written" "$grade" stress solution --only hit_sphere --trusted --json "$disk/s.json"
expect 3 "cannot be written" "$grade" converge solution scenes/whitted.toml --samples 1,4 --replicates 2 --folder "$disk/kept"
expect 3 "the grader failed: $disk/grade-" env TMPDIR="$disk" "$grade" solution moved
rmdir "$disk"/page 2>/dev/null
expect 0 "filler" ls "$disk"
left=$(find "$disk" -type f ! -name filler)
[ -z "$left" ] || { echo "left behind: $left"; failures=$((failures + 1)); }

end
