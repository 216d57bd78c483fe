#pragma once

#include <chrono>
#include <string>

#include "diagnosis/diagnosis.h"
#include "programs/progress.h"
#include "record/record.h"

namespace grade {

/// Who reads it.
struct Reader {
    bool color = false;
    bool own = false;    // what was graded is what this grader's calls repeat
    std::string folder;  // from where they stand to it, before the paths of the record: "starter/"
};

/// The result as a table: part, fragment, verdict, points, and what to do about each fragment that does not pass. Sums
/// of one thing are left out.
std::string table(const Record& record, const Reader& reader);

/// Its middle: a row for each fragment, with what to open; below it what is wrong, the call, what to read, and last
/// what the compiler warns of.
std::string fragment_rows(const Record& record, const Reader& reader);

/// "17 passed, 3 failed, 12 not started"
std::string verdicts_in_words(const Record& record);

/// Whether what goes to stdout may have colours: it is a terminal that has them, and its user wants them.
bool has_colors();

/// One line about how far a grading is, rewritten in place. Where stderr is no terminal it says nothing, or, of long
/// work, a line after the first step and then one every ten seconds.
class ProgressLine {
public:
    explicit ProgressLine(bool long_work = false);
    ~ProgressLine() { clear(); }
    void show(int done, int all, const std::string& doing);
    void clear();
    Progress::Listener listener() {
        return [this](int done, int all, const std::string& doing) { show(done, all, doing); };
    }

private:
    using Clock = std::chrono::steady_clock;

    bool on_, long_work_;
    bool shown_ = false;
    Clock::time_point start_ = Clock::now(), next_ = start_;
};

/// Where to read about what does not pass; empty: what is blank or does not compile has its own words.
std::string where_to_read(Verdict verdict, const Diagnosis& diagnosis);

/// A verdict in words for people: "not started".
std::string in_words(Verdict verdict);

}  // namespace grade
