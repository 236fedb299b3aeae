#include "flexkey/cache/npz_sequence.h"

#include <gmock/gmock.h>

#include "cache/frames.h"
#include "cache/npz_file.h"

namespace flexkey {
namespace {

using test::NpyFile;
using test::read_npz;
using test::write_all;
using testing::ElementsAre;
using testing::ElementsAreArray;

class NpzSequence : public test::Folder {
 protected:
  std::map<std::string, NpyFile> written(const CacheShape& shape, int frame) const {
    const FramePath path_of = [this](int k) { return *this / (std::to_string(k) + ".npz"); };
    std::uintmax_t bytes = write_all(npz_sequence_sink(path_of, shape), shape);
    for (const int k : shape.frames) bytes -= std::filesystem::file_size(path_of(k));
    EXPECT_EQ(bytes, 0u);
    return read_npz(read_file(path_of(frame)));
  }
};

TEST_F(NpzSequence, HoldsTheFrameAndItsHandles) {
  const Mesh mesh = meshes::bumpy(meshes::cube(), 0.1);
  const CacheShape shape{"shot", mesh, 25, {0, 7}, {"base", "tip", "Öse"}};
  const auto arrays = written(shape, 7);

  const NpyFile& positions = arrays.at("positions.npy");
  EXPECT_THAT(positions.shape, ElementsAre(8, 3));
  const Positions expected = test::posed(mesh, 7);
  EXPECT_THAT(positions.doubles(), ElementsAreArray(expected.data(), 24));
  EXPECT_THAT(arrays.at("faces.npy").shape, ElementsAre(6, 4));
  EXPECT_EQ(arrays.at("faces.npy").ints(), mesh.corners);
  EXPECT_THAT(arrays.at("frame.npy").shape, ElementsAre()) << "a single value";
  EXPECT_THAT(arrays.at("frame.npy").ints(), ElementsAre(7));
  EXPECT_THAT(arrays.at("time.npy").doubles(), ElementsAre(7 / 25.0));
  EXPECT_THAT(arrays.at("lambda.npy").doubles(), ElementsAre(test::lambda_of(7)));
  EXPECT_EQ(arrays.size(), 7u);
}

TEST_F(NpzSequence, MatricesAreRowMajorOnePerHandle) {
  const Mesh mesh = meshes::cube();
  const CacheShape shape{"shot", mesh, 25, {3}, {"base", "tip"}};
  const NpyFile matrices = written(shape, 3).at("handle_matrices.npy");
  EXPECT_THAT(matrices.shape, ElementsAre(2, 4, 4));
  const std::vector<double> values = matrices.doubles();
  for (int h = 0; h < 2; ++h)
    for (int n = 0; n < 16; ++n)
      EXPECT_EQ(values.at(static_cast<std::size_t>(16 * h + n)), test::matrix_of(h, 3)(n / 4, n % 4));
}

TEST_F(NpzSequence, NamesAreTextsOfOneLength) {
  const Mesh mesh = meshes::cube();
  const NpyFile names =
      written({"shot", mesh, 25, {0}, {"a", "Öse €", "\xF0\x9F\xA6\x8A"}}, 0).at("handle_names.npy");
  EXPECT_THAT(names.shape, ElementsAre(3));
  EXPECT_EQ(names.type.substr(1), "U5");
  EXPECT_THAT(names.texts(), ElementsAre(U"a", U"Öse €", U"\U0001F98A"));
}

TEST_F(NpzSequence, PolygonsOfSeveralSizesAreOffsetsAndCorners) {
  const Mesh mesh = test::mixed_mesh();
  const auto arrays = written({"shot", mesh, 24, {0}, {"base"}}, 0);
  EXPECT_FALSE(arrays.contains("faces.npy"));
  EXPECT_EQ(arrays.at("face_offsets.npy").ints(), mesh.face_offsets);
  EXPECT_EQ(arrays.at("corners.npy").ints(), mesh.corners);
}

TEST_F(NpzSequence, TheSameFrameGivesTheSameBytes) {
  const Mesh mesh = meshes::cube();
  const CacheShape shape{"shot", mesh, 24, {0}, {"base"}};
  for (const char* name : {"a.npz", "b.npz"})
    write_all(npz_sequence_sink([&](int) { return *this / name; }, shape), shape);
  EXPECT_EQ(read_file(*this / "a.npz"), read_file(*this / "b.npz"));
}

}  // namespace
}  // namespace flexkey
