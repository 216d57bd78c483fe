#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "files/files.h"
#include "protocol/bytes.h"
#include "rt/files/image.h"

/// What one run keeps for another: a tree of JSON, as CBOR, whose numbers and pictures have all their bits.
namespace grade {

using KeptJson = nlohmann::ordered_json;

inline KeptJson kept_numbers(std::span<const double> numbers) {
    std::vector<std::uint8_t> bytes(numbers.size_bytes());
    copy_bytes(bytes.data(), numbers.data(), bytes.size());
    return KeptJson::binary(std::move(bytes));
}

/// Throws nlohmann::json::exception.
inline std::vector<double> numbers_of(const KeptJson& kept) { return numbers_of_bytes(kept.get_binary()); }

inline KeptJson kept_image(const rt::Image& image) {
    const std::span pixels(reinterpret_cast<const double*>(image.pixels.data()), 3 * image.pixels.size());
    return {{"width", image.width}, {"height", image.height}, {"pixels", kept_numbers(pixels)}};
}

/// Throws nlohmann::json::exception, std::runtime_error.
inline rt::Image image_of(const KeptJson& kept) {
    rt::Image image(kept.at("width"), kept.at("height"));
    const std::vector<double> numbers = numbers_of(kept.at("pixels"));
    if (numbers.size() != 3 * image.pixels.size()) throw std::runtime_error("another size of image");
    copy_bytes(image.pixels.data(), numbers.data(), numbers.size() * sizeof(double));
    return image;
}

/// Makes the folder where it is missing. Throws std::runtime_error.
inline void write_kept(const fs::path& path, const KeptJson& kept) {
    const std::vector<std::uint8_t> bytes = KeptJson::to_cbor(kept);
    fs::create_directories(path.parent_path());
    write_text(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

/// What `from` makes of the file; none where it is missing, broken, or not what `from` can read.
template <class From>
auto read_kept(const fs::path& path, From from) -> std::optional<decltype(from(KeptJson()))> {
    const auto bytes = read_text(path, std::uint64_t(1) << 30);
    if (!bytes) return std::nullopt;
    try {
        return from(KeptJson::from_cbor(*bytes));
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

}  // namespace grade
