#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace grade {

/// A command that few need. All of them are in a second program, which is built when one is first asked for.
struct Study {
    const char* name;
    const char* purpose;
};

constexpr std::array<Study, 12> studies{
    {{"convert", "a record in the words of Gradescope, PrairieLearn, JUnit, GitHub Actions, Canvas, Moodle, ..."},
     {"class", "grade a folder of submissions, as course systems export them"},
     {"merge", "put the parts of a class together that several machines have graded"},
     {"replay", "grade a submission again as a record says, into a new record"},
     {"verify", "does a submission get the points and verdicts of its record again?"},
     {"compare", "what has changed between two records, or two gradings of a class"},
     {"stress", "how extreme a scene the fragments survive: far, tiny, huge, grazing, narrow"},
     {"converge", "error against run time: how fast it falls, with which sampler, and to which bias"},
     {"lesson", "part 1 in plots: how fast errors fall, by the way of sampling"},
     {"calibrate", "grade known wrong and right fragments: how far can verdicts be trusted?"},
     {"new", "make the files of a new fragment, scene, check or mistake"},
     {"audit", "what fragments lack to be handed out: comment, checks, mistakes, pictures, a section, ..."}}};

constexpr const char* purpose_of(std::string_view name) {
    return std::ranges::find(studies, name, &Study::name)->purpose;
}

}  // namespace grade
