#pragma once

#include <optional>
#include <span>
#include <string>

#include "flexkey/animate/hash.h"

namespace flexkey {

/// The values' bytes and, behind them, their digest, by which `unseal` knows that they are whole.
template <class... Values>
std::string sealed(const Values&... values) {
  std::string bytes;
  Saving saving([&](std::span<const std::byte> more) {
    bytes.append(reinterpret_cast<const char*>(more.data()), more.size());
  });
  saving(values...);
  saving(digest_of_bytes(std::as_bytes(std::span(bytes))));
  return bytes;
}

/// Sealed bytes without the digest; nothing where it is not theirs.
std::optional<std::span<const std::byte>> unseal(std::span<const std::byte> bytes);

}  // namespace flexkey
