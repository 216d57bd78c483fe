#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "textbook/expressions.h"
#include "textbook/source.h"

/// A student's source is read for the diagnosis, or refused: its expressions stand in lines that it has.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    try {
        const auto source = grade::textbook::editable(text);
        const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
        for (const auto& node : source.nodes)
            if (node.line < 1 || node.line > lines || node.text.empty()) {
                std::fprintf(stderr, "source_fuzz: line %d of %ld has no \"%s\"\n", node.line, long(lines),
                             node.text.c_str());
                std::abort();
            }
    } catch (const std::runtime_error&) {
    } catch (const grade::textbook::TooLong&) {}
    return 0;
}
