#include "rt/files/obj_reader.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <array>
#include <charconv>
#include <istream>
#include <map>
#include <optional>
#include <streambuf>
#include <string_view>

#include "rt/files/obj_lines.h"
#include "rt/files/polygon.h"
#include "rt/files/read_number.h"
#include "rt/files/scene_reader.h"
#include "rt/files/toml_table.h"

namespace rt {
namespace {

std::string_view without_plus(std::string_view word) {
    return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

/// The number that a word is; nothing: it is none. One that is too small is 0, one that is too large is infinite.
std::optional<double> number_of(std::string_view word) {
    const std::string_view digits = without_plus(word);
    double number = 0;
    const auto [end, error] = read_number(digits, number);
    if (digits.empty() || end != digits.data() + digits.size() || error == std::errc::invalid_argument) return {};
    if (error == std::errc::result_out_of_range) return std::strtod(std::string(digits).c_str(), nullptr);
    return number;
}

/// As NaN and infinity are written, by some on Windows as 1.#QNAN.
bool is_no_finite_number(std::string_view word) {
    const auto number = number_of(word);
    return number ? !std::isfinite(*number) : word.find("1.#") != word.npos || word.find("nan(") != word.npos;
}

/// What the file holds, as it is being read.
struct Reading {
    ObjLines lines;
    std::vector<vec3> vertices, normals;  // a normal that is no number is 0, which is none
    vec3 exact{0};                        // of the line that the library reads now
    struct Corner {
        int vertex, normal;                               // -1: none
        auto operator<=>(const Corner&) const = default;  // NOLINT(modernize-use-nullptr): clang-tidy 14 is wrong here
    };
    std::vector<std::array<Corner, 3>> triangles;

    /// OBJ counts from 1, or from -1 backwards.
    int index(std::string_view digits, std::string_view word, std::size_t count, const char* what) const {
        std::int64_t i = 0;
        digits = without_plus(digits);
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), i);
        if (end != digits.data() + digits.size() || error == std::errc::invalid_argument)
            lines.fail(word, fmt::format("{} in a face is no corner", in_quotes(word)),
                       "a vertex number, or vertex/texture/normal");
        const auto n = std::int64_t(count);
        const std::int64_t k = error != std::errc() ? -1 : i > 0 ? i - 1 : n + i;
        if (i == 0 || k < 0 || k >= n)
            lines.fail(word, fmt::format("a face has {} {}", what, digits), fmt::format("one of the {} so far", n));
        return int(k);
    }

    Corner corner(std::string_view word) const {
        std::array<std::string_view, 3> parts;
        std::string_view rest = word;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::size_t slash = rest.find('/');
            parts[i] = rest.substr(0, slash);
            if (slash == rest.npos) break;
            rest = rest.substr(slash + 1);
            if (i == 2)
                lines.fail(word, fmt::format("{} has too many slashes", in_quotes(word)), "vertex/texture/normal");
        }
        if (parts[0].empty())
            lines.fail(word, fmt::format("{} in a face is no corner", in_quotes(word)),
                       "a vertex number, or vertex/texture/normal");
        const auto texture = number_of(parts[1].empty() ? "1" : parts[1]);
        if (!texture || *texture != std::floor(*texture))
            lines.fail(word, fmt::format("{} has a texture that is no whole number", in_quotes(word)),
                       "vertex/texture/normal");
        return {index(parts[0], word, vertices.size(), "vertex"),
                parts[2].empty() ? -1 : index(parts[2], word, normals.size(), "normal")};
    }

    void read_face(std::string_view keyword) {
        std::vector<Corner> corners;
        std::vector<vec3> places;
        for (auto word = lines.word(); !word.empty(); word = lines.word()) {
            corners.push_back(corner(word));
            places.push_back(vertices[std::size_t(corners.back().vertex)]);
        }
        if (corners.size() < 3)
            lines.fail(keyword, fmt::format("a face has {} corner{}", corners.size(), corners.size() == 1 ? "" : "s"),
                       "three or more");
        const auto split = split_polygon(places);
        if (!split)
            lines.fail(keyword,
                       fmt::format("the face of {} corners crosses itself, and cannot be split into triangles",
                                   corners.size()),
                       "corners in their order around the face, or triangles");
        for (const auto& t : *split)
            triangles.push_back({corners[std::size_t(t[0])], corners[std::size_t(t[1])], corners[std::size_t(t[2])]});
    }

    /// The next vertex or normal, as the library is to read it; empty: there is none.
    std::string next_numbers() {
        while (lines.next()) {
            const std::string_view keyword = lines.word();
            const ObjWord kind = obj_word(keyword);
            if (kind == ObjWord::face) read_face(keyword);
            if (kind == ObjWord::unsupported)
                lines.fail(
                    keyword,
                    fmt::format("{} makes a shape that is no polygon, or is in another file", in_quotes(keyword)),
                    "faces ('f') in this file");
            if (kind == ObjWord::unknown)
                lines.fail(keyword, fmt::format("{} is no word of the format", in_quotes(keyword)),
                           "v, vn, f or another statement of a Wavefront OBJ file");
            if (kind == ObjWord::vertex || kind == ObjWord::normal) return numbers(keyword, kind == ObjWord::vertex);
        }
        return {};
    }

