#include "commands/watch.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <sstream>
#include <thread>

#include "files/interrupt.h"
#include "report/terminal.h"
#include "submission/submission.h"

namespace grade {

namespace {

using Texts = std::map<std::string, std::string>;

/// What is in the files now; nothing while an editor replaces them.
Texts texts_of(const std::string& folder, const Assignment& assignment) try {
    return read_submission(folder, assignment.names()).texts;
} catch (const SubmissionError&) {
    return {};
}

std::set<std::string> changed(const Texts& before, const Texts& now) {
    std::set<std::string> names;
    for (const auto& [name, text] : now)
        if (const auto old = before.find(name); old == before.end() || old->second != text) names.insert(name);
    for (const auto& [name, text] : before)
        if (!now.contains(name)) names.insert(name);
    return names;
}

/// Lines of the terminal; plenty where there is none.
std::size_t screen_lines() {
    winsize size{};
    return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 0 ? size.ws_row : 1000;
}

/// The lines that fit: what was edited first, then what does not pass, then the sum.
std::string screen(const Record& record, const std::set<std::string>& edited, const Reader& reader) {
    Record shown = record;
    std::erase_if(shown.fragments, [&](const FragmentRecord& fragment) {
        return !edited.contains(fragment.name) &&
               (fragment.verdict == Verdict::passed || fragment.verdict == Verdict::not_started);
    });
    std::ranges::stable_sort(shown.fragments, {}, [&](const FragmentRecord& f) { return !edited.contains(f.name); });
    std::string tail;
    for (const std::string& change : record.changes) tail += "  " + change + "\n";
    tail += fmt::format("{:g} of {:g} points: {}\n", record.score(), record.max_score(), verdicts_in_words(record));
    const std::time_t now = std::time(nullptr);
    const std::string head = fmt::format("{:%H:%M:%S}  {}; save a fragment to grade it again, Ctrl-C ends\n\n",
                                         fmt::localtime(now), record.submission);
    const std::size_t used = 3 + std::size_t(std::ranges::count(tail, '\n')), all = screen_lines();
    std::istringstream rows(fragment_rows(shown, reader));
    std::string text;
    std::size_t count = 0;
    for (std::string line; std::getline(rows, line); ++count) {
        if (used + count + 2 > all) {
            text += "  ...\n";
            break;
        }
        text += line + "\n";
    }
    return head + text + (text.empty() ? "" : "\n") + tail;
}

}  // namespace

void watch(const std::string& folder, const Reader& reader, const Assignment& assignment,
           const std::set<std::string>& only, const std::function<Record()>& grade,
           const std::function<void(const Record&)>& shown) try {
    const bool terminal = isatty(STDOUT_FILENO);
    std::set<std::string> edited = only;
    for (;;) {
        const Texts texts = texts_of(folder, assignment);
        const Record record = grade();
        fmt::print("{}{}", terminal ? "\033[H\033[2J\033[3J" : "", screen(record, edited, reader));
        if (!terminal) fmt::print("\n");
        std::fflush(stdout);
        shown(record);
        for (edited.clear(); edited.empty();) {
            std::this_thread::sleep_for(std::chrono::milliseconds(150));
            check_interrupt();
            const Texts now = texts_of(folder, assignment);
            if (!now.empty()) edited = changed(texts, now);
            if (!only.empty()) std::erase_if(edited, [&](const std::string& name) { return !only.contains(name); });
        }
    }
} catch (const Interrupted&) {
    fmt::print("\n");
}

}  // namespace grade
