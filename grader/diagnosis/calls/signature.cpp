#include "diagnosis/calls/arguments.h"

#include <map>
#include <sstream>
#include <stdexcept>

#include "protocol/rows.h"

namespace grade {

namespace {

struct Structure {
    std::vector<Signature::Argument> fields;
    Row defaults;
};

std::string without(std::string text, const std::string& word) {
    for (std::size_t at; (at = text.find(word)) != text.npos;) text.erase(at, word.size());
    return text;
}

/// "const Camera& camera, vec2 film"
std::vector<Signature::Argument> declared(const std::string& text) {
    std::vector<Signature::Argument> list;
    std::istringstream in(text);
    for (std::string one; std::getline(in, one, ',');) {
        one = without(without(one, "const "), "&");
        one.erase(0, one.find_first_not_of(' '));
        const std::size_t space = one.rfind(' ');
        if (space == one.npos) continue;
        list.push_back({one.substr(0, space), one.substr(space + 1)});
    }
    return list;
}

/// The structs of rows.h. Colors and vectors are one type there, and two here.
const std::map<std::string, Structure>& fields_of() {
    const auto entry = [](const char* fields, Row defaults) {
        return Structure{declared(fields), std::move(defaults)};
    };
    static const std::map<std::string, Structure> all = {
        {"Ray", entry("vec3 origin, vec3 direction, Real near, Real far", row(rt::Ray{}))},
        {"Hit", entry("vec3 point, vec3 normal, Real error", row(rt::Hit{}))},
        {"Sphere", entry("vec3 center, Real radius", row(rt::Sphere{}))},
        {"Triangle", entry("vec3 a, vec3 b, vec3 c", row(rt::Triangle{}))},
        {"Quad", entry("vec3 center, vec3 u, vec3 v", row(rt::Quad{}))},
        {"Disc", entry("vec3 center, vec3 normal, Real radius", row(rt::Disc{}))},
        {"Camera",
         entry("vec3 eye, vec3 right, vec3 up, vec3 back, Real tan_half_fov, ivec2 size, Real lens_radius, Real focus",
               row(rt::Camera{}))},
        {"Shutter", entry("Real open, Real close", row(rt::Shutter{}))},
        {"Extent", entry("vec2 low, vec2 high", row(rt::Extent{}))},
        {"PointLight", entry("vec3 position, Color intensity, bool directional", row(rt::PointLight{}))},
        {"Emitter",
         entry("Emitter::Kind kind, Quad quad, Disc disc, Sphere sphere, Color radiance", row(rt::Emitter{}))},
        {"Material",
         entry("Color ambient, Color albedo, Color specular, Real shininess, Color reflectance, Color transmittance, "
               "Real exponent, Real ior, Color emission, bool sampled, Real medium.extinction, Color medium.albedo, "
               "Real medium.g",
               row(rt::Material{}))},
        {"LightSample", entry("vec3 direction, Real distance, Real density", row(rt::LightSample{}))},
        {"DiskSample", entry("vec2 point, Real density", row(rt::DiskSample{}))},
        {"DirectionSample", entry("vec3 direction, Real density", row(rt::DirectionSample{}))},
        {"FilmSample", entry("vec2 position, Real weight", row(rt::FilmSample{}))},
        {"Scattered", entry("vec3 direction, Color weight", row(rt::Scattered{}))},
        {"Outgoing", entry("Color local, Color mirror, Color glass", row(rt::Outgoing{}))}};
    return all;
}

std::optional<Kind> kind_of(const std::string& type) {
    static const std::map<std::string, Kind> all = {
        {"Real", Kind::number},          {"int", Kind::whole},   {"bool", Kind::flag},   {"Event", Kind::choice},
        {"Emitter::Kind", Kind::choice}, {"vec3", Kind::vector}, {"Color", Kind::color}, {"vec2", Kind::pair},
        {"ivec2", Kind::whole_pair}};
    const auto found = all.find(type);
    return found == all.end() ? std::nullopt : std::optional(found->second);
}

/// Elements of a list, and a function's parameters, end at the place that is returned.
std::size_t add_list(const Signature::Argument& argument, const Row& row, std::size_t at, Layout& layout) {
    if (argument.type == "Function") {
        layout.formulas.push_back({argument.name, Kind::number, at});
        return at + 2 + std::size_t(row.at(at + 1));
    }
    const std::size_t count = std::size_t(row.at(at));
    const bool strata = argument.type.find("Stratum") != std::string::npos;
    const std::size_t stride = strata ? 0 : argument.type.find("Color") != std::string::npos ? 3 : 1;
    layout.lists.push_back({argument.name, at, count, stride});
    std::size_t end = at + 1 + stride * count;
    for (std::size_t i = 0; strata && i < count; ++i) end += 3 + std::size_t(row.at(end + 2));
    return end;
}

std::size_t add(const Signature::Argument& argument, const std::string& name, const Row& row, std::size_t at,
                Layout& layout) {
    if (const auto kind = kind_of(argument.type)) {
        layout.parts.push_back({name, *kind, at});
        return at + size_of(*kind);
    }
    const auto found = fields_of().find(argument.type);
    if (found == fields_of().end()) return add_list(argument, row, at, layout);
    for (const auto& field : found->second.fields)
        at = add(field, name.empty() ? field.name : name + "." + field.name, row, at, layout);
    return at;
}

}  // namespace

std::string choice_type(const Field& part) { return part.name.ends_with("kind") ? "Emitter::Kind" : "Event"; }

const std::vector<std::string>& choices_of(const Field& part) {
    static const std::map<std::string, std::vector<std::string>> all = {
        {"Emitter::Kind", {"quad", "disc", "sphere"}}, {"Event", {"camera", "diffuse", "specular", "lobe", "medium"}}};
    static const std::vector<std::string> none;
    const auto found = all.find(choice_type(part));
    return found == all.end() ? none : found->second;
}

std::vector<std::string> structures() {
    std::vector<std::string> names;
    for (const auto& entry : fields_of()) names.push_back(entry.first);
    return names;
}

bool is_structure(const std::string& type) { return fields_of().contains(type); }

std::size_t size_of(Kind kind) {
    switch (kind) {
        case Kind::vector:
        case Kind::color:
            return 3;
        case Kind::pair:
        case Kind::whole_pair:
            return 2;
        default:
            return 1;
    }
}

Layout Signature::of_arguments(const Row& row) const {
    Layout layout;
    std::size_t at = 0;
    for (const Argument& argument : arguments) at = add(argument, argument.name, row, at, layout);
    if (at > row.size()) throw std::out_of_range("the row is too short");
    return layout;
}

Layout Signature::of_result(const Row& row) const {
    Layout layout;
    if (add({result, ""}, "", row, 0, layout) > row.size()) throw std::out_of_range("the row is too short");
    return layout;
}

Row Signature::blank() const {
    Row all;
    for (const Argument& argument : arguments) {
        if (const auto found = fields_of().find(argument.type); found != fields_of().end())
            all.insert(all.end(), found->second.defaults.begin(), found->second.defaults.end());
        else if (const auto kind = kind_of(argument.type))
            all.resize(all.size() + size_of(*kind));
        else
            all.resize(all.size() + (argument.type == "Function" ? 2 : 1));
    }
    return all;
}

std::optional<Signature> signature_of(const std::string& fragment, const std::string& header) {
    std::istringstream lines(header);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t at = line.find(" " + fragment + "(");
        if (at == line.npos || line.front() == '/' || line.front() == ' ' || !line.ends_with(");")) continue;
        const std::size_t open = line.find('(', at);
        return Signature{fragment, line.substr(0, at), declared(line.substr(open + 1, line.size() - open - 3))};
    }
    return std::nullopt;
}

}  // namespace grade
