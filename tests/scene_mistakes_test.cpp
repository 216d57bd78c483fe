#include <cstdio>
#include <filesystem>
#include <random>

#include "catch.h"
#include "rt/files/scene_reader.h"
#include "small_scene.h"

namespace {

namespace fs = std::filesystem;
using namespace std::string_literals;

/// A mistake in the small scene, and what it must be told.
struct Mistake {
    std::string from, to, complaint;
};

const std::vector<Mistake> mistakes = {
    {"albedo = [0.2, 0.3, 0.4]", "albedo = 1.01", "28:10: 'albedo' is 1.01; expected "},
    {"albedo = [0.2, 0.3, 0.4]", "albedo = = 0.5", "28:10: could not determine value type; expected "},
    {"radius = 0.5", "radius = 1e400", "53:15: '1e400' could not be interpreted as a value; expected "},
    {"radius = 0.5", "radius = nan", "53:10: 'radius' is nan; expected "},
    {"radius = 0.5", "radius = 0", "53:10: 'radius' is 0; expected "},
    {"radius = 0.5", "radius = -0.0", "53:10: 'radius' is -0; expected "},
    {"radius = 0.5", "radius = -1", "53:10: 'radius' is -1; expected "},
    {"radius = 0.5", "radius = 1\nradius = 2", "54:10: cannot redefine existing integer 'radius'; expected "},
    {"radius = 0.5\n", "", "50:1: 'radius' is missing in [[shape]]; expected "},
    {"center = [1, 2, 3]", "center = [0, 1e300, 0]", "52:14: 'center' is 1e+300; expected "},
    {"center = [1, 2, 3]", "center = [0, inf, 0]", "52:14: 'center' is inf; expected "},
    {"size = 0.25", "size = 0", "37:42: 'size' is 0; expected "},
    {", size = 0.25", "", "37:11: 'size' is missing"},
    {"g = -0.5", "g = 1", "38:58: 'g' is 1; expected "},
    {"extinction = 3, ", "", "38:10: 'extinction' is missing"},
    {"target = [0, 0, 1]", "target = [0, 0, 5]", "15:10: the camera's target is its eye; expected "},
    {"target = [0, 0, 1]", "targt = [0, 0, 1]", "15:1: unknown key 'targt' in [camera]; expected "},
    {"up = [0, 2, 0]", "up = [0, 0, 1]", "16:6: the camera looks along 'up'; expected "},
    {"up = [0, 2, 0]", "up = [0, 0, 0]", "16:6: 'up' is zero; expected "},
    {"eye = [0, 0, 5]", "eye = [0, 1]", "14:7: 'eye' has 2 numbers; expected "},
    {"eye = [0, 0, 5]", "eye = \"above\"", "14:7: 'eye' is a string; expected "},
    {"vfov = 90", "vfov = 180", "17:8: 'vfov' is 180; expected "},
    {"vfov = 90", "vfov = 0", "17:8: 'vfov' is 0; expected "},
    {"focus = inf", "focus = 0", "20:9: 'focus' is 0; expected "},
    {"size = [30, 20]", "size = [1.5, 100]", "18:9: 'size' is a number; expected "},
    {"size = [30, 20]", "size = [65536, 65536]", "18:8: 'size' has more than 268435456 pixels; expected "},
    {"size = [30, 20]", "size = [0, 100]", "18:9: 'size' is 0; expected "},
    {"open = -1", "open = 3", "24:9: the shutter closes before it opens; expected "},
    {"samples = 7", "samples = 0", "7:11: 'samples' is 0; expected "},
    {"\"stratified\"", "\"halton\"", "10:11: 'sampler' is 'halton'; expected "},
    {"[[light]]", "[[lights]]", "40:3: unknown key 'lights' in the file; expected "},
    {"intensity = [4, 5, 6]", "intensity = [1, -1, 1]", "43:17: 'intensity' is -1; expected "},
    {"toward = [0, 10, 0]", "toward = [0, 0, 0]", "47:10: 'toward' is zero; expected "},
    {"type = \"sphere\"", "type = \"spere\"", "51:8: 'type' is 'spere'; expected "},
    {"material = \"all\"\nvelocity", "material = \"al\"\nvelocity", "54:12: there is no material 'al'; expected "},
    {"material = \"all\"\nvelocity", "velocity", "50:1: 'material' is missing in [[shape]]; expected "},
    {"sampled = false", "sampled = true", "54:12: shadow rays cannot look for"},
    {"c = [0, 1, 0]", "c = [3, 0, 0]", "59:5: the triangle has no area; expected "},
    {"v = [0, 0, -3]", "v = [0, 0, 0]", "68:5: 'v' is zero; expected "},
    {"v = [0, 0, -3]", "v = [0.1, 1, 0]", "68:5: 'u' and 'v' meet at a cosine of 0.0995; expected "},
    {"normal = [0, -4, 0]", "normal = [0, 0, 0]", "74:10: 'normal' is zero; expected "},
};

const std::string view = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n";

std::string shape(const std::string& key_of_material, const std::string& keys) {
    return view + "[materials.only]\n" + key_of_material + " = 1\n[[shape]]\nmaterial = \"only\"\n" + keys;
}

/// Other texts, and what each must be told.
const std::vector<std::pair<std::string, std::string>> no_scenes = {
    {"", "s.toml:1:1: the file is empty; expected "},
    {"# nothing here\n", "s.toml:1:1: there is no camera; expected "},
    {"\n[materials.white]\nalbedo = 0.5\n", "s.toml:1:1: there is no camera; expected "},
    {view + "[light]\ntype = \"point\"\n", "s.toml:4:1: 'light' is a table; expected "},
    {view + "[materials.wh\0]\xff\xfe\x80"s, "s.toml:4:15: Encountered invalid utf-8 sequence; expected "},
    {shape("emission", "type = \"triangle\"\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [0, 1, 0]\n"),
     "s.toml:7:12: shadow rays cannot look for"},
    {shape("albedo", "type = \"mesh\"\nfile = \"nowhere.obj\"\n"),
     "s.toml:9:8: 'nowhere.obj' cannot be read: No such file or directory; expected "},
    {shape("albedo", "type = \"mesh\"\nfile = \"bad_face.obj\"\n"), "bad_face.obj:4:7: a face has vertex 4; expected "},
    {shape("albedo", "type = \"mesh\"\nfile = \"bad_face.obj\"\nscale = [1, 0, 1]\n"),
     "s.toml:10:13: 'scale' is 0; expected "},
    {shape("albedo", "type = \"mesh\"\nfile = \"bad_face.obj\"\nscale = \"twice\"\n"),
     "s.toml:10:9: 'scale' is a string; expected [x, y, z], or one number for all three"},
};

/// The message of the InputError that the text earns; empty: it is a scene.
std::string complaint(const std::string& text, const fs::path& path = "s.toml") {
    return complaint_of([&] { rt::parse_scene(text, path.string()); });
}

bool is_located(const std::string& message) {
    int line = 0, column = 0, text = 0;
    return std::sscanf(message.c_str(), "s.toml:%d:%d: %n", &line, &column, &text) == 2 && line > 0 && column > 0 &&
           text > 0 && message.find("; expected ") != std::string::npos && message.find('\n') == std::string::npos;
}

/// Start and length of the value in each line that has one.
std::vector<std::pair<std::size_t, std::size_t>> values(const std::string& text) {
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (auto i = text.find(" = "); i != std::string::npos; i = text.find(" = ", text.find('\n', i)))
        found.emplace_back(i + 3, text.find('\n', i) - i - 3);
    return found;
}

}  // namespace

