#include "rt/files/obj_reader.h"

#include <filesystem>
#include <fstream>

#include "catch.h"
#include "rt/files/polygon.h"
#include "rt/files/scene_reader.h"

/// OBJ files as other programs write them: read as they are meant, or refused with the true reason.

namespace {

using namespace std::string_literals;
namespace fs = std::filesystem;

const std::string square = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";

rt::Mesh read(const std::string& text, bool smooth = false) {
    const auto path = fs::temp_directory_path() / "penumbra_obj_test.obj";
    std::ofstream(path, std::ios::binary) << text;
    return rt::read_obj(path.string(), smooth);
}

/// The complaint about a file, from the line number on; empty: none.
std::string complaint(const std::string& text) {
    const std::string message = complaint_of([&] { read(text); });
    return message.substr(std::min(message.size(), message.find(".obj:") + 5));
}

/// Whether a mesh is the square |x|, |y| <= 1, z = 0, seen from the front: by its area, corners and normals.
bool is_square(const rt::Mesh& mesh) {
    rt::vec3 area(0);
    for (const auto& t : mesh.triangles) {
        const auto at = [&](int i) { return mesh.vertices[std::size_t(t[i])]; };
        area += cross(at(1) - at(0), at(2) - at(0)) / 2.0;
        for (int i = 0; i < 3; ++i)
            if (std::abs(at(i).x) != 1 || std::abs(at(i).y) != 1 || at(i).z != 0) return false;
    }
    for (const auto& n : mesh.normals)
        if (n != rt::vec3(0, 0, 1)) return false;
    return mesh.triangles.size() == 2 && area == rt::vec3(0, 0, 4);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (auto at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

}  // namespace

TEST_CASE("each of the meshes that were read wrongly is the square that it is", "[obj]") {
    int files = 0;
    for (const auto& entry : fs::directory_iterator("tests/cases/meshes")) {
        INFO(entry.path().string());
        ++files;
        CHECK(is_square(rt::read_obj(entry.path().string(), false)));
        CHECK(is_square(rt::read_obj(entry.path().string(), true)));
    }
    CHECK(files == 6);
}

namespace {

const std::string face = "f 1 2 3 4\n", whole = square + face;

/// The square in other ways to write it.
const std::string ways_to_write[] = {
    whole,
    "\xef\xbb\xbf" + whole,
    "# a\n\xef\xbb\xbf" + whole,
    replaced(whole, "\n", "\r\n"),
    replaced(whole, "\n", "\r"),
    replaced(whole, "\n", "\n\r\n"),
    replaced(whole, " ", "\t"),
    replaced(whole, " ", "  \t "),
    replaced(whole, "\n", " \t\n"),
    replaced(whole, "v", "  v"),
    replaced(whole, "v", "V"),
    square + "F 1 2 3 4",
    square + "fo 1 2 3 4",
    square + "f 1 2 3 4",
    square + "f 1 2 3 4#floor",
    square + "f 1 2 3 4 # a \\\n",
    square + "f 1 2 \\\n3 4",
    square + "f 1 2 \\\r\n3 4\r\n",
    square + "f 1 2 \\\r3 4\r",
    square + "f \\\n1 \\\n2 \\\n3 \\\n4 \\\n",
    square + "f 1 2 3 \\  \n 4",
    square + "f 1 2\\\n 3 4",
    "# C:\\models\\\n" + whole,
    "mtllib C:\\models\\\n" + whole,
    "# a comment \\\nthat goes on\n" + whole,
    "g a \\\nb c\n" + whole,
    "mtllib a.mtl\no b\ng c d\ns off\nusemtl e\nvt 0 0\nvt 1 0 0\nvp 1 2\n" + whole + "l 1 2 3\np 4\ns 1\n",
    square + "f -4 -3 -2 -1",
    square + "f 1 -3 3 -1",
    square + "f +1 2 3 4",
    square + "f 1/ 2/ 3/ 4/",
    square + "f 1// 2// 3// 4//",
    square + "f 1/7 2/7 3/7 4/7",
    square + "vn 0 0 1\nf 1//1 2//1 3//-1 4//1",
    square + "vn 0 0 1\nf 1/5/1 2/5/1 3//1 4/5/1",
    square + "vn nan nan nan\nf 1//1 2//1 3//1 4//1",
    square + "vn -nan(ind) -1.#IND 1.#QNAN\nf 1//1 2//1 3//1 4//1",
    square + "vn 0 0 0\nf 1//1 2//1 3//1 4//1",
    square + "vn 0 0 1\nf 1//1 2//1 3//1 4",
    replaced(square, " 0\n", " 0 1\n") + face,
    replaced(square, " 0\n", " 0 0.5 0.25 1\n") + face,
    replaced(square, " 0\n", " 0 1 0.5 0.25 1\n") + face,
    replaced(square, "1", "1.0e0") + face,
    replaced(square, "1", "1.") + face,
    replaced(square, "1", "10E-1") + face,
    replaced(replaced(square, " 1", " +1"), "0", ".0") + face,
    replaced(square, " 0\n", " 1e-400\n") + face,
    square + "f 1 2 2 3 4",
    square + "f 1 2 3 4 1",
    square + "f 1 1 2\nf 1 2 1 2\n" + face,
    square + "v 5 5 0\nf 5 5 5\n" + face,
    square + square + "f 1 6 3 8",
    whole + "\n\n\n",
    "\n\n" + whole,
};

}  // namespace

TEST_CASE("line ends, blanks, comments, continued lines and marks are not what a mesh is made of", "[obj]") {
    for (const std::string& text : ways_to_write) {
        INFO(text);
        CHECK(complaint_of([&] {
                  CHECK(is_square(read(text)));
                  CHECK(is_square(read(text, true)));
              }) == "");
    }
}

TEST_CASE("what is no mesh is refused at its line and column, with the reason", "[obj]") {
    const std::pair<std::string, const char*> files[] = {
        {square + "f 1 2 5", "5:7: a face has vertex 5; expected one of the 4 so far"},
        {square + "f 1 2 0", "5:7: a face has vertex 0; expected "},
        {square + "f 1 2 -5", "5:7: a face has vertex -5; expected "},
        {square + "f 1 2 99999999999999999999", "5:7: a face has vertex 99999999999999999999; expected "},
        {square + "f 1 2\\\n  5 4", "6:3: a face has vertex 5; expected "},
        {square + "f 1//1 2//1 3//1", "5:3: a face has normal 1; expected one of the 0 so far"},
        {square + "f 1 2", "5:1: a face has 2 corners; expected three or more"},
        {square + "  f 1 2 # 3", "5:3: a face has 2 corners; expected "},
        {square + "f", "5:1: a face has 0 corners; expected "},
        {square + "f 1 2 x", "5:7: 'x' in a face is no corner; expected "},
        {square + "f 1 2 3.0", "5:7: '3.0' in a face is no corner; expected "},
        {square + "f 1 2 /3", "5:7: '/3' in a face is no corner; expected "},
        {square + "f 1 2 3/x", "5:7: '3/x' has a texture that is no whole number; expected "},
        {square + "f 1 2 3/1/1/1", "5:7: '3/1/1/1' has too many slashes; expected "},
        {square + "f 1 2 \\ 3", "5:7: '\\' in a face is no corner; expected "},
        {square + "f 1 3 2 4", "5:1: the face of 4 corners crosses itself"},
        {square + "face 1 2 3", "5:1: 'face' is no word of the format; expected "},
        {"v 0 0 x", "1:7: 'x' is no number; expected three numbers"},
        {"v 0,5 0 0", "1:3: '0,5' is no number; expected three numbers, with a point and no comma"},
        {"v 0 nan 0", "1:5: 'nan' is nan; expected a number from -1e70 to 1e70"},
        {"v 0 0 1e71", "1:7: '1e71' is 1e+71; expected "},
        {"v 0 0 1e400", "1:7: '1e400' is inf; expected "},
        {"v 0 0 0x10", "1:7: '0x10' is no number; expected "},
        {"v 0 0", "1:1: 'v' is followed by 2 numbers; expected three numbers"},
        {"v 0 0 0 red", "1:9: 'red' is no number; expected "},
        {"\xef\xbb\xbfv 0 0 x", "1:7: 'x' is no number; expected "},
        {"vn 0 0 z", "1:8: 'z' is no number; expected "},
        {"cstype bezier\nsurf 0 1 0 1 1 2 3", "2:1: 'surf' makes a shape that is no polygon"},
        {"v 0 0 0\nv 0 \0 0\n"s, "2:5: there is a byte 0 in the file; expected text"},
        {"v\0 \0000\0 \0000\0 \0000\0\n\0"s, "1:2: every other byte is 0, as in UTF-16 text; expected UTF-8 or ASCII"},
        {"\xff\xfev\0 \0"s, "1:1: the file is UTF-16 text; expected "},
        {"\xfe\xff\0v\0 "s, "1:1: the file is UTF-16 text; expected "},
        {square, "1:1: there is no face with an area in the file; expected "},
        {square + "f 1 1 2\nf 1 2 1", "1:1: there is no face with an area in the file; expected "},
        {"", "1:1: there is no face"},
        {"\x7f"
         "ELF\x01\xff",
         "1:1: '?ELF?\xff' is no word of the format; expected "},
    };
    for (const auto& [text, expected] : files) {
        INFO(text);
        const std::string message = complaint(text);
        CHECK(message.substr(0, std::string(expected).size()) == expected);
    }
}

TEST_CASE("polygons become triangles that cover them once, whichever corner comes first", "[obj]") {
    const std::vector<std::vector<rt::vec2>> outlines = {
        {{0, 0}, {4, 0}, {4, 4}, {0, 4}},
        {{0, 0}, {4, 0}, {1, 1}, {0, 4}},                                  // an arrow
        {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}},                  // an L
        {{0, 0}, {5, 0}, {5, 5}, {4, 5}, {4, 1}, {1, 1}, {1, 5}, {0, 5}},  // a U
        {{0, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 2}, {0, 4}, {0, 2}},  // with corners on straight lines
        {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}},  // a hole, by a slit
        {{3, 0}, {3.5, 2}, {6, 3}, {3.5, 4}, {3, 6}, {2.5, 4}, {0, 3}, {2.5, 2}},          // a star
    };
    for (const auto& outline : outlines)
        for (std::size_t first = 0; first < outline.size(); ++first)
            for (const double tilt : {0.0, 0.7})
                for (const double size : {1.0, 1e-20, 1e20}) {
                    std::vector<rt::vec3> corners;
                    double area = 0;
                    for (std::size_t i = 0; i < outline.size(); ++i) {
                        const rt::vec2 p = outline[(first + i) % outline.size()],
                                       q = outline[(first + i + 1) % outline.size()];
                        corners.push_back(size * rt::vec3(p.x, p.y * std::cos(tilt), p.y * std::sin(tilt)));
                        area += (p.x * q.y - p.y * q.x) / 2;
                    }
                    CAPTURE(outline.size(), first, tilt, size);
                    const auto triangles = rt::split_polygon(corners);
                    REQUIRE(triangles);
                    double sum = 0;
                    for (const auto& t : *triangles) {
                        const auto at = [&](int i) { return corners[std::size_t(t[std::size_t(i)])] / size; };
                        const rt::vec3 n = cross(at(1) - at(0), at(2) - at(0));
                        CHECK(-n.y * std::sin(tilt) + n.z * std::cos(tilt) >= -1e-12);
                        sum += length(n) / 2;
                    }
                    CHECK(sum == Approx(area));
                }
    // a star drawn in one go, and a ribbon
    CHECK_FALSE(rt::split_polygon({{0, 3, 0}, {2, -3, 0}, {-3, 1, 0}, {3, 1, 0}, {-2, -3, 0}}));
    CHECK_FALSE(rt::split_polygon({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {3, 1, 0}}));
}

