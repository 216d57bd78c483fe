#pragma once

#include <memory>
#include <string>

#include "rt/show/preview.h"
#include "rt/show/tev.h"

/// Pictures on a screen, and what is said of them. Nobody needs this folder for the assignment.
namespace rt {

/// Who looks on while a picture is made.
struct ShowOptions {
    std::string preview;  // "auto", "blocks", "kitty" or "sixel"; empty: none
    Real exposure = 1;    // of the preview
    std::optional<TevAddress> tev;
    std::string name;          // of the picture, in tev
    ivec2 film{0}, corner{0};  // size of the film, and where in it the picture begins
};

class Onlookers {
public:
    /// Those who cannot look on are told of on the standard error; the picture is made all the same.
    explicit Onlookers(const ShowOptions& options);

    bool any() const { return preview_ || tev_; }
    void show(const Image& image);

    /// The last look, at the picture as it is.
    void finish(const Image& image);

private:
    std::unique_ptr<Preview> preview_;
    std::unique_ptr<Tev> tev_;
    std::string tev_name_;
};

}  // namespace rt
