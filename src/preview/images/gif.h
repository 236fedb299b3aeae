#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "flexkey/preview/images/palette.h"
#include "flexkey/preview/images/spool.h"
#include "flexkey/preview/picture.h"

namespace flexkey {

/// An animated GIF that repeats for ever. One palette serves the whole clip, so the frames wait on disk,
/// beside the file, until all are known; memory does not grow with their number.
class GifWriter {
 public:
  explicit GifWriter(std::filesystem::path path);

  /// A frame that is shown from `time` (seconds, increasing) until the next. All have the first one's size.
  /// Viewers slow delays below 2 centiseconds down to 10: a frame so soon after another is left out.
  void add(const Picture& picture, double time);

  /// Writes the file; the last frame is shown until `end`. The delays are whole centiseconds and add up to
  /// the clip's duration. Throws OutputError if the file cannot be written or has no frame.
  void finish(double end);

 private:
  int centiseconds(double time) const;

  std::filesystem::path path_;
  int width_ = 0, height_ = 0;
  double first_time_ = 0;
  std::vector<int> starts_;  // of the frames kept, centiseconds from the first
  std::unique_ptr<Spool> frames_;
  ColourCount colours_;
};

}  // namespace flexkey
