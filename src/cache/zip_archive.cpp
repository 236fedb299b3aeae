#include "flexkey/cache/zip_archive.h"

#include <fmt/format.h>
#include <zip.h>

#include <array>
#include <memory>
#include <span>

#include "flexkey/mesh/error.h"
#include "flexkey/mesh/output_file.h"

namespace flexkey {
namespace {

constexpr zip_uint16_t first_of_january_1980 = 1 << 5 | 1;  // the first day that a ZIP can tell

struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, FreeSource>;

struct DiscardArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
using Archive = std::unique_ptr<zip_t, DiscardArchive>;

[[noreturn]] void fail(const std::filesystem::path& path, zip_error_t& error) {
  throw OutputError(fmt::format("cannot write '{}': {}", path.string(), zip_error_strerror(&error)));
}

void add(zip_t* archive, const ZipEntry& entry, const std::filesystem::path& path) {
  zip_source_t* source = zip_source_buffer(archive, entry.bytes.data(), entry.bytes.size(), 0);
  const zip_int64_t added = zip_file_add(archive, entry.name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (added < 0) {
    zip_source_free(source);
    fail(path, *zip_get_error(archive));
  }
  const auto index = static_cast<zip_uint64_t>(added);
  if (zip_set_file_compression(archive, index, ZIP_CM_STORE, 0) != 0 ||
      zip_file_set_dostime(archive, index, 0, first_of_january_1980, 0) != 0)
    fail(path, *zip_get_error(archive));
}

/// The archive in memory, since libzip goes back in what it writes.
Source archive_of(const std::vector<ZipEntry>& entries, const std::filesystem::path& path) {
  zip_error_t error;
  zip_error_init(&error);
  Source memory(zip_source_buffer_create(nullptr, 0, 0, &error));
  if (!memory) fail(path, error);
  Archive archive(zip_open_from_source(memory.get(), ZIP_TRUNCATE, &error));
  if (!archive) fail(path, error);
  zip_source_keep(memory.get());  // the archive owns it from now on, and so does this function
  for (const ZipEntry& entry : entries) add(archive.get(), entry, path);
  if (zip_close(archive.get()) != 0) fail(path, *zip_get_error(archive.get()));
  archive.release();
  return memory;
}

}  // namespace

std::uintmax_t write_zip(const std::filesystem::path& path, const std::vector<ZipEntry>& entries) {
  const Source archive = archive_of(entries, path);
  OutputFile file(path);
  if (zip_source_open(archive.get()) != 0) fail(path, *zip_source_error(archive.get()));
  std::array<std::byte, 1 << 16> chunk;
  zip_int64_t read = 0;
  while ((read = zip_source_read(archive.get(), chunk.data(), chunk.size())) > 0)
    file.write(std::span(chunk).first(static_cast<std::size_t>(read)));
  if (read < 0) fail(path, *zip_source_error(archive.get()));
  file.commit();
  return file.bytes_written();
}

}  // namespace flexkey
