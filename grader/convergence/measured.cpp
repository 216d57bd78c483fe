#include "convergence/measured.h"

#include <algorithm>

namespace grade::convergence {

const Run* Measured::find(int samples, int replicate) const {
    const auto level = std::ranges::find(levels, samples, &Level::samples);
    if (level == levels.end() || replicate >= int(level->runs.size())) return nullptr;
    return &level->runs[std::size_t(replicate)];
}

void Measured::add(int samples, int replicate, const Run& run, const rt::Image& image) {
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

KeptJson to_kept(const Measured& measured) {
    KeptJson kept{{"weights", measured.weights}, {"levels", KeptJson::array()}, {"means", KeptJson::array()}};
    for (const Level& level : measured.levels) {
        KeptJson runs = KeptJson::array();
        for (const Run& run : level.runs) runs.push_back({run.mse, run.relative, run.cpu_seconds, run.rays});
        kept["levels"].push_back({{"samples", level.samples}, {"runs", runs}});
    }
    for (const rt::Image& mean : measured.means) kept["means"].push_back(kept_image(mean));
    return kept;
}

Measured measured_of(const KeptJson& kept) {
    Measured measured;
    measured.weights = kept.at("weights");
    for (const auto& level : kept.at("levels")) {
        measured.levels.push_back({level.at("samples"), {}});
        for (const auto& run : level.at("runs"))
            measured.levels.back().runs.push_back({run.at(0), run.at(1), run.at(2), run.at(3)});
    }
    for (std::size_t k = 0; k < measured.means.size(); ++k) measured.means[k] = image_of(kept.at("means").at(k));
    return measured;
}

}  // namespace grade::convergence
