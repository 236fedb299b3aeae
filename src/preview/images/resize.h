#pragma once

#include "flexkey/preview/picture.h"

namespace flexkey {

/// The picture at another size, filtered by Lanczos' window of 3 lobes in linear light; not below black.
Picture resized(const Picture& picture, int width, int height);

/// At another width and the same proportions; itself where it has that width.
Picture resized_to_width(const Picture& picture, int width);

}  // namespace flexkey
