#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "protocol/protocol.h"
#include "protocol/rows.h"
#include "require.h"

/// The numbers of an answer are rows, or none; a value in them is read, or the reader throws.
namespace {

template <class Value>
void read_as(std::span<const double> row) {
    try {
        grade::from_row<Value>(row);
    } catch (const std::out_of_range&) {
    } catch (const std::domain_error&) {}
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<double> numbers(size / sizeof(double));
    if (!numbers.empty()) std::memcpy(numbers.data(), data, numbers.size() * sizeof(double));
    std::vector<std::vector<double>> rows;
    if (grade::unflatten(numbers, rows)) {
        const std::vector<double> again = grade::flatten(rows);
        const std::size_t first = 1 + rows.size();  // behind the counts, of which -0 is one
        require(again.size() == numbers.size() && std::memcmp(again.data() + first, numbers.data() + first,
                                                              (again.size() - first) * sizeof(double)) == 0,
                "other numbers came back");
        for (const auto& row : rows) {
            read_as<rt::Ray>(row), read_as<rt::vec3>(row), read_as<rt::LightSample>(row), read_as<rt::Scattered>(row),
                read_as<rt::Outgoing>(row);
            read_as<std::vector<double>>(row), read_as<std::vector<grade::StratumOf>>(row),
                read_as<grade::Integrand>(row);
        }
    }
    return 0;
}
