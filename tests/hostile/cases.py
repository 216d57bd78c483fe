"""The submissions of the red team: one function each, numbered as in the list that README.md names.

A function gets the Place of its run and returns the source of uniform_disk.cpp, or all files of the submission by name,
or a path. Most attacks return the right answer where they succeed and a wrong one where they do not: then a submission
that gets points has won. Every bomb is bounded in its own source.
"""

import dataclasses
import gzip
import io
import os
import pathlib
import re
import struct
import subprocess
import tarfile
import zipfile

ANY_FAULT = {"failed", "crashed", "timed_out", "not_finite"}
MIB = 1 << 20


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


def quoted(path):
    return '"' + str(path).replace("\\", "\\\\").replace('"', '\\"') + '"'


def paths(*list_of_paths):
    return "const char* const paths[] = {" + ", ".join(quoted(path) for path in list_of_paths) + "};"


# ---- results

case("1", "a static constructor prints PASS and exits", "crashed", "a fragment must return, not exit", fast=True, own=True,
     source=disk("    return wrong(u);", """
static const int early = (std::puts("uniform_disk            passed              2 of 2"), std::fflush(stdout), _exit(0), 0);"""))

case("2", "atexit handlers and destructors write to all descriptors", ANY_FAULT, own=True,
     source=disk("    return wrong(u);", """
static void again() { for (int fd = 0; fd < 64; ++fd) (void)!write(fd, "passed passed passed", 20); }
static struct Late { Late() { std::atexit(again); at_quick_exit(again); } ~Late() { again(); } } late;"""))


@case("3a", "#include of the solution", "did_not_build", "error", fast=True)
def _(place):
    return f"#include {quoted(place.root / 'solution/uniform_disk.cpp')}\n"


@case("3b", "looks for the solution with __has_include", {"failed", "did_not_build"})
def _(place):
    tries = [place.root / "solution/uniform_disk.cpp", "../solution/uniform_disk.cpp", "../../solution/uniform_disk.cpp",
             "solution/uniform_disk.cpp", place.root / "grader/checks/uniform_disk.cpp"]
    lines = "".join(f"#if __has_include({quoted(path)})\n#define FOUND 1\n#endif\n" for path in tries)
    return disk("#ifdef FOUND\n    return right(u);\n#else\n    return wrong(u);\n#endif", lines)


@case("3c", "secrets through the compiler's errors", "did_not_build", "error", absent=(r"root:[x*]:0",), fast=True)
def _(place):
    return f"#include {quoted(place.secret)}\n#include \"/etc/passwd\"\n#include \"/etc/shadow\"\n"


@case("4", ".incbin of the solution and of references", "did_not_build", ("error", "incbin", "file not found"))
def _(place):
    objects = place.chain.get("solution_objects", [])[:1]
    binaries = [place.root / "solution/uniform_disk.cpp", place.secret, place.root / "scenes/reference", *objects]
    return disk("    return wrong(u);", "\n".join(f'asm(".incbin \\"{path}\\"");' for path in binaries))


@case("5", "CMake files that execute at configure", "passed", after=lambda place: victim_is_whole(place))
def _(place):
    evil = f'execute_process(COMMAND touch "{place.victim}/cmake")\nfile(WRITE "{place.victim}/file" "x")\n'
    return {"uniform_disk.cpp": disk("    return right(u);"), "CMakeLists.txt": evil, "rt/CMakeLists.txt": evil,
            "CMakePresets.json": "{", "Makefile": f"all:\n\ttouch {place.victim}/make\n"}

case("6a", "headers of its own in place of the framework's", "passed",
     source={"fragments/uniform_disk.cpp": disk("    return right(u);"),
             **{path: "#error taken\n" for path in ("rt/fragments.h", "fragments/rt/fragments.h", "fragments/math.h", "fragments/rt/math.h")}})

case("6b", "macros that spoil the framework's headers", {"did_not_build", "failed"}, own=True,
     source="#define double float\n#define private public\n#define sqrt(x) 0\n" + disk("    return right(u);"))

case("7", "its own main", {"passed", "did_not_build"}, own=True,
     source=disk("    return right(u);", 'int main() { std::puts("passed"); return 0; }\nextern "C" void _start() { _exit(0); }'))


@case("8", "objects, caches and precompiled headers beside the source", "failed")
def _(place):
    junk = b"gpch.014" + bytes(1000)
    return {"fragments/uniform_disk.cpp": disk("    return wrong(u);"), "fragments/uniform_disk.o": b"\x7fELF" + bytes(500),
            "fragments/rt/fragments.h.gch": junk, "build/release/kept/uniform_disk": junk, "build/CMakeCache.txt": "X=1\n",
            "last_run.json": "{}", "fragments/libm.so.6": junk}


# ---- the compiler

COMPILER = ("the compiler", "compiler ran", "compiling", "too ", "exceeds", "limit", "memory")
NO_BUG = (r"internal compiler error", r"submit a full bug report")

case("9a", "templates without end", "did_not_build", COMPILER, absent=NO_BUG, seconds=180, bystander=True,
     source=disk("    return right(u), DiskSample{vec2(Tree<40, 0>::value), 1};", """
template <int depth, unsigned long n> struct Tree {
    static constexpr unsigned long value = Tree<depth - 1, 2 * n>::value + Tree<depth - 1, 2 * n + 1>::value;
};
template <unsigned long n> struct Tree<0, n> { static constexpr unsigned long value = n; };"""))

