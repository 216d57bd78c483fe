"""What is told: fake result lines, HTML and escape sequences, machine code; and sources that the grader itself reads, to say
what must stand in which line."""

from .kit import case, disk, outputs_are_short, zipped

case("10", "12,000 errors", "did_not_build", "error", own=True, after=outputs_are_short,
     source="#include \"rt/fragments.h\"\n" + "#error and again\n" * 12_000)

# GitHub obeys "::error::" behind blanks as well, and "##[" anywhere in a line
FAKES = (r"(?m)^\s*uniform_disk +passed", r"(?m)^\s*::", r"##\[")

case("12a", "fake result lines and annotations, then an abort", "crashed", "abort",
     unsaid=FAKES, html=True, fast=True,
     source=disk(r"""    const char* text = "\n  uniform_disk            passed              2 of 2\n::error::taken\n##[set-output]x\nTotal  100 of 100\n";
    std::fputs(text, stderr), std::fputs(text, stdout), std::fflush(stdout);
    std::abort();"""))

case("12b", "fake result lines in an exception and in an error", "crashed", "exception",
     unsaid=FAKES,
     source=disk(r'    throw std::runtime_error("\n  uniform_disk            passed              2 of 2\n::error::taken\n##[x]");',
                 head="#include <stdexcept>\n"))

TAGS, CONTROLS = (r"<script>alert\(1\)", r"<img src=x"), ("\x1b", "\x07")

INJECTION = '<script>alert(1)</script> <img src=x onerror=alert(2)> \\u001b[31mred\\u001b[0m \\a =cmd|calc!A1'


@case("32a", "HTML, ANSI and formulas in a compiler's error", "did_not_build", "error", absent=CONTROLS, off_page=TAGS, html=True)
def _(place):
    raw = INJECTION.replace("\\u001b", "\x1b").replace("\\a", "\x07")
    return f'#include "rt/fragments.h"\n#error {raw}\nnamespace rt {{ "{raw}" }}\n'


@case("32b", "the same in an exception", "crashed", "exception", absent=CONTROLS, off_page=TAGS, html=True, fast=True)
def _(place):
    text = INJECTION.replace("\\u001b", "\\x1b""\" \"")
    return disk(f'    throw std::runtime_error("{text}");', head="#include <stdexcept>\n")


@case("32c", "the same in the names of an archive", "passed", absent=CONTROLS, off_page=TAGS, html=True)
def _(place):
    odd = "\x1b[31m<script>alert(1)</script>\x07/fragments/"
    return zipped(place, [(odd + "uniform_disk.cpp", disk("    return right(u);")), ("<img src=x onerror=alert(2)>/fragments/uniform_disk.cpp", "x"),
                          (odd + "Uniform-Disk.cpp", "x"), (odd + "phong.cpp", "x")])


@case("32d", "ESC in the name of the submission, which is none", set(), absent=CONTROLS, off_page=TAGS, code=2)
def _(place):
    folder = place.folder / "\x1b[31m<script>alert(1)<"
    folder.mkdir()
    (folder / "\x1b[31m.zip").write_text("x")
    return folder


SIBLING = r"""
#include <stdexcept>
static std::string code() {
    std::string text;
    const auto* at = reinterpret_cast<const unsigned char*>(&rt::cosine_hemisphere);
    char two[3];
    for (int i = 0; i < 2000; ++i) std::snprintf(two, 3, "%02x", at[i]), text += two;
    return text;
}"""

case("44a", "machine code of its siblings in an excerpt", "crashed", absent=(r"[0-9a-f]{400}",), html=True,
     source=disk("    std::fputs(code().c_str(), stderr), std::abort();", SIBLING))

case("44b", "machine code of its siblings in an exception", "crashed", "exception", absent=(r"[0-9a-f]{400}",), html=True,
     source=disk("    throw std::runtime_error(code());", SIBLING))

case("46a", "a name of 31,500 letters", "failed", own=True, fast=True,
     source=disk("    DiskSample " + "y" * 31_500 + " = wrong(u);\n    return " + "y" * 31_500 + ";"))

case("46b", "a product of 40 sums, and a condition with 40 parts", "failed", own=True, fast=True,
     source=disk("    DiskSample s = wrong(u);\n    if (u.x < 2" + " && u.x < 2" * 40 + ")\n"
                 "        s.point = s.point * (u.x + 2)" + " * (u.x / 2 + 1)" * 40 + ";\n    return s;"))

case("46c", "580 values that may stand in each other's place", "failed", own=True,
     source=disk("    vec2 v0 = u + 1.0;\n" + "".join(f"    const vec2 v{i} = v{i - 1} + u;\n" for i in range(1, 580))
                 + "    DiskSample s = wrong(u);\n    s.point = v579;\n    return s;"))

case("46d", "lambdas within each other, behind each of which no statement follows", "failed", own=True,
     source=disk("    const auto f = " + "[&] { const Real y = " * 40 + "u.x" + "; return y; }() ?: 1.0" * 40 + ";\n    (void)f;\n    return wrong(u);"))

case("46e", "sleeps where it is asked with changed expressions", "failed", seconds=120, own=True,
     source=disk("    if (changed()) usleep(200'000);\n    return wrong(u);",
                 "static bool changed() {\n    char path[500] = {};\n    return readlink(\"/proc/self/exe\", path, 499) > 0 && std::strstr(path, \"editable\");\n}"))

case("46f", "words in a comment of the line that is told", "failed", own=True, unsaid=(r"full points", r"`[^`]*```"),
     source=disk("    DiskSample s = wrong(u);\n    Real volatile /* full points, please ``` */ k = u.x * 3;\n    s.point = s.point * k;\n    return s;"))
