#pragma once

#include <set>
#include <string>

#include "record/record.h"

/// What pages are put together from.
namespace grade {

/// page.css and page.js, as every page holds them, and class.css and stress.css, for one page each; the build makes
/// them texts.
extern const char* const page_style;
extern const char* const page_script;
extern const char* const class_style;
extern const char* const stress_style;

/// All before <main>.
///
/// style  of this page alone
std::string page_head(const std::string& title, const char* style = "");

std::string badge(Verdict verdict);

/// Where to read about something: `See handout, "SECTION"`, a link where the handout is known. Empty without section.
std::string read_link(const std::string& section, const std::string& handout);

/// "<a href="handout.html#hit_sphere">WORDS</a>", or the words alone, where no handout is known.
std::string section_link(const std::string& section, const std::string& handout, const std::string& words);

/// Yours, the right one, and the difference; without the right one, yours alone.
///
/// what  "for NAME" or "of SCENE"
/// more  figures that stand with them
std::string three_pictures(const rt::Image& mine, const rt::Image& right, double exposure, const std::string& what,
                           const std::string& more = "");

/// All pictures of a check; empty: it draws none.
std::string pictures(const CheckRecord& check);

/// What a page tells once, however many statistics say it.
using Told = std::set<std::string>;

/// A check with its pictures and statistics.
std::string check_section(const CheckRecord& check, bool fragment_passes, Told& told);

/// Deviations that are right; without noise, all that are not wrong.
double right_within(const StatisticRecord& statistic);

/// A statistic as a small drawing: the truth as a line, about it what is right as a band and what is neither right nor
/// wrong as a fainter one, the value as a dot on its confidence interval. Empty where there is no value.
std::string bar(const StatisticRecord& statistic);

/// What one picture of a check costs and how noisy it is, beside the solution's; empty: not known. How efficient that
/// is says nothing where its fragment does not pass.
std::string cost_line(const CheckRecord& check, bool passes);

/// The section with error against run time, a dot for each picture; empty: there is none with noise.
std::string error_section(const Record& record);

}  // namespace grade
