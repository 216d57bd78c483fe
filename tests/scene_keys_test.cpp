#include "rt/files/scene_keys.h"

#include "catch.h"
#include "rt/files/scene_reader.h"

using namespace rt;

namespace {

/// In TOML; what three numbers are where each is this one.
std::string value_of(const KeyWords& key, const std::string& number) {
    switch (key.kind) {
        case Kind::text:
            return "\"m\"";
        case Kind::flag:
            return "true";
        case Kind::choice:
            return "\"sobol\"";
        case Kind::vector:
            return "[0, " + number + ", 5]";
        case Kind::pair:
            return "[8, " + number + "]";
        default:
            return number;
    }
}

/// A scene with one key of one table, and what must be there.
std::string scene_with(const KeyTable& table, const KeyWords& wanted, const std::string& number) {
    const std::size_t dot = table.name.find('.');
    const std::string name(table.name.substr(0, dot)), inner(dot == table.name.npos ? "" : table.name.substr(dot + 1));
    std::string file, keys;
    for (const KeyWords& key : table.keys)
        if (key.name == wanted.name || (key.otherwise.empty() && key.kind != Kind::table))
            keys += std::string(key.name) + " = " + value_of(key, key.name == wanted.name ? number : "0.5") + "\n";
    if (name.empty()) file = keys;
    file += "[materials.m]\n";
    if (name == "materials") file += inner.empty() ? keys : "[materials.m." + inner + "]\n" + keys;
    if (name == "light" || name == "shape") file += "[[" + name + "]]\ntype = \"" + inner + "\"\n" + keys;
    if (name == "render" || name == "shutter") file += "[" + name + "]\n" + keys;
    return file + "[camera]\n" + (name == "camera" ? keys : "eye = [0, 0, 5]\ntarget = [0, 0, 0]\n");
}

std::string complaint(const std::string& scene) {
    return complaint_of([&] { parse_scene(scene, "s.toml"); });
}

}  // namespace

TEST_CASE("each key of a scene is read, and told what is expected where its number is out of range") {
    int bounded = 0;
    for (const KeyTable& table : scene_tables())
        for (const KeyWords& key : table.keys) {
            INFO(table.name << ": " << key.name);
            CHECK(complaint(scene_with(table, key, "0.5")).find("unknown key") == std::string::npos);
            const bool whole = key.kind == Kind::whole || key.kind == Kind::pair;
            const std::string expected = whole ? "a whole number from " : key.limits.expected();
            const auto is_told = [&](const std::string& number) {
                const std::string message = complaint(scene_with(table, key, number));
                CHECK(message.find("'" + std::string(key.name) + "' is ") != std::string::npos);
                CHECK(message.find(expected) > message.find("; expected "));
                CHECK(message.find(expected) != std::string::npos);
                ++bounded;
            };
            if (key.limits.low > -huge) is_told(whole ? "-5" : "-1e60");
            if (key.limits.high < huge && key.kind != Kind::table) is_told(whole ? "2000000000" : "1e60");
        }
    CHECK(bounded > 40);
}

TEST_CASE("what is expected of a number, in words") {
    CHECK(any_number.expected() == "a number from -1e70 to 1e70");
    CHECK(positive.expected() == "a number above 0, up to 1e70");
    CHECK(positive_or_inf.expected() == "a number above 0, or inf");
    CHECK(share.expected() == "a number from 0 to 1");
    CHECK(keys::angle.expected() == "a number between 0 and 180");
    CHECK(radiance.expected() == "a number from 0 to 3.4e38, the largest that a picture holds");
    CHECK((positive_or_inf.hold(inf) && !positive.hold(inf) && !positive.hold(0) && !keys::angle.hold(180)));
    CHECK((keys::factor.hold(-1) && !keys::factor.hold(0) && !any_number.hold(std::nan(""))));
}
