#include "rt/files/scene_keys.h"
#include "rt/files/scene_parts.h"

namespace rt {
namespace {

/// A table within that of a material.
template <class T, std::size_t n>
T read_inner(const Table& material, std::string_view name, const Key<T> (&keys)[n]) {
    const Table table = material.table(name);
    check_keys(table, "materials." + std::string(name));
    return read_keys(table, keys);
}

Material read_material(const Table& table) {
    check_keys(table, "materials");
    Material m = read_keys(table, keys::material);
    if (table.has("medium")) m.medium = read_inner(table, "medium", keys::medium);
    if (table.has("checker")) m.checker = read_inner(table, "checker", keys::checker);
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