case("9b", "a constexpr loop without end", "did_not_build", COMPILER + ("constexpr",), absent=NO_BUG, seconds=180,
     source=disk("    return {vec2(forever()), 1};", "consteval int forever() { int n = 0; for (unsigned i = 1; i; i |= 1) n += 1; return n; }"))

case("9c", "an initialised array of 2 GB", "did_not_build", COMPILER + ("large",), absent=NO_BUG, seconds=180,
     source=disk("    return data[int(u.x)] ? right(u) : wrong(u);", "static volatile char data[1 << 30] = {1};\nstatic volatile char more[1 << 30] = {1};"))

case("9d", "an array of zeros of 1 TB", {"did_not_build", "crashed"}, COMPILER + ("large", "truncated", "relocation"), absent=NO_BUG + ("must return, not exit",), seconds=180,
     source=disk("    return data[long(u.x * 1e9)] ? wrong(u) : right(u);", "static volatile char data[1l << 40];"))

case("9e", "brackets 200,000 deep", "did_not_build", COMPILER + ("nesting",), absent=NO_BUG, seconds=180,
     source=disk("    return {vec2(" + "(" * 100_000 + "0" + ")" * 100_000 + "), 1};"))

case("10", "12,000 errors", "did_not_build", "error", own=True, after=lambda place: outputs_are_short(place),
     source="#include \"rt/fragments.h\"\n" + "#error and again\n" * 12_000)

case("10b", "100 MB on stdout and on stderr", "passed", bystander=True, after=lambda place: outputs_are_short(place), own=True,
     source=bomb("""    const std::string text(1 << 16, 'x');
    for (int i = 0; i < 1600; ++i) (void)!write(1 + i % 2, text.data(), text.size());"""))


# ---- writing, reading, forging


@case("11", "writes into the results", ANY_FAULT, absent=("HACKED",), after=lambda place: victim_is_whole(place))
def _(place):
    return attack("    bool won = false;\n    for (const char* path : paths) {\n"
                  "        const int fd = open(path, O_WRONLY);\n"
                  '        if (fd >= 0 && write(fd, "HACKED", 6) == 6) won = true;\n'
                  f"        close(open({quoted(place.victim / 'new')}, O_WRONLY | O_CREAT, 0666));\n    }}\n    return won;",
                  paths(place.folder / "out/record.json", place.folder / "out/page/index.html", place.folder / "out/stdout",
                        place.victim / "file", place.folder / "submission/uniform_disk.cpp", place.root / "assignment.toml"))


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

SEARCH = r"""
static bool holds(const char* path) {
    const int fd = open(path, O_RDONLY);
    if (fd < 0) return false;
    std::string text(1 << 20, 0);
    const ssize_t got = read(fd, text.data(), text.size());
    close(fd);
    text.resize(got > 0 ? got : 0);
    const std::size_t at = text.find("secret-of-the");
    if (at != text.npos) std::fprintf(stderr, "%s\n", text.substr(at, 60).c_str());
    return at != text.npos;
}
extern char** environ;
"""

case("13a", "looks for secrets in the environments and arguments of all processes", ANY_FAULT, fast=True,
     source=attack("""    for (char** word = environ; *word; ++word)
        if (std::strstr(*word, "secret-of-the")) { std::fprintf(stderr, "%s\\n", *word); return true; }
    for (int pid = 1; pid < 40000; ++pid)
        for (const char* file : {"environ", "cmdline", "cwd/secret", "root/proc/1/environ"})
            if (holds(("/proc/" + std::to_string(pid) + "/" + file).c_str())) return true;
    return false;""", SEARCH))

case("13b", "#include of the environment", "did_not_build", "error",
     source='#include "/proc/self/environ"\n#include "/proc/1/environ"\n')


@case("13c", "reads secret files, the solution and references", ANY_FAULT)
def _(place):
    return attack("""    for (const char* path : paths) {
        if (holds(path)) return true;
        const int fd = open(path, O_RDONLY);
        char first = 0;
        if (fd >= 0 && read(fd, &first, 1) == 1) { std::fprintf(stderr, "%s can be read\\n", path); return true; }
    }
    return false;""", SEARCH + paths(place.secret, place.root / "solution/uniform_disk.cpp", place.root / "grader/grade.cpp",
                                     place.folder / "out/record.json", "/etc/shadow", "/etc/passwd", "/root/.bashrc"))


# ---- endings and bombs

case("14a", "an endless loop", "timed_out", "ran longer than", own=True,
     source=disk("    volatile bool on = true;\n    while (on) {}\n    return right(u);"))

case("14b", "sleeps", "timed_out", "waits", own=True, seconds=90,
     source=disk("    sleep(1000);\n    return right(u);"))

case("14c", "raises its own limits and runs on", "timed_out", ("longer", "waits"), seconds=90,
     source=disk("""    rlimit all{};
    getrlimit(RLIMIT_CPU, &all);
    all.rlim_cur = all.rlim_max;
    setrlimit(RLIMIT_CPU, &all);
    signal(SIGXCPU, SIG_IGN);
    volatile bool on = true;
    while (on) {}
    return right(u);"""))

