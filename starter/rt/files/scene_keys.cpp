#include "rt/files/scene_keys.h"

#include <algorithm>

namespace rt {

void read_value(const Table& table, const KeyWords& key, Real& value) { value = table.number(key.name, key.limits); }

void read_value(const Table& table, const KeyWords& key, int& value) {
    value = table.integer(key.name, int(key.limits.low), int(key.limits.high));
}

void read_value(const Table& table, const KeyWords& key, bool& value) { value = table.flag(key.name, value); }

void read_value(const Table& table, const KeyWords& key, vec3& value) {
    value = key.kind == Kind::color     ? table.color(key.name, key.limits)
            : key.kind == Kind::factors ? table.factors(key.name, key.limits)
                                        : table.vector(key.name, key.limits);
}

void read_value(const Table& table, const KeyWords& key, ivec2& value) {
    value = table.pair(key.name, int(key.limits.low), int(key.limits.high));
}

void read_value(const Table& table, const KeyWords& key, Sampler& value) {
    value = Sampler(table.choice(key.name, sampler_names));
}

void read_value(const Table& table, const KeyWords& key, std::string& value) { value = table.text(key.name); }

namespace {

std::vector<KeyTable> make_tables() {
    std::vector<KeyTable> tables;
    const auto add = [&](std::string_view name, const auto&... lists) {
        KeyTable table{name, {}};
        const auto add_list = [&](const auto& list) {
            for (const auto& key : list) table.keys.push_back(words_of(key));
        };
        (add_list(lists), ...);
        tables.push_back(std::move(table));
    };
    add("", keys::top);
    add("render", keys::render);
    add("camera", keys::camera);
    add("shutter", keys::shutter);
    add("materials", keys::material);
    add("materials.medium", keys::medium);
    add("materials.checker", keys::checker);
    add("light.point", keys::point);
    add("light.directional", keys::directional);
    add("shape.sphere", keys::shape, keys::sphere);
    add("shape.triangle", keys::shape, keys::triangle);
    add("shape.quad", keys::shape, keys::quad);
    add("shape.disc", keys::shape, keys::disc);
    add("shape.mesh", keys::shape, keys::mesh);
    return tables;
}

void check_keys(const Table& table, const KeyTable& known, std::vector<std::string_view> names) {
    for (const KeyWords& key : known.keys) names.push_back(key.name);
    table.only(names);
}

}  // namespace

const std::vector<KeyTable>& scene_tables() {
    static const std::vector<KeyTable> tables = make_tables();
    return tables;
}

void check_keys(const Table& table, std::string_view name) {
    check_keys(table, *std::ranges::find(scene_tables(), name, &KeyTable::name), {});
}

int read_type(const Table& table, std::string_view name) {
    std::vector<std::string_view> types;
    std::vector<const KeyTable*> tables;
    for (const KeyTable& known : scene_tables())
        if (known.name.starts_with(name) && known.name.substr(name.size()).starts_with('.'))
            types.push_back(known.name.substr(name.size() + 1)), tables.push_back(&known);
    const int type = table.choice("type", types);
    check_keys(table, *tables[std::size_t(type)], {"type"});
    return type;
}

}  // namespace rt
