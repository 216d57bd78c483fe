#!/bin/sh
# Every script passes shellcheck.
command -v shellcheck >/dev/null || exit 77
exec shellcheck -x grade check .ci/run .ci/package grader/kit/grade grader/kit/gradescope/setup.sh grader/kit/gradescope/run_autograder grader/class/slurm.sbatch grader/class/parallel starter/cmake/inline_or_link scenes/take_screenshot tests/*.sh tests/platforms/debian tests/platforms/kit tests/platforms/clang tests/platforms/package
