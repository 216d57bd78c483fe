#include <algorithm>

#include "diagnosis/steps_made.h"

namespace grade {

namespace {

using namespace rt;

std::vector<Steps> of_film() {
    return {steps(
        "low + cell * size, size = high - low", "vec2 cell; vec2 low; vec2 size",
        +[](const Extent& pixel, const int& i, const int& n, const vec2& u) {
            const Real columns = std::floor(std::sqrt(Real(n))), column = std::floor(i * columns / n);
            const Real first = std::ceil(column * n / columns), next = std::ceil((column + 1) * n / columns);
            return row(vec2((first + u.x * (next - first)) / n, (i - first + u.y) / (next - first)), pixel.low,
                       pixel.high - pixel.low);
        },
        +[](const double* s, const Extent&, const int&, const int&, const vec2&) {
            return row(FilmSample{vec2(s[2], s[3]) + vec2(s[0], s[1]) * vec2(s[4], s[5]), 1});
        })};
}

std::vector<Steps> of_mean() {
    using Colors = std::vector<Color>;
    using Weights = std::vector<Real>;
    return {steps(
        "the sum of weight[i] * radiance[i] over radiance.size()",
        "int the number of terms; int radiance.size(); bool weights left out; bool weights squared; bool 1 / weight[i] "
        "in place of weight[i]; bool the sum of the weights in place of the number of samples; bool a sum that starts "
        "at radiance[0], which is added again; bool the last sample alone; bool weight[0] for all; bool the first "
        "sample left out; bool the last sample left out; bool the first channel in all; bool the mean of the channels "
        "in all; bool the mean of the radiance times the mean of the weights",
        +[](const Colors& all, const Weights&) {
            Row taken = row(int(all.size()), int(all.size()));
            taken.resize(14);
            return taken;
        },
        +[](const double* s, const Colors& all, const Weights& weights) {
            Color sum = s[6] != 0 ? all.at(0) : Color(0), plain(0);
            Real of_weights = 0;
            const std::size_t last = std::min(all.size() - (s[10] != 0), std::size_t(std::max(s[0], 0.0)));
            for (std::size_t i = s[7] != 0 ? all.size() - 1 : s[9] != 0; i < last; ++i) {
                const Real w = weights.at(s[8] != 0 ? 0 : i);
                sum += (s[2] != 0 ? 1 : s[3] != 0 ? w * w : s[4] != 0 ? 1 / w : w) * all[i];
                of_weights += w, plain += all[i];
            }
            if (s[13] != 0) return row(plain * of_weights / sqr(Real(all.size())));
            if (s[11] != 0) sum = Color(sum.x);
            if (s[12] != 0) sum = Color((sum.x + sum.y + sum.z) / 3);
            return row(sum / (s[5] != 0 ? of_weights : s[1]));
        })};
}

std::vector<Steps> of_shutter() {
    return {steps(
        "open + u * (close - open)", "Real open; Real u; Real close - open",
        +[](const Shutter& shutter, const Real& u) { return row(shutter.open, u, shutter.close - shutter.open); },
        +[](const double* s, const Shutter&, const Real&) { return row(s[0] + s[1] * s[2]); })};
}

std::vector<Steps> of_flight() {
    return {steps(
        "-log(1 - u) / extinction",
        "Real log(1 - u); bool log(1 + u) / extinction; bool -log(1 + u) / extinction; bool exp(-u / extinction); bool "
        "exp(-u * extinction); bool extinction * exp(-extinction * u); bool a product with extinction in place of the "
        "division",
        +[](const Real&, const Real& u) { return row(std::log1p(-u), false, false, false, false, false, false); },
        +[](const double* s, const Real& given, const Real& u) {
            const Real extinction = s[6] != 0 ? 1 / given : given;
            if (s[1] != 0 || s[2] != 0) return row((s[1] != 0 ? 1 : -1) * std::log1p(u) / extinction);
            if (s[3] != 0) return row(std::exp(-u / extinction));
            if (s[5] != 0) return row(extinction * std::exp(-extinction * u));
            return row(s[4] != 0 ? std::exp(-u * extinction) : -s[0] / extinction);
        })};
}

std::vector<Steps> of_lens() {
    return {steps(
                "offset = R * (at.x * right + at.y * up), at = uniform_disk(u).point", "vec2 at",
                +[](const Camera&, const Ray&, const vec2& u) { return row(on_disk(u)); },
                +[](const double* s, const Camera& c, const Ray& ray, const vec2&) {
                    const vec3 offset = c.lens_radius * (s[0] * c.right + s[1] * c.up);
                    const Real t = c.focus / -dot(ray.direction, c.back);
                    return row(Ray{ray.origin + offset, unit(ray.direction - offset / t), 0, inf});
                }),
            steps(
                "unit(d - offset / t), t = focus / cos, cos = -dot(d, back)", "Real t; Real cos; vec3 offset",
                +[](const Camera& c, const Ray& ray, const vec2& u) {
                    const vec2 p = c.lens_radius * on_disk(u);
                    const Real cosine = -dot(ray.direction, c.back);
                    return row(c.focus / cosine, cosine, p.x * c.right + p.y * c.up);
                },
                +[](const double* s, const Camera& c, const Ray& ray, const vec2& u) {
                    const vec2 p = c.lens_radius * on_disk(u);
                    const Real t = s[1] != -dot(ray.direction, c.back) ? c.focus / s[1] : s[0];
                    const vec3 offset(s[2], s[3], s[4]);
                    return row(Ray{ray.origin + p.x * c.right + p.y * c.up, unit(ray.direction - offset / t), 0, inf});
                }),
            steps(
                "unit(point - start), point = eye + t * d, t = focus / cos, start = eye + offset",
                "vec3 point; vec3 start; vec3 offset",
                +[](const Camera& c, const Ray& ray, const vec2& u) {
                    const vec2 p = c.lens_radius * on_disk(u);
                    const Real t = std::min(c.focus / -dot(ray.direction, c.back), 1e12);
                    const vec3 offset = p.x * c.right + p.y * c.up;
                    return row(ray.origin + t * ray.direction, ray.origin + offset, offset);
                },
                +[](const double* s, const Camera& c, const Ray& ray, const vec2& u) {
                    const vec2 p = c.lens_radius * on_disk(u);
                    const vec3 usual = p.x * c.right + p.y * c.up, offset(s[6], s[7], s[8]);
                    const vec3 start = offset != usual ? ray.origin + offset : vec3(s[3], s[4], s[5]);
                    return row(Ray{ray.origin + usual, unit(vec3(s[0], s[1], s[2]) - start), 0, inf});
                })};
}

}  // namespace

std::vector<Steps> steps_of_distribution(const std::string& fragment) {
    if (fragment == "film_sample") return of_film();
    if (fragment == "pixel_mean") return of_mean();
    if (fragment == "free_flight") return of_flight();
    if (fragment == "shutter_time") return of_shutter();
    if (fragment == "lens_ray") return of_lens();
    return {};
}

}  // namespace grade