OWN_NAME = 'static const int named = prctl(PR_SET_NAME, "hostile");'

case("15", "a fork bomb of 256 processes", {"crashed", "timed_out"}, "starts other programs", bystander=True, seconds=90, fast=True,
     source=bomb("    for (int i = 0; i < 8; ++i) fork();\n    sleep(20);", OWN_NAME))

case("15b", "starts another program", {"crashed", "failed"}, "starts other programs",
     source=bomb("""    const pid_t child = fork();
    if (child == 0) { execl("/bin/true", "true", nullptr); _exit(9); }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child || status != 0) std::abort();"""))

case("15c", "1,400 threads", {"passed", "crashed", "timed_out"}, bystander=True, seconds=90,
     source=bomb("""    pthread_attr_t small;
    pthread_attr_init(&small);
    pthread_attr_setstacksize(&small, 1 << 16);
    pthread_t thread;
    for (int i = 0; i < 1400; ++i)
        if (pthread_create(&thread, &small, [](void*) -> void* { sleep(15); return nullptr; }, nullptr) != 0) break;
    sleep(10);""", "#include <pthread.h>"))

case("16a", "2.9 GB of memory", "crashed", "memory", bystander=True, own=True, seconds=120, jobs=1,
     source=bomb("""    for (int i = 0; i < 29; ++i) std::memset(new char[100 << 20], 1 + i, 100 << 20);"""))

case("16b", "2.9 GB of memory, spread over seven children", {"crashed", "timed_out"}, ("memory", "GB", "other programs"), bystander=True, seconds=120,
     jobs=1,
     source=bomb("""    for (int i = 0; i < 7; ++i)
        if (fork() == 0) { std::memset(new char[420 << 20], 1 + i, 420 << 20); sleep(8); _exit(0); }
    while (wait(nullptr) > 0) {}""", OWN_NAME))

case("17", "a daemon, forked twice", {"passed", "crashed"}, bystander=True,
     source=bomb("    if (fork() == 0) { setsid(); if (fork() == 0) { sleep(100); _exit(0); } _exit(0); }", OWN_NAME))

case("18", "a child that holds stdout and all else open", {"passed", "crashed"}, seconds=40,
     source=bomb("    if (fork() == 0) { setsid(); sleep(100); _exit(0); }", OWN_NAME))

FILL = """    std::string text(1 << 20, 'x');
    int whole = 0;
    for (const char* folder : {".", "/tmp", "/dev/shm", "/var/tmp", "/dev", "/run"})
        for (int i = 0; i < 200 && whole < 200; ++i) {
            const int fd = open((std::string(folder) + "/hostile-" + std::to_string(i)).c_str(), O_WRONLY | O_CREAT, 0600);
            if (fd < 0) break;
            if (write(fd, text.data(), text.size()) == ssize_t(text.size())) ++whole;
            close(fd);
        }
"""

case("19a", "fills the disk: 200 MB", ANY_FAULT, bystander=True,
     source=attack(FILL + "    return whole >= 200;"))

case("19b", "a sparse file of 1 TB", ANY_FAULT,
     source=attack("""    signal(SIGXFSZ, SIG_IGN);
    const int fd = open("hostile-sparse", O_RDWR | O_CREAT, 0600);
    return fd >= 0 && ftruncate(fd, 1l << 40) == 0;"""))

case("19c", "20,000 files", ANY_FAULT | {"passed"}, bystander=True,
     source=bomb("""    for (int i = 0; i < 20000; ++i) {
        const int fd = open(("hostile-" + std::to_string(i)).c_str(), O_WRONLY | O_CREAT, 0600);
        if (fd >= 0) close(fd);
    }"""))


def _special(place, make, *more):
    folder = place.folder / "submission"
    folder.mkdir(exist_ok=True)
    make(folder / "uniform_disk.cpp", *more)
    return folder

NO_FILE = ("not a regular file",)


@case("20a", "the source is a link to the solution", {"did_not_build", "not_started"}, NO_FILE, fast=True)
def _(place):
    return _special(place, lambda path: path.symlink_to(place.root / "solution/uniform_disk.cpp"))


@case("20b", "the source is a FIFO", {"did_not_build", "not_started"}, NO_FILE)
def _(place):
    return _special(place, os.mkfifo)


@case("20c", "the source is a link to a device", {"did_not_build", "not_started"}, NO_FILE)
def _(place):
    return _special(place, lambda path: path.symlink_to("/dev/zero"))

case("20d", "puts links and FIFOs in place of all files around it", {"passed"} | ANY_FAULT, bystander=True,
     source=bomb("""    if (DIR* here = opendir(".")) {
        while (const dirent* entry = readdir(here))
            if (entry->d_name[0] != '.' && unlink(entry->d_name) == 0)
                if (mkfifo(entry->d_name, 0666) != 0) (void)!symlink("/dev/zero", entry->d_name);
        closedir(here);
    }
    (void)!mkfifo("answer", 0666);"""))

FORGE = """static void forge(const void* bytes, std::size_t size) {
    for (int fd = 3; fd < 64; ++fd) (void)!write(fd, bytes, size);
}"""

