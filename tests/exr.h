#pragma once

#include "rt/files/image.h"

/// Pictures that were written, read again. What is none throws.
namespace rt {

/// Channels R, G, B of the data window.
Image read_exr(const std::string& path);

/// The attributes that a label can hold, in the order of their names.
Label read_label(const std::string& path);

}  // namespace rt
