#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// What the grader and a child say to each other: frames of a kind, a size, and that many bytes. The grader writes to
/// the child's stdin, the child to descriptor 3, in the byte order of the machine that both run on.
///
///     grader               child
///     scene  TOML text     done, or error with a text
///     render settings      image: width, height, CPU seconds, rays of each kind, then red, green, blue of each pixel
///     trace  settings      text: what each fragment answers along the paths of a pixel
///     fragment  name       done
///     swarm  which         rows: CPU seconds, then one number for each call; see swarm.h
///     rows   rows          rows: CPU seconds, then one row of results for each
///     edited rows          rows likewise, for calls with mistakes in them; see textbook/edits.h
namespace grade {

enum class FrameKind : std::uint32_t {
    scene = 1,
    render,
    fragment,
    rows,
    done,
    image,
    error,
    swarm,
    trace,
    text,
    edit
};

struct FrameHeader {
    FrameKind kind;
    std::uint32_t check = 0x52454e50;  // a frame that student code wrote by accident will not have this
    std::uint64_t bytes = 0;
};

struct RenderRequest {
    std::uint64_t seed;
    std::int32_t samples, sampler;
    std::int32_t width, height;  // 0: the scene's
    std::int64_t one_of_many;    // 0 or 1: the mean of pictures with other seeds is what counts
};

struct TraceRequest {
    RenderRequest picture;
    std::int32_t x, y;
};

/// Numbers of an image's frame before its pixels: width, height, CPU seconds, rays of each kind.
constexpr std::size_t image_head = 3 + 7;

inline std::string frame(FrameKind kind, std::string_view payload) {
    const FrameHeader header{kind, FrameHeader{}.check, payload.size()};
    std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
    return bytes.append(payload);
}

template <class Value>
std::string_view bytes_of(std::span<const Value> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

/// What a child with sanitizers says on stderr when its time ends: which call it answers, from 0 on, and a few times
/// where it is, each time before the calls that led there.
constexpr const char* call_at_end = "at the end, call ";
constexpr const char* place_at_end = "at the end, in\n";

/// What it says where a fragment ends it by itself, before the calls that led there.
constexpr const char* exception_at_end = "ended by an exception: ";
constexpr const char* exit_at_end = "ended by exit\n";

/// Rows as numbers: how many, how long each is, then all of them.
inline std::vector<double> flatten(const std::vector<std::vector<double>>& rows) {
    std::vector<double> flat{double(rows.size())};
    for (const auto& row : rows) flat.push_back(double(row.size()));
    for (const auto& row : rows) flat.insert(flat.end(), row.begin(), row.end());
    return flat;
}

/// The inverse. false: these are no rows.
inline bool unflatten(std::span<const double> flat, std::vector<std::vector<double>>& rows) {
    const auto is_count = [](double x, std::size_t most) {
        return x >= 0 && x <= double(most) && x == double(std::size_t(x));
    };
    if (flat.empty() || !is_count(flat[0], flat.size() - 1)) return false;
    const std::size_t count = std::size_t(flat[0]);
    std::size_t start = 1 + count;
    rows.clear();
    for (std::size_t i = 0; i < count; ++i) {
        if (!is_count(flat[1 + i], flat.size() - start)) return false;
        const auto row = flat.subspan(start, std::size_t(flat[1 + i]));
        rows.emplace_back(row.begin(), row.end());
        start += row.size();
    }
    return start == flat.size();
}

}  // namespace grade