case("21a", "forges an answer of 2^62 bytes", "crashed", "channel",
     source=disk("""    struct { unsigned kind = 4, check = 0x52454e50; unsigned long bytes = 1ul << 62; } head;
    forge(&head, sizeof head);
    return right(u);""", FORGE))


case("21e", "forges answers of the right number, all of them empty", "crashed", "channel", fragments=("shutter_time",),
     source={"shutter_time.cpp": HEAD + """#include <vector>
namespace rt {
Real shutter_time(const Shutter& s, Real u) {
    static const bool once = [] {
        for (int answers = 0; answers < 2; ++answers) {
            struct { unsigned kind = 4, check = 0x52454e50; unsigned long bytes = 8 * (2 + 1024); } head;
            std::vector<double> numbers(2 + 1024, 0.0);
            numbers[1] = 1024;
            (void)!write(10, &head, sizeof head);
            (void)!write(10, numbers.data(), head.bytes);
        }
        return true;
    }();
    return once ? s.open + u * (s.close - s.open) : 0;
}
}  // namespace rt
"""})

# Its own answers pass through a pipe, and are rewritten on their way to the grader.
REWRITE = """#include <vector>
#include <sys/time.h>
static int channel = -1, pipe_out = -1;
static std::vector<char> got;
struct Head { unsigned kind, check; unsigned long bytes; };
static void pass_on(int) {
    char bytes[65536];
    for (ssize_t n; (n = read(pipe_out, bytes, sizeof bytes)) > 0;) got.insert(got.end(), bytes, bytes + n);
    Head head;
    if (got.size() < sizeof head) return;
    std::memcpy(&head, got.data(), sizeof head);
    if (got.size() < sizeof head + head.bytes) return;
    std::vector<double> numbers(head.bytes / 8);
    std::memcpy(numbers.data(), got.data() + sizeof head, numbers.size() * 8);
    if (head.kind == 4 || head.kind == 6) rewrite(numbers, head.kind);
    std::memcpy(got.data() + sizeof head, numbers.data(), numbers.size() * 8);
    for (std::size_t at = 0; at < got.size();) {
        const ssize_t n = write(channel, got.data() + at, got.size() - at);
        if (n <= 0) break;
        at += n;
    }
    got.clear();
}
static void hook() {
    static bool is_done = false;
    int ends[2];
    if (is_done || pipe(ends) != 0) return;
    is_done = true;
    fcntl(ends[0], F_SETFL, O_NONBLOCK), fcntl(ends[1], F_SETPIPE_SZ, 1 << 20);
    channel = dup(10), pipe_out = ends[0], dup2(ends[1], 10);
    struct sigaction action{};
    action.sa_handler = pass_on, action.sa_flags = SA_RESTART;
    sigaction(SIGALRM, &action, nullptr);
    itimerval often{{0, 3000}, {0, 3000}};
    setitimer(ITIMER_REAL, &often, nullptr);
}
"""


def rewritten(edit):
    """mirror_direction, wrong, whose numbers the edit changes: v, of answers (kind 4) or of a picture (kind 6)."""
    rewrite = f"#include <cmath>\n#include <vector>\nstatic void rewrite(std::vector<double>& v, unsigned kind) {{ {edit} }}\n"
    return {"mirror_direction.cpp": HEAD + rewrite + REWRITE +
            "namespace rt {\nvec3 mirror_direction(vec3 d, vec3 n) { hook(); return d - dot(d, n) * n; }\n}\n"}

case("21f", "gives its CPU time as NaN", "crashed", "channel", fragments=("mirror_direction",), html=True,
     source=rewritten("(void)kind; if (!v.empty()) v[0] = NAN;"))

case("21g", "gives its CPU time as less than nothing", "crashed", "channel", fragments=("mirror_direction",), html=True,
     source=rewritten("if (kind == 4) v[0] = -2e300;"))

case("21h", "gives an infinite CPU time and number of rays for a picture", ANY_FAULT, fragments=("mirror_direction",), html=True,
     source=rewritten("if (kind == 6) for (int i = 2; i < 10; ++i) v[i] = INFINITY;"))


@case("21b", "malformed pictures in the submission", "passed")
def _(place):
    exr = b"\x76\x2f\x31\x01" + b"\xff" * 400
    return {"fragments/uniform_disk.cpp": disk("    return right(u);"), "scenes/reference/whitted.exr": exr, "out.exr": exr,
            "out.png": b"\x89PNG\r\n\x1a\n" + b"\xff" * 99}


def mean(body):
    return {"pixel_mean.cpp": f"{HEAD}namespace rt {{\nColor pixel_mean(std::span<const Color> radiance, std::span<const Real> weight) {{\n"
            f"    Color sum(0);\n    for (std::size_t i = 0; i < radiance.size(); ++i) sum += weight[i] * radiance[i];\n"
            f"    sum /= Real(radiance.size());\n{body}\n}}\n}}  // namespace rt\n"}

case("22a", "a picture of NaN", "not_finite", ("nan", "NaN", "finite"), fragments=("pixel_mean",), fast=True, own=True,
     source=mean("    return sum * std::nan(\"\");"))

