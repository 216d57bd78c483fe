"""What comes back: forged and rewritten answers, spoilt numbers, pictures that only look right."""

from .kit import ANY_FAULT, HEAD, case, disk, mean

case("1", "a static constructor prints PASS and exits", "crashed", "a fragment must return, not exit", fast=True, own=True,
     source=disk("    return wrong(u);", """
static const int early = (std::puts("uniform_disk            passed              2 of 2"), std::fflush(stdout), _exit(0), 0);"""))

case("2", "atexit handlers and destructors write to all descriptors", ANY_FAULT, own=True,
     source=disk("    return wrong(u);", """
static void again() { for (int fd = 0; fd < 64; ++fd) (void)!write(fd, "passed passed passed", 20); }
static struct Late { Late() { std::atexit(again); at_quick_exit(again); } ~Late() { again(); } } late;"""))

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


case("22a", "a picture of NaN", "not_finite", ("nan", "NaN", "finite"), fragments=("pixel_mean",), fast=True, own=True,
     source=mean("    return sum * std::nan(\"\");"))

case("22b", "infinity", {"not_finite", "failed"}, ("inf", "finite"), fragments=("pixel_mean",), own=True,
     source=mean("    return sum / 0.0;"))

case("22c", "negative light", "failed", fragments=("pixel_mean",), own=True,
     source=mean("    return -sum;"))

case("22e", "light whose squares are no number", "failed", fragments=("pixel_mean",), own=True, html=True,
     source=mean("    return 1e200 * sum;"))


case("22d", "forges a picture of the wrong size", ANY_FAULT, ("channel", "size"), fragments=("pixel_mean",),
     source=mean("""    struct { unsigned kind = 6, check = 0x52454e50; unsigned long bytes = 10 * 8; double numbers[10] = {1e9, 1e9, 0}; } head;
    forge(&head, sizeof head);
    return sum;""", FORGE + "\n"))


case("23", "answers that are written down", "failed", fragments=("pixel_mean",), own=True,
     source=mean("    return Color(0.5);"))

case("28b", "throws rows of its own into the channel", ANY_FAULT, ("channel",),
     source=disk("""    struct { unsigned kind = 4, check = 0x52454e50; unsigned long bytes = 32; double numbers[4] = {0, 1, 1, 0.5}; } rows;
    forge(&rows, sizeof rows);
    return wrong(u);""", FORGE))

case("29", "a blurred picture with the right mean", "failed", fragments=("film_sample",), own=True,
     source={"film_sample.cpp": '#include "rt/fragments.h"\nnamespace rt {\nFilmSample film_sample(const Extent& pixel, int, int, vec2 u) {\n'
             "    const vec2 middle = 0.5 * (pixel.low + pixel.high);\n    return {middle + 6.0 * (u - vec2(0.5)), 1};\n}\n}  // namespace rt\n"})

case("30", "one sample with noise painted on", "failed", fragments=("pixel_mean",), own=True,
     source=mean("    return radiance[0] * (1 + 0.01 * std::sin(1e6 * radiance[0].x));"))
