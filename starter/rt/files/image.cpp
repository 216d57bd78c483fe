#include "rt/files/image.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>
#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "rt/sampler.h"

namespace rt {
namespace {

constexpr const char* channels[] = {"R", "G", "B"};

[[noreturn]] void fail_to_write(const std::string& path, const std::string& cause) {
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", path, cause));
}

std::string last_error() { return std::generic_category().message(errno); }

/// Lets `write` fill a temporary file beside the path, then puts it in the path's place in one step.
template <class Write>
void replace_file(const std::string& path, Write write) {
    const std::string temporary = fmt::format("{}.{}.tmp", path, getpid());
    try {
        write(temporary);
        if (std::rename(temporary.c_str(), path.c_str()) != 0) throw std::runtime_error(last_error());
    } catch (const std::exception& error) {
        std::remove(temporary.c_str());
        fail_to_write(path, error.what());
    }
}

/// The nearest float; a finite number stays finite.
float to_float(Real x) {
    constexpr Real most = std::numeric_limits<float>::max();
    return float(std::isfinite(x) ? std::clamp(x, -most, most) : x);
}

/// The header of a picture in its film.
Imf::Header header_of(const Image& image, const Label& label) {
    const ivec2 film = label.film == ivec2(0) ? ivec2(image.width, image.height) : label.film, corner = label.corner;
    const Imath::Box2i display({0, 0}, {film.x - 1, film.y - 1}),
        data({corner.x, corner.y}, {corner.x + image.width - 1, corner.y + image.height - 1});
    Imf::Header header(display, data);
    for (const auto& [name, value] : label.attributes) {
        if (const int* number = std::get_if<int>(&value)) header.insert(name, Imf::IntAttribute(*number));
        if (const double* number = std::get_if<double>(&value)) header.insert(name, Imf::DoubleAttribute(*number));
        if (const std::string* text = std::get_if<std::string>(&value))
            header.insert(name, Imf::StringAttribute(*text));
    }
    header.compression() = Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = 1;  // noise hardly shrinks, however long one tries
    for (const char* name : channels) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    return header;
}

}  // namespace

std::uint8_t to_srgb(Real linear) {
    const Real x = linear > 0 ? std::min(linear, 1.0) : 0;
    const Real encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return std::uint8_t(std::lround(encoded * 255));
}

void write_exr(const std::string& path, const Image& image, const Label& label) {
    if (image.width < 1 || image.height < 1) fail_to_write(path, "the image has no pixels");
    replace_file(path, [&](const std::string& temporary) {
        std::vector<float> samples;
        samples.reserve(image.pixels.size() * 3);
        for (const Color& c : image.pixels)
            for (int i = 0; i < 3; ++i) samples.push_back(to_float(c[i]));
        const Imf::Header header = header_of(image, label);
        Imf::OutputFile file(temporary.c_str(), header);
        Imf::FrameBuffer buffer;
        for (int i = 0; i < 3; ++i)
            buffer.insert(channels[i],
                          Imf::Slice::Make(Imf::FLOAT, samples.data() + i, header.dataWindow(), 3 * sizeof(float)));
        file.setFrameBuffer(buffer);
        file.writePixels(image.height);
    });
}

std::uint64_t hash_of(const Image& image) {
    Bits hash = combine(0, Bits(image.width));
    for (const Color& c : image.pixels)
        for (int i = 0; i < 3; ++i)
            hash = combine(hash, std::isnan(c[i]) ? 0x7fc00000u : std::bit_cast<std::uint32_t>(to_float(c[i])));
    return hash;
}

std::string png_bytes(const Image& image, Real exposure) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(image.pixels.size() * 3);
    for (const Color& c : image.pixels)
        for (int i = 0; i < 3; ++i) bytes.push_back(to_srgb(exposure * c[i]));

    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = png_uint_32(image.width);
    png.height = png_uint_32(image.height);
    png.format = PNG_FORMAT_RGB;
    png.flags = PNG_IMAGE_FLAG_FAST;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string file(size, '\0');
    if (!png_image_write_to_memory(&png, file.data(), &size, 0, bytes.data(), 0, nullptr))
        throw std::runtime_error(fmt::format("a PNG cannot be made: {}", png.message));
    file.resize(size);
    return file;
}

void write_png(const std::string& path, const Image& image, Real exposure) {
    replace_file(path, [&](const std::string& temporary) {
        const std::string bytes = png_bytes(image, exposure);
        std::ofstream file(temporary, std::ios::binary);
        file.write(bytes.data(), std::streamsize(bytes.size()));
        file.close();
        if (!file) throw std::runtime_error(last_error());
    });
}

}  // namespace rt