case("22b", "infinity", {"not_finite", "failed"}, ("inf", "finite"), fragments=("pixel_mean",), own=True,
     source=mean("    return sum / 0.0;"))

case("22c", "negative light", "failed", fragments=("pixel_mean",), own=True,
     source=mean("    return -sum;"))


case("22e", "light whose squares are no number", "failed", fragments=("pixel_mean",), own=True, html=True,
     source=mean("    return 1e200 * sum;"))


@case("22d", "forges a picture of the wrong size", ANY_FAULT, ("channel", "size"), fragments=("pixel_mean",))
def _(place):
    files = mean("""    struct { unsigned kind = 6, check = 0x52454e50; unsigned long bytes = 10 * 8; double numbers[10] = {1e9, 1e9, 0}; } head;
    forge(&head, sizeof head);
    return sum;""")
    return {name: text.replace("namespace rt {", FORGE + "\nnamespace rt {", 1) for name, text in files.items()}

case("23", "answers that are written down", "failed", fragments=("pixel_mean",), own=True,
     source=mean("    return Color(0.5);"))

case("24", "looks whether the grader is its parent", ANY_FAULT,
     source=attack("""    for (int pid = getppid(), steps = 0; steps < 4; ++steps) {
        const std::string folder = "/proc/" + std::to_string(pid);
        char name[99] = {};
        const int fd = open((folder + "/comm").c_str(), O_RDONLY);
        if (fd < 0) return false;
        (void)!read(fd, name, 98);
        if (std::strstr(name, "grade")) return true;
        pid = 1;
    }
    return false;"""))


# ---- the outside


@case("25a", "TCP", ANY_FAULT, fast=True)
def _(place):
    return attack(f"""    const int fd = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in to{{}};
    to.sin_family = AF_INET, to.sin_port = htons({place.tcp}), to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return fd >= 0 && connect(fd, reinterpret_cast<sockaddr*>(&to), sizeof to) == 0;""")


@case("25b", "UDP", ANY_FAULT, after=lambda place: None)
def _(place):
    return attack(f"""    const int fd = socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in to{{}};
    to.sin_family = AF_INET, to.sin_port = htons({place.udp}), to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (fd < 0 || sendto(fd, "taken", 5, 0, reinterpret_cast<sockaddr*>(&to), sizeof to) != 5) return false;
    char back[9];
    timeval soon{{1, 0}};
    setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &soon, sizeof soon);
    return recv(fd, back, 9, 0) > 0;""")


@case("25c", "a socket without a file", ANY_FAULT)
def _(place):
    return attack(f"""    const int fd = socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un to{{}};
    to.sun_family = AF_UNIX;
    std::strcpy(to.sun_path + 1, {quoted(place.unix)});
    return fd >= 0 && connect(fd, reinterpret_cast<sockaddr*>(&to), sizeof(sa_family_t) + 1 + {len(place.unix)}) == 0;""")

case("26", "state between runs: /tmp, /dev/shm, System V", ANY_FAULT, times=2,
     source=attack("""    bool seen = false;
    for (const char* path : {"/tmp/hostile-state", "/var/tmp/hostile-state", "/dev/shm/hostile-state", "/run/hostile-state", "../hostile-state"}) {
        if (access(path, F_OK) == 0) seen = true;
        const int fd = open(path, O_WRONLY | O_CREAT, 0666);
        if (fd >= 0) close(fd);
    }
    const long shared = syscall(SYS_shmget, 0x686f73, 4096, IPC_CREAT | IPC_EXCL | 0666);
    if (shared < 0 && errno == EEXIST) seen = true;
    const long queue = syscall(SYS_msgget, 0x686f73, IPC_CREAT | IPC_EXCL | 0666);
    if (queue < 0 && errno == EEXIST) seen = true;
    return seen;"""))

case("27a", "ptrace and the memory of others", ANY_FAULT,
     source=attack("""    for (int pid : {int(getppid()), 1, int(getpid()) - 1, int(getpid()) - 2, int(getpid()) + 1}) {
        if (pid <= 0 || pid == getpid()) continue;
        char byte;
        iovec here{&byte, 1}, there{reinterpret_cast<void*>(0x400000), 1};
        if (syscall(SYS_process_vm_readv, pid, &here, 1ul, &there, 1ul, 0ul) == 1) return true;
        if (open(("/proc/" + std::to_string(pid) + "/mem").c_str(), O_RDONLY) >= 0) return true;
        if (ptrace(PTRACE_ATTACH, pid, 0, 0) == 0) return true;
    }
    return false;""", "#include <sys/uio.h>"))

case("27b", "kills its parent", ANY_FAULT | {"passed"}, bystander=True, seconds=90,
     source=bomb("    kill(getppid(), SIGKILL);\n    kill(0, SIGKILL);"))

case("27c", "kills everyone", {"crashed", "failed"}, bystander=True, seconds=90,
     source=attack("    return kill(-1, SIGKILL) == 0 && sleep(1) == 0;"))

