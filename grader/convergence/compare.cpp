#include "convergence/compare.h"

#include <cmath>
#include <functional>
#include <vector>

#include "statistics/distributions.h"
#include "statistics/moments.h"

namespace grade::convergence {

namespace {

/// A point on logarithmic axes.
struct LogPoint {
    double x, y;
};

/// The points whose x rises from each to the next: what noise has put back is left out.
std::vector<LogPoint> rising(std::span<const Waypoint> path, const std::function<LogPoint(const Waypoint&)>& point_of) {
    std::vector<LogPoint> points;
    for (const Waypoint& place : path) {
        if (!(place.seconds > 0 && place.mse > 0)) continue;
        const LogPoint point = point_of(place);
        if (points.empty() || point.x > points.back().x) points.push_back(point);
    }
    return points;
}

/// On straight lines through the points, beyond them by at most `reach`.
std::optional<double> value_at(const std::vector<LogPoint>& points, double x, double reach) {
    if (points.size() < 2 || !(x >= points.front().x - reach && x <= points.back().x + reach)) return std::nullopt;
    std::size_t i = 1;
    while (i + 1 < points.size() && points[i].x < x) ++i;
    const LogPoint a = points[i - 1], b = points[i];
    return std::exp(a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
}

}  // namespace

std::optional<double> mse_at(std::span<const Waypoint> path, double seconds) {
    const auto points = rising(path, [](const Waypoint& p) { return LogPoint{std::log(p.seconds), std::log(p.mse)}; });
    return value_at(points, std::log(seconds), std::log(most_extrapolation));
}

std::optional<double> seconds_for(std::span<const Waypoint> path, double mse) {
    if (!(mse > 0)) return std::nullopt;
    const auto points = rising(path, [](const Waypoint& p) { return LogPoint{-std::log(p.mse), std::log(p.seconds)}; });
    const auto seconds = value_at(points, -std::log(mse), std::log(most_extrapolation));
    // where the error hardly falls any more, a step down takes all the time in the world
    if (!seconds || *seconds > path.back().seconds * most_extrapolation * most_extrapolation) return std::nullopt;
    return seconds;
}

std::optional<Ratio> geometric_mean(std::span<const double> values) {
    Moments logs;
    for (const double value : values) logs.add(std::log(value));
    if (logs.count == 0) return std::nullopt;
    const double reach = logs.count > 1 ? student_quantile(logs.count - 1, 0.025) * logs.standard_error() : 0;
    return Ratio{std::exp(logs.mean), std::exp(logs.mean - reach), std::exp(logs.mean + reach)};
}

}  // namespace grade::convergence
