#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <ctime>
#include <fstream>
#include <sstream>
#include <thread>

#include "catch.h"
#include "files/files.h"
#include "programs/process.h"
#include "programs/sandbox.h"
#include "sandboxes.h"

using namespace grade;

namespace {

Ending shell(const Sandbox& sandbox, const fs::path& folder, const std::string& text, bool is_tool = true,
             double wall = 20) {
    Step step{{"/bin/sh", "-c", text}, {}, folder, {}, is_tool};
    step.limits.wall_seconds = wall;
    return run(sandbox, step);
}

int count_of(const std::string& word) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator("/proc")) {
        const std::ifstream line(entry.path() / "cmdline");
        std::ostringstream words;
        words << line.rdbuf();  // nothing where the process has ended meanwhile; an iterator would throw
        count += words.str().find(word) != std::string::npos;
    }
    return count;
}

}  // namespace

TEST_CASE("what a process has computed and waited for, in all of its threads") {
    const double own = own_delay();
    const Times before = times_of(getpid());
    // of a thread that may have to wait, and of this one
    std::jthread([] {
        for (const std::clock_t start = std::clock(); std::clock() - start < CLOCKS_PER_SEC / 5;) {}
    }).join();
    std::atomic<bool> is_done = false;
    const std::jthread waits([&] { is_done.wait(false); });
    const Times now = times_of(getpid());
    is_done = true, is_done.notify_all();
    CHECK(now.computed - before.computed >= 0.15);
    CHECK(now.delayed >= own_delay() - 1e-3);
    CHECK(own_delay() >= own);
    CHECK(times_of(0).computed == 0);  // there is no such process
}

TEST_CASE("a step sees its own folder, and neither another nor a secret, nor the environment", "[steps]") {
    for (const Sandbox& sandbox : sandboxes()) {
        INFO(sandbox.description);
        const StepFolder place, other;
        write_text(other.folder / "secret", "secret");
        write_text(place.folder / "mine", "mine");
        setenv("PENUMBRA_SECRET", "secret", 1);
        CHECK(shell(sandbox, place.folder, "cat mine").out == "mine");
        CHECK(shell(sandbox, place.folder, "cat " + (other.folder / "secret").string()).out.empty());
        CHECK(shell(sandbox, place.folder, "cat solution/phong.cpp " + fs::absolute("solution/phong.cpp").string())
                  .out.empty());
        CHECK(shell(sandbox, place.folder, "cat /etc/passwd /proc/1/environ /proc/self/maps").out.empty());
        CHECK(shell(sandbox, place.folder, "env").out.find("secret") == std::string::npos);
        CHECK(shell(sandbox, place.folder,
                    fmt::format("kill -9 {} && echo sent; kill -9 $PPID && echo sent; true", getpid()))
                  .out.empty());
        shell(sandbox, place.folder,
              "echo x >" + (other.folder / "new").string() + "; echo x >/dev/shm/penumbra; echo x >/x");
        CHECK_FALSE(fs::exists(other.folder / "new"));
        CHECK_FALSE(fs::exists("/dev/shm/penumbra"));
        CHECK_FALSE(fs::exists("/x"));
    }
}

TEST_CASE("of the grader's own folders a step sees what it names alone, also where all else of /usr is seen",
          "[steps]") {
    const fs::path own = "/usr/lib/gcc";  // as if the project were there
    REQUIRE(fs::is_directory(own));
    const fs::path inner = fs::directory_iterator(own)->path();
    for (Sandbox sandbox : sandboxes()) {
        INFO(sandbox.description);
        const StepFolder place;
        const auto listed = [&] {
            return shell(sandbox, place.folder, "cd /usr/lib/gcc && ls; cd /lib/gcc && ls").out;
        };
        CHECK_FALSE(listed().empty());
        sandbox.hidden = {"/lib/gcc"};
        if (sandbox.kind == Sandbox::Kind::container) {
            CHECK_THAT(fault_of(sandbox, {}), Catch::Matchers::ContainsSubstring("expected it outside of /usr"));
            continue;
        }
        CHECK(fault_of(sandbox, {}).empty());
        CHECK(listed().empty());
        CHECK(shell(sandbox, place.folder, "echo x >/usr/lib/gcc/x; cat /usr/lib/gcc/x").out.empty());
        sandbox.readable = {inner};
        CHECK(shell(sandbox, place.folder, "ls /usr/lib/gcc").out == inner.filename().string() + "\n");
        CHECK_FALSE(shell(sandbox, place.folder, "ls " + inner.string()).out.empty());
    }
}

TEST_CASE("a tool writes into its folder, and nothing that it starts outlives it", "[steps]") {
    for (const Sandbox& sandbox : sandboxes()) {
        INFO(sandbox.description);
        const StepFolder place;
        CHECK(
            shell(sandbox, place.folder, "echo made >made && mkdir -p deep && mv made deep/made && chmod 700 deep/made")
                .good());
        CHECK(read_text(place.folder / "deep/made") == "made\n");
        const std::string seconds = fmt::format("{}.5", 700000 + getpid());
        for (const std::string start : {"sleep ", "setsid sleep ", "nohup sleep "})
            shell(sandbox, place.folder, start + seconds + " & " + start + seconds + " & exit 0");
        CHECK(count_of(seconds) == 0);
        CHECK(shell(sandbox, place.folder, "sleep " + seconds, true, 0.5).waited);
        CHECK(count_of(seconds) == 0);
    }
}

