#pragma once

#include <memory>
#include <mutex>
#include <optional>

namespace grade {

/// What takes a while and is needed only where a check runs: later(make)() is make(), made once, when it is first asked
/// for, from any thread. Copies share it.
template <class Make>
auto later(Make make) {
    struct Made {
        std::once_flag once;
        std::optional<decltype(make())> value;
    };
    return [make = std::move(make), made = std::make_shared<Made>()]() -> const decltype(make())& {
        std::call_once(made->once, [&] { made->value = make(); });
        return *made->value;
    };
}

}  // namespace grade
