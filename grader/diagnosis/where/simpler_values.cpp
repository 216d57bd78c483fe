#include "diagnosis/where/simpler_values.h"

#include <algorithm>
#include <cmath>

#include "rt/math.h"

namespace grade {

std::vector<std::vector<double>> simpler_values(const Field& part, const Row& row) {
    std::vector<std::vector<double>> list;
    const std::size_t n = size_of(part.kind);
    const std::vector<double> now(row.begin() + std::ptrdiff_t(part.at), row.begin() + std::ptrdiff_t(part.at + n));
    const auto add = [&](std::vector<double> value) { list.push_back(std::move(value)); };
    if (part.kind == Kind::vector || part.kind == Kind::color) {
        for (const double s : {0.0, 1.0, 0.5})
            if (part.kind == Kind::color || s == 0) add({s, s, s});
        if (part.kind == Kind::vector) {
            for (const double s : {1.0, -1.0})
                for (int axis : {2, 1, 0}) {
                    std::vector<double> value(3);
                    value[std::size_t(axis)] = s;
                    add(value);
                }
            for (const double s : {1.0, -1.0})
                add({0, 0.6, s * 0.8}), add({0.6, 0, s * 0.8}), add({0.6, s * 0.8, 0}), add({-0.6, 0, s * 0.8});
            add({0, 0, 2}), add({0, 0, -2}), add({1, 2, 2});
        } else
            add({1, 0, 0}), add({0.2, 0.5, 1});
    } else if (part.kind == Kind::whole || part.kind == Kind::whole_pair) {
        if (n == 1)
            for (const double x : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0}) add({x});
        else
            add({2, 2}), add({4, 2}), add({2, 4}), add({100, 100}), add({200, 100});
    } else if (part.kind == Kind::flag) {
        add({0});
    } else if (part.kind != Kind::choice) {
        // the same number as 1 - u, by which others sample as well
        if (part.name == "u") add(std::vector<double>(n, 0.5));
        // a power of 0 shows least
        if (part.name.ends_with("exponent") || part.name.ends_with("shininess")) add({1}), add({2});
        for (const double x : {0.0, 1.0, 0.5, 2.0, -1.0, 0.25, 3.0, 10.0, 100.0, rt::inf})
            add(std::vector<double>(n, x));
        if (n == 2)
            for (const double x : {0.0, 0.5, 0.25}) add({x, now[1]}), add({now[0], x});
        if (n == 2) add({0.25, 0.5}), add({0.5, 0.25});
    }
    const double length = std::hypot(now[0], n > 1 ? now[1] : 0, n > 2 ? now[2] : 0);
    const bool is_unit = part.kind == Kind::vector && std::abs(length - 1) < 1e-9;
    for (int digits = 1; digits < 4 && !is_unit; ++digits) {
        std::vector<double> value;
        for (const double x : now) value.push_back(rounded(x, digits));
        add(value);
    }
    // what stands there is as good as what comes after it
    if (const auto place = std::ranges::find(list, now); place != list.end()) list.erase(place, list.end());
    return list;
}

}  // namespace grade
