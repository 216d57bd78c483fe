"""A kit, as `grade hand-out` writes it, and what one does with it."""

import pathlib
import shutil
import subprocess
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from helpers import record_of, timeless  # noqa: E402


def without_times(record):
    """A record without what depends on time, load, place and build."""
    own = ("command", "sandbox", "toolchain", "program_sha256", "reference_sha256", "flags", "built_for")
    same = timeless(record, own)
    del same["submission"]["name"]
    return same


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
        return record_of([self.folder / "grade", *words], cwd=self.folder)
