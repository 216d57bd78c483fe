#pragma once

#include <string>
#include <string_view>

#include "record/record.h"

namespace grade {

/// What a statistic speaks of, in the order in which mistakes are told: of two statistics that fail, the earlier one
/// explains the later one more often than the other way round. A missing factor, as the regression over many layouts
/// finds it, bends where a lamp's light seems to come from, so it is told before all geometry.
enum class Subject { sharing, no_image, tone, factor, geometry, radiometry, variance };

/// The subject of a statistic's id: of "A1", geometry. Throws std::out_of_range for an id that has none.
Subject subject_of(std::string_view id);

/// What is wrong with a fragment: what to tell first, and where to read about it.
struct Diagnosis {
    std::string words;    // a line or two; may hold untrusted text
    std::string section;  // heading in the handout; empty where nothing is wrong
};

/// From all that does not pass: a program that ends by itself first, then shared numbers and what is no image, then
/// what calls of the fragment show, since there is nothing else in them, then pictures; each in the order of the
/// subjects, and of one subject in the order of the checks.
Diagnosis diagnose(const FragmentRecord& fragment);

/// The first thing to say about what is not passed, in a line or two; may hold untrusted text.
std::string first_message(const FragmentRecord& fragment);

/// Where to read about one statistic or check that does not pass.
std::string section_of(const CheckRecord& check, const StatisticRecord* statistic);

/// "pixels 24 to 31 from the left and 8 to 15 from the top are 0.31 bright, must be 0.42"
std::string tile_in_words(const Tiles& tiles, std::size_t tile);

/// As the record has it: handout.md, "lens_ray".
std::string reading(const std::string& section);

/// The anchor of a heading, as Markdown's readers make it: "when-it-looks-wrong".
std::string anchor(const std::string& section);

/// Headings of the handout that are no fragment's.
constexpr std::string_view rules_section = "How to start", numbers_section = "What to use instead of an epsilon",
                           verdicts_section = "The grader", pictures_section = "When it looks wrong";

}  // namespace grade
