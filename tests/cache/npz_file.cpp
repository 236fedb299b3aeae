#include "cache/npz_file.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "cache/binary.h"

namespace flexkey::test {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(what);
}

/// The checksum of ZIP: the reflected polynomial 0xEDB88320.
std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = ~0U;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1U ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

template <class Value>
std::vector<Value> values_of(const NpyFile& file, const std::string& type) {
  const char* order = std::endian::native == std::endian::little ? "<" : ">";
  require(file.type == order + type, "another type");
  std::vector<Value> values(file.values.size() / sizeof(Value));
  std::memcpy(values.data(), file.values.data(), file.values.size());
  return values;
}

/// Takes what stands in the text up to `end`, and `end`.
std::string take_until(std::string& text, const std::string& end) {
  const std::size_t at = text.find(end);
  require(at != std::string::npos, "another header");
  const std::string taken = text.substr(0, at);
  text.erase(0, at + end.size());
  return taken;
}

/// The lengths in a Python tuple of numbers, without its brackets.
std::vector<int> lengths_in(const std::string& tuple) {
  std::vector<int> lengths;
  std::istringstream words(tuple);
  for (std::string word; words >> word;) lengths.push_back(std::stoi(word));
  const std::ptrdiff_t commas = std::count(tuple.begin(), tuple.end(), ',');
  const auto count = static_cast<std::ptrdiff_t>(lengths.size());
  require(commas == (count == 1 ? 1 : std::max<std::ptrdiff_t>(0, count - 1)), "no tuple");
  return lengths;
}

NpyFile read_npy(const std::string& bytes) {
  BinaryReader reader(bytes, Order::little);
  require(reader.text(6) == "\x93NUMPY", "no NumPy file");
  require(reader.number(2) == 1, "not version 1.0");
  const std::uint32_t length = reader.number(2);
  require((10 + length) % 64 == 0, "the values do not lie at a multiple of 64");
  std::string header = reader.text(length);
  require(take_until(header, "{'descr': '").empty(), "another header");
  NpyFile file;
  file.type = take_until(header, "', 'fortran_order': False, 'shape': (");
  file.shape = lengths_in(take_until(header, "), }"));
  require(header.find_first_not_of(' ') == header.size() - 1 && header.back() == '\n',
          "no end of the header");
  file.values = bytes.substr(10 + length);

  auto size = static_cast<std::size_t>(std::stoi(file.type.substr(2))) * (file.type[1] == 'U' ? 4 : 1);
  for (const int axis : file.shape) size *= static_cast<std::size_t>(axis);
  require(file.values.size() == size, "not as many values as the shape says");
  return file;
}

/// One file of the archive; the reader stands at its entry in the central directory and goes behind it.
std::pair<std::string, std::string> read_entry(BinaryReader& directory, const std::string& archive) {
  require(directory.number(4) == 0x02014b50, "no entry in the directory");
  directory.text(6);
  require(directory.number(2) == 0, "compressed");
  require(directory.number(2) == 0 && directory.number(2) == 0x21, "not of 1980-01-01");
  const std::uint32_t crc = directory.number(4), size = directory.number(4);
  require(directory.number(4) == size, "two sizes");
  const std::uint32_t name_length = directory.number(2);
  const std::uint32_t behind = directory.number(2) + directory.number(2);
  directory.text(8);
  const std::uint32_t place = directory.number(4);
  const std::string name = directory.text(name_length);
  directory.text(behind);

  BinaryReader local(archive, Order::little);
  local.go_to(place);
  require(local.number(4) == 0x04034b50, "no file where the directory says");
  local.text(22);
  const std::uint32_t own_name_length = local.number(2), extra = local.number(2);
  require(local.text(own_name_length) == name, "two names");
  local.text(extra);
  std::string bytes = local.text(size);
  require(crc32(bytes) == crc, "a wrong checksum");
  return {name, std::move(bytes)};
}

}  // namespace

std::vector<double> NpyFile::doubles() const {
  return values_of<double>(*this, "f8");
}

std::vector<int> NpyFile::ints() const {
  return values_of<int>(*this, "i4");
}

std::vector<std::u32string> NpyFile::texts() const {
  const auto characters = values_of<char32_t>(*this, type.substr(1));
  const auto length = static_cast<std::size_t>(std::stoi(type.substr(2)));
  std::vector<std::u32string> texts;
  for (std::size_t at = 0; at < characters.size(); at += length) {
    texts.emplace_back(characters.data() + at, length);
    texts.back().erase(texts.back().find_last_not_of(U'\0') + 1);
  }
  return texts;
}

std::map<std::string, NpyFile> read_npz(const std::string& archive) {
  constexpr std::size_t end_length = 22;
  require(archive.size() >= end_length, "too short");
  BinaryReader end(archive, Order::little);
  end.go_to(archive.size() - end_length);
  require(end.number(4) == 0x06054b50, "no end of the directory");
  end.text(6);
  const std::uint32_t entries = end.number(2);
  end.text(4);
  BinaryReader directory(archive, Order::little);
  directory.go_to(end.number(4));
  std::map<std::string, NpyFile> files;
  for (std::uint32_t k = 0; k < entries; ++k) {
    const auto [name, bytes] = read_entry(directory, archive);
    files.emplace(name, read_npy(bytes));
  }
  return files;
}

}  // namespace flexkey::test
