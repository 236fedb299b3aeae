#include "flexkey/animate/checkpoint.h"

#include <utility>

#include "flexkey/animate/seal.h"
#include "flexkey/animate/state_format.h"
#include "flexkey/mesh/output_file.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey {
namespace {

constexpr StateMark checkpoint_mark{{"flexkey point"}};

}  // namespace

template <MaybeConst<CheckpointHead> Self>
auto members_of(Self& head) {
  auto& [inputs, motion, next] = head;
  return std::tie(inputs, motion, next);
}

std::unique_ptr<const Checkpoint> read_checkpoint(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return nullptr;
  auto checkpoint = std::make_unique<Checkpoint>();
  checkpoint->file = read_file(path, limits::checkpoint_bytes);
  const auto contents = unseal(std::as_bytes(std::span(checkpoint->file)));
  if (!contents) return nullptr;
  Loading loading(*contents);
  StateMark mark;
  try {
    loading(mark, checkpoint->head);
  } catch (const ArchiveError&) {
    return nullptr;
  }
  if (mark != checkpoint_mark) return nullptr;
  checkpoint->waypoint = loading.rest();
  return checkpoint;
}

void write_checkpoint(const std::filesystem::path& path, const CheckpointHead& head,
                      const Waypoint& waypoint) {
  OutputFile file(path);
  Hash hash;
  Saving saving([&](std::span<const std::byte> bytes) {
    hash.add(bytes);
    file.write(bytes);
  });
  saving(checkpoint_mark, head);
  save(waypoint, saving);
  saving(hash.digest());
  file.commit();
}

}  // namespace flexkey
