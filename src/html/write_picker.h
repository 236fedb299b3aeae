#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "flexkey/mesh/weld.h"

namespace flexkey {

/// Writes one page on which a click or a brush on the mesh gives a selection for a timeline: it opens from
/// disk and needs no network. name: stands on it. Returns its size in bytes. Throws OutputError.
std::uintmax_t write_picker(const Weld& weld, const std::string& name, const std::filesystem::path& path);

}  // namespace flexkey
