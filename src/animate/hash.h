#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "flexkey/animate/archive.h"

namespace flexkey {

/// Tells whether values are the same; no guard against forgery.
struct Digest {
  std::uint64_t high = 0, low = 0;
  friend bool operator==(const Digest&, const Digest&) = default;
};

template <MaybeConst<Digest> Self>
auto members_of(Self& digest) {
  auto& [high, low] = digest;
  return std::tie(high, low);
}

/// XXH3, 128 bits, of bytes as they come.
class Hash {
 public:
  Hash();
  ~Hash();
  Hash(const Hash&) = delete;
  Hash& operator=(const Hash&) = delete;

  void add(std::span<const std::byte> bytes);
  Digest digest() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

Digest digest_of_bytes(std::span<const std::byte> bytes);

/// Of values that an archive takes.
template <class... Values>
Digest digest_of(const Values&... values) {
  Hash hash;
  Saving saving([&](std::span<const std::byte> bytes) { hash.add(bytes); });
  saving(values...);
  return hash.digest();
}

}  // namespace flexkey
