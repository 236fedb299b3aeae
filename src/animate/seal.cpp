#include "flexkey/animate/seal.h"

namespace flexkey {

std::optional<std::span<const std::byte>> unseal(std::span<const std::byte> bytes) {
  if (bytes.size() < sizeof(Digest)) return std::nullopt;
  const auto contents = bytes.first(bytes.size() - sizeof(Digest));
  Digest digest;
  Loading{bytes.last(sizeof(Digest))}(digest);
  if (digest_of_bytes(contents) != digest) return std::nullopt;
  return contents;
}

}  // namespace flexkey
