#pragma once

#include <optional>
#include <string>

#include "rt/files/image.h"

/// Pictures for tev, Thomas Müller's viewer of images with high dynamic range, by its own protocol: messages over TCP,
/// each of its length, with the length itself, in 4 bytes; a byte for what it asks for; and that. Numbers are little
/// endian, texts end with a zero. Nobody needs this file for the assignment.
///
/// Source: https://github.com/Tom94/tev, include/tev/Ipc.h
namespace rt {

struct TevAddress {
    std::string host, port;
};

/// HOST:PORT, or [HOST]:PORT where the host has colons itself; nothing if it is neither.
std::optional<TevAddress> tev_address(const std::string& text);

/// Asks for a black picture, in the place of one of that name.
std::string tev_create(const std::string& name, ivec2 size);

/// Puts lines from first to last of the image into a picture, whose corner is where the image begins.
std::string tev_update(const std::string& name, ivec2 corner, const Image& image, int first, int last);

/// A connection to tev, which shows one picture.
class Tev {
public:
    /// Connects, and makes the picture. Throws std::runtime_error that says what went wrong, after two seconds at most.
    Tev(const TevAddress& address, const std::string& name, ivec2 film, ivec2 corner);
    ~Tev();
    Tev(const Tev&) = delete;
    Tev& operator=(const Tev&) = delete;

    /// Shows what there is of the picture. Once tev has gone, or has not listened for two seconds, nothing.
    void show(const Image& image);

    /// Why nothing is shown any more; empty: all is well.
    const std::string& gone() const { return gone_; }

private:
    void send(const std::string& message);

    int socket_ = -1;
    std::string name_, gone_;
    ivec2 corner_;
};

}  // namespace rt
