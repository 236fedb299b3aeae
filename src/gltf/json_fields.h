#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace flexkey {

// Members of a glTF file's JSON objects, checked as they are read: each function throws InputError for a
// value of another type, naming `what`, such as "accessor 3". Templates over the JSON library's value, which
// no header names.

/// Throws InputError: "'count' of accessor 3 is not a list".
[[noreturn]] void refuse_member(const char* key, const std::string& what, const std::string& problem);

/// Throws InputError: "accessor 3 has no 'count'".
[[noreturn]] void refuse_absence(const char* key, const std::string& what);

/// The member `key` of an object, or null.
template <class Json>
const Json* find_member(const Json& object, const char* key, const std::string& what) {
  if (!object.is_object()) refuse_member(key, what, "is read of what is no JSON object");
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

/// The items of an array; none where the member is absent.
template <class Json>
const typename Json::array_t& list_at(const Json& object, const char* key, const std::string& what) {
  static const typename Json::array_t none;
  const Json* member = find_member(object, key, what);
  if (member == nullptr) return none;
  if (!member->is_array()) refuse_member(key, what, "is not a list");
  return member->template get_ref<const typename Json::array_t&>();
}

/// A value that is a whole number from 0 to 2^53; 24.0 is one too, as JSON has it.
template <class Json>
std::size_t count_of(const Json& value, const char* key, const std::string& what) {
  constexpr double most = 9007199254740992.0;
  const double number = value.is_number() ? value.template get<double>() : -1;
  if (!(number >= 0 && number <= most && number == std::floor(number)))
    refuse_member(key, what, "is not a whole number from 0");
  return static_cast<std::size_t>(number);
}

/// A value that is an index into a list of `size` things.
template <class Json>
int index_of(const Json& value, const char* key, std::size_t size, const std::string& what) {
  const std::size_t index = count_of(value, key, what);
  if (index >= size)
    refuse_member(key, what, "is " + std::to_string(index) + ", and the file has " + std::to_string(size));
  return static_cast<int>(index);
}

template <class Json>
std::optional<std::size_t> find_count(const Json& object, const char* key, const std::string& what) {
  const Json* member = find_member(object, key, what);
  return member == nullptr ? std::nullopt : std::optional(count_of(*member, key, what));
}

template <class Json>
std::size_t require_count(const Json& object, const char* key, const std::string& what) {
  const std::optional<std::size_t> count = find_count(object, key, what);
  if (!count) refuse_absence(key, what);
  return *count;
}

/// -1 where the member is absent.
template <class Json>
int find_index(const Json& object, const char* key, std::size_t size, const std::string& what) {
  const Json* member = find_member(object, key, what);
  return member == nullptr ? -1 : index_of(*member, key, size, what);
}

template <class Json>
int require_index(const Json& object, const char* key, std::size_t size, const std::string& what) {
  const int index = find_index(object, key, size, what);
  if (index < 0) refuse_absence(key, what);
  return index;
}

/// A text; empty where the member is absent.
template <class Json>
std::string text_at(const Json& object, const char* key, const std::string& what) {
  const Json* member = find_member(object, key, what);
  if (member == nullptr) return {};
  if (!member->is_string()) refuse_member(key, what, "is not a text");
  return member->template get<std::string>();
}

/// A list of numbers; empty where the member is absent.
template <class Json>
std::vector<double> numbers_at(const Json& object, const char* key, const std::string& what) {
  std::vector<double> numbers;
  for (const Json& item : list_at(object, key, what)) {
    if (!item.is_number()) refuse_member(key, what, "has an item that is no number");
    numbers.push_back(item.template get<double>());
  }
  return numbers;
}

/// The extension of that name of an object, or null.
template <class Json>
const Json* find_extension(const Json& object, const char* name, const std::string& what) {
  const Json* extensions = find_member(object, "extensions", what);
  return extensions == nullptr ? nullptr : find_member(*extensions, name, "the extensions of " + what);
}

}  // namespace flexkey
