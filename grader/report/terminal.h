#pragma once

#include <chrono>
#include <string>

#include "record/record.h"

namespace grade {

/// The result as a table: part, fragment, verdict, points, and what to do about each fragment that does not pass.
std::string table(const Record& record, bool color);

/// Its middle: a row for each fragment, and below it what to do about it.
std::string fragment_rows(const Record& record, bool color);

/// One line about how far a grading is, rewritten in place. Where stderr is no terminal it says nothing, or, of long
/// work, a line after the first step and then one every ten seconds.
class ProgressLine {
public:
    explicit ProgressLine(bool long_work = false);
    ~ProgressLine() { clear(); }
    void show(int done, int all, const std::string& doing);
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    bool on_, long_work_;
    bool shown_ = false;
    Clock::time_point start_ = Clock::now(), next_ = start_;
};

/// A verdict in words for people: "not started".
std::string in_words(Verdict verdict);

}  // namespace grade
