"""What tests of records, formats, classes and kits share."""

import json
import pathlib
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOLUTION = ROOT / "solution"
BLANKS = ROOT / "starter/fragments"
SCHEMA = ROOT / "grader/record/result.schema.json"

failures = []


def expect(holds, what):
    if not holds:
        failures.append(what)
        print(f"FAILED: {what}", flush=True)


def end(words):
    print(words if not failures else f"{len(failures)} failures")
    sys.exit(1 if failures else 0)


def skip(words):
    print(f"skipped: {words}")
    sys.exit(77)


def run(command, expected=0, **more):
    """Its output; the exit code must be the expected one, or one of several."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **more)
    codes = expected if isinstance(expected, tuple) else (expected,)
    expect(done.returncode in codes, f"{' '.join(map(str, command))} ended with {done.returncode}, expected {expected}:\n"
           f"{done.stdout[-1500:]}{done.stderr[-1500:]}")
    return done.stdout + done.stderr


def points_in_order():
    """Points by fragment, in the order of the assignment."""
    parts = tomllib.loads((ROOT / "assignment.toml").read_text())["part"]
    return {f["name"]: f["points"] for part in parts for f in part["fragments"] if not f.get("given", False)}


def variant(patch):
    """The fragment of a patch of tests/variants, and its text."""
    head = dict(line[2:].split(": ", 1) for line in patch.read_text().splitlines() if line.startswith("# ") and ": " in line)
    done = subprocess.run(["patch", "--silent", "-o", "-", SOLUTION / f"{head['fragment']}.cpp", patch],
                          capture_output=True, text=True, check=True)
    return head["fragment"], done.stdout


def timeless(value, also=()):
    """A record without what depends on time and load, and without these keys."""
    if isinstance(value, dict):
        return {k: timeless(v, also) for k, v in value.items() if not k.endswith("_seconds") and k != "date" and k not in also}
    return [timeless(v, also) for v in value] if isinstance(value, list) else value


def record_at(path):
    return json.loads(pathlib.Path(path).read_text())


def steps_of(workflow):
    """The shell of each step, in order: of `run: COMMAND` and `run: |`."""
    steps, indent = [], None
    for line in workflow.splitlines():
        depth = len(line) - len(line.lstrip())
        if indent is not None and line.strip() and depth > indent:
            steps[-1] += line.strip() + "\n"
            continue
        indent = None
        if line.strip().startswith("run:"):
            command = line.split("run:", 1)[1].strip()
            steps.append("" if command == "|" else command + "\n")
            indent = depth if command == "|" else None
    return steps


def validator():
    """Of the record's schema; None where there is no such library."""
    try:
        import jsonschema
    except ImportError:
        print("python3-jsonschema is not installed: records are not held against their schema")
        return None
    schema = json.loads(SCHEMA.read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)
