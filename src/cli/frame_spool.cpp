#include "cli/frame_spool.h"

#include <cstring>

namespace flexkey::cli {

FrameSpool::FrameSpool(const std::filesystem::path& beside, int vertex_count)
    : vertex_count_(vertex_count),
      spool_(beside, static_cast<std::size_t>(vertex_count) * 3 * sizeof(double)) {}

void FrameSpool::add(const SolvedFrame& frame) {
  const std::span<const double> numbers(frame.positions.data(),
                                        static_cast<std::size_t>(frame.positions.size()));
  const std::span<const std::byte> bytes = std::as_bytes(numbers);
  std::vector<std::uint8_t> block(bytes.size());
  std::memcpy(block.data(), bytes.data(), bytes.size());
  places_.insert_or_assign(frame.report.frame, Place{spool_.size(), frame.report});
  spool_.add(block);
}

KeptFrame FrameSpool::frame(int number) const {
  const Place& place = places_.at(number);
  KeptFrame frame{place.report, Positions(vertex_count_, 3)};
  const std::vector<std::uint8_t> block = spool_.block(place.block);
  std::memcpy(frame.positions.data(), block.data(), block.size());
  return frame;
}

}  // namespace flexkey::cli
