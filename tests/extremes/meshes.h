#pragma once

#include <array>
#include <map>

#include "extremes/extremes.h"

/// Closed meshes about the origin, of size 1 or so, each with its inside's middle: a point well inside.

struct ClosedMesh {
    std::string name;
    rt::Mesh mesh;
    rt::vec3 middle{0};
};

inline rt::Mesh cube() {
    rt::Mesh m;
    for (int i = 0; i < 8; ++i) m.vertices.push_back(rt::vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    for (const auto& q : std::vector<std::array<int, 4>>{
             {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
        m.triangles.push_back({q[0], q[1], q[2]});
        m.triangles.push_back({q[0], q[2], q[3]});
    }
    return m;
}

/// A sphere of 20 * 4^levels triangles; bumps push its vertices in and out.
inline rt::Mesh ball(int levels, double bumps, Random& random) {
    const double g = (1 + std::sqrt(5)) / 2;
    rt::Mesh m;
    for (const double a : {-1.0, 1.0})
        for (const double b : {-g, g}) {
            m.vertices.push_back(rt::unit(rt::vec3(a, b, 0)));
            m.vertices.push_back(rt::unit(rt::vec3(0, a, b)));
            m.vertices.push_back(rt::unit(rt::vec3(b, 0, a)));
        }
    // Three vertices are a face where all are next to each other.
    const auto next = [&](int i, int j) { return dot(m.vertices[std::size_t(i)], m.vertices[std::size_t(j)]) > 0.4; };
    for (int i = 0; i < 12; ++i)
        for (int j = i + 1; j < 12; ++j)
            for (int k = j + 1; k < 12; ++k)
                if (next(i, j) && next(j, k) && next(k, i)) m.triangles.push_back({i, j, k});
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int i, int j) {
            const auto [place, fresh] = middles.try_emplace(std::minmax(i, j), int(m.vertices.size()));
            if (fresh) m.vertices.push_back(rt::unit(m.vertices[std::size_t(i)] + m.vertices[std::size_t(j)]));
            return place->second;
        };
        std::vector<glm::ivec3> finer;
        for (const auto& t : m.triangles) {
            const int ab = middle(t.x, t.y), bc = middle(t.y, t.z), ca = middle(t.z, t.x);
            for (const glm::ivec3 part : {glm::ivec3{t.x, ab, ca}, {ab, t.y, bc}, {ca, bc, t.z}, {ab, bc, ca}})
                finer.push_back(part);
        }
        m.triangles = finer;
    }
    for (rt::vec3& v : m.vertices) v *= 1 + bumps * random.between(-1, 1);
    return m;
}

/// A sphere by longitude and latitude: needles at the poles.
inline rt::Mesh globe(int around, int down) {
    rt::Mesh m;
    m.vertices = {rt::vec3(0, 0, 1), rt::vec3(0, 0, -1)};
    for (int j = 1; j < down; ++j)
        for (int i = 0; i < around; ++i) {
            const double theta = rt::pi * j / down, phi = 2 * rt::pi * i / around;
            m.vertices.push_back({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
        }
    const auto at = [&](int i, int j) { return j == 0 ? 0 : j == down ? 1 : 2 + (j - 1) * around + i % around; };
    for (int j = 0; j < down; ++j)
        for (int i = 0; i < around; ++i) {
            if (j > 0) m.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
            if (j < down - 1) m.triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
        }
    return m;
}

/// A tube around the circle of radius 1; its middle is a point of that circle.
inline rt::Mesh ring(int around, int across, double thickness) {
    rt::Mesh m;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double phi = 2 * rt::pi * i / around, psi = 2 * rt::pi * j / across;
            const double r = 1 + thickness * std::cos(psi);
            m.vertices.push_back({r * std::cos(phi), r * std::sin(phi), thickness * std::sin(psi)});
        }
    const auto at = [&](int i, int j) { return (i % around) * across + j % across; };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            m.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            m.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return m;
}

inline std::vector<ClosedMesh> closed_meshes() {
    Random random(17);
    return {{"cube", cube(), {0.1, -0.2, 0.05}},
            {"ball", ball(3, 0, random), rt::vec3(0)},
            {"bumpy ball", ball(4, 0.1, random), {0.01, 0.02, -0.03}},
            {"globe with needles", globe(256, 24), {0.1, 0.1, 0.1}},
            {"ring", ring(96, 48, 0.25), {std::cos(0.1), std::sin(0.1), 0.01}}};
}
