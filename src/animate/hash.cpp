#include "flexkey/animate/hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace flexkey {

struct Hash::State {
  XXH3_state_t state;
};

Hash::Hash() : state_(std::make_unique<State>()) {
  XXH3_128bits_reset(&state_->state);
}

Hash::~Hash() = default;

void Hash::add(std::span<const std::byte> bytes) {
  XXH3_128bits_update(&state_->state, bytes.data(), bytes.size());
}

Digest Hash::digest() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(&state_->state);
  return {hash.high64, hash.low64};
}

Digest digest_of_bytes(std::span<const std::byte> bytes) {
  Hash hash;
  hash.add(bytes);
  return hash.digest();
}

}  // namespace flexkey
