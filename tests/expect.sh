# Sourced by tests of whole commands: a folder `work` that goes at the end, and a count of what was not as expected.
# shellcheck shell=bash
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# expect CODE WORDS COMMAND...: the exit code, and words that the output must hold
expect() {
    local code=$1 words=$2
    shift 2
    local output
    output=$("$@" 2>&1)
    local got=$?
    if [ "$got" != "$code" ] || [[ $output != *"$words"* ]]; then
        printf 'FAILED: %s\n  exit %s, expected %s with "%s"; it said:\n%s\n' "$*" "$got" "$code" "$words" "$output"
        failures=$((failures + 1))
    fi
}

# end: of the test, by what has been counted
end() {
    [ $failures = 0 ] && echo "all as expected"
    exit $((failures > 0))
}
