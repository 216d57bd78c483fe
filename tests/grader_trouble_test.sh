#!/usr/bin/env bash
# grader_trouble_test.sh BUILD: the machine's trouble is no verdict, and a grading that is killed leaves nothing behind.
set -u
build=$1 grade=$1/grader/grade
# shellcheck source=tests/expect.sh
. "$(dirname "$0")/expect.sh"
export TMPDIR=$work/temporary
mkdir "$TMPDIR"
left() { find "$TMPDIR" -mindepth 1 -maxdepth 1 | wc -l; }

# too few descriptors or processes: tried twice, then said
# shellcheck disable=SC2317  # expect calls them
limited() { (ulimit "$1" "$2" && shift 2 && "$@"); }
expect 3 "" limited -n 8 "$grade" solution phong
expect 0 "0" left

# a record that is not complete is there before the first compile, and never looks complete
mkdir "$work/slow" "$work/page"
echo '"complete": true' >"$work/a.json"
echo "the last page" >"$work/page/index.html"
sed 's|// BEGIN SOLUTION|for (volatile int i = 0; i < 1;) {}|' solution/phong.cpp >"$work/slow/phong.cpp"
"$grade" "$work/slow" phong --json "$work/a.json" --html "$work/page" >/dev/null 2>&1 &
pid=$!
for _ in $(seq 600); do
    grep -q '"complete": false' "$work/a.json" && [ "$(left)" -gt 0 ] && break
    sleep 0.1
done
kill -9 "$pid"
wait "$pid" 2>/dev/null
expect 0 '"complete": false' cat "$work/a.json"
expect 0 "not complete" cat "$work/page/index.html"
for folder in "$TMPDIR"/grade-*/; do
    mkdir -p "$folder/deep/er"
    chmod 000 "$folder/deep"
done
touch "$TMPDIR/grade-killed.lock"  # before its folder was made
# what the next one finds, it removes; what is somebody else's, and what is in use, it does not
mkdir "$TMPDIR/grade-other" "$work/others"
chmod 500 "$work/others"
ln -s "$work/others" "$TMPDIR/grade-link"
touch "$TMPDIR/grade-link.lock"
expect 0 "3 of 3" "$grade" solution phong
expect 0 "3" left
expect 0 "500" stat -c %a "$work/others"
rm "$TMPDIR/grade-link" "$TMPDIR/grade-link.lock"
rmdir "$TMPDIR/grade-other"

# objects kept in a folder whose name is in what takes the place of its name
mkdir "$work/kept"
echo 'int x = ;' >"$work/kept/phong.cpp"
expect 0 "did not build" env -C "$work" timeout 100 "$build/grader/grade" kept phong --keep "$work/kept"

# no sandbox: refused, unless the code is one's own
cat >"$work/nothing" <<'END'
echo 0 >/proc/sys/user/max_user_namespaces && echo 0 >/proc/sys/user/max_mnt_namespaces && exec "$@"
END
if unshare -Ur sh "$work/nothing" true 2>/dev/null; then
    expect 0 "Landlock" unshare -Ur sh "$work/nothing" "$grade" solution phong
    expect 0 "0 of 3" unshare -Ur sh "$work/nothing" "$grade" "$work/slow" phong --time-limit 1
    expect 0 "resource limits only" unshare -Ur sh "$work/nothing" "$grade" solution phong --trusted
fi
expect 0 "0" left

end
