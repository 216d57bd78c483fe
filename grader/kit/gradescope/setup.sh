#!/usr/bin/env bash
# Gradescope runs this once, where the archive is uploaded: as root in /autograder/source, on Ubuntu 24.04 or Debian 12 or newer.
# It ends with the first grading, which fails here and not with the students where this machine cannot grade.
set -euo pipefail
kit=$(dirname "$(readlink -f -- "$0")")/kit
if ! command -v g++ >/dev/null; then
    apt-get update
    DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends g++
fi
# any fragment that is no blank: it is compiled, linked and run
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sed 's/not_started(/(/' "$kit/grader/blanks/mirror_direction.cpp" >"$work/mirror_direction.cpp"
"$kit/grade" "$work" mirror_direction --seed 1
