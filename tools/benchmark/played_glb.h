#pragma once

#include <filesystem>

#include "flexkey/animate/clip.h"

namespace flexkey::bench {

/// The largest distance at any frame between the clip's vertices and those of a GLB of it that another writer
/// made, as a share of the rest diagonal. The file may have its vertices in any order: each is compared with
/// the clip's vertex that is nearest at rest. Throws Error where its first animation plays no weights.
double error_of(const std::filesystem::path& glb, const Clip& clip);

}  // namespace flexkey::bench
