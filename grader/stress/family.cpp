#include "stress/family.h"

#include <cmath>
#include <cstdlib>

namespace grade::stress {

int Demand::mildest() const {
    int best = decades.front();
    bool best_scored = scored.holds(best);
    for (const int decade : decades) {
        const bool in = scored.holds(decade);
        if ((in && !best_scored) || (in == best_scored && std::abs(decade) < std::abs(best)))
            best = decade, best_scored = in;
    }
    return best;
}

std::vector<int> sweep(int low, int high, int step, std::vector<int> more) {
    std::vector<int> all;
    for (int decade = low; decade <= high; decade += step) all.push_back(decade);
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

double worse_error(double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return rt::inf;
    return a > b ? a : b;
}

std::vector<rt::vec2> grid(int n) {
    std::vector<rt::vec2> points;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) points.emplace_back((i + 0.5) / n, (j + 0.5) / n);
    return points;
}

const std::vector<Family>& all_families() {
    static const std::vector<Family> all = [] {
        std::vector<Family> list;
        for (const auto& some :
             {sum_families(), camera_families(), sphere_families(), flat_families(), mesh_families(),
              leaving_families(), shading_families(), glass_families(), warp_families(), lobe_families(),
              light_families(), frame_families(), medium_families(), picture_families()})
            list.insert(list.end(), some.begin(), some.end());
        return list;
    }();
    return all;
}

}  // namespace grade::stress
