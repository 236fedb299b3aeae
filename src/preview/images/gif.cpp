#include "flexkey/preview/images/gif.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/output_file.h"
#include "flexkey/preview/images/gif_frames.h"
#include "flexkey/preview/images/srgb.h"

namespace flexkey {
namespace {

constexpr int shortest_delay = 2;          // centiseconds
constexpr int longest_delay = 65535;       // what the format can hold
constexpr std::size_t most_colours = 255;  // one of 256 says "as before"

}  // namespace

GifWriter::GifWriter(std::filesystem::path path) : path_(std::move(path)) {}

int GifWriter::centiseconds(double time) const {
  return static_cast<int>(std::lround(100 * (time - first_time_)));
}

void GifWriter::add(const Picture& picture, double time) {
  if (!frames_) {
    check_picture_size(picture.width, picture.height);
    width_ = picture.width;
    height_ = picture.height;
    first_time_ = time;
    frames_ = std::make_unique<Spool>(path_, picture.rgb.size());
  } else if (picture.width != width_ || picture.height != height_) {
    throw InputError(fmt::format("'{}': a frame of {} x {} pixels among frames of {} x {}", path_.string(),
                                 picture.width, picture.height, width_, height_));
  }
  const int start = centiseconds(time);
  if (!starts_.empty() && start - starts_.back() < shortest_delay) return;
  const std::vector<std::uint8_t> rgb = srgb_bytes(picture);
  colours_.add(rgb);
  frames_->add(rgb);
  starts_.push_back(start);
}

void GifWriter::finish(double end) {
  if (!frames_) throw OutputError(fmt::format("cannot write '{}': it has no frames", path_.string()));
  std::vector<int> ends(starts_.begin() + 1, starts_.end());
  ends.push_back(std::max(centiseconds(end), starts_.back() + shortest_delay));

  OutputFile file(path_);
  GifFrames frames(width_, height_, make_palette(colours_.samples(), most_colours));
  std::size_t k = 0;
  const auto next = [&](GifFrame& frame) {
    if (k == starts_.size()) return false;
    frame = frames.next(frames_->block(k), std::min(ends[k] - starts_[k], longest_delay));
    ++k;
    return true;
  };
  image_module().write_gif(frames.screen(), next,
                           [&](std::span<const std::byte> bytes) { file.write(bytes); });
  file.commit();
}

}  // namespace flexkey
