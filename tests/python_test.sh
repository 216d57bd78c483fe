#!/bin/sh
# No script of Python has a name that is not defined, or an import that is not used.
command -v flake8 >/dev/null || exit 77
# shellcheck disable=SC2046  # none has a blank in its name
exec flake8 --isolated --select F $({ grep -rlE '^#!/.*\bpython3?$' scenes starter tests; find tests -name '*.py'; } | sort -u)
