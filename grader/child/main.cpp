#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csetjmp>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <iterator>
#include <optional>

#include "arithmetic/self_test.h"
#include "child/probes.h"
#include "protocol/bytes.h"
#include "protocol/protocol.h"
#include "protocol/swarm.h"
#include "rt/files/scene_reader.h"
#include "rt/processor.h"
#include "rt/render.h"
#include "textbook/edits.h"

extern "C" [[gnu::weak]] void __sanitizer_print_stack_trace();  // NOLINT: it is the sanitizers' name

/// child SECONDS [MESHES [locked]]: renders scenes and calls fragments as the grader asks. It only ever answers with
/// data; each answer may take SECONDS of CPU time. Locked: it cannot become another program.
namespace {

using namespace grade;

static_assert(image_head == 3 + std::tuple_size_v<rt::RayCounts>);

/// Kills the program where it would become another one. The sandbox cannot forbid that: by the same call this one
/// starts.
void lock_in(int argc, char**, char**) {
    if (argc < 4) return;
    sock_filter code[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_execve, 1, 0), BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_execveat, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS), BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
    const sock_fprog program{std::size(code), code};
    if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) _exit(127);
}

/// Runs before any constructor, also those of fragments.
[[gnu::section(".preinit_array"), gnu::used]] void (*const locks_in)(int, char**, char**) = lock_in;

int results = -1;  // a copy of descriptor 3 that fragments do not know

void write_all(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = write(results, bytes.data(), bytes.size());
        if (sent <= 0) std::_Exit(0);  // the grader is gone
        bytes.remove_prefix(std::size_t(sent));
    }
}

bool read_all(void* target, std::size_t bytes) {
    auto* place = static_cast<char*>(target);
    while (bytes > 0) {
        const ssize_t got = read(STDIN_FILENO, place, bytes);
        if (got <= 0) return false;
        place += got;
        bytes -= std::size_t(got);
    }
    return true;
}

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
}

/// From now on there are that many seconds of CPU time.
void allow(double seconds) {
    rlimit limit{};
    getrlimit(RLIMIT_CPU, &limit);
    limit.rlim_cur = std::min(rlim_t(std::ceil(cpu_seconds() + seconds)), limit.rlim_max);
    setrlimit(RLIMIT_CPU, &limit);
}

template <class Request>
Request request_of(const std::string& payload) {
    Request request{};
    if (payload.size() != sizeof request) throw std::runtime_error("a request of the wrong size");
    std::memcpy(&request, payload.data(), sizeof request);
    return request;
}

/// Of a picture; its size is the scene's afterwards.
rt::RenderSettings settings_of(const RenderRequest& request, rt::Scene& scene) {
    rt::RenderSettings settings;
    settings.samples = request.samples;
    settings.seed = request.seed;
    settings.sampler = rt::Sampler(request.sampler);
    settings.threads = 1;
    settings.estimate_error = false;
    settings.one_of_many = request.one_of_many != 0;
    if (request.width > 0 && request.height > 0) scene.camera.size = {request.width, request.height};
    return settings;
}

std::string render(rt::Scene scene, const std::string& payload) {
    const rt::RenderSettings settings = settings_of(request_of<RenderRequest>(payload), scene);
    const rt::Rendering rendering = rt::render(scene, settings);
    std::vector<double> numbers{double(rendering.image.width), double(rendering.image.height), rendering.cpu_seconds};
    numbers.reserve(image_head + 3 * rendering.image.pixels.size());
    for (const std::uint64_t rays : rendering.rays) numbers.push_back(double(rays));
    for (const rt::Color& pixel : rendering.image.pixels) numbers.insert(numbers.end(), {pixel.r, pixel.g, pixel.b});
    return frame(FrameKind::image, bytes_of<double>(numbers));
}

std::string trace(rt::Scene scene, const std::string& payload) {
    const auto request = request_of<TraceRequest>(payload);
    const rt::RenderSettings settings = settings_of(request.picture, scene);
    return frame(FrameKind::text, rt::trace_pixel(scene, settings, request.x, request.y));
}

std::size_t row_asked = 0;  // of the call that is being answered

/// At the end of its time: which call that is, and where it is, a few times over, for a loop that does not end is never
/// left. Of a program with sanitizers alone, which know lines.
void tell_where(int) {
    constexpr int enough = 8;
    constexpr itimerval soon{{0, 0}, {0, 1000}};
    static int told = 0;
    if (told == 0) {
        char text[64] = {};
        const int length = std::snprintf(text, sizeof text, "%s%zu\n", call_at_end, row_asked);
        (void)!write(STDERR_FILENO, text, std::size_t(length));
    }
    (void)!write(STDERR_FILENO, place_at_end, std::strlen(place_at_end));
    __sanitizer_print_stack_trace();
    if (++told == enough) _exit(128 + SIGXCPU);
    setitimer(ITIMER_VIRTUAL, &soon, nullptr);
}

void say(std::string_view words) { (void)!write(STDERR_FILENO, words.data(), words.size()); }

/// What is thrown and never caught; the calls that led there are those of the program then.
void tell_exception() {
    std::string what = "no std::exception";
    try {
        std::rethrow_exception(std::current_exception());
    } catch (const std::exception& error) {
        what = error.what();
    } catch (...) {  // as it is
    }
    say(exception_at_end + what + "\n");
    __sanitizer_print_stack_trace();
    _exit(1);
}

