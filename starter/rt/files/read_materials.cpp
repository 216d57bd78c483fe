#include "rt/files/scene_parts.h"

namespace rt {
namespace {

Medium read_medium(const Table& table) {
    table.only({"extinction", "albedo", "g"});
    constexpr Limits cosine{[](Real x) { return x > -1 && x < 1; }, "a number between -1 and 1"};
    Medium medium;
    medium.extinction = table.number("extinction", not_negative);
    medium.albedo = table.color("albedo", share, medium.albedo);
    medium.g = table.number("g", cosine, medium.g);
    return medium;
}

Checker read_checker(const Table& table) {
    table.only({"albedo", "size"});
    return {table.color("albedo", share), table.number("size", positive)};
}

Material read_material(const Table& table) {
    table.only({"ambient", "albedo", "specular", "shininess", "reflectance", "transmittance", "exponent", "ior",
                "emission", "sampled", "medium", "checker"});
    constexpr Limits exponent{[](Real x) { return x >= 0; }, "a number from 0, or inf"};
    Material m;
    m.ambient = table.color("ambient", share, m.ambient);
    m.albedo = table.color("albedo", share, m.albedo);
    if (table.has("checker")) m.checker = read_checker(table.table("checker"));
    m.specular = table.color("specular", share, m.specular);
    m.shininess = table.number("shininess", not_negative, m.shininess);
    m.reflectance = table.color("reflectance", share, m.reflectance);
    m.transmittance = table.color("transmittance", share, m.transmittance);
    m.exponent = table.number("exponent", exponent, m.exponent);
    m.ior = table.number("ior", positive, m.ior);
    m.emission = table.color("emission", radiance, m.emission);
    m.sampled = table.flag("sampled", m.sampled);
    if (table.has("medium")) m.medium = read_medium(table.table("medium"));
    return m;
}

}  // namespace

void read_materials(const Table& table, Scene& scene) {
    for (const std::string& name : table.keys()) {
        scene.materials.push_back(read_material(table.table(name)));
        scene.material_names.push_back(name);
    }
}

}  // namespace rt
