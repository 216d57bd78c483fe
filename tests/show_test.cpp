/// What is drawn into terminals and sent to viewers.

#include "catch.h"
#include "rt/files/words.h"
#include "rt/show/encode.h"
#include "rt/show/preview.h"
#include "rt/show/report.h"
#include "rt/show/terminal.h"
#include "rt/show/tev.h"

namespace {

using namespace rt;

Shown of_colors(int width, int height, std::vector<std::uint8_t> rgb) { return {width, height, std::move(rgb)}; }

/// A picture whose colours differ from pixel to pixel.
Image gradient(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.at(x, y) = {Real(x) / width, Real(y) / height, 0.5};
    return image;
}

/// What sixels paint: the colour of each pixel; -1: none. Only what this program writes is understood.
std::vector<int> painted(const std::string& text, int width, int height) {
    std::vector<int> pixels(std::size_t(width) * std::size_t(height), -1);
    std::size_t at = text.find('#');
    int color = 0, x = 0, top = 0, count = 1;
    const auto number = [&] {
        int n = 0;
        while (std::isdigit(text[at + 1])) n = 10 * n + (text[++at] - '0');
        return n;
    };
    for (; text[at] != '\033'; ++at) {
        const char c = text[at];
        if (c == '#') {
            color = number();
            for (bool defines = text[at + 1] == ';'; defines && text[at + 1] == ';';) ++at, number();
        } else if (c == '!') {
            count = number();
        } else if (c == '$') {
            x = 0;
        } else if (c == '-') {
            x = 0, top += 6;
        } else {
            REQUIRE((c >= 63 && c <= 126));
            for (int k = 0; k < count; ++k, ++x)
                for (int bit = 0; bit < 6; ++bit)
                    if ((c - 63) >> bit & 1) {
                        REQUIRE((x < width && top + bit < height));
                        int& pixel = pixels[std::size_t(top + bit) * std::size_t(width) + std::size_t(x)];
                        CHECK(pixel == -1);  // each once
                        pixel = color;
                    }
            count = 1;
        }
    }
    return pixels;
}

}  // namespace

TEST_CASE("a picture is made small enough, in linear light, and never larger", "[show]") {
    Image image(4, 2);
    image.at(0, 0) = Color(1), image.at(1, 1) = Color(1);  // half of the left square
    const Shown half = shown(image, 1, 2, 80);
    REQUIRE((half.width == 2 && half.height == 1));
    CHECK(int(half.at(0, 0)[0]) == 188);  // half the light, not half of 255
    CHECK(int(half.at(1, 0)[0]) == 0);
    const Shown whole = shown(image, 1, 100, 100);
    CHECK((whole.width == 4 && whole.height == 2));
    const Shown strip = shown(Image(1000, 1), 1, 10, 10);
    CHECK((strip.width == 10 && strip.height == 1));
}

TEST_CASE("half blocks: ink above, ground below, colours said once", "[show]") {
    const auto lines = half_blocks(of_colors(2, 3, {1, 2, 3, 1, 2, 3, 4, 5, 6, 7, 8, 9, 255, 0, 0, 0, 255, 0}));
    REQUIRE(lines.size() == 2);
    CHECK(lines[0] == "\033[38;2;1;2;3m\033[48;2;4;5;6m\u2580\033[48;2;7;8;9m\u2580\033[0m");
    CHECK(lines[1] == "\033[38;2;255;0;0m\u2580\033[38;2;0;255;0m\u2580\033[0m");  // nothing below the last line
}

TEST_CASE("base64 is that of RFC 4648", "[show]") {
    for (const auto& [plain, coded] : {std::pair("", ""),
                                       {"f", "Zg=="},
                                       {"fo", "Zm8="},
                                       {"foo", "Zm9v"},
                                       {"foob", "Zm9vYg=="},
                                       {"fooba", "Zm9vYmE="},
                                       {"foobar", "Zm9vYmFy"}})
        CHECK(base64(plain) == coded);
    CHECK(base64(std::string("\xff\xfe\x00", 3)) == "//4A");
}

TEST_CASE("kitty: pieces of 4096 characters, all but the last with more to come, which make up the PNG", "[show]") {
    for (const std::size_t size : {1u, 3072u, 3073u, 10000u}) {
        const std::string png(size, 'x');
        std::string text = kitty(png, 7), payload;
        int pieces = 0;
        for (; !text.empty(); ++pieces) {
            REQUIRE(text.rfind("\033_G", 0) == 0);
            const auto semicolon = text.find(';'), end = text.find("\033\\");
            const std::string head = text.substr(3, semicolon - 3),
                              piece = text.substr(semicolon + 1, end - semicolon - 1);
            CHECK((head.find("a=T") != std::string::npos) == (pieces == 0));
            CHECK(piece.size() <= 4096);
            text = text.substr(end + 2);
            CHECK((head.find("m=1") != std::string::npos) == !text.empty());
            CHECK((text.empty() || piece.size() % 4 == 0));
            payload += piece;
        }
        INFO(size << " bytes in " << pieces << " pieces");
        CHECK(payload == base64(png));
        CHECK(pieces == int((payload.size() + 4095) / 4096));
    }
}

