#include "convergence/gathered.h"

#include <algorithm>

namespace grade {

const Run* Gathered::find(int samples, int replicate) const {
    const auto level = std::ranges::find(levels, samples, &Level::samples);
    if (level == levels.end() || replicate >= int(level->runs.size())) return nullptr;
    return &level->runs[std::size_t(replicate)];
}

void Gathered::add(int samples, int replicate, const Run& run, const rt::Image& image) {
    auto level = std::ranges::lower_bound(levels, samples, {}, &Level::samples);
    if (level == levels.end() || level->samples != samples) level = levels.insert(level, Level{samples, {}});
    level->runs.push_back(run);
    const auto half = std::size_t(replicate % 2);
    rt::Image& mean = means[half];
    if (mean.pixels.empty()) mean = rt::Image(image.width, image.height);
    weights[half] += samples;
    for (std::size_t i = 0; i < mean.pixels.size(); ++i)
        mean.pixels[i] += (image.pixels[i] - mean.pixels[i]) * (samples / weights[half]);
}

KeptResult to_kept(const Gathered& gathered) {
    KeptResult kept;
    kept.head["weights"] = gathered.weights;
    for (const Level& level : gathered.levels) {
        nlohmann::ordered_json runs = nlohmann::ordered_json::array();
        for (const Run& run : level.runs) runs.push_back({run.mse, run.relative, run.cpu_seconds, run.rays});
        kept.head["levels"].push_back({{"samples", level.samples}, {"runs", runs}});
    }
    kept.images.assign(gathered.means.begin(), gathered.means.end());
    return kept;
}

void take(Gathered& gathered, const KeptResult& kept) {
    gathered.weights = kept.head.at("weights");
    for (const auto& level : kept.head.at("levels")) {
        gathered.levels.push_back({level.at("samples"), {}});
        for (const auto& run : level.at("runs"))
            gathered.levels.back().runs.push_back({run.at(0), run.at(1), run.at(2), run.at(3)});
    }
    for (std::size_t k = 0; k < gathered.means.size(); ++k) gathered.means[k] = kept.images.at(k);
}

}  // namespace grade
