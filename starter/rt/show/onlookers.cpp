#include "rt/show/onlookers.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>

namespace rt {
namespace {

constexpr std::chrono::milliseconds patience_with_terminal(500);  // with a terminal's answer

Graphics graphics_named(const std::string& name) {
    if (name == "kitty") return Graphics::kitty;
    if (name == "sixel") return Graphics::sixel;
    return name == "blocks" ? Graphics::blocks : ask_for_graphics(patience_with_terminal);
}

}  // namespace

Onlookers::Onlookers(const ShowOptions& o) {
    if (!o.preview.empty() && !can_draw(STDERR_FILENO))
        fmt::print(stderr, "--preview: the standard error is no terminal that can draw; the picture is made without\n");
    else if (!o.preview.empty())
        preview_ = std::make_unique<Preview>(STDERR_FILENO, graphics_named(o.preview), o.exposure);
    if (!o.tev) return;
    tev_name_ = o.tev->host + ":" + o.tev->port;
    try {
        tev_ = std::make_unique<Tev>(*o.tev, o.name, o.film, o.corner);
    } catch (const std::runtime_error& error) {
        fmt::print(stderr, "--tev: no tev at {}: {}; the picture is made without\n", tev_name_, error.what());
    }
}

void Onlookers::show(const Image& image) {
    if (preview_) preview_->draw(image);
    if (tev_) tev_->show(image);
}

void Onlookers::finish(const Image& image) {
    show(image);
    if (tev_ && !tev_->gone().empty())
        fmt::print(stderr, "--tev: tev at {} has gone: {}; the picture is complete without\n", tev_name_, tev_->gone());
}

}  // namespace rt