TEST_CASE("sixels paint each pixel once, in a colour near its own", "[show]") {
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(7, 6), std::pair(20, 13)}) {
        const Shown picture = shown(gradient(width, height), 1, 1000, 1000);
        const std::string text = sixel(picture);
        CHECK(text.rfind("\033P0;1;0q", 0) == 0);
        CHECK(text.substr(text.size() - 2) == "\033\\");
        const std::vector<int> pixels = painted(text, width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const int color = pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
                INFO(x << ',' << y << " colour " << color);
                REQUIRE(color >= 0);
                const int levels[] = {color / 36, color / 6 % 6, color % 6};
                for (int i = 0; i < 3; ++i) CHECK(std::abs(51 * levels[i] - int(picture.at(x, y)[i])) < 51);
            }
    }
    CHECK(sixel(of_colors(5, 1, std::vector<std::uint8_t>(15, 0))).find("!5@$-") != std::string::npos);
}

TEST_CASE("what a terminal answers says how it draws", "[show]") {
    CHECK(graphics_of("\033_Gi=31;OK\033\\\033[?62;c") == Graphics::kitty);
    CHECK(graphics_of("\033[?62;4;22c") == Graphics::sixel);
    CHECK(graphics_of("\033[?65;1;9;4c") == Graphics::sixel);
    for (const char* other :
         {"", "\033[?1;2c", "\033[?64;14;40c", "\033[?4c", "\033_Gi=31;ENOTSUPPORTED\033\\\033[?62c", "garbage;4"})
        CHECK(graphics_of(other) == Graphics::blocks);
}

TEST_CASE("a frame fits the terminal and ends below the picture", "[show]") {
    for (const Graphics graphics : {Graphics::blocks, Graphics::kitty, Graphics::sixel})
        for (const auto& [columns, rows] : {std::pair(80, 24), std::pair(20, 50), std::pair(1, 1)}) {
            const Drawing drawing = drawing_of(gradient(300, 200), 1, graphics, {columns, rows, 10, 20});
            INFO(columns << " x " << rows << ": " << drawing.rows << " lines");
            CHECK((drawing.rows >= 1 && drawing.rows <= std::max(1, rows - 1)));
            if (graphics != Graphics::blocks) continue;
            const auto count = [&](const std::string& what) {
                int n = 0;
                for (auto at = drawing.text.find(what); at != std::string::npos; at = drawing.text.find(what, at + 1))
                    ++n;
                return n;
            };
            CHECK(count("\r\n") == drawing.rows);
            CHECK(count("\u2580") <= columns * drawing.rows);
        }
}

TEST_CASE("an address of tev is HOST:PORT", "[show]") {
    const auto address = tev_address("[::1]:14158");
    REQUIRE(address);
    CHECK((address->host == "::1" && address->port == "14158"));
    CHECK(tev_address("localhost:1"));
    for (const char* wrong : {"", "localhost", ":14158", "localhost:", "localhost:x", "localhost:0", "localhost:65536",
                              "localhost:-1", "::1:5", "[]:5", "localhost:123456"}) {
        INFO(wrong);
        CHECK(!tev_address(wrong));
    }
}

TEST_CASE("a number that is none is reported with the command that shows its sample, whichever pass it was in",
          "[show]") {
    const RenderSettings settings{.seed = 7, .sampler = Sampler::orthogonal, .time_limit = 5};
    BadSample bad{{3, 4}, 100, {std::numeric_limits<Real>::quiet_NaN(), 0, 0}, {}};
    bad.slice = next_slice(settings.sampler, settings.seed, 6, 64, 64);
    CHECK(report_bad_sample("a.toml", {10, 20}, settings, bad) ==
          "a.toml: pixel 3,4, sample 100: radiance nan 0 0; expected a finite number\n"
          "To see how it came about: raytrace a.toml --pixel 3,4 --seed 7 --samples 128 --sampler sobol --size 10x20 "
          "--time-limit 1\n");
    bad.sample.reset();
    CHECK(
        report_bad_sample("a.toml", {10, 20}, settings, bad)
            .starts_with(
                "a.toml: pixel 3,4: the mean is no finite number, though every sample is; expected a finite number\n"));
}

TEST_CASE("a picture that ends long before its time limit says why, unless it was reached or stopped", "[show]") {
    RenderSettings settings{.time_limit = 1};
    Rendering r;
    r.image = Image(1, 1);
    r.samples = 1, r.wall_seconds = 0.6, r.rmse = 0.1;
    const auto says = [&] { return report("a.exr", settings, r).find("does not fit into 1 s") != std::string::npos; };
    CHECK(says());
    r.stopped = true;
    CHECK(!says());
    r.stopped = false, settings.target_error = 0.2;
    CHECK(!says());
    settings.target_error = 0, r.wall_seconds = 0.95;
    CHECK(!says());
}

TEST_CASE("an error that is not known is not given as a number", "[show]") {
    Rendering r;
    r.image = Image(1, 1);
    CHECK(report("a.exr", {}, r).find("error    unknown") != std::string::npos);
}
