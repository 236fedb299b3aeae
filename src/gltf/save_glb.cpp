#include "flexkey/gltf/save_glb.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <ostream>
#include <streambuf>
#include <string_view>

#include "flexkey/gltf/size_estimate.h"
#include "flexkey/mesh/error.h"
#include "flexkey/mesh/output_file.h"

namespace flexkey {
namespace {

/// Hands what a stream writes straight to the file, so that the GLB is never in memory as a whole.
class FileBuffer : public std::streambuf {
 public:
  explicit FileBuffer(OutputFile& file) : file_(file) {}

 protected:
  std::streamsize xsputn(const char* text, std::streamsize count) override {
    file_.write(std::string_view(text, static_cast<std::size_t>(count)));
    return count;
  }
  int_type overflow(int_type character) override {
    const char byte = traits_type::to_char_type(character);
    xsputn(&byte, 1);
    return character;
  }

 private:
  OutputFile& file_;
};

}  // namespace

std::uintmax_t save_glb(const tinygltf::Model& model, const std::filesystem::path& path) {
  OutputFile file(path);
  FileBuffer buffer(file);
  std::ostream stream(&buffer);
  // tinygltf never looks whether a write went well: the stream throws on what the file threw.
  stream.exceptions(std::ios::badbit | std::ios::failbit);
  tinygltf::TinyGLTF writer;
  const bool written = writer.WriteGltfSceneToStream(&model, stream, false, true);
  if (!written) throw OutputError(fmt::format("cannot write '{}': tinygltf failed", path.string()));
  if (file.bytes_written() > static_cast<std::uintmax_t>(kMostGlbBytes)) {
    throw InputError(fmt::format("'{}' would be larger than 4 GiB, which a GLB cannot be", path.string()));
  }
  file.commit();
  return file.bytes_written();
}

}  // namespace flexkey