void tell_where_it_ends() {
    if (!__sanitizer_print_stack_trace) return;
    for (const int signal : {SIGXCPU, SIGVTALRM}) std::signal(signal, tell_where);
    std::set_terminate(tell_exception);
    std::atexit([] {
        say(exit_at_end);
        __sanitizer_print_stack_trace();
    });
}

sigjmp_buf before_edited;

/// Mistakes make loops and indices run over: where that is seen, the answer is none, and the next ones go on.
void answer_faults() {
    static std::array<char, 1 << 16> stack;  // the fragment may have used up its own
    const stack_t other{stack.data(), 0, stack.size()};
    sigaltstack(&other, nullptr);
    struct sigaction action {};
    action.sa_handler = [](int) { siglongjmp(before_edited, 1); };
    action.sa_flags = SA_ONSTACK | SA_NODEFER;
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigaction(signal, &action, nullptr);
}

/// What a fragment with mistakes in it answers; nothing where it breaks off.
std::vector<double> edited(const std::string& fragment, const std::vector<double>& row) {
    const textbook::EditedCall call = textbook::edited_call_of(row);
    const auto mistake = [&](std::size_t i) { return i < call.mistakes.size() ? &call.mistakes[i] : nullptr; };
    std::vector<double> known = call.arguments;
    known.insert(known.end(), call.more.begin(), call.more.end());
    textbook::watch.begin(0, call.nodes, known, mistake(0), mistake(1));
    std::vector<double> answer;
    if (sigsetjmp(before_edited, 0) == 0) {
        try {
            answer = probe(fragment, call.arguments);
        } catch (const std::exception&) {
            answer.clear();
        }
    }
    if (!call.only_kinds) return answer;
    answer.clear();
    for (const textbook::Value& value : textbook::watch.values) answer.push_back(seen(value));
    return answer;
}

template <class Answer>
std::string call(const std::string& fragment, const std::string& payload, Answer answer) {
    std::vector<double> flat(payload.size() / sizeof(double));
    copy_bytes(flat.data(), payload.data(), flat.size() * sizeof(double));
    std::vector<std::vector<double>> rows;
    if (!unflatten(flat, rows)) throw std::runtime_error("rows that are none");

    const double start = cpu_seconds();
    for (row_asked = 0; row_asked < rows.size(); ++row_asked) rows[row_asked] = answer(fragment, rows[row_asked]);
    std::vector<double> numbers = flatten(rows);
    numbers.insert(numbers.begin(), cpu_seconds() - start);
    return frame(FrameKind::rows, bytes_of<double>(numbers));
}

std::string call_many(const std::string& payload) {
    const double start = cpu_seconds();
    std::vector<double> numbers = swarm(request_of<SwarmRequest>(payload));
    numbers.insert(numbers.begin(), cpu_seconds() - start);
    return frame(FrameKind::rows, bytes_of<double>(numbers));
}

/// Answers frames.
class Child {
public:
    explicit Child(std::string meshes) : meshes_(std::move(meshes)) {}

    std::string answer(FrameKind kind, const std::string& payload) {
        switch (kind) {
            case FrameKind::scene:
                scene_ = rt::parse_scene(payload, meshes_);
                return frame(FrameKind::done, {});
            case FrameKind::fragment:
                fragment_ = payload;
                return frame(FrameKind::done, {});
            case FrameKind::render:
                return render(scene_.value(), payload);
            case FrameKind::trace:
                return trace(scene_.value(), payload);
            case FrameKind::swarm:
                return call_many(payload);
            case FrameKind::rows:
                return call(fragment_, payload, probe);
            case FrameKind::edit:
                answer_faults();
                return call(fragment_, payload, edited);
            default:
                std::_Exit(1);
        }
    }

    /// What is thrown is the answer.
    std::string answer_or_error(FrameKind kind, const std::string& payload) try {
        return answer(kind, payload);
    } catch (const std::exception& error) {
        return frame(FrameKind::error, error.what());
    }

private:
    std::string meshes_;
    std::optional<rt::Scene> scene_;
    std::string fragment_;
};

}  // namespace

int main(int argc, char** argv) {
    rt::require_processor();
    tell_where_it_ends();
    results = fcntl(3, F_DUPFD_CLOEXEC, 10);
    close(3);
    const double seconds = argc > 1 ? std::atof(argv[1]) : 10;
    const bool in_view = argc < 3;  // grade call: a fragment's prints are its user's

    // the grader has tested its own: what is different here is a fragment's doing
    const std::string fault = arithmetic_fault();
    Child child(argc > 2 ? argv[2] : "scene.toml");  // where the scene's meshes are looked for
    for (FrameHeader header{}; read_all(&header, sizeof header);) {
        std::string payload(header.bytes, '\0');
        if (!read_all(payload.data(), payload.size())) break;
        allow(seconds);
        if (!fault.empty())
            write_all(frame(FrameKind::error, "the fragment changes the arithmetic of its program: " + fault));
        else if (__sanitizer_print_stack_trace)  // where nothing catches it, it is known where something is thrown
            write_all(child.answer(header.kind, payload));
        else
            write_all(child.answer_or_error(header.kind, payload));
        if (in_view) std::fflush(stdout);
    }
    std::_Exit(0);
}
