#include "rt/files/image.h"

#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iterator>

#include "catch.h"
#include "exr.h"
#include "files/files.h"

namespace {

namespace fs = std::filesystem;

/// A folder of its own, gone at the end of the test.
struct Folder {
    fs::path path = fs::temp_directory_path() / ("penumbra_image_test_" + std::to_string(getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    std::string operator/(const char* name) const { return (path / name).string(); }
    std::size_t count() const { return std::size_t(std::distance(fs::directory_iterator(path), {})); }
};

/// The bytes of a PNG's pixels, R G B.
std::vector<std::uint8_t> decoded(const std::string& file) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_memory(&png, file.data(), file.size()));
    png.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(png));
    REQUIRE(png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr));
    return bytes;
}

}  // namespace

TEST_CASE("an EXR keeps every float, beyond what a half can hold", "[image]") {
    const Folder folder;
    rt::Image image(3, 2);
    image.at(0, 0) = {0, -0.0, 1};
    image.at(1, 0) = {65504, 65520, 1e30};
    image.at(2, 0) = {1.0f / 3, 1e-40f, -5};
    image.at(0, 1) = {rt::inf, -rt::inf, std::nan("")};
    image.at(1, 1) = {1e300, -1e300, 3.4e38f};
    image.at(2, 1) = {1, 2, 3};
    rt::write_exr(folder / "a.exr", image);
    const rt::Image back = rt::read_exr(folder / "a.exr");
    REQUIRE((back.width == 3 && back.height == 2));
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x)
            for (int i = 0; i < 3; ++i) {
                const double in = image.at(x, y)[i], out = back.at(x, y)[i];
                INFO("pixel " << x << ' ' << y << " channel " << i << ": " << in << " becomes " << out);
                const double most = std::numeric_limits<float>::max();
                if (std::isnan(in))
                    CHECK(std::isnan(out));
                else if (std::isinf(in))
                    CHECK(out == in);
                else
                    CHECK(out == double(float(std::clamp(in, -most, most))));
            }
    CHECK(folder.count() == 1);
}

TEST_CASE("images of extreme shape survive", "[image]") {
    const Folder folder;
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 65536), std::pair(65536, 1), std::pair(17, 33)}) {
        rt::Image image(width, height);
        image.at(width - 1, height - 1) = {1, 2, 3};
        rt::write_exr(folder / "a.exr", image);
        rt::write_png(folder / "a.png", image);
        const rt::Image back = rt::read_exr(folder / "a.exr");
        REQUIRE((back.width == width && back.height == height));
        CHECK(back.at(width - 1, height - 1) == rt::Color(1, 2, 3));
    }
}

TEST_CASE("a file that cannot be written leaves the old one whole and nothing behind", "[image]") {
    const Folder folder;
    fs::create_directory(folder / "taken.exr");
    const rt::Image image(2, 2);
    for (const char* name : {"taken.exr", "no_such_folder/a.exr"}) {
        const std::string path = folder / name;
        const std::string exr = complaint_of([&] { rt::write_exr(path, image); });
        const std::string png = complaint_of([&] { rt::write_png(path, image); });
        INFO(exr << '\n' << png);
        CHECK(exr.rfind(path + ": cannot be written: ", 0) == 0);
        CHECK(png.rfind(path + ": cannot be written: ", 0) == 0);
    }
    CHECK(folder.count() == 1);

    rt::write_exr(folder / "old.exr", image);
    const auto before = grade::read_text(folder / "old.exr");
    CHECK(complaint_of([&] { rt::write_exr(folder / "old.exr", rt::Image()); }) != "");
    CHECK(grade::read_text(folder / "old.exr") == before);
}

TEST_CASE("the preview is sRGB: linear 0.2159 shows as 128", "[image]") {
    rt::Image image(8, 1);
    const double linear[] = {0, 1, 0.2158605, 0.0031308, 0.001, 2, -1, std::nan("")};
    const int shown[] = {0, 255, 128, 10, 3, 255, 0, 0};
    for (int x = 0; x < 8; ++x) image.at(x, 0) = rt::Color(linear[x]);
    image.at(7, 0) = {std::nan(""), 1, 0};
    const auto bytes = decoded(rt::png_bytes(image));
    for (std::size_t x = 0; x < 7; ++x) {
        INFO("linear " << linear[x]);
        CHECK(int(bytes[3 * x]) == shown[x]);
    }
    CHECK((bytes[21] == 0 && bytes[22] == 255 && bytes[23] == 0));
}

TEST_CASE("exposure scales the preview, in linear light", "[image]") {
    rt::Image image(1, 1);
    image.at(0, 0) = {0.1, 0.2, 0.4};
    rt::Image doubled(1, 1);
    doubled.at(0, 0) = {0.2, 0.4, 0.8};
    CHECK(decoded(rt::png_bytes(image, 2)) == decoded(rt::png_bytes(doubled)));
    CHECK(decoded(rt::png_bytes(image, 2)) != decoded(rt::png_bytes(image)));
}

TEST_CASE("a part of a film keeps its place in the file, and reads back as the part", "[image]") {
    const Folder folder;
    rt::Image part(3, 2);
    part.at(2, 1) = {1, 2, 3};
    rt::write_exr(folder / "part.exr", part, {{5, 6}, {32, 24}, {}});
    const rt::Image back = rt::read_exr(folder / "part.exr");
    REQUIRE((back.width == 3 && back.height == 2));
    CHECK(back.at(2, 1) == rt::Color(1, 2, 3));
    const rt::Label label = rt::read_label(folder / "part.exr");
    CHECK(label.corner == rt::ivec2(5, 6));
    CHECK(label.film == rt::ivec2(32, 24));
    rt::write_exr(folder / "all.exr", part);
    CHECK(rt::read_label(folder / "all.exr").film == rt::ivec2(3, 2));
    CHECK(rt::read_label(folder / "all.exr").corner == rt::ivec2(0, 0));
}

TEST_CASE("what a file says of its picture reads back as it was", "[image]") {
    const Folder folder;
    rt::Label label;
    label.attributes = {
        {"error", 0.125}, {"passes", -3}, {"scene", std::string("a \"b\" ü.toml")}, {"seed", std::string()}};
    rt::write_exr(folder / "a.exr", rt::Image(2, 2), label);
    CHECK(rt::read_label(folder / "a.exr").attributes == label.attributes);
}

TEST_CASE("equal pictures have equal hashes, whatever is said of them; others have others", "[image]") {
    const Folder folder;
    rt::Image image(4, 3);
    image.at(1, 1) = {0.1, 1e300, rt::inf};
    const std::uint64_t hash = rt::hash_of(image);
    rt::Label label;
    label.attributes = {{"wall_seconds", 1.5}};
    rt::write_exr(folder / "a.exr", image, label);
    CHECK(rt::hash_of(rt::read_exr(folder / "a.exr")) == hash);
    for (std::size_t k = 0; k < image.pixels.size(); ++k)
        for (int i = 0; i < 3; ++i) {
            rt::Image other = image;
            other.pixels[k][i] += 1;
            if (std::isfinite(image.pixels[k][i]) && image.pixels[k][i] < 1e9) CHECK(rt::hash_of(other) != hash);
        }
    rt::Image turned(3, 4);
    turned.pixels = image.pixels;
    CHECK(rt::hash_of(turned) != hash);
    rt::Image swapped = image;
    std::swap(swapped.at(0, 0), swapped.at(1, 1));
    CHECK(rt::hash_of(swapped) != hash);
}
