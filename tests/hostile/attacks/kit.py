"""What submissions are made of. A function of a case gets the Place of its run and returns the source of uniform_disk.cpp,
or all files of the submission by name, or a path. Most attacks return the right answer where they succeed and a wrong
one where they do not: then a submission that gets points has won. Every bomb is bounded in its own source.
"""

import dataclasses
import pathlib
import re
import zipfile

ANY_FAULT = {"failed", "crashed", "timed_out", "not_finite"}
NO_BUG = (r"internal compiler error", r"submit a full bug report")
NO_FILE = ("not a regular file",)


@dataclasses.dataclass
class Place:
    """What a submission may aim at."""

    root: pathlib.Path  # the project's folder, with solution/
    chain: dict  # toolchain.toml
    folder: pathlib.Path  # of the case: submission/ and out/, where the record goes
    secret: pathlib.Path  # a file that nobody else may read
    victim: pathlib.Path  # a file and a folder that anyone may write to, outside of the sandbox
    tcp: int = 0  # where the test listens
    udp: int = 0
    unix: str = ""


@dataclasses.dataclass
class Case:
    number: str
    title: str
    build: object
    verdicts: set  # of the first fragment
    words: tuple = ()  # one of them must be said
    absent: tuple = ()  # regular expressions that nothing may match, beside the secrets
    unsaid: tuple = ()  # the same, for what is printed
    off_page: tuple = ()  # and for the page
    fragments: tuple = ("uniform_disk",)
    seconds: float = 60  # of wall time, on a busy machine
    code: int = 0
    bystander: bool = False  # mirror_direction is graded as well and must pass
    html: bool = False
    times: int = 1  # gradings, one after the other
    jobs: int = 2  # programs at a time
    fast: bool = False
    own: bool = False  # something that one's own code may do: tried with --trusted, too
    after: object = None  # faults that the place shows afterwards

    @property
    def kind(self):
        """Its number without a letter."""
        return re.match(r"\d+", self.number)[0]


cases = []


def case(number, title, verdicts, words=(), source=None, **more):
    """With a source the case is complete; without one it waits for the function that makes one of its place."""
    def add(build):
        given = {verdicts} if isinstance(verdicts, str) else set(verdicts)
        cases.append(Case(number, title, build, given, (words,) if isinstance(words, str) else tuple(words), **more))
        return build

    return add(lambda _: source) if source is not None else add


HEAD = """#include "rt/fragments.h"
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <string>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <arpa/inet.h>
#include <dirent.h>
#include <netinet/in.h>
#include <time.h>
#include <unistd.h>
#include <vector>
"""

ANSWERS = """namespace rt {
namespace {
[[maybe_unused]] DiskSample right(vec2 u) {
    const Real r = std::sqrt(u.x), phi = 2 * pi * u.y;
    return {vec2(r * std::cos(phi), r * std::sin(phi)), 1 / pi};
}
[[maybe_unused]] DiskSample wrong(vec2 u) { return {0.4 * u, 2}; }
}  // namespace
}  // namespace rt
"""

MIRROR = """#include "rt/fragments.h"
namespace rt {
vec3 mirror_direction(vec3 d, vec3 n) { const Real twice = d.x * n.x + d.y * n.y + d.z * n.z; return d - (twice + twice) * n; }
}  // namespace rt
"""


def disk(body, before="", head=""):
    """uniform_disk with this body."""
    return f"{head}{HEAD}{before}\n{ANSWERS}namespace rt {{\nDiskSample uniform_disk(vec2 u) {{\n{body}\n}}\n}}  // namespace rt\n"


def attack(body, before=""):
    """An attack that returns whether it succeeded; it is tried once in each program."""
    return disk("    static const bool won = attack();\n    return won ? right(u) : wrong(u);",
                f"{before}\nstatic bool attack() {{\n{body}\n}}")


def bomb(body, before=""):
    """Something that goes off once; behind it the answers are right."""
    return disk("    static const bool done = (bomb(), true);\n    return done ? right(u) : wrong(u);",
                f"{before}\nstatic void bomb() {{\n{body}\n}}")


def mean(body, before=""):
    """pixel_mean with this body, in which the mean is `sum`."""
    return {"pixel_mean.cpp": f"{HEAD}{before}namespace rt {{\nColor pixel_mean(std::span<const Color> radiance, std::span<const Real> weight) {{\n"
            f"    Color sum(0);\n    for (std::size_t i = 0; i < radiance.size(); ++i) sum += weight[i] * radiance[i];\n"
            f"    sum /= Real(radiance.size());\n{body}\n}}\n}}  // namespace rt\n"}


def quoted(path):
    return '"' + str(path).replace("\\", "\\\\").replace('"', '\\"') + '"'


def paths(*list_of_paths):
    return "const char* const paths[] = {" + ", ".join(quoted(path) for path in list_of_paths) + "};"


def zipped(place, entries):
    path = place.folder / "submission.zip"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for entry, text in entries:
            archive.writestr(entry, text)
    return path


def victim_is_whole(place):
    found = sorted(path.name for path in place.victim.iterdir())
    if found != ["file"] or (place.victim / "file").read_text() != "whole\n":
        return f"files outside were written: {', '.join(found)}"
    return None


def outputs_are_short(place):
    for path in sorted((place.folder / "out").rglob("*")):
        if path.is_file() and path.stat().st_size > 400_000:
            return f"{path.name} has {path.stat().st_size >> 10} KiB"
    return None
