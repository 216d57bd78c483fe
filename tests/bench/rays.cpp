/// Rays per CPU second through a mesh of n triangles: this renderer's stages against Embree's single rays.
///
///     rays N [--rounds R]
///
/// The same rays for both, in turns; one line of JSON with seconds for each round. One thread. Camera rays are
/// coherent; bounce and shadow rays leave the points that camera rays hit. Without Embree at build time only our own
/// are timed.

#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "rt/sampler.h"
#include "rt/stages/stages.h"
#ifdef WITH_EMBREE
#include <embree3/rtcore.h>
#endif

using namespace rt;

namespace {

double cpu_seconds() {
    rusage used;
    getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](timeval t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// A number in [0, 1) for each ray.
Real number(std::size_t ray, int which) { return Real(combine(combine(7, ray), Bits(which)) >> 11) * 0x1p-53; }

/// A tube with bumps along a trefoil knot, about n triangles, on a floor of two.
Mesh knot(int n) {
    const int around = std::max(8, int(std::sqrt(n / 16.0))), along = n / 2 / around;
    Mesh m;
    const auto curve = [](Real t) {
        const Real r = 1 + 0.45 * std::cos(3 * t);
        return vec3(r * std::cos(2 * t), 0.45 * std::sin(3 * t), r * std::sin(2 * t));
    };
    for (int i = 0; i < along; ++i) {
        const Real t = 2 * pi * i / along;
        const Frame f = frame_about(unit(curve(t + 1e-4) - curve(t - 1e-4)));
        const vec3 x = unit(cross(f.z, curve(t) - vec3(std::cos(2 * t), 0, std::sin(2 * t)))), y = cross(f.z, x);
        for (int k = 0; k < around; ++k) {
            const Real a = 2 * pi * k / around;
            const Real r = 0.3 * (1 + 0.1 * std::sin(9 * a) * std::sin(61 * t));
            m.vertices.push_back(curve(t) + r * (std::cos(a) * x + std::sin(a) * y) + vec3(0, 0.8, 0));
        }
    }
    const auto at = [&](int i, int k) { return (i % along) * around + k % around; };
    for (int i = 0; i < along; ++i)
        for (int k = 0; k < around; ++k) {
            m.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            m.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    const int floor = int(m.vertices.size());
    for (const vec3 v : {vec3(-6, 0, -6), vec3(6, 0, -6), vec3(6, 0, 6), vec3(-6, 0, 6)}) m.vertices.push_back(v);
    m.triangles.push_back({floor, floor + 2, floor + 1});
    m.triangles.push_back({floor, floor + 3, floor + 2});
    return m;
}

using Rays = std::vector<Ray>;

/// Four rays through each of 256 x 256 pixels.
Rays camera_rays() {
    const vec3 eye{0, 4, 4.6}, back = unit(eye - vec3(0, 0.6, 0)), right = unit(cross(vec3(0, 1, 0), back)),
                               up = cross(back, right);
    Rays rays;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            for (int s = 0; s < 4; ++s) {
                const Real u = (x + number(rays.size(), 0)) / 128 - 1, v = (y + number(rays.size(), 1)) / 128 - 1;
                rays.push_back({eye, unit(0.4 * (u * right - v * up) - back), 0, inf});
            }
    return rays;
}

/// Our side: batches as the renderer fills them. The distances and triangles found, or only whether there is any.
struct Found {
    std::vector<Real> t;
    std::vector<Index> id;
};

/// The part of a batch that is its rays, as small as Embree's.
struct Lanes {
    Real numbers[8 * lanes];
};

std::vector<Lanes> batches_of(const Rays& rays) {
    std::vector<Lanes> batches(rays.size() / lanes);
    for (std::size_t k = 0; k < batches.size() * lanes; ++k) {
        const Ray& r = rays[k];
        const Real numbers[] = {r.origin.x,    r.origin.y,    r.origin.z, r.direction.x,
                                r.direction.y, r.direction.z, r.near,     r.far};
        for (std::size_t c = 0; c < 8; ++c) batches[k / lanes].numbers[c * lanes + k % lanes] = numbers[c];
    }
    return batches;
}

double ours(const World& world, const std::vector<Lanes>& batches, bool any, Found* found) {
    Batch b{};
    std::size_t hits = 0;
    static_assert(offsetof(Batch, far) == offsetof(Batch, origin) + 7 * lanes * sizeof(Real));
    double seconds = -cpu_seconds();
    for (const Lanes& rays : batches) {
        b.count = lanes;
        std::memcpy(&b.origin, rays.numbers, sizeof rays);
        std::fill(b.shape, b.shape + lanes, nothing);
        any ? any_hit_stage(world, b) : nearest_stage(world, b);
        for (int i = 0; i < lanes; ++i) {
            hits += b.shape[i] != nothing;
            if (found) found->t.push_back(b.far[i]), found->id.push_back(b.shape[i]);
        }
    }
    seconds += cpu_seconds();
    if (hits == ~std::size_t(0)) std::puts("");
    return seconds;
}

/// Where camera rays hit: rays on, all over the hemisphere; and shadow rays to a lamp 2 m wide.
std::pair<Rays, Rays> second_rays(const Mesh& m, const Rays& rays, const Found& found) {
    Rays bounces, shadows;
    for (std::size_t k = 0; k < found.t.size(); ++k) {
        if (found.id[k] == nothing) continue;
        const glm::ivec3 c = m.triangles[std::size_t(found.id[k])];
        const auto corner = [&](int which) { return m.vertices[std::size_t(c[which])]; };
        vec3 n = unit(cross(corner(1) - corner(0), corner(2) - corner(0)));
        if (dot(n, rays[k].direction) > 0) n = -n;
        // Above the surface by more than single precision's errors, so that both hit the same.
        const vec3 p = rays[k].origin + found.t[k] * rays[k].direction + 1e-4 * n;
        const Real z = std::sqrt(number(k, 2)), r = std::sqrt(1 - z * z), phi = 2 * pi * number(k, 3);
        bounces.push_back({p, frame_about(n).to_world({r * std::cos(phi), r * std::sin(phi), z}), 0, inf});
        const vec3 lamp = vec3(3, 5.5, 2) + vec3(2 * number(k, 4) - 1, 0, 2 * number(k, 5) - 1);
        const Real distance = std::sqrt(dot(lamp - p, lamp - p));
        shadows.push_back({p, (lamp - p) / distance, 0, distance * short_of_light});
    }
    return {bounces, shadows};
}

#ifdef WITH_EMBREE
struct Embree {
    RTCDevice device = rtcNewDevice("threads=1");
    RTCScene scene = rtcNewScene(device);
    double build_seconds = 0;

    Embree(const Mesh& m, RTCBuildQuality quality) {
        RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* v = static_cast<float*>(
            rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, m.vertices.size()));
        for (std::size_t i = 0; i < m.vertices.size(); ++i)
            for (int a = 0; a < 3; ++a) v[3 * i + std::size_t(a)] = float(m.vertices[i][a]);
        auto* t = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, m.triangles.size()));
        for (std::size_t i = 0; i < m.triangles.size(); ++i)
            for (int a = 0; a < 3; ++a) t[3 * i + std::size_t(a)] = unsigned(m.triangles[i][a]);
        build_seconds -= cpu_seconds();
        rtcSetGeometryBuildQuality(g, quality);
        rtcCommitGeometry(g);
        rtcAttachGeometry(scene, g);
        rtcSetSceneBuildQuality(scene, quality);
        rtcCommitScene(scene);
        build_seconds += cpu_seconds();
        rtcReleaseGeometry(g);
    }
    ~Embree() { rtcReleaseScene(scene), rtcReleaseDevice(device); }
};

