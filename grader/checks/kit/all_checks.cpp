#include "checks/fragment_checks.h"
#include "checks/kit/draw.h"

namespace grade {

namespace {

void add_checks(const FragmentChecks& of, std::uint64_t seed, std::vector<Check>& all) {
    Generator random = stream(seed, of.fragment);
    for (Check& check : of.checks(random)) {
        check.fragment = of.fragment;
        if (auto* probe = std::get_if<Probe>(&check.experiment)) probe->fragment = of.fragment;
        all.push_back(std::move(check));
    }
}

}  // namespace

std::vector<Check> all_checks(std::uint64_t seed) {
    std::vector<Check> all;
    for (const FragmentChecks& of : fragment_checks) add_checks(of, seed, all);
    return all;
}

std::vector<Check> checks_of(const std::string& fragment, std::uint64_t seed) {
    std::vector<Check> all;
    for (const FragmentChecks& of : fragment_checks)
        if (of.fragment == fragment) add_checks(of, seed, all);
    return all;
}

}  // namespace grade
