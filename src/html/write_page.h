#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "flexkey/animate/clip.h"

namespace flexkey {

/// A handle as the page marks it.
struct PageHandle {
  std::string name;
  bool is_anchor = false;
  std::vector<Positions> points;  // #frames of the clip, each #points x 3; no rows while it does not hold
};

/// A part of the clip that the GLB has as an animation of this name.
struct PageClip {
  std::string name;
  double from = 0;  // seconds after the clip's first frame
};

/// What the page plays beside the clip's own name and bounds.
struct PageContents {
  std::string glb;  // the file's bytes
  std::vector<PageHandle> handles;
  std::vector<PageClip> clips;
};

/// Writes one file of HTML that plays the GLB in a browser, without a network. Returns its bytes.
/// Throws OutputError where the file cannot be written.
std::uintmax_t write_page(const Clip& clip, const PageContents& contents, const std::filesystem::path& path);

}  // namespace flexkey
