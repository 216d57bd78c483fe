#include "programs/sandbox.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <stdexcept>

#include "files/files.h"

namespace grade {

namespace {

constexpr const char* bubblewrap = "/usr/bin/bwrap";
constexpr const char* of_the_system[] = {"/usr", "/bin", "/lib", "/lib64", "/etc/alternatives", "/etc/ld.so.cache"};

/// Where a folder is to be seen among what all steps see: under each of these names, /lib being a link to /usr/lib.
std::vector<fs::path> places_in_system(const fs::path& folder) {
    std::error_code error;
    const fs::path real = fs::weakly_canonical(folder, error);
    std::vector<fs::path> places;
    for (const fs::path system : of_the_system) {
        const fs::path within = real.lexically_relative(fs::weakly_canonical(system, error));
        if (!within.empty() && *within.begin() != "..") places.push_back(system / within);
    }
    return places;
}

std::vector<fs::path> hidden_places(const Sandbox& sandbox) {
    std::vector<fs::path> all;
    for (const fs::path& folder : sandbox.hidden) {
        const std::vector<fs::path> places = places_in_system(folder);
        all.insert(all.end(), places.begin(), places.end());
    }
    return all;
}

std::vector<std::string> in_bubblewrap(const Sandbox& sandbox, const Step& step) {
    std::vector<std::string> words{bubblewrap, "--unshare-all", "--die-with-parent", "--cap-drop", "ALL", "--seccomp",
                                   "4",        "--dev-bind",    "/dev/null",         "/dev/null"};
    if (step.sees_itself) words.insert(words.end(), {"--proc", "/proc"});
    if (step.is_tool) words.insert(words.end(), {"--size", fmt::to_string(256u << 20), "--tmpfs", "/tmp"});
    for (const char* path : of_the_system) words.insert(words.end(), {"--ro-bind-try", path, path});
    const std::vector<fs::path> hidden = hidden_places(sandbox);
    for (const fs::path& path : hidden) words.insert(words.end(), {"--tmpfs", path.string()});
    for (const auto* list : {&sandbox.readable, &step.readable})
        for (const fs::path& path : *list) words.insert(words.end(), {"--ro-bind", path.string(), path.string()});
    words.insert(words.end(), {step.is_tool ? "--bind" : "--ro-bind", step.folder.string(), step.folder.string()});
    for (const fs::path& path : hidden) words.insert(words.end(), {"--remount-ro", path.string()});
    words.insert(words.end(), {"--remount-ro", "/", "--chdir", step.folder.string(), "--"});
    words.insert(words.end(), step.command.begin(), step.command.end());
    return words;
}

/// A user that nobody else is: none of the system's, and another for each of the steps that run now.
unsigned next_user() {
    static std::atomic<unsigned> count = 0;
    constexpr unsigned first = 61184, last = 65519;  // what systemd gives to services for as long as they run
    return first + (unsigned(getpid()) * 61 + count++) % (last - first + 1);
}

/// A file descriptor that closes itself.
struct Descriptor {
    int number = -1;
    ~Descriptor() {
        if (number >= 0) close(number);
    }
};

}  // namespace

std::unique_ptr<Process> start(const Sandbox& sandbox, const Step& step) {
    const Starts starts = step.is_tool ? Starts::programs : Starts::nothing;
    if (sandbox.kind == Sandbox::Kind::limits_only)
        return std::make_unique<Process>(step.command, step.limits, step.folder.string());
    if (sandbox.kind == Sandbox::Kind::host)
        return std::make_unique<Process>(in_bubblewrap(sandbox, step), step.limits, step.folder.string(),
                                         Walls{.calls = allowed_calls(starts, false)});

    std::vector<fs::path> readable(std::begin(of_the_system), std::end(of_the_system)), writable{"/dev/null"};
    for (const auto* list : {&sandbox.readable, &step.readable})
        readable.insert(readable.end(), list->begin(), list->end());
    (step.is_tool ? writable : readable).push_back(step.folder);
    const Descriptor rules{landlock_rules(readable, writable)};
    if (rules.number < 0) throw std::runtime_error("Landlock does not work any more");
    Walls walls{.itself = true, .files = rules.number, .calls = allowed_calls(starts, !step.is_tool)};
    if (sandbox.own_user) {
        walls.user = next_user();
        if (step.is_tool && chown(step.folder.c_str(), walls.user, gid_t(-1)) != 0)
            throw std::runtime_error(fmt::format("{}: cannot be given to another user", step.folder.string()));
    }
    return std::make_unique<Process>(step.command, step.limits, step.folder.string(), std::move(walls));
}

Ending run(const Sandbox& sandbox, const Step& step) {
    const auto process = start(sandbox, step);
    return process->finish(in_seconds(step.limits.wall_seconds));
}

std::string fault_of(const Sandbox& sandbox, const std::vector<fs::path>& needed) try {
    if (sandbox.kind == Sandbox::Kind::limits_only) return {};
    if (sandbox.kind == Sandbox::Kind::host && !fs::exists(bubblewrap)) return "bubblewrap is not installed";
    if (sandbox.kind == Sandbox::Kind::container && landlock_version() == 0)
        return "the kernel has no Landlock, or does not allow it";
    if (const auto hidden = hidden_places(sandbox); sandbox.kind == Sandbox::Kind::container && !hidden.empty())
        return fmt::format(
            "every step reads what is in {}, which Landlock cannot hide; expected it outside of /usr, "
            "as in /opt/penumbra",
            hidden.front().string());
    if (allowed_calls(Starts::nothing, false).code.empty())
        return "its system calls are not known on this kind of processor";
    const TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms(0711));
    const fs::path inside = folder.path() / "inside";
    fs::create_directory(inside);
    Step step{{"/usr/bin/head", "--bytes=1"}, {}, inside, {}};
    for (const fs::path& file : needed) {
        step.command.push_back(file.string());
        step.readable.push_back(file);
    }
    if (needed.empty()) step.command = {"/usr/bin/true"};
    const Ending ending = run(sandbox, step);
    if (ending.good()) return {};
    return ending.err.empty() ? "the kernel does not allow it" : ending.err.substr(0, ending.err.find('\n'));
} catch (const std::exception& error) {
    return error.what();
}

Sandbox find_sandbox(bool trusted, const std::vector<fs::path>& needed, const std::vector<fs::path>& hidden) {
    if (trusted) return {Sandbox::Kind::limits_only, "resource limits only: the code is its owner's", {}, {}};
    const Sandbox host{
        Sandbox::Kind::host,
        "bubblewrap: no network, no other processes, files read-only; system calls filtered; resource limits",
        {},
        hidden};
    const std::string no_host = fault_of(host, needed);
    if (no_host.empty()) return host;

    Sandbox container{Sandbox::Kind::container, {}, {}, hidden};
    std::string no_container;
    for (const bool own_user : {true, false}) {
        if (own_user && geteuid() != 0) continue;
        container.own_user = own_user;
        no_container = fault_of(container, needed);
        if (!no_container.empty()) continue;
        container.description = fmt::format(
            "Landlock {} and seccomp: no network, no signals to others, files read-only; {}; resource limits; no "
            "bubblewrap: {}",
            landlock_version(), own_user ? "a user of its own for each step" : "the grader's own user", no_host);
        return container;
    }
    throw std::runtime_error(
        fmt::format("there is no sandbox here that student code can be run in. bubblewrap: {}. Landlock and seccomp: "
                    "{}. Expected one of them; with --trusted, for code that is your own, there are limits only",
                    no_host, no_container));
}

}  // namespace grade