std::vector<RTCRay> embree_rays(const Rays& rays) {
    std::vector<RTCRay> out;
    for (const Ray& r : rays)
        out.push_back({float(r.origin.x), float(r.origin.y), float(r.origin.z), 0, float(r.direction.x),
                       float(r.direction.y), float(r.direction.z), 0, float(r.far), ~0u, 0, 0});
    return out;
}

double theirs(const Embree& embree, const std::vector<RTCRay>& rays, bool any, Found* found) {
    double seconds = -cpu_seconds();
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    std::size_t hits = 0;
    for (const RTCRay& r : rays) {
        RTCRayHit ray{r, {}};
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        bool hit;
        if (any) {
            rtcOccluded1(embree.scene, &context, &ray.ray);
            hit = ray.ray.tfar < 0;
        } else {
            rtcIntersect1(embree.scene, &context, &ray);
            hit = ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
        }
        hits += hit;
        if (found) found->t.push_back(ray.ray.tfar), found->id.push_back(hit ? Index(ray.hit.primID) : nothing);
    }
    seconds += cpu_seconds();
    if (hits == ~std::size_t(0)) std::puts("");
    return seconds;
}

/// Share of rays for which one finds something and the other nothing.
double disagreement(const Found& a, const Found& b) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < a.id.size(); ++i) n += (a.id[i] == nothing) != (b.id[i] == nothing);
    return double(n) / double(a.id.size());
}
#endif

