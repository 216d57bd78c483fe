#include "rt/files/mitsuba.h"

#include "catch.h"
#include "rt/files/scene_reader.h"

namespace {

const std::string camera = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n";

/// A scene whose materials are all on shapes.
rt::Scene scene_of(const std::string& top, const std::string& materials, const std::string& more = "") {
    std::string text = top + "\n" + camera + materials + more;
    for (std::size_t at = 0; (at = materials.find("[materials.", at)) != std::string::npos; ++at) {
        const std::size_t start = at + std::string("[materials.").size();
        text += "\n[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"" +
                materials.substr(start, materials.find(']', start) - start) + "\"\n";
    }
    return rt::parse_scene(text, "scene.toml");
}

std::string complaint(const rt::Scene& scene) {
    return complaint_of([&] { rt::to_mitsuba(scene, "mesh"); });
}

std::string max_depth(const rt::Scene& scene) {
    const std::string xml = rt::to_mitsuba(scene, "mesh").xml, key = "max_depth\" value=\"";
    const std::size_t at = xml.find(key) + key.size();
    return xml.substr(at, xml.find('"', at) - at);
}

const std::string diffuse = "[materials.a]\nalbedo = 0.5\n";
const std::string lamp = "[materials.b]\nemission = 1\n";
const std::string hidden_lamp = "[materials.c]\nemission = 1\nsampled = false\n";
const std::string mirror = "[materials.d]\nreflectance = 0.5\n";
const std::string cloud = "[materials.e]\ntransmittance = 1\nmedium = { extinction = 1 }\n";

}  // namespace

TEST_CASE("what Mitsuba has no words for is named") {
    using Catch::Matchers::ContainsSubstring;
    CHECK_THAT(complaint(scene_of("", "[materials.shiny]\nspecular = 0.5\n")),
               ContainsSubstring("material \"shiny\": Phong's highlight"));
    CHECK_THAT(complaint(scene_of("ambient = 1", "[materials.a]\nambient = 0.5\n")),
               ContainsSubstring("ambient light"));
    CHECK_THAT(complaint(scene_of("background = 1", diffuse)), ContainsSubstring("'background'"));
    CHECK_THAT(complaint(scene_of("", "[materials.a]\nalbedo = 0.5\nreflectance = 0.2\n")),
               ContainsSubstring("perfect mirror"));
    CHECK_THAT(complaint(scene_of("", "[materials.a]\nalbedo = 0.5\nreflectance = 0.6\nexponent = 9\n")),
               ContainsSubstring("above 1 together"));
    CHECK_THAT(complaint(scene_of("", diffuse + lamp + mirror)), ContainsSubstring("bounces = 0"));
    CHECK_THAT(complaint(scene_of("", cloud, "[[light]]\ntype = \"point\"\nposition = [0, 3, 0]\nintensity = 1\n")),
               ContainsSubstring("beside a medium that scatters"));
    CHECK_THAT(complaint(scene_of("", diffuse,
                                  "[shutter]\nclose = 1\n[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\n"
                                  "material = \"a\"\nvelocity = [1, 0, 0]\n")),
               ContainsSubstring("move while the shutter is open"));
    CHECK_THAT(complaint(scene_of("background = 1", "[materials.shiny]\nspecular = 0.5\n")),
               ContainsSubstring("Phong's") && ContainsSubstring("'background'"));
}

TEST_CASE("Mitsuba follows paths as far as the scene says") {
    const std::string bounces = "[render]\nbounces = 3\ndepth = 7";
    CHECK(max_depth(scene_of("", diffuse + lamp)) == "2");
    CHECK(max_depth(scene_of(bounces, diffuse + lamp)) == "5");
    CHECK(max_depth(scene_of(bounces, diffuse + hidden_lamp)) == "4");
    CHECK(max_depth(scene_of(bounces, mirror + lamp)) == "8");
    CHECK(max_depth(scene_of(bounces, diffuse + mirror + lamp)) == "-1");
    CHECK(max_depth(scene_of(bounces, cloud + lamp)) == "-1");
    CHECK(rt::to_mitsuba(scene_of("", cloud), "mesh").xml.find("volpath") != std::string::npos);
}

TEST_CASE("triangles go into one PLY file for each material") {
    const std::string triangle =
        "[[shape]]\ntype = \"triangle\"\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [0, 1, 0]\nmaterial = ";
    const rt::MitsubaFiles files = rt::to_mitsuba(
        scene_of("", diffuse + hidden_lamp, triangle + "\"a\"\n" + triangle + "\"c\"\n" + triangle + "\"a\"\n"),
        "stem");
    REQUIRE(files.meshes.size() == 2);
    CHECK(files.meshes[0].name == "stem0.ply");
    CHECK(files.meshes[0].contents.find("element vertex 6\n") != std::string::npos);
    CHECK(files.meshes[0].contents.find("element face 2\n") != std::string::npos);
    CHECK(files.meshes[1].contents.find("element face 1\n") != std::string::npos);
    CHECK(files.xml.find("value=\"stem1.ply\"") != std::string::npos);
}

TEST_CASE("a checker on quads is Mitsuba's, scaled to each; on other shapes it is named") {
    using Catch::Matchers::ContainsSubstring;
    const std::string tiles = "[materials.tiles]\nalbedo = 0.5\nchecker = { albedo = 0.25, size = 0.5 }\n";
    CHECK_THAT(complaint(scene_of("", tiles)), ContainsSubstring("material \"tiles\": 'checker' on other shapes"));
    const std::string quad =
        "[[shape]]\ntype = \"quad\"\ncenter = [0, 0, 0]\nu = [1, 0, 0]\nv = [0, 3, 0]\nmaterial = \"tiles\"\n";
    const rt::Scene scene = rt::parse_scene("environment = 1\n" + camera + tiles + quad, "scene.toml");
    CHECK_THAT(rt::to_mitsuba(scene, "mesh").xml,
               ContainsSubstring("checkerboard") &&
                   ContainsSubstring("<scale x=\"2\" y=\"6\"/><translate x=\"-1\" y=\"-3\"/>"));
}
