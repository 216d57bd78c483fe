"""A kit, as `grade hand-out` writes it, and what one does with it."""

import json
import pathlib
import shutil
import subprocess
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SOLUTION = ROOT / "solution"


def points_in_order():
    """Points by fragment, in the order of the assignment."""
    parts = tomllib.loads((ROOT / "assignment.toml").read_text())["part"]
    return {f["name"]: f["points"] for part in parts for f in part["fragments"] if not f.get("given", False)}


def variant(patch):
    """The fragment of a patch of tests/variants, and its text."""
    head = dict(line[2:].split(": ", 1) for line in patch.read_text().splitlines() if line.startswith("# ") and ": " in line)
    source = SOLUTION / f"{head['fragment']}.cpp"
    done = subprocess.run(["patch", "--silent", "-o", "-", source, patch], capture_output=True, text=True, check=True)
    return head["fragment"], done.stdout


def without_times(value):
    """A record without what depends on time, load, place and build."""
    if isinstance(value, dict):
        own = ("command", "date", "sandbox", "toolchain", "program_sha256", "reference_sha256", "flags", "built_for")
        timeless = {k: without_times(v) for k, v in value.items() if not k.endswith("_seconds") and k not in own}
        if "schema" in timeless:
            del timeless["submission"]["name"]
        return timeless
    return [without_times(v) for v in value] if isinstance(value, list) else value


class Kit:
    """Handed out by a built grader into a folder."""

    def __init__(self, grade, folder):
        self.folder = folder
        subprocess.run([grade, "hand-out", folder], check=True, capture_output=True)

    def write(self, texts):
        for fragment, text in texts.items():
            (self.folder / "starter/fragments" / f"{fragment}.cpp").write_text(text)

    def blank(self, fragments):
        for fragment in fragments:
            shutil.copy(self.folder / "grader/blanks" / f"{fragment}.cpp", self.folder / "starter/fragments")

    def run(self, *words):
        """What is said, and the exit code."""
        done = subprocess.run([self.folder / "grade", *words], cwd=self.folder, capture_output=True, text=True)
        return done.stdout + done.stderr, done.returncode

    def grade(self, *words):
        out = self.folder / "record.json"
        said, code = self.run(*words, "--json", str(out))
        if code != 0:
            raise SystemExit(f"grade {' '.join(words)} ended with {code}:\n{said}")
        return json.loads(out.read_text())