    std::string numbers(std::string_view keyword, bool vertex) {
        std::string text = vertex ? "v" : "vn";
        bool none = false;
        int count = 0;
        for (auto word = lines.word(); !word.empty(); word = lines.word(), ++count) {
            const auto number = number_of(word);
            const bool extra = count >= 3;  // a weight, a colour
            if (!vertex && is_no_finite_number(word)) {
                none = true;
                continue;
            }
            if (!number)
                lines.fail(word, fmt::format("{} is no number", in_quotes(word)),
                           word.find(',') == word.npos ? "three numbers" : "three numbers, with a point and no comma");
            if (extra) continue;
            if (!(std::abs(*number) <= huge))
                lines.fail(word, fmt::format("{} is {}", in_quotes(word), *number), any_number.expected());
            exact[count] = *number;
            text += ' ';
            text += without_plus(word);
        }
        if (count < 3)
            lines.fail(keyword, fmt::format("'{}' is followed by {} numbers", keyword, count), "three numbers");
        if (none) exact = vec3(0), text = "vn 0 0 0";
        return text + '\n';
    }

    /// The library's numbers; where it loses more than roundings, those that were checked.
    vec3 checked(vec3 read) const {
        for (int i = 0; i < 3; ++i)
            if (!(std::abs(read[i] - exact[i]) <= 1e-14 * std::abs(exact[i]))) read[i] = exact[i];
        return read;
    }
};

/// Hands the library vertices and normals, line by line; faces are read here, for it knows of no comments in them.
class StatementBuffer : public std::streambuf {
public:
    explicit StatementBuffer(Reading& reading) : reading_(reading) {}

protected:
    int_type underflow() override {
        line_ = reading_.next_numbers();
        setg(line_.data(), line_.data(), line_.data() + line_.size());
        return line_.empty() ? traits_type::eof() : traits_type::to_int_type(line_[0]);
    }

private:
    Reading& reading_;
    std::string line_;
};

void read_lines(Reading& reading) {
    using tinyobj::real_t;
    tinyobj::callback_t callback;
    callback.vertex_cb = [](void* r, real_t x, real_t y, real_t z, real_t) {
        Reading& reading = *static_cast<Reading*>(r);
        reading.vertices.push_back(reading.checked({x, y, z}));
    };
    callback.normal_cb = [](void* r, real_t x, real_t y, real_t z) {
        Reading& reading = *static_cast<Reading*>(r);
        reading.normals.push_back(reading.checked({x, y, z}));
    };
    StatementBuffer numbers(reading);
    std::istream stream(&numbers);
    stream.exceptions(std::ios::badbit);  // or the stream would keep InputError to itself
    std::string warning, error;
    if (!tinyobj::LoadObjWithCallback(stream, callback, &reading, nullptr, &warning, &error))
        reading.lines.fail({}, "no OBJ file: " + error, "a Wavefront OBJ file");
}

bool has_normals(const Reading& reading) {
    for (const auto& triangle : reading.triangles)
        for (const auto& corner : triangle)
            if (corner.normal < 0 || unit(reading.normals[std::size_t(corner.normal)]) == vec3(0)) return false;
    return true;
}

/// The file's normals: a vertex is split where its faces disagree.
void use_file_normals(const Reading& reading, Mesh& mesh) {
    std::map<Reading::Corner, int> places;
    mesh.vertices.clear();
    for (std::size_t t = 0; t < reading.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) {
            const auto corner = reading.triangles[t][std::size_t(i)];
            const auto [place, fresh] = places.try_emplace(corner, int(mesh.vertices.size()));
            mesh.triangles[t][i] = place->second;
            if (!fresh) continue;
            mesh.vertices.push_back(reading.vertices[std::size_t(corner.vertex)]);
            mesh.normals.push_back(unit(reading.normals[std::size_t(corner.normal)]));
        }
}

void use_mean_normals(Mesh& mesh) {
    mesh.normals.assign(mesh.vertices.size(), vec3(0));
    for (const auto& t : mesh.triangles) {
        const vec3 a = mesh.vertices[std::size_t(t[0])], b = mesh.vertices[std::size_t(t[1])];
        const vec3 area = cross(b - a, mesh.vertices[std::size_t(t[2])] - a);
        for (int i = 0; i < 3; ++i) mesh.normals[std::size_t(t[i])] += area;
    }
    for (vec3& n : mesh.normals) n = n == vec3(0) ? vec3(0, 0, 1) : unit(n / largest(n));
}

}  // namespace

Mesh read_obj(const std::string& path, bool smooth) {
    Reading reading{ObjLines(path), {}, {}, vec3(0), {}};
    read_lines(reading);
    if (reading.triangles.empty())
        throw InputError(path + ":1:1: there is no face with an area in the file; expected one or more");

    Mesh mesh;
    mesh.vertices = reading.vertices;
    for (const auto& t : reading.triangles) mesh.triangles.emplace_back(t[0].vertex, t[1].vertex, t[2].vertex);
    if (smooth && has_normals(reading))
        use_file_normals(reading, mesh);
    else if (smooth)
        use_mean_normals(mesh);
    return mesh;
}

}  // namespace rt
