"""What the compiler reads: includes of what is not theirs, odd files, headers and macros of their own."""

import pathlib

from .kit import NO_BUG, case, disk, quoted


@case("3a", "#include of the solution", "did_not_build", "error", fast=True)
def _(place):
    return f"#include {quoted(place.root / 'solution/uniform_disk.cpp')}\n"


@case("3b", "looks for the solution with __has_include", {"failed", "did_not_build"})
def _(place):
    tries = [place.root / "solution/uniform_disk.cpp", "../solution/uniform_disk.cpp", "../../solution/uniform_disk.cpp",
             "solution/uniform_disk.cpp", place.root / "grader/checks/uniform_disk.cpp"]
    lines = "".join(f"#if __has_include({quoted(path)})\n#define FOUND 1\n#endif\n" for path in tries)
    return disk("#ifdef FOUND\n    return right(u);\n#else\n    return wrong(u);\n#endif", lines)


case("3d", "#include of the same fragment as the assignment's folder has it", "did_not_build", "fatal error", fast=True,
     source='#include "fragments/uniform_disk.cpp"\n')


@case("3c", "secrets through the compiler's errors", "did_not_build", "error", absent=(r"root:[x*]:0",), fast=True)
def _(place):
    return f"#include {quoted(place.secret)}\n#include \"/etc/passwd\"\n#include \"/etc/shadow\"\n"


@case("4", ".incbin of the solution and of references", "did_not_build", ("error", "incbin", "file not found"))
def _(place):
    objects = place.chain.get("solution_objects", [])[:1]
    binaries = [place.root / "solution/uniform_disk.cpp", place.secret, place.root / "scenes/reference", *objects]
    return disk("    return wrong(u);", "\n".join(f'asm(".incbin \\"{path}\\"");' for path in binaries))


case("6a", "headers of its own in place of the framework's", "passed",
     source={"fragments/uniform_disk.cpp": disk("    return right(u);"),
             **{path: "#error taken\n" for path in ("rt/fragments.h", "fragments/rt/fragments.h", "fragments/math.h", "fragments/rt/math.h")}})

case("6b", "macros that spoil the framework's headers", {"did_not_build", "failed"}, own=True,
     source="#define double float\n#define private public\n#define sqrt(x) 0\n" + disk("    return right(u);"))

case("13b", "#include of the environment", "did_not_build", "error",
     source='#include "/proc/self/environ"\n#include "/proc/1/environ"\n')

case("34a", "helpers outside of the marked region", "passed", own=True,
     source=disk("    return helper(u);", "#include <array>\nnamespace rt { static DiskSample helper(vec2 u); }") + \
         "namespace rt { static DiskSample helper(vec2 u) { return right(u); } }\n")


@case("34b", "edits of the framework", "passed", ("ignored", "framework", "not looked at", "left out"), own=True)
def _(place):
    header = (place.root / "starter/rt/math.h").read_text()
    return {"fragments/uniform_disk.cpp": disk("    return right(u);"), "rt/math.h": header.replace("double", "float"), "raytrace.cpp": "int main() {}\n",
            "CMakeLists.txt": "project(mine)\n"}


case("35a", "an empty file", {"did_not_build", "not_started"}, ("empty", "no function", "fill in"), own=True,
     source="")

case("35b", "half a file", "did_not_build", "error", own=True,
     source=disk("    return right(u);").rsplit("return right", 1)[0])

case("35c", "line ends of Windows, with a mark in front", "passed", own=True, fast=True,
     source={"uniform_disk.cpp": b"\xef\xbb\xbf" + disk("    return right(u);").replace("\n", "\r\n").encode()})

case("35d", "Latin-1 in comments and in an error", "did_not_build", "error", own=True,
     source={"uniform_disk.cpp": b'// \xe4\xf6\xfc \xff\xfe\n#error "\xe4\xf6\xfc \xff \xc3"\n'})

case("35e", "UTF-16", "did_not_build", "UTF-16", own=True,
     source={"uniform_disk.cpp": disk("    return right(u);").encode("utf-16")})

case("35f", "a file that is not there", "not_started", "not in the submission", own=True,
     source={"fragments/phong.cpp": "x\n"})

case("35g", "a comment without end", "did_not_build", ("no end", "unterminated"), own=True,
     source="/* " + disk("    return right(u);"))

case("35h", "no text but a program", "did_not_build", own=True,
     source={"uniform_disk.cpp": pathlib.Path("/bin/true").read_bytes()})


for letter, device in zip("abc", ("stdout", "stdin", "zero")):
    case(f"38{letter}", f"#include of /dev/{device}", "did_not_build", absent=NO_BUG, seconds=75, own=device == "stdout",
         source=f'#include "/dev/{device}"\n')
