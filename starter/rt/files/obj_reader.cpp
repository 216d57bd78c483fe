#include "rt/files/obj_reader.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <map>
#include <streambuf>
#include <system_error>

#include "rt/files/read_number.h"
#include "rt/files/scene_reader.h"

namespace rt {
namespace {

[[noreturn]] void fail(const std::string& path, int line, const std::string& wrong, const std::string& expected) {
    throw InputError(fmt::format("{}:{}:1: {}; expected {}", path, line, wrong, expected));
}

/// Whether the text starts with a number; the library takes anything else for a zero.
template <class Number>
bool starts_with_number(std::string_view text) {
    Number number;
    if (!text.empty() && text[0] == '+') text.remove_prefix(1);
    const auto read = read_number(text, number);
    const bool whole_word = read.ptr == text.data() + text.size() || *read.ptr == '/';
    return read.ec == std::errc() && whole_word && std::abs(double(number)) <= 1e70;
}

void check_line(std::string_view line, const std::string& path, int number) {
    const auto next_word = [&line] {
        const auto start = std::min(line.find_first_not_of(" \t\r\n"), line.size());
        line.remove_prefix(start);
        const auto word = line.substr(0, line.find_first_of(" \t\r\n"));
        line.remove_prefix(word.size());
        return word;
    };
    const auto kind = next_word();
    if (kind != "v" && kind != "vn" && kind != "f") return;
    for (int i = 0; i < 3; ++i) {
        const auto word = next_word();
        if (kind == "f" ? !starts_with_number<int>(word) : !starts_with_number<double>(word))
            fail(path, number, fmt::format("'{}' is followed by no number where there must be one", kind),
                 kind == "f" ? "three vertex numbers or more" : "three numbers");
    }
}

/// Hands out a file line by line, so that it is known at any time which line is being read.
class Lines : public std::streambuf {
  public:
    explicit Lines(const std::string& path) : path_(path), file_(path, std::ios::binary) {
        if (!file_) throw std::system_error(errno, std::generic_category());
        file_.peek();
        if (file_.bad()) throw std::system_error(EISDIR, std::generic_category());
    }
    int number() const { return number_; }

  protected:
    int_type underflow() override {
        if (!std::getline(file_, line_)) return traits_type::eof();
        check_line(line_, path_, ++number_);
        line_ += '\n';
        setg(line_.data(), line_.data(), line_.data() + line_.size());
        return traits_type::to_int_type(line_[0]);
    }

  private:
    std::string path_, line_;
    std::ifstream file_;
    int number_ = 0;
};

/// What the file holds, as it is being read.
struct Reading {
    const std::string& path;
    const Lines& lines;
    std::vector<vec3> vertices, normals;
    struct Corner {
        int vertex, normal;  // -1: none
        auto operator<=>(const Corner&) const = default;
    };
    std::vector<std::array<Corner, 3>> triangles;

    /// OBJ counts from 1, or from -1 backwards.
    int index(int i, std::size_t count, const char* what) const {
        const auto n = std::int64_t(count), k = i > 0 ? std::int64_t(i) - 1 : n + i;
        if (i == 0 || k < 0 || k >= n)
            fail(path, lines.number(), fmt::format("a face has {} {}", what, i),
                 fmt::format("one of the {} so far", n));
        return int(k);
    }

    void add_face(const tinyobj::index_t* corners, int count) {
        const auto corner = [&](int i) {
            const auto& c = corners[i];
            return Corner{index(c.vertex_index, vertices.size(), "vertex"),
                          c.normal_index ? index(c.normal_index, normals.size(), "normal") : -1};
        };
        for (int i = 2; i < count; ++i) triangles.push_back({corner(0), corner(i - 1), corner(i)});
    }
};

void read_lines(std::istream& stream, Reading& reading) {
    using tinyobj::real_t;
    tinyobj::callback_t callback;
    callback.vertex_cb = [](void* r, real_t x, real_t y, real_t z, real_t) {
        static_cast<Reading*>(r)->vertices.emplace_back(x, y, z);
    };
    callback.normal_cb = [](void* r, real_t x, real_t y, real_t z) {
        static_cast<Reading*>(r)->normals.emplace_back(x, y, z);
    };
    callback.index_cb = [](void* r, tinyobj::index_t* corners, int count) {
        static_cast<Reading*>(r)->add_face(corners, count);
    };
    std::string warning, error;
    if (!tinyobj::LoadObjWithCallback(stream, callback, &reading, nullptr, &warning, &error))
        fail(reading.path, std::max(reading.lines.number(), 1), "no OBJ file: " + error, "a Wavefront OBJ file");
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
    Lines lines(path);
    std::istream stream(&lines);
    stream.exceptions(std::ios::badbit);  // or the stream would keep InputError to itself
    Reading reading{path, lines, {}, {}, {}};
    read_lines(stream, reading);
    if (reading.triangles.empty()) fail(path, 1, "there is no face in the file", "one or more");

    Mesh mesh;
    mesh.vertices = reading.vertices;
    for (const auto& t : reading.triangles) mesh.triangles.emplace_back(t[0].vertex, t[1].vertex, t[2].vertex);
    if (smooth && has_normals(reading)) use_file_normals(reading, mesh);
    else if (smooth) use_mean_normals(mesh);
    return mesh;
}

}  // namespace rt