TEST_CASE("a quad that is bent is split into two triangles", "[obj]") {
    const auto mesh = read("v 0 0 0\nv 1 0 0.3\nv 1 1 0\nv 0 1 0.3\nf 1 2 3 4\n");
    CHECK(mesh.triangles.size() == 2);
}

TEST_CASE("faces of an OBJ file become triangles", "[reader]") {
    const std::string vertices = "# a square\r\nv 0 0 0\r\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    CHECK_THROWS_AS(read(vertices + "f -4/1/1 -3// -2\n"), rt::InputError);  // names a normal that is not there

    const rt::Mesh mesh = read(vertices + "f -4 -3 -2");
    REQUIRE(mesh.triangles.size() == 3);
    CHECK(mesh.triangles[0] == glm::ivec3(0, 1, 2));
    CHECK(mesh.triangles[1] == glm::ivec3(0, 2, 3));
    CHECK(mesh.triangles[2] == glm::ivec3(0, 1, 2));
    CHECK(mesh.normals.empty());

    const rt::Mesh smooth = read(vertices + "f -4 -3 -2", true);
    REQUIRE(smooth.normals.size() == smooth.vertices.size());
    for (const auto& n : smooth.normals) CHECK(n == rt::vec3(0, 0, 1));
}

TEST_CASE("a mesh keeps the normals of its file, and turns them with a mirror image", "[reader]") {
    read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 1\nf 1//1 2//1 3//1\n");
    const std::string scene = R"([camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[materials.m]
[[shape]]
type = "mesh"
file = "penumbra_obj_test.obj"
smooth = true
scale = [-1, 1, 1]
translate = [0, 0, 1]
material = "m"
)";
    const rt::Mesh mesh = rt::parse_scene(scene, (fs::temp_directory_path() / "tilted.toml").string()).meshes.at(0);
    const auto at = [&](int i) { return mesh.vertices[std::size_t(mesh.triangles[0][i])]; };
    CHECK(rt::cross(at(1) - at(0), at(2) - at(0)) == rt::vec3(0, 0, 1));
    CHECK(mesh.normals[0].x == Approx(-std::sqrt(0.5)));
    CHECK(mesh.normals[0].z == Approx(std::sqrt(0.5)));
    CHECK(at(0) == rt::vec3(0, 0, 1));
}
