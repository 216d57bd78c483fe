#include "checks/kit/own_numbers.h"

#include <fmt/format.h>

#include "checks/kit/render_check.h"
#include "statistics/sharing.h"

namespace grade {

Statistic own_numbers(const Region& region, int samples, const std::string& what, const std::string& otherwise) {
    const auto cause = [=](const Observation& seen) {
        const Sharing shared = sharing(seen.image, region, samples);
        if (shared.all > 0.7)
            return fmt::format(
                "all pixels have one {}: it is drawn once, or is always {}; it must come from u, which is another for "
                "each sample of each pixel",
                what, otherwise);
        if (shared.rows > 0.5) return fmt::format("all pixels of a row have one {}: it must come from u alone", what);
        if (shared.columns > 0.5)
            return fmt::format("all pixels of a column have one {}: it must come from u alone", what);
        return std::string();
    };
    return of_picture(
        {.id = "G1",
         .what = "share of the variance that pixels have in common: of the picture, a row, a column",
         .number = [=](const rt::Image& image) { return sharing(image, region, samples).sum(); },
         .truth = 0,
         .delta = 0.4,
         .hint = with_value("pixels share {:.3g} of their variance: is one " + what + " drawn for many pixels?"),
         .cause = cause});
}

}  // namespace grade
