#pragma once

#include <string>

#include "flexkey/mesh/types.h"

namespace flexkey::cli {

/// A name or a path as YAML reads it back: as it is where it is a plain word, else in quotes.
std::string quoted(const std::string& text);

/// To whole steps of about a ten-thousandth of `size`, so that a person can read it.
double rounded(double value, double size);
Vec3 rounded(const Vec3& point, double size);

/// "[0.1, 0.25, -3]"
std::string yaml_of(const Vec3& point);

}  // namespace flexkey::cli