TEST_CASE("each mistake is told what is wrong, and where", "[reader]") {
    REQUIRE(complaint(small_scene) == "");
    for (const auto& [from, to, expected] : mistakes) {
        const std::size_t at = small_scene.find(from);
        REQUIRE(at != std::string::npos);
        const std::string message = complaint(std::string(small_scene).replace(at, from.size(), to));
        INFO(to);
        CHECK(message.substr(0, 7 + expected.size()) == "s.toml:" + expected);
    }
    const fs::path folder = fs::path(__FILE__).parent_path() / "bad_scenes";
    for (const auto& [text, expected] : no_scenes) {
        const std::string message = complaint(text, folder / "s.toml");
        INFO(text);
        CHECK(message.substr(0, folder.string().size() + 1 + expected.size()) == (folder / expected).string());
    }
}

TEST_CASE("any value may be replaced by any other: the answer is a scene or a located error", "[reader]") {
    const std::string others[] = {"nan",
                                  "-nan",
                                  "inf",
                                  "-inf",
                                  "1e400",
                                  "-1e400",
                                  "1e308",
                                  "1e-400",
                                  "4.9e-324",
                                  "-0.0",
                                  "0",
                                  "-1",
                                  "0x10",
                                  "true",
                                  "[]",
                                  "{}",
                                  "[[1]]",
                                  "[nan, 0, 0]",
                                  "[0, 0, 0]",
                                  "[1, 2, 3]",
                                  "[1, 2]",
                                  "''",
                                  "",
                                  "\"\"",
                                  "[[]]",
                                  "[{}]",
                                  "{ x = 1 }",
                                  "1979-05-27",
                                  "99999999999999999999"};
    for (const auto& [start, length] : values(small_scene))
        for (const std::string& other : others) {
            const std::string text = std::string(small_scene).replace(start, length, other);
            const std::string message = complaint(text);
            INFO("'" << small_scene.substr(start, length) << "' becomes '" << other << "': " << message);
            CHECK((message.empty() || is_located(message)));
        }
}

