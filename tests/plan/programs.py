"""Renderers from the solution's fragments and from blanks, linked as the build links them; and what they draw."""

import pathlib
import re
import subprocess
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from helpers import fragments_in_order  # noqa: E402


def link_line(build, program):
    done = subprocess.run(
        ["ninja", "-C", build, "-t", "commands", "-s", program], capture_output=True, text=True, check=True
    )
    return done.stdout.strip()


def objects(line):
    """The object of each fragment in a line that links."""
    return {pathlib.Path(o).name.split(".")[0]: o for o in re.findall(r"\S*fragments_of_\w+\.dir\S*\.cpp\.o", line)}


class Programs:
    def __init__(self, build):
        self.build = build
        self.line = link_line(build, "raytrace_linked")
        self.filled, self.blanks = objects(self.line), objects(link_line(build, "raytrace_starter"))
        assert set(self.filled) == set(self.blanks) == {f for part in fragments_in_order().values() for f in part}
        self.calls = {f: self.called_by(f) for f in self.filled}

    def called_by(self, fragment):
        """The other fragments that the solution's calls: what its object leaves undefined."""
        symbols = subprocess.run(
            ["nm", "-u", self.build / self.filled[fragment]], capture_output=True, text=True, check=True
        ).stdout
        return {f for f in self.filled if f != fragment and f"_ZN2rt{len(f)}{f}E" in symbols}

    def with_called(self, fragments):
        """These fragments and all that they call."""
        found, new = set(), set(fragments)
        while new:
            found |= new
            new = {g for f in new for g in self.calls[f]} - found
        return found

    def link(self, fragments, program):
        """A renderer with the solution's fragments of these names; the others are blank, and say so when they are called."""
        command = re.sub(r"-o \S+", f"-o {program}", self.line)
        for name in set(self.filled) - set(fragments):
            command = command.replace(self.filled[name], self.blanks[name])
        subprocess.run(command, shell=True, check=True, cwd=self.build)
        return program


def named(raytrace, scene, options=()):
    """The fragments that --plan says are called, and its rows that are on."""
    table = subprocess.run(
        [raytrace, scene, "--plan", *options], capture_output=True, text=True, check=True
    ).stdout
    _, fragments = table.split("fragments that the stages call\n")
    return {f for line in fragments.splitlines() for f in re.findall(r"\w+", line)[1:]}


def draw(program, scene, out, options=()):
    """The picture's hash, and the blanks that were called."""
    done = subprocess.run(
        [program, scene, "-o", out, "--threads", "1", *options], capture_output=True, text=True, check=False
    )
    text = done.stdout + done.stderr
    hashed = re.search(r"^hash +(\w+)$", done.stdout, re.MULTILINE)
    return (hashed.group(1) if hashed else text), set(re.findall(r"(\w+)\.cpp.*not started", text))
