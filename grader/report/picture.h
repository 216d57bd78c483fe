#pragma once

#include <string>
#include <vector>

#include "rt/files/image.h"
#include "statistics/tiles.h"

namespace grade {

/// The preview of a picture as the source of an <img>: "data:image/png;base64,...".
std::string data_uri(const rt::Image& image, double exposure);

/// The exposure that shows most of a picture, none of it too dark.
double preview_exposure(const rt::Image& image);

/// The picture times a factor.
rt::Image scaled(const rt::Image& image, double factor);

/// Pictures of one height in a row, with a gap between them.
rt::Image side_by_side(const std::vector<rt::Image>& pictures);

/// Where one picture is brighter (orange) or darker (blue) than another, white where they agree; colours that
/// colour-blind eyes tell apart too.
struct Difference {
    rt::Image image;  // already as the colours are to be seen: exposure 1
    double full;      // luminance difference that has the full colour
};

/// How sure it is that a picture is brighter (orange) or darker (blue), tile by tile, in those colours: full where
/// Welch's t is beyond `full`. As large as the picture.
Difference significance(const Tiles& tiles, int width, int height);

/// Of two pictures of one size.
Difference difference(const rt::Image& picture, const rt::Image& truth);

}  // namespace grade
