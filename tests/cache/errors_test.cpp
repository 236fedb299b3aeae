// What cannot be written: an error that names the file, and no half file left.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>
#include <limits>
#include <map>
#include <thread>

#include "cache/frames.h"
#include "flexkey/cache/mdd.h"
#include "flexkey/cache/npz_sequence.h"
#include "flexkey/cache/obj_sequence.h"
#include "flexkey/cache/pc2.h"
#include "flexkey/cache/usda.h"
#include "flexkey/mesh/error.h"

namespace flexkey {
namespace {

using test::add_frame;
using test::write_all;
namespace fs = std::filesystem;
using testing::HasSubstr;

using Maker = std::function<FrameSink(const fs::path&, const CacheShape&)>;

const std::map<std::string, Maker> single_files = {{"pc2", pc2_sink}, {"mdd", mdd_sink}, {"usda", usda_sink}};

FramePath always(const fs::path& path) {
  return [path](int) { return path; };
}

std::map<std::string, Maker> all_forms() {
  std::map<std::string, Maker> forms = single_files;
  forms["obj"] = [](const fs::path& path, const CacheShape& shape) {
    return obj_sequence_sink(always(path), shape);
  };
  forms["npz"] = [](const fs::path& path, const CacheShape& shape) {
    return npz_sequence_sink(always(path), shape);
  };
  return forms;
}

/// What is said when frames 0 and 1 are written there.
std::string message_of(const Maker& make, const fs::path& path, const Mesh& mesh = meshes::bar(9, 9, 9)) {
  const CacheShape shape{"shot", mesh, 24, {0, 1}, {"base"}};
  try {
    write_all(make(path, shape), shape);
  } catch (const OutputError& error) {
    return error.what();
  }
  return "no error";
}

class CacheErrors : public test::Folder {};

TEST_F(CacheErrors, AFullDisk) {
  for (const auto& [name, make] : all_forms())
    EXPECT_EQ(message_of(make, "/dev/full"), "cannot write '/dev/full': No space left on device") << name;
}

TEST_F(CacheErrors, AFileInTheFoldersPlace) {
  std::ofstream(*this / "taken") << "text";
  for (const auto& [name, make] : all_forms())
    EXPECT_THAT(message_of(make, *this / "taken/a"), HasSubstr("taken/a': Not a directory")) << name;
}

TEST_F(CacheErrors, AFolderInTheFilesPlace) {
  fs::create_directory(*this / "a");
  for (const auto& [name, make] : all_forms())
    EXPECT_THAT(message_of(make, *this / "a"), HasSubstr("Is a directory")) << name;
}

TEST_F(CacheErrors, AFolderThatMayNotBeWritten) {
  for (const auto& [name, make] : all_forms())
    EXPECT_THAT(message_of(make, "/proc/a"), HasSubstr("cannot write '/proc/a'")) << name;
}

TEST_F(CacheErrors, ACoordinateThatIsNoNumberNamesItsVertex) {
  Mesh mesh = meshes::cube();
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    mesh.positions(5, 1) = value;
    for (const auto& [name, make] : all_forms())
      EXPECT_THAT(message_of(make, *this / "a", mesh), HasSubstr("vertex 5 of frame 0 is at")) << name;
  }
  EXPECT_TRUE(is_empty());
}

TEST_F(CacheErrors, ACoordinateThatNoFloatHolds) {
  Mesh mesh = meshes::cube();
  mesh.positions(5, 1) = 1e39;
  for (const auto& [name, make] : single_files)
    EXPECT_THAT(message_of(make, *this / "a", mesh), HasSubstr("which is not a finite float")) << name;
  EXPECT_TRUE(is_empty());
  for (const char* name : {"obj", "npz"})
    EXPECT_EQ(message_of(all_forms().at(name), *this / name, mesh), "no error");
}

TEST_F(CacheErrors, AFileThatIsNotFinishedLeavesTheOldOne) {
  for (const auto& [name, make] : single_files) {
    const fs::path path = *this / name;
    std::ofstream(path) << "the old one";
    {
      const Mesh mesh = meshes::cube();
      const CacheShape shape{"shot", mesh, 24, {0, 1}, {}};
      const FrameSink sink = make(path, shape);
      add_frame(sink, shape, 0);
      EXPECT_EQ(read_file(path), "the old one") << name;
    }
    EXPECT_EQ(read_file(path), "the old one") << name;
    fs::remove(path);
  }
  EXPECT_TRUE(is_empty());
}

TEST_F(CacheErrors, APipeIsWrittenFromFrontToBack) {
  const Mesh mesh = meshes::cube();
  const CacheShape shape{"shot", mesh, 24, {0, 1}, {"base"}};
  const fs::path pipe = *this / "pipe", file = *this / "file";
  for (const auto& [name, make] : single_files) {
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::string read;
    std::thread reader([&] { read = read_file(pipe); });
    const std::uintmax_t bytes = write_all(make(pipe, shape), shape);
    reader.join();
    write_all(make(file, shape), shape);
    EXPECT_EQ(read, read_file(file)) << name;
    EXPECT_EQ(bytes, read.size()) << name;
    fs::remove(pipe);
  }
}

}  // namespace
}  // namespace flexkey