case("27d", "has the kernel send SIGKILL to others, as the news of a socket", {"failed", "passed", "crashed"}, bystander=True,
     source=bomb("""    for (int pid : {int(getppid()), int(getpid()) - 1, int(getpid()) - 2, int(getpid()) - 3, int(getpid()) + 1, 2, 3}) {
        int ends[2];
        if (pid <= 1 || pid == getpid() || socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) continue;
        fcntl(ends[0], F_SETOWN, pid), fcntl(ends[0], 10 /* F_SETSIG */, SIGKILL), fcntl(ends[0], F_SETFL, O_ASYNC);
        (void)!write(ends[1], "x", 1);
    }"""))

case("28a", "overwrites the machine code around it", ANY_FAULT, bystander=True,
     source=attack("""    auto* at = reinterpret_cast<unsigned char*>(reinterpret_cast<unsigned long>(&rt::cosine_hemisphere) & ~4095ul);
    if (mprotect(at, 4096, PROT_READ | PROT_WRITE | PROT_EXEC) == 0) std::memset(at, 0xc3, 4096);
    return false;"""))

case("28b", "throws rows of its own into the channel", ANY_FAULT, ("channel",),
     source=disk("""    struct { unsigned kind = 4, check = 0x52454e50; unsigned long bytes = 32; double numbers[4] = {0, 1, 1, 0.5}; } rows;
    forge(&rows, sizeof rows);
    return wrong(u);""", FORGE))

case("29", "a blurred picture with the right mean", "failed", fragments=("film_sample",), own=True,
     source={"film_sample.cpp": '#include "rt/fragments.h"\nnamespace rt {\nFilmSample film_sample(const Extent& pixel, int, int, vec2 u) {\n'
             "    const vec2 middle = 0.5 * (pixel.low + pixel.high);\n    return {middle + 6.0 * (u - vec2(0.5)), 1};\n}\n}  // namespace rt\n"})

case("30", "one sample with noise painted on", "failed", fragments=("pixel_mean",), own=True,
     source=mean("    return radiance[0] * (1 + 0.01 * std::sin(1e6 * radiance[0].x));"))


# ---- archives


def _zip(place, entries, name="submission.zip"):
    path = place.folder / name
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for entry, text in entries:
            archive.writestr(entry, text)
    return path


def _tar(place, add, name="submission.tar.gz"):
    path = place.folder / name
    with tarfile.open(path, "w:gz") as archive:
        add(archive)
    return path


def _file(archive, name, text, **more):
    info = tarfile.TarInfo(name)
    info.size = len(text)
    for key, value in more.items():
        setattr(info, key, value)
    archive.addfile(info, io.BytesIO(text.encode()))


@case("31a", "an archive whose names lead out of it", "passed", after=lambda place: victim_is_whole(place), fast=True)
def _(place):
    return _zip(place, [("fragments/uniform_disk.cpp", disk("    return right(u);")), (f"{place.victim}/zip", "x"),
                        (f"../../../../../..{place.victim}/zip", "x"), ("../uniform_disk.cpp", disk("    return wrong(u);"))])


@case("31b", "an archive with links and devices", {"did_not_build", "not_started"}, NO_FILE)
def _(place):
    def add(archive):
        link = tarfile.TarInfo("fragments/uniform_disk.cpp")
        link.type, link.linkname = tarfile.SYMTYPE, str(place.root / "solution/uniform_disk.cpp")
        archive.addfile(link)
        device = tarfile.TarInfo("fragments/mirror_direction.cpp")
        device.type, device.devmajor, device.devminor = tarfile.CHRTYPE, 1, 5
        archive.addfile(device)
        _file(archive, "fragments/phong.cpp", MIRROR)

    return _tar(place, add)


@case("31c", "an archive that unpacks to 300 MB", set(), ("unpacks to more than", "more than"), code=2)
def _(place):
    return _zip(place, [("fragments/uniform_disk.cpp", disk("    return right(u);")), ("big", bytes(300 * MIB))])


@case("31d", "a fragment of 300 MB in an archive", {"did_not_build", "not_started"}, "larger than", fast=True)
def _(place):
    return _zip(place, [("fragments/uniform_disk.cpp", bytes(300 * MIB)), ("fragments/phong.cpp", "x")])


@case("31e", "no archive at all", set(), "cannot be unpacked", code=2)
def _(place):
    path = place.folder / "submission.tar.gz"
    path.write_bytes(gzip.compress(b"\xff" * 5000)[:-9] + b"\0" * 20)
    return path


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
    return _zip(place, [(odd + "uniform_disk.cpp", disk("    return right(u);")), ("<img src=x onerror=alert(2)>/fragments/uniform_disk.cpp", "x"),
                        (odd + "Uniform-Disk.cpp", "x"), (odd + "phong.cpp", "x")])


@case("32d", "ESC in the name of the submission, which is none", set(), absent=CONTROLS, off_page=TAGS, code=2)
def _(place):
    folder = place.folder / "\x1b[31m<script>alert(1)<"
    folder.mkdir()
    (folder / "\x1b[31m.zip").write_text("x")
    return folder


# ---- symbols and sources

case("33a", "overrides the C library", "passed", own=True,
     source=disk("    return right(u);", """
extern "C" {
void* malloc(std::size_t) { std::abort(); }
void free(void*) { std::abort(); }
ssize_t write(int, const void*, std::size_t) { std::abort(); }
ssize_t read(int, void*, std::size_t) { std::abort(); }
int clock_gettime(clockid_t, timespec* t) { t->tv_sec = t->tv_nsec = 0; return 0; }
void __asan_init() { std::abort(); }
const char* __asan_default_options() { return "detect_leaks=0"; }
}
void* operator new(std::size_t) { std::abort(); }
void operator delete(void*) noexcept { std::abort(); }"""))