TEST_CASE("a student's program starts no other, and writes nowhere", "[steps]") {
    for (const Sandbox& sandbox : sandboxes()) {
        INFO(sandbox.description);
        const StepFolder place;
        write_text(place.folder / "there", "there");
        CHECK(shell(sandbox, place.folder, "echo only this", false).out == "only this\n");
        const Ending forks = shell(sandbox, place.folder, "/bin/true; echo more", false);
        CHECK(forks.how == Ending::How::signalled);
        CHECK(forks.code == SIGSYS);
        CHECK(forks.out.empty());
        shell(sandbox, place.folder, "echo x >new", false);
        shell(sandbox, place.folder, "echo x >>there", false);
        shell(sandbox, place.folder, "echo x >there", false);
        CHECK_FALSE(fs::exists(place.folder / "new"));
        CHECK(read_text(place.folder / "there") == "there");
        for (const std::string own : {"chmod 000 there", "truncate -s 0 there", "touch -d 2000-01-01 there"})
            CHECK_FALSE(shell(sandbox, place.folder, "exec " + own, false).good());
        CHECK(read_text(place.folder / "there") == "there");
    }
}

TEST_CASE("nothing can be read again from where a step writes to", "[steps]") {
    for (const Sandbox& sandbox : sandboxes()) {
        INFO(sandbox.description);
        const StepFolder place;
        for (const std::string file : {"/dev/stdout", "/dev/stdin", "/dev/zero", "/dev/tty", "/proc/self/fd/1",
                                       "/proc/self/fd/0", "/dev/fd/2"}) {
            const Ending ending = shell(sandbox, place.folder, "exec cat " + file);
            INFO(file);
            CHECK(ending.how == Ending::How::exited);
            CHECK(ending.code == 1);
        }
        CHECK(shell(sandbox, place.folder, "cat; echo end").out == "end\n");
    }
}

TEST_CASE("a sandbox that does not work is told, and the grader goes no further", "[steps]") {
    CHECK_FALSE(fault_of({Sandbox::Kind::host, {}, {}}, {"/no/such/file"}).empty());
    CHECK_THROWS_WITH(find_sandbox(false, {"/no/such/file"}),
                      Catch::Matchers::ContainsSubstring("there is no sandbox here") &&
                          Catch::Matchers::ContainsSubstring("--trusted"));
    CHECK(find_sandbox(true, {"/no/such/file"}).kind == Sandbox::Kind::limits_only);
}

TEST_CASE("only the runner of steps starts processes", "[steps]") {
    const std::vector<std::string> ways{"fork(", "vfork(",      "clone(", "execv",
                                        "execl", "posix_spawn", "popen(", "system("};
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator("grader")) {
        if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
        const std::string text = read_text(entry.path()).value_or("");
        for (const std::string& way : ways)
            for (std::size_t at = 0; (at = text.find(way, at)) != text.npos; ++at)
                if (at == 0 || (std::isalnum(text[at - 1]) == 0 && text[at - 1] != '_'))
                    found.push_back(entry.path().generic_string() + ": " + way);
    }
    std::ranges::sort(found);
    // the first becomes grade_studies, with the words that it was called with; the next are the user's own code in view
    CHECK(found == std::vector<std::string>{"grader/commands/command_line.cpp: execv",
                                            "grader/programs/in_view.cpp: execv", "grader/programs/in_view.cpp: fork(",
                                            "grader/programs/process.cpp: execv",
                                            "grader/programs/process.cpp: fork("});
}

TEST_CASE("who lets the deadline of an answer pass has timed out, also who ends at the hang-up") {
    Process waits({"/bin/sh", "-c", "read line; exit 0"}, {}, "/");
    CHECK_FALSE(waits.receive(1, in_seconds(1.1)));
    const Ending ending = waits.finish(in_seconds(5));
    CHECK(ending.how == Ending::How::timed_out);
    CHECK(ending.waited);
    Process leaves({"/bin/sh", "-c", "exit 3"}, {}, "/");
    CHECK_FALSE(leaves.receive(1, in_seconds(5)));
    CHECK(leaves.finish(in_seconds(5)).code == 3);
}

TEST_CASE("a program's end, output and limits are told") {
    const auto shell = [](const std::string& text, Limits limits = {}) {
        return run({"/bin/sh", "-c", text}, limits, "/");
    };
    CHECK(shell("echo out; echo err >&2; exit 3").code == 3);
    CHECK(shell("echo out").out == "out\n");
    CHECK(shell("kill -SEGV $$").how == Ending::How::signalled);
    Limits limits;
    limits.wall_seconds = 0.5;
    CHECK(shell("sleep 100", limits).how == Ending::How::timed_out);
    limits = {};
    limits.cpu_seconds = limits.most_cpu_seconds = 1;
    CHECK(shell("while :; do :; done", limits).how == Ending::How::timed_out);
    limits = {};
    limits.output = 1000;
    CHECK(shell("yes | head -c 1000000", limits).out.size() == 1000);
    CHECK(shell("sleep 100 & echo done").out == "done\n");
    CHECK(shell("env").out.find("HOME") == std::string::npos);
    CHECK(run({"/no/such/program"}, {}, "/").how == Ending::How::not_run);
}
