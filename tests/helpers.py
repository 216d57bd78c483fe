"""What tests of records, formats, classes and kits share."""

import json
import pathlib
import resource
import subprocess
import sys
import tempfile
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


def cpu_seconds():
    """Of all programs that have been run."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def parts():
    return tomllib.loads((ROOT / "assignment.toml").read_text())["part"]


def fragments_in_order():
    """As assignment.toml has them, by parts."""
    return {part["name"]: [fragment["name"] for fragment in part["fragments"]] for part in parts()}


def points_in_order():
    """Points by fragment, of those that are graded, in the order of the assignment."""
    return {f["name"]: f["points"] for part in parts() for f in part["fragments"] if not f.get("given", False)}


def head_of(patch):
    """What the head of a patch of tests/variants says, by its words; "what": what the patch does."""
    what, *lines = [line[2:] for line in patch.read_text().splitlines() if line.startswith("# ")]
    return {"what": what, **dict(line.split(": ", 1) for line in lines)}


def variant(patch):
    """The fragment of such a patch, and its text."""
    fragment = head_of(patch)["fragment"]
    done = subprocess.run(["patch", "--silent", "-o", "-", SOLUTION / f"{fragment}.cpp", patch],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        sys.exit(f"{patch}:1:1: does not apply to solution/{fragment}.cpp; expected: a patch of today's solution\n{done.stdout}")
    return fragment, done.stdout


def timeless(value, also=()):
    """A record without what depends on time and load, and without these keys."""
    if isinstance(value, dict):
        return {k: timeless(v, also) for k, v in value.items() if not k.endswith("_seconds") and k != "date" and k not in also}
    return [timeless(v, also) for v in value] if isinstance(value, list) else value


def record_at(path):
    return json.loads(pathlib.Path(path).read_text())


def record_of(command, **more):
    """The record that a grader writes, which must end well."""
    with tempfile.TemporaryDirectory() as folder:
        record = pathlib.Path(folder) / "record.json"
        done = subprocess.run([str(word) for word in (*command, "--json", record)], capture_output=True, text=True, **more)
        if done.returncode != 0:
            sys.exit(f"{' '.join(map(str, command))} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
        return record_at(record)


def record_of_one(grade, fragment, text, seed):
    """What becomes of a fragment with this text among the solution's others."""
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / f"{fragment}.cpp").write_text(text)
        return record_of([grade, folder, fragment, "--trusted", "--jobs", "1", "--seed", seed])["fragments"][0]


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