TEST_CASE("a number that is not finite never gets into a scene", "[reader]") {
    const std::string with_inf = "focus exponent";
    for (const auto& [start, length] : values(small_scene))
        for (const std::string other : {"nan", "inf", "1e400", "[nan, 1, 1]", "[1, -inf, 1]"}) {
            const auto line = small_scene.rfind('\n', start) + 1;
            const std::string key = small_scene.substr(line, small_scene.find(' ', line) - line);
            if (other == "inf" && with_inf.find(key) != std::string::npos) continue;
            INFO(key << " = " << other);
            CHECK(complaint(std::string(small_scene).replace(start, length, other)) != "");
        }
}

TEST_CASE("no sequence of bytes crashes the reader", "[reader]") {
    std::mt19937 random(1);
    const auto below = [&](std::size_t n) { return std::size_t(random() % n); };
    const std::string bytes = "\0\n\t\"'#=.,[]{}-+_e0919anif\xff\xc3(\xef\xbb\xbf\x7f\r\\u"s;
    for (int round = 0; round < 4000; ++round) {
        std::string text = small_scene;
        for (auto edits = 1 + below(6); edits > 0; --edits) {
            const auto place = below(text.size());
            if (below(3) == 0)
                text.erase(place, 1 + below(20));
            else if (below(2) == 0)
                text.insert(place, 1, bytes[below(bytes.size())]);
            else
                text[place] = bytes[below(bytes.size())];
            if (text.empty()) text = "x";
        }
        const std::string message = complaint(text);
        INFO("round " << round << ": " << message);
        REQUIRE((message.empty() || is_located(message)));
    }
}

TEST_CASE("deep nesting of any kind is an error", "[reader]") {
    const auto repeat = [](const std::string& piece, int n) {
        std::string text;
        for (int i = 0; i < n; ++i) text += piece;
        return text;
    };
    for (const std::string& text :
         {repeat("a.", 100000) + "a = 1", "[" + repeat("a.", 100000) + "a]", repeat("a . ", 100000) + "a = 1",
          repeat("'a'.", 100000) + "a = 1", "a = " + repeat("[", 100000), "a = " + repeat("{a=", 100000),
          "a = {" + repeat("a.", 100000) + "a = 1}"})
        CHECK(is_located(complaint(text)));
    CHECK(complaint(repeat("a.", 101) + "a = 1").starts_with("s.toml:1:130: too many dots in one key; expected "));
}
