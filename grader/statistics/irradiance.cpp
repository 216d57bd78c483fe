#include "statistics/irradiance.h"

#include <array>

namespace grade {

double quad_irradiance(const rt::Quad& quad, rt::vec3 p, rt::vec3 n) {
    const std::array<rt::vec3, 4> corners = {quad.center - quad.u - quad.v, quad.center + quad.u - quad.v,
                                             quad.center + quad.u + quad.v, quad.center - quad.u + quad.v};
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
        const rt::vec3 a = rt::unit(corners[i] - p), b = rt::unit(corners[(i + 1) % 4] - p);
        const rt::vec3 normal = rt::cross(a, b);
        const double sine = std::sqrt(rt::dot(normal, normal));
        sum += std::atan2(sine, rt::dot(a, b)) * rt::dot(normal, n) / sine;
    }
    return std::abs(sum) / 2;
}

double coaxial_disc_irradiance(double radius, double height) {
    return rt::pi * rt::sqr(radius) / (rt::sqr(radius) + rt::sqr(height));
}

double sphere_irradiance(const rt::Sphere& sphere, rt::vec3 p, rt::vec3 n) {
    const rt::vec3 to_center = sphere.center - p;
    return rt::pi * rt::sqr(sphere.radius) / rt::dot(to_center, to_center) * rt::dot(rt::unit(to_center), n);
}

}  // namespace grade
