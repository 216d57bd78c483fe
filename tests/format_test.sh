#!/usr/bin/env bash
# All code is as .clang-format has it, and no line is longer than 120 columns (styles of pages apart). Versions of
# clang-format disagree in details: Debian 12's decides.
set -euo pipefail
# variants and hostile submissions look as students write
files=$(find starter solution grader tests -name '*.cpp' -o -name '*.h' | grep -v -e tests/variants -e tests/hostile)
# shellcheck disable=SC2046,SC2086  # words
long=$(perl -CSD -ne 'chomp; print "$ARGV:$.: longer than 120 columns\n" if length > 120; close ARGV if eof' \
    $(grep -L 'R"css(' $files))
if [ -n "$long" ]; then
    echo "$long" >&2
    exit 1
fi
version=$(clang-format --version 2>/dev/null) || { echo "no clang-format"; exit 77; }
[[ $version == *"version 14."* ]] || { echo "clang-format is not of version 14"; exit 77; }
# shellcheck disable=SC2086  # words
exec clang-format --dry-run --Werror $files