void print_list(const char* name, const std::vector<double>& values) {
    std::printf(", \"%s\": [", name);
    for (std::size_t i = 0; i < values.size(); ++i) std::printf("%s%.6f", i ? ", " : "", values[i]);
    std::printf("]");
}

/// Both sides in turns on the first rays that make whole batches.
template <class Theirs>
void compare(const char* name, const World& world, Rays rays, bool any, int rounds, Theirs theirs_of) {
    rays.resize(rays.size() / lanes * lanes);
    const std::vector<Lanes> batches = batches_of(rays);
    std::vector<double> a, b, c;
    const auto other = theirs_of(rays, any);
    for (int k = 0; k < rounds; ++k) {
        a.push_back(ours(world, batches, any, nullptr));
        other(b, c);
    }
    std::printf(", \"%s\": {\"rays\": %zu", name, rays.size());
    print_list("ours", a);
    if (!b.empty()) print_list("embree", b), print_list("embree_high", c);
#ifdef WITH_EMBREE
    Found one, two;
    ours(world, batches, any, &one);
    other.found(two);
    std::printf(", \"disagreement\": %.2e", disagreement(one, two));
#endif
    std::printf("}");
}

}  // namespace

int main(int argc, char** argv) {
    const int n = argc > 1 ? std::atoi(argv[1]) : 100000;
    const int rounds = argc > 3 && std::string(argv[2]) == "--rounds" ? std::atoi(argv[3]) : 5;
    Scene scene;
    scene.materials.resize(1);
    scene.meshes.push_back(knot(n));
    const Mesh& mesh = scene.meshes[0];
    double world_seconds = -cpu_seconds();
    const World world = make_world(scene);
    world_seconds += cpu_seconds();
    std::vector<double> build;
    Bvh bvh;
    for (int k = 0; k < 9; ++k) {
        build.push_back(-cpu_seconds());
        bvh = build_bvh(mesh.triangles.size(), [&](std::size_t i) {
            Box box;
            for (int c = 0; c < 3; ++c) box.include(mesh.vertices[std::size_t(mesh.triangles[i][c])]);
            return box;
        });
        build.back() += cpu_seconds();
    }
    std::printf("{\"triangles\": %zu, \"nodes\": %zu, \"bytes\": %zu, \"world_seconds\": %.4f", mesh.triangles.size(),
                bvh.nodes.size(), bvh.nodes.size() * sizeof(bvh.nodes[0]), world_seconds);
    print_list("build", build);
#ifdef WITH_EMBREE
    const Embree medium(mesh, RTC_BUILD_QUALITY_MEDIUM), high(mesh, RTC_BUILD_QUALITY_HIGH);
    std::printf(", \"embree_build\": %.4f, \"embree_high_build\": %.4f", medium.build_seconds, high.build_seconds);
    struct Other {
        const Embree &medium, &high;
        std::vector<RTCRay> rays;
        bool any;
        void operator()(std::vector<double>& b, std::vector<double>& c) const {
            b.push_back(theirs(medium, rays, any, nullptr));
            c.push_back(theirs(high, rays, any, nullptr));
        }
        void found(Found& f) const { theirs(medium, rays, any, &f); }
    };
    const auto other = [&](const Rays& rays, bool any) { return Other{medium, high, embree_rays(rays), any}; };
#else
    const auto other = [](const Rays&, bool) { return [](std::vector<double>&, std::vector<double>&) {}; };
#endif
    const Rays camera = camera_rays();
    Found first;
    ours(world, batches_of(camera), false, &first);
    const auto [bounces, shadows] = second_rays(mesh, camera, first);
    compare("camera, closest", world, camera, false, rounds, other);
    compare("bounce, closest", world, bounces, false, rounds, other);
    compare("bounce, any", world, bounces, true, rounds, other);
    compare("shadow, any", world, shadows, true, rounds, other);
    std::printf("}\n");
}
