#include "theory/questions.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "files/stamp.h"
#include "rt/sampler.h"

namespace grade {

namespace {

constexpr double pi = std::numbers::pi;

/// In small letters, with single spaces between its words.
std::string plain(const std::string& name) {
    std::string text;
    for (const char c : name) {
        if (std::isspace(static_cast<unsigned char>(c)) == 0)
            text += char(std::tolower(static_cast<unsigned char>(c)));
        else if (!text.empty() && text.back() != ' ')
            text += ' ';
    }
    if (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

/// The numbers of a name, one after the other: FNV-1a, mixed as in splitmix64.
class Draw {
public:
    explicit Draw(const std::string& name) : state_(fnv1a(plain(name))) {}

    /// low + k step, of `count` such numbers.
    double operator()(double low, double step, int count) {
        return low + step * double(rt::mix(state_ += 0x9e3779b97f4a7c15ULL) % std::uint64_t(count));
    }

private:
    std::uint64_t state_;
};

Question irradiance(Draw& draw) {
    const double intensity = draw(20, 5, 17), height = draw(1.5, 0.25, 11), away = draw(0.5, 0.25, 11);
    const double r = std::hypot(height, away), answer = intensity * height / (r * r * r);
    return {
        "irradiance",
        fmt::format("A point light of {} W/sr hangs {} m above a floor. What is the floor's irradiance {} m from the "
                    "place right below it?",
                    intensity, height, away),
        "W/m2",
        {intensity, height, away},
        answer,
        fmt::format("E = I cos(theta)/r^2, where r = sqrt({0}^2 + {1}^2) = {2:.4g} m and cos(theta) = {0}/r = {3:.4g}. "
                    "So E = {4} * {3:.4g} / {5:.4g} = {6:.4g}.",
                    height, away, r, height / r, intensity, r * r, answer)};
}

Question radiance(Draw& draw) {
    const double albedo = draw(0.2, 0.05, 14), irradiance = draw(10, 2, 31), answer = albedo * irradiance / pi;
    return {
        "radiance",
        fmt::format("A Lambertian wall of albedo {:.2f} has the irradiance {} W/m2. Which radiance does it reflect?",
                    albedo, irradiance),
        "W/(sr m2)",
        {albedo, irradiance},
        answer,
        fmt::format("The integral of cos(theta) over the hemisphere is pi, so the BRDF is albedo/pi, and L = {:.2f} * "
                    "{} / pi = {:.4g}.",
                    albedo, irradiance, answer)};
}

Question solid_angle(Draw& draw) {
    const double radius = draw(0.5, 0.25, 7), distance = radius + draw(0.5, 0.25, 13);
    const double sine = radius / distance, answer = 2 * pi * (1 - std::sqrt(1 - sine * sine));
    return {
        "solid_angle",
        fmt::format("A ball of radius {} m has its centre {} m from your eye. Which solid angle does it fill?", radius,
                    distance),
        "sr",
        {radius, distance},
        answer,
        fmt::format("The rim is at sin(theta) = {}/{} = {:.4g}, so cos(theta) = {:.4g}. A cap of the unit sphere has "
                    "2 pi (1 - cos(theta)) = {:.4g}.",
                    radius, distance, sine, std::sqrt(1 - sine * sine), answer)};
}

Question critical_angle(Draw& draw) {
    const double ior = draw(1.3, 0.05, 15), answer = std::asin(1 / ior) * 180 / pi;
    return {"critical_angle",
            fmt::format("Light goes from glass of index {:.2f} to air. From which angle to the normal on is it totally "
                        "reflected?",
                        ior),
            "degrees",
            {ior},
            answer,
            fmt::format("Snell: {0:.2f} sin(theta) = sin(90 degrees) = 1 at the limit, so theta = asin(1/{0:.2f}) = "
                        "{1:.4g} degrees.",
                        ior, answer)};
}

Question samples(Draw& draw) {
    const double taken = draw(16, 8, 10), error = draw(0.04, 0.01, 9), wanted = error / draw(2, 0.5, 7);
    const double answer = taken * error * error / (wanted * wanted);
    return {
        "samples",
        fmt::format("With {} independent samples a pixel a picture has a root mean square error of {:.2f}. How many "
                    "samples a pixel does an error of {:.4g} need?",
                    taken, error, wanted),
        "",
        {taken, error, wanted},
        answer,
        fmt::format("The error falls with 1/sqrt(N). It must become {:.4g} times smaller, so N must become that "
                    "squared times larger: {} * {:.4g} = {:.4g}.",
                    error / wanted, taken, error * error / (wanted * wanted), answer)};
}

Question deviation(Draw& draw) {
    const double power = draw(1, 1, 6), points = draw(50, 25, 15);
    const double square = 1 / (2 * power + 1), mean = 1 / (power + 1),
                 answer = std::sqrt((square - mean * mean) / points);
    return {
        "deviation",
        fmt::format("The integral of x^{} from 0 to 1 is estimated by the mean of {} independent uniform points. What "
                    "is the standard deviation of the estimate?",
                    power, points),
        "",
        {power, points},
        answer,
        fmt::format("Of one point the mean is 1/{0} and the mean square 1/{1}, so the variance is 1/{1} - 1/{0}^2 = "
                    "{2:.4g}. The mean of {3} has the root of {2:.4g}/{3}, which is {4:.4g}.",
                    power + 1, 2 * power + 1, square - mean * mean, points, answer)};
}

Question inversion(Draw& draw) {
    const double power = draw(1, 1, 8), u = draw(0.15, 0.05, 15), answer = std::pow(u, 1 / (power + 1));
    return {
        "inversion",
        fmt::format("Points of [0, 1] are wanted with the density {} x^{}. Inversion, with increasing x: which x does "
                    "the random number {:.2f} give?",
                    power + 1, power, u),
        "",
        {power, u},
        answer,
        fmt::format("The share of the points below x is x^{0}, the integral of the density. x^{0} = {1:.2f} gives x = "
                    "{1:.2f}^(1/{0}) = {2:.4g}.",
                    power + 1, u, answer)};
}

Question blur(Draw& draw) {
    const double radius = draw(5, 1, 16), focus = draw(2, 0.5, 9), lamp = focus + draw(0.5, 0.25, 15);
    const double answer = radius * (lamp - focus) / lamp;
    return {
        "blur",
        fmt::format("A thin lens of radius {} mm is in focus at {} m. A small lamp is on its axis, {} m away. What is "
                    "the radius of its disc of blur, measured in the plane in focus?",
                    radius, focus, lamp),
        "mm",
        {radius, focus, lamp},
        answer,
        fmt::format("The rays from the lamp to the rim of the lens make a cone: {0} mm wide at {1} m from its tip. The "
                    "plane in focus is {1} - {2} = {3} m from the tip: {0} * {3}/{1} = {4:.4g} mm.",
                    radius, lamp, focus, lamp - focus, answer)};
}

}  // namespace

std::vector<Question> questions_of(const std::string& name) {
    Draw draw(name);
    std::vector<Question> all;
    for (const auto ask : {irradiance, radiance, solid_angle, critical_angle, samples, deviation, inversion, blur})
        all.push_back(ask(draw));
    return all;
}

}  // namespace grade
