#include "convergence/keep.h"

#include "protocol/bytes.h"

namespace grade {

namespace {

constexpr std::uint64_t most_bytes = 1u << 30;

}  // namespace

void write_kept(const fs::path& path, const KeptResult& kept) {
    nlohmann::ordered_json head = kept.head;
    head["images"] = nlohmann::ordered_json::array();
    for (const rt::Image& image : kept.images) head["images"].push_back({image.width, image.height});
    std::string text = head.dump() + "\n";
    for (const rt::Image& image : kept.images)
        text.append(reinterpret_cast<const char*>(image.pixels.data()), image.pixels.size() * sizeof(rt::Color));
    fs::create_directories(path.parent_path());
    write_text(path, text);
}

std::optional<KeptResult> read_kept(const fs::path& path) try {
    const auto text = read_text(path, most_bytes);
    if (!text) return std::nullopt;
    std::size_t at = text->find('\n');
    KeptResult kept{nlohmann::ordered_json::parse(text->substr(0, at++)), {}};
    for (const auto& size : kept.head.at("images")) {
        rt::Image image(size.at(0), size.at(1));
        const std::size_t bytes = image.pixels.size() * sizeof(rt::Color);
        if (text->size() < at + bytes) return std::nullopt;
        copy_bytes(image.pixels.data(), text->data() + at, bytes);
        at += bytes;
        kept.images.push_back(std::move(image));
    }
    return at == text->size() ? std::optional(std::move(kept)) : std::nullopt;
} catch (const nlohmann::json::exception&) {
    return std::nullopt;
}

}  // namespace grade