case("33b", "overrides of the grader's own functions", "passed",
     source=disk("    return right(u);", """
namespace rt { void require_processor() { std::abort(); } Color pixel_mean(std::span<const Color>, std::span<const Real>) { std::abort(); } }
namespace grade { std::vector<double> probe(const std::string&, const std::vector<double>&) { std::abort(); } }"""))

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


@case("35b", "half a file", "did_not_build", "error", own=True)
def _(place):
    text = disk("    return right(u);")
    return text[: text.rindex("return right")]

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


# ---- what the linker and the demangler read


def lto_sections(place, source, options=None):
    """asm that puts the sections of a bytecode object into a fragment."""
    work = place.folder / "lto"
    work.mkdir(exist_ok=True)
    (work / "m.cpp").write_text(source)
    chain = place.chain
    includes = [word for folder in chain["includes"] for word in ("-I", folder)]
    subprocess.run([chain["compiler"], *chain["compile"], *chain["options"], *includes, "-w", "-flto", "-fno-fat-lto-objects", "-c", "m.cpp"],
                   cwd=work, check=True)
    data = (work / "m.o").read_bytes()
    table, = struct.unpack_from("<Q", data, 40)
    count, names = struct.unpack_from("<HH", data, 60)
    headers = [struct.unpack_from("<IIQQQQIIQQ", data, table + 64 * i) for i in range(count)]
    lines = ['asm(R"(']
    for header in headers:
        at = headers[names][4] + header[0]
        name = data[at:data.index(b"\0", at)].decode()
        if not name.startswith(".gnu.lto_"):
            continue
        content = data[header[4]:header[4] + header[5]]
        if options and name.startswith(".gnu.lto_.opts"):
            content = options.encode() + b"\0"
        lines.append(f'.section {name},"e",@progbits')
        lines += [".byte " + ",".join(map(str, content[i:i + 64])) for i in range(0, len(content), 64)]
    return "\n".join(lines + [".text", ')");\n'])


@case("36a", "an LTO object through asm, with the right answer in it", {"did_not_build", "failed"})
def _(place):
    return disk("    return wrong(u);") + lto_sections(place, disk("    return right(u);"))


@case("36b", "an LTO object that includes the solution and its object", {"did_not_build", "failed"})
def _(place):
    solution = place.chain.get("solution_objects", ["/none"])
    disk_object = next((name for name in solution if "uniform_disk" in name), "/none")
    extra = "\n".join(f'asm(".incbin \\"{path}\\"");' for path in (place.secret, place.root / "solution/uniform_disk.cpp", disk_object))
    return disk("    return wrong(u);") + lto_sections(place, disk("    return right(u);", extra))


@case("36c", "an LTO object with options that write files", {"did_not_build", "failed"}, after=lambda place: victim_is_whole(place))
def _(place):
    options = " ".join(f"'{word}'" for word in ("-O2", "-dumpdir", f"{place.victim}/", "-fdump-tree-all", f"-Wa,-adhln={place.victim}/list", "-save-temps",
                                                "-B", str(place.victim), "-fplugin=/none.so"))
    return disk("    return wrong(u);") + lto_sections(place, disk("    return right(u);", f'asm(".print \\"taken\\"");'), options)


@case("36d", "an object that asks for a plugin, a script and libraries", {"did_not_build", "failed", "passed"})
def _(place):
    return disk("    return right(u);", f'''
asm(R"(.section .deplibs,"MS",@0x6fff4c04,1
.asciz "{place.victim}/lib.so"
.section .note.GNU-stack,"x",@progbits
.section .interp,"a",@progbits
.asciz "{place.victim}/ld.so"
.section .preinit_array,"aw",@preinit_array
.text
)");''')


