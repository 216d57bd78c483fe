#pragma once

#include <chrono>
#include <string>

#include "record/record.h"

namespace grade {

/// The result as a table: part, fragment, verdict, points, and what to do about each fragment that does not pass.
std::string table(const Record& record, bool color);

/// Its middle: a row for each fragment, and below it what to do about it.
std::string fragment_rows(const Record& record, bool color);

/// One line about how far a grading is, rewritten in place. Says nothing where stderr is no terminal.
class ProgressLine {
public:
    ProgressLine();
    ~ProgressLine() { clear(); }
    void show(int done, int all, const std::string& doing);
    void clear();

private:
    bool on_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A verdict in words for people: "not started".
std::string in_words(Verdict verdict);

}  // namespace grade
