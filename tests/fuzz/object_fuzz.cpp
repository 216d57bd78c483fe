#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "programs/object.h"

/// An object's tables are read within its bounds, or it is none.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const grade::ObjectFile object = grade::read_object({reinterpret_cast<const char*>(data), size});
        for (const std::string& name : object.defined)
            if (name.size() > size) std::fprintf(stderr, "object_fuzz: a name longer than the object\n"), std::abort();
        grade::object_fault(object);
    } catch (const grade::BadObject&) {}
    return 0;
}
