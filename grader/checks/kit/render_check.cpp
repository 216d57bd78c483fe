#include "checks/kit/render_check.h"

#include <fmt/format.h>

#include "checks/kit/draw.h"

namespace grade {

std::string toml(double x) { return fmt::format("{:.17g}", x); }

std::string toml(rt::vec3 v) { return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v.x, v.y, v.z); }

std::string toml(const View& view) {
    std::string text =
        fmt::format("[camera]\neye = {}\ntarget = {}\nup = {}\nvfov = {}\nsize = [{}, {}]\n", toml(view.eye),
                    toml(view.target), toml(view.up), toml(view.vfov), view.size.x, view.size.y);
    if (view.lens_radius > 0) text += fmt::format("lens_radius = {}\n", toml(view.lens_radius));
    if (view.focus > 0) text += fmt::format("focus = {}\n", toml(view.focus));
    return text + "\n";
}

namespace {

std::string shape(const std::string& type, const std::string& keys, const std::string& material, rt::vec3 velocity) {
    const std::string moving = velocity == rt::vec3(0) ? "" : fmt::format("velocity = {}\n", toml(velocity));
    return fmt::format("[[shape]]\ntype = \"{}\"\n{}material = \"{}\"\n{}\n", type, keys, material, moving);
}

}  // namespace

std::string sphere(const std::string& material, rt::vec3 center, double radius, rt::vec3 velocity) {
    return shape("sphere", fmt::format("center = {}\nradius = {}\n", toml(center), toml(radius)), material, velocity);
}

std::string disc(const std::string& material, rt::vec3 center, rt::vec3 normal, double radius, rt::vec3 velocity) {
    const std::string keys =
        fmt::format("center = {}\nnormal = {}\nradius = {}\n", toml(center), toml(normal), toml(radius));
    return shape("disc", keys, material, velocity);
}

std::string quad(const std::string& material, rt::vec3 center, rt::vec3 u, rt::vec3 v, rt::vec3 velocity) {
    return shape("quad", fmt::format("center = {}\nu = {}\nv = {}\n", toml(center), toml(u), toml(v)), material,
                 velocity);
}

Place any_place(Generator& random) {
    const rt::vec3 z = direction(random);
    const rt::vec3 x = tilted(random, z, rt::pi / 2);
    return {{x, rt::cross(z, x), z}, box(random, -2, 2)};
}

rt::vec3 view_direction(const rt::Camera& camera, rt::vec2 film) {
    const double scale = 2 * camera.tan_half_fov / camera.size.y;
    return rt::unit(scale * (film.x - 0.5 * camera.size.x) * camera.right -
                    scale * (film.y - 0.5 * camera.size.y) * camera.up - camera.back);
}

rt::vec3 seen_on_plane(const rt::Camera& camera, rt::vec2 film, rt::vec3 point, rt::vec3 normal) {
    const rt::vec3 d = view_direction(camera, film);
    return camera.eye + rt::dot(point - camera.eye, normal) / rt::dot(d, normal) * d;
}

Check render_check(std::string name, Render render, std::vector<Statistic> statistics, int share) {
    return {std::move(name), {}, std::move(render), std::move(statistics), share};
}

Statistic of_picture(std::string id, std::string what, std::function<double(const rt::Image&)> number, double truth,
                     double delta, Hint hint) {
    Statistic s;
    s.id = std::move(id);
    s.what = std::move(what);
    s.measure = [number = std::move(number)](const Observation& seen) { return number(seen.image); };
    s.truth = truth;
    s.delta0 = delta / 10;
    s.delta = delta;
    s.hint = std::move(hint);
    return s;
}

Hint by_value(std::string what, std::vector<KnownValue> known, double near, std::string else_words) {
    return [=](double value, double truth) {
        const std::string off = fmt::format("{} is {:.3g}, not {:.3g}", what, value, truth);
        std::string words = nearest_words(known, value, near);
        if (words.empty()) words = else_words;
        return words.empty() ? off : off + ": " + words;
    };
}

}  // namespace grade
