#pragma once

#include <Eigen/Core>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/members.h"

namespace flexkey {

/// Bytes that are not what an archive saved.
class ArchiveError : public Error {
 public:
  using Error::Error;
};

using ByteSink = std::function<void(std::span<const std::byte>)>;

template <class Type>
concept Number = std::is_arithmetic_v<Type> || std::is_enum_v<Type>;

template <class Type>
concept Matrix = requires(Type& matrix) {
  matrix.derived();
  matrix.data();
};

/// What lies in memory as one block of known size.
template <class Type>
concept Block = Number<Type> || std::has_unique_object_representations_v<Type> ||
    (Matrix<Type>&& Type::SizeAtCompileTime > 0);

template <class Type>
concept Sequence = requires(Type& values) {
  values.resize(values.size());
  typename Type::value_type;
}
&&!Matrix<Type>;

template <class Type>
concept HasMembers = requires(Type& value) {
  members_of(value);
};

template <class Type>
concept HasOwnMembers = requires(Type& value) {
  Type::members_of(value);
};

/// Hands values to a sink as bytes, in the order of this machine: to save or to hash them. Takes numbers,
/// Eigen matrices, vectors, strings, optionals and what has `members_of`, see members.h.
class Saving {
 public:
  explicit Saving(ByteSink sink) : sink_(std::move(sink)) {}

  template <class... Values>
  void operator()(const Values&... values) {
    (save(values), ...);
  }

 private:
  template <class Value>
  void save(const Value& value) {
    if constexpr (Block<Value>) {
      put(&value, sizeof value);
    } else if constexpr (Matrix<Value>) {
      save(std::int64_t{value.rows()});
      save(std::int64_t{value.cols()});
      put(value.data(), static_cast<std::size_t>(value.size()) * sizeof(typename Value::Scalar));
    } else if constexpr (HasOwnMembers<const Value>) {
      std::apply(*this, Value::members_of(value));
    } else if constexpr (HasMembers<const Value>) {
      std::apply(*this, members_of(value));
    } else {
      save_several(value);
    }
  }
  template <Sequence Values>
  void save_several(const Values& values) {
    save(std::uint64_t{values.size()});
    if constexpr (Block<typename Values::value_type>) {
      put(values.data(), values.size() * sizeof(typename Values::value_type));
    } else {
      for (const auto& value : values) save(value);
    }
  }
  template <class Value>
  void save_several(const std::optional<Value>& value) {
    save(value.has_value());
    if (value) save(*value);
  }
  void put(const void* data, std::size_t size) {
    sink_(std::span(static_cast<const std::byte*>(data), size));
  }

  ByteSink sink_;
};

/// Fills values from what was saved of their like. Throws ArchiveError where bytes are missing; nothing is
/// taken of memory that the bytes do not fill.
class Loading {
 public:
  explicit Loading(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class... Values>
  void operator()(Values&... values) {
    (load(values), ...);
  }
  /// What is still to come.
  std::span<const std::byte> rest() const { return bytes_; }

 private:
  template <class Value>
  void load(Value& value) {
    if constexpr (Block<Value>) {
      get(&value, sizeof value);
    } else if constexpr (Matrix<Value>) {
      load_matrix(value);
    } else if constexpr (HasOwnMembers<Value>) {
      std::apply(*this, Value::members_of(value));
    } else if constexpr (HasMembers<Value>) {
      std::apply(*this, members_of(value));
    } else {
      load_several(value);
    }
  }
  void load(bool& value) {
    unsigned char byte = 0;
    get(&byte, 1);
    value = byte != 0;
  }
  template <Matrix Value>
  void load_matrix(Value& value) {
    const std::uint64_t rows = load_count(0), columns = load_count(0);
    constexpr int fixed = Value::ColsAtCompileTime;
    if (fixed >= 0 && columns != static_cast<std::uint64_t>(fixed)) fail();
    constexpr std::uint64_t most = std::numeric_limits<int>::max();
    const std::uint64_t numbers = bytes_.size() / sizeof(typename Value::Scalar);
    if (rows > most || columns > most || rows * columns > numbers) fail();
    value.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
    get(value.data(), rows * columns * sizeof(typename Value::Scalar));
  }
  template <Sequence Values>
  void load_several(Values& values) {
    using Value = typename Values::value_type;
    if constexpr (Block<Value>) {
      values.resize(load_count(sizeof(Value)));
      get(values.data(), values.size() * sizeof(Value));
    } else {
      values.resize(load_count(1));
      for (Value& value : values) load(value);
    }
  }
  template <class Value>
  void load_several(std::optional<Value>& value) {
    bool is_there = false;
    load(is_there);
    value.reset();
    if (is_there) load(value.emplace());
  }
  /// A count of things of at least so many bytes, all of which are still to come.
  std::uint64_t load_count(std::size_t least) {
    std::uint64_t count = 0;
    get(&count, sizeof count);
    if (least > 0 && count > bytes_.size() / least) fail();
    return count;
  }
  void get(void* data, std::size_t size);
  [[noreturn]] void fail() const;

  std::span<const std::byte> bytes_;
};

}  // namespace flexkey