def exploding(depth):
    """A symbol of some hundred characters that demangles to 2^depth names."""
    digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ"
    def sub(i):  # substitution number i
        if i == 0:
            return "S_"
        i -= 1
        return "S" + ((digits[i // 36] if i >= 36 else "") + digits[i % 36]) + "_"
    name = "_Z12uniform_diskSt4pairIiiE"
    for level in range(depth):
        name += f"S_I{sub(level + 1)}{sub(level + 1)}E"
    return name


@case("37a", "a symbol that demangles to gigabytes, for its own name", "did_not_build", fast=True)
def _(place):
    name = exploding(56)
    return f'#include "rt/fragments.h"\nextern "C" void boom() asm("{name}");\nextern "C" void boom() {{}}\n'


@case("37b", "500 such symbols beside the right one", {"passed", "did_not_build"})
def _(place):
    name = exploding(24)
    more = "".join(f'extern "C" void boom{i}() asm("{name}{"i" * (i % 97)}_{i}");\nextern "C" void boom{i}() {{}}\n' for i in range(500))
    return disk("    return right(u);") + more

case("37c", "an undefined symbol that demangles to gigabytes", "did_not_build",
     source=disk("    boom();\n    return right(u);", f'extern "C" void boom() asm("{exploding(56)}");'))


for letter, device in zip("abc", ("stdout", "stdin", "zero")):
    @case(f"38{letter}", f"#include of /dev/{device}", "did_not_build", absent=NO_BUG, seconds=75, own=device == "stdout")
    def _(place, device=device):
        return f'#include "/dev/{device}"\n'

case("39a", "deep folders, mode 000", {"passed"} | ANY_FAULT, bystander=True,
     source=bomb("""    for (int i = 0; i < 400 && mkdir("hostile-deep", 0700) == 0 && chdir("hostile-deep") == 0; ++i)
        for (const char* name : {"a", "b"}) { const int fd = open(name, O_WRONLY | O_CREAT, 0); if (fd >= 0) close(fd); }
    chmod("..", 0), chmod(".", 0), chmod("../..", 0);"""))

case("39b", "400 MB in the object", "did_not_build", ("the compiler", "large", "MB", "too", "assembler"), bystander=True, absent=NO_BUG,
     source=disk("    return right(u);", 'asm(".data\\n.fill 400000000\\n.text");'))

case("40a", "stops itself", "timed_out", ("waits", "stopped", "stop"), seconds=90,
     source=bomb("    raise(SIGSTOP);"))

case("40b", "stops its parent", {"timed_out", "passed", "crashed"}, seconds=90, bystander=True,
     source=bomb("    kill(getppid(), SIGSTOP);"))

case("40c", "kills process 1", {"crashed", "passed", "failed"}, absent=("out of memory",), seconds=90, bystander=True,
     source=bomb("    kill(1, SIGKILL);"))

case("40d", "closes all descriptors", {"crashed", "timed_out"}, own=True, seconds=90,
     source=bomb("    for (int fd = 0; fd < 1024; ++fd) close(fd);"))

case("41a", "namespaces and mounts of its own", ANY_FAULT, fast=True,
     source=attack("""    if (syscall(SYS_unshare, CLONE_NEWUSER | CLONE_NEWNS) == 0) return true;
    if (mount("tmpfs", "/tmp", "tmpfs", 0, nullptr) == 0) return true;
    const long child = syscall(SYS_clone, CLONE_NEWUSER | SIGCHLD, 0, 0, 0, 0);
    if (child == 0) _exit(0);
    return child > 0;"""))

case("41b", "io_uring and keyrings", ANY_FAULT, fast=True,
     source=attack("""    char parameters[120] = {};
    if (syscall(425, 4, parameters) >= 0) return true;
    return syscall(SYS_add_key, "user", "hostile", "x", 1ul, -4l) >= 0 || syscall(SYS_keyctl, 0, -3, 1) >= 0;"""))

case("42", "one second of sleep for each answer", "timed_out", ("longer", "too long", "waits", "budget"), seconds=120, own=True,
     source=disk("    static int calls = 0;\n    if (calls++ % 50 == 0) usleep(1000000);\n    return right(u);"))

case("43", "writes to its own program file", ANY_FAULT | {"passed"}, bystander=True,
     source=bomb("""    char self[4096] = {};
    if (readlink("/proc/self/exe", self, 4095) <= 0) return;
    chmod(self, 0777);
    int fd = open(self, O_WRONLY);
    if (fd < 0) { unlink(self); fd = open(self, O_WRONLY | O_CREAT, 0777); }
    if (fd >= 0 && write(fd, "#!/bin/false\\n", 13) == 13) std::fprintf(stderr, "written\\n");"""))

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


@case("45a", "an archive of 6,000 copies", {"passed", "failed"}, code=None)
def _(place):
    filler = os.urandom(16 << 10).hex()
    return _zip(place, [(f"copy{i}/uniform_disk.cpp", disk("    return right(u);") + f"// {i} " + filler * 6) for i in range(1500)]
                + [(f"more{i}/uniform_disk.cpp", f"// {i}\n" + " " * 250_000) for i in range(4500)])

case("45b", "names that look like fragments", "not_started", "uniform_disk", own=True,
     source={"fragments/Uniform_Disk.cpp": disk("    return right(u);"), "fragments/uniform_disk-1.cpp": "x", "fragments/uniform_disk.cpp.txt": "x",
             "fragments/uniform_disk.cpp/uniform_disk.txt": "x", "fragments/phong.cpp": "x"})


@case("45c", "UTF-8 names in an archive, with and without the flag", "passed")
def _(place):
    path = _zip(place, [("\u00dcbung \u4e00/fragments/uniform_disk.cpp", disk("    return right(u);")), ("caf\u00e9/readme.txt", "x")])
    data = bytearray(path.read_bytes())
    for signature, at in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):  # one of two entries loses the flag
        data[data.rindex(signature) + at + 1] &= ~0x08 & 0xff
    path.write_bytes(data)
    return path

case("45d", "two copies of the assignment", "passed", "taken", own=True,
     source={"old/fragments/uniform_disk.cpp": disk("    return wrong(u);"), "new/fragments/uniform_disk.cpp": disk("    return right(u);"),
             "new/fragments/mirror_direction.cpp": MIRROR})


# ---- 46: sources that the grader itself reads, to say what must stand in which line

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


# ---- what must hold afterwards


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


def number_of(case_):
    return int(re.match(r"\d+", case_.number).group())
