#include "rt/show/tev.h"

#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace rt {
namespace {

constexpr int patience_with_tev = 2;  // [s]
constexpr std::size_t pixels_at_once = 1 << 18;

enum class Kind : char { create = 4, update = 6 };

/// A message, piece by piece.
struct Message {
    std::string bytes = std::string(4, '\0');

    explicit Message(Kind kind) { bytes += char(kind); }
    template <class Number>
    void number(Number value) {
        for (std::size_t k = 0; k < sizeof(Number); ++k) bytes += char(value >> (8 * k) & 0xff);
    }
    void flag(bool value) { bytes += char(value); }
    void text(const std::string& value) { bytes += value + '\0'; }
    void channels() {
        number(std::int32_t(3));
        for (const char* name : {"R", "G", "B"}) text(name);
    }
    std::string finished() {
        for (std::size_t k = 0; k < 4; ++k) bytes[k] = char(bytes.size() >> (8 * k) & 0xff);
        return std::move(bytes);
    }
};

std::string error_text(int code) { return std::generic_category().message(code); }

/// Connects within the time; throws the cause.
void connect_in_time(int socket, const addrinfo& address) {
    const timeval wait{patience_with_tev, 0};
    setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &wait, sizeof wait);  // for connecting and for sending
    if (connect(socket, address.ai_addr, address.ai_addrlen) == 0) return;
    throw std::runtime_error(errno == EINPROGRESS ? "no answer" : error_text(errno));
}

}  // namespace

std::optional<TevAddress> tev_address(const std::string& text) {
    const auto colon = text.rfind(':');
    if (colon == std::string::npos || colon == 0) return std::nullopt;
    TevAddress address{text.substr(0, colon), text.substr(colon + 1)};
    if (address.host.front() == '[' && address.host.back() == ']')
        address.host = address.host.substr(1, address.host.size() - 2);
    else if (address.host.find(':') != std::string::npos)
        return std::nullopt;
    const bool digits =
        !address.port.empty() && address.port.size() <= 5 &&
        std::all_of(address.port.begin(), address.port.end(), [](char c) { return '0' <= c && c <= '9'; });
    if (address.host.empty() || !digits || std::stoi(address.port) < 1 || std::stoi(address.port) > 65535)
        return std::nullopt;
    return address;
}

std::string tev_create(const std::string& name, ivec2 size) {
    Message m(Kind::create);
    m.flag(true);  // it comes to the front
    m.text(name);
    m.number(size.x), m.number(size.y);
    m.channels();
    return m.finished();
}

std::string tev_update(const std::string& name, ivec2 corner, const Image& image, int first, int last) {
    Message m(Kind::update);
    m.flag(false);
    m.text(name);
    m.channels();
    m.number(corner.x), m.number(corner.y + first), m.number(image.width), m.number(last - first);
    for (std::int64_t offset = 0; offset < 3; ++offset) m.number(offset);
    for (int k = 0; k < 3; ++k) m.number(std::int64_t(3));  // from pixel to pixel
    for (int y = first; y < last; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int i = 0; i < 3; ++i) m.number(std::bit_cast<std::uint32_t>(float(image.at(x, y)[i])));
    return m.finished();
}

Tev::Tev(const TevAddress& address, const std::string& name, ivec2 film, ivec2 corner) : name_(name), corner_(corner) {
    addrinfo wanted{}, *found = nullptr;
    wanted.ai_socktype = SOCK_STREAM;
    if (const int code = getaddrinfo(address.host.c_str(), address.port.c_str(), &wanted, &found); code != 0)
        throw std::runtime_error(gai_strerror(code));
    std::string cause;
    for (const addrinfo* one = found; one && socket_ < 0; one = one->ai_next) {
        socket_ = ::socket(one->ai_family, one->ai_socktype | SOCK_CLOEXEC, one->ai_protocol);
        try {
            connect_in_time(socket_, *one);
        } catch (const std::runtime_error& error) {
            cause = error.what();
            close(socket_), socket_ = -1;
        }
    }
    freeaddrinfo(found);
    if (socket_ < 0) throw std::runtime_error(cause);
    send(tev_create(name_, film));
}

Tev::~Tev() { close(socket_); }

void Tev::show(const Image& image) {
    const int step = int(std::max<std::size_t>(1, pixels_at_once / std::size_t(image.width)));
    for (int y = 0; y < image.height && gone_.empty(); y += step)
        send(tev_update(name_, corner_, image, y, std::min(image.height, y + step)));
}

void Tev::send(const std::string& message) {
    for (std::size_t done = 0; done < message.size();) {
        const ssize_t sent = ::send(socket_, message.data() + done, message.size() - done, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) gone_ = errno == EAGAIN ? "it does not listen" : error_text(errno);
        if (sent < 0) return;
        done += std::size_t(sent);
    }
}

}  // namespace rt
