#include "judging/blank_record.h"

#include "files/sha256.h"
#include "judging/provenance.h"

namespace grade {

CheckRecord blank_record(const Check& check) {
    CheckRecord record;
    record.name = check.name;
    record.fragment = check.fragment;
    record.share = check.share;
    if (const auto* render = std::get_if<Render>(&check.experiment)) {
        record.scene = render->scene;
        record.samples = render->samples;
        record.sampler = render->sampler;
    }
    return record;
}

Record blank_record(const Programs& programs, const Assignment& assignment, const GradingSettings& settings) {
    Record grading;
    grading.submission = programs.submission();
    grading.title = assignment.title;
    grading.seed = settings.seed;
    grading.sandbox = programs.sandbox().description;
    grading.command = settings.command;
    grading.date = now();
    grading.provenance = settings.provenance;
    grading.limits.time = settings.time_limit;
    grading.parts = assignment.parts;

    for (const Fragment& fragment : assignment.fragments) {
        if (fragment.given || (!settings.only.empty() && !settings.only.contains(fragment.name))) continue;
        FragmentRecord record;
        record.name = fragment.name, record.part = fragment.part, record.max_points = fragment.points;
        record.visibility = fragment.visibility;
        if (const auto text = programs.texts().find(fragment.name); text != programs.texts().end())
            record.file = programs.file_of(fragment.name), record.sha256 = sha256(text->second);
        if (!settings.only.empty()) grading.selection.push_back(fragment.name);
        grading.fragments.push_back(std::move(record));
    }
    grading.sha256 = hash_of(programs.texts(), assignment);
    return grading;
}

}  // namespace grade
