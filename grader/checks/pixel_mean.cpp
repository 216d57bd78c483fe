#include "checks/kit/draw.h"
#include "checks/kit/formula.h"
#include "checks/fragment_checks.h"
#include "checks/kit/pictures.h"
#include "checks/kit/probe_check.h"

namespace grade {

namespace {

using rt::Color;
using Colors = std::vector<Color>;
using Weights = std::vector<double>;

/// The mean of each sample's value, with a change to each sample and to the mean that may be wrong.
RowFunction mean(std::function<Color(Color, double weight)> each, std::function<Color(Color sum, const Weights&)> all) {
    return of<Colors, Weights>([=](const Colors& radiance, const Weights& weight) {
        Color sum(0);
        for (std::size_t i = 0; i < radiance.size(); ++i) sum += each(radiance[i], weight[i]);
        return all(sum, weight);
    });
}

Color quantised(Color c) { return glm::floor(glm::min(c, Color(1)) * 255.0) / 255.0; }

}  // namespace

Checks check_pixel_mean(Generator& random) {
    const auto inputs = rows_of(64, [](Generator& random) {
        const int n = chance(random, 0.1) ? 1 : whole_between(random, 2, 30);
        Colors radiance;
        Weights weight;
        for (int i = 0; i < n; ++i) {
            // a bright emitter among dim surfaces: radiance has no upper bound
            radiance.push_back(chance(random, 0.2) ? box(random, 5, 50) : box(random, 0, 0.9));
            weight.push_back(between(random, 0.2, 1.6));
        }
        return row(radiance, weight);
    });
    const auto weighted = [](Color c, double w) { return w * c; };
    const auto over_n = [](Color sum, const Weights& w) { return sum / double(w.size()); };
    const auto total = [](const Weights& w) {
        double sum = 0;
        for (const double x : w) sum += x;
        return sum;
    };
    const std::vector<Suspect> suspects = {
        {"the sum is not divided by the number of samples",
         mean(weighted, [](Color sum, const Weights&) { return sum; })},
        {"the sum is divided by the sum of the weights; expected the number of samples",
         mean(weighted, [=](Color sum, const Weights& w) { return sum / total(w); })},
        {"the weights are ignored", mean([](Color c, double) { return c; }, over_n)},
        {"each sample is clamped to 1 before the mean: radiance has no upper bound",
         mean([](Color c, double w) { return w * glm::min(c, Color(1)); }, over_n)},
        {"the mean is clamped to 1: a preview does that, the image is linear",
         mean(weighted, [=](Color sum, const Weights& w) { return glm::min(over_n(sum, w), Color(1)); })},
        {"a gamma of 2.2 is applied to each sample: the image is linear",
         mean([](Color c, double w) { return w * glm::pow(c, Color(1 / 2.2)); }, over_n)},
        {"a gamma of 2.2 is applied to the mean: the image is linear",
         mean(weighted, [=](Color sum, const Weights& w) { return glm::pow(over_n(sum, w), Color(1 / 2.2)); })},
        {"samples are rounded to 8 bits before the mean",
         mean([](Color c, double w) { return w * quantised(c); }, over_n)},
        {"samples are rounded to 8 bits before the mean",
         mean([](Color c, double w) { return glm::floor(w * c * 255.0 + 0.5) / 255.0; }, over_n)},
        {"the mean is rounded to 8 bits: a preview does that, the image keeps all digits",
         mean(weighted, [=](Color sum, const Weights& w) { return glm::floor(over_n(sum, w) * 255.0 + 0.5) / 255.0; })},
        {"only floor(sqrt n)^2 of the n samples are added", of<Colors, Weights>([](const Colors& c, const Weights& w) {
             const auto root = std::size_t(std::sqrt(double(c.size())));
             Color sum(0);
             for (std::size_t i = 0; i < root * root; ++i) sum += w[i] * c[i] / double(c.size());
             return sum;
         })},
        {"the sum is divided by floor(sqrt n)^2; expected n",
         mean(weighted,
              [](Color sum, const Weights& w) { return sum / rt::sqr(std::floor(std::sqrt(double(w.size())))); })},
        {"the sum is divided by n - 1; expected n",
         mean(weighted, [](Color sum, const Weights& w) { return sum / (double(w.size()) - 1); })},
        {"the sum is divided by sqrt(n); expected n",
         mean(weighted, [](Color sum, const Weights& w) { return sum / std::sqrt(double(w.size())); })},
        {"the channels are exchanged: red for blue", mean(weighted,
                                                          [=](Color sum, const Weights& w) {
                                                              const Color c = over_n(sum, w);
                                                              return Color(c.z, c.y, c.x);
                                                          })},
        {"the channels are exchanged", mean(weighted,
                                            [=](Color sum, const Weights& w) {
                                                const Color c = over_n(sum, w);
                                                return Color(c.y, c.z, c.x);
                                            })},
        {"the channels are exchanged", mean(weighted,
                                            [=](Color sum, const Weights& w) {
                                                const Color c = over_n(sum, w);
                                                return Color(c.z, c.x, c.y);
                                            })},
        {"only the first sample counts", of<Colors, Weights>([](const Colors& c, const Weights&) { return c[0]; })},
        {"only the last sample counts", of<Colors, Weights>([](const Colors& c, const Weights&) { return c.back(); })}};
    return {probe_check("linear_mean", inputs, {formula("G4", "mean, off by", mean(weighted, over_n), 1e-4, suspects)}),
            lamp_steps(random), thin_lamps(random)};
}

}  // namespace grade
