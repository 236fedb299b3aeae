// Small pictures beside those that were judged good. After a change of the looks that is meant,
// FLEXKEY_WRITE_REFERENCES=1 makes this test write them anew: look at them before they are committed.
#include <gtest/gtest.h>

#include <cstdlib>

#include "flexkey/preview/images/image_file.h"
#include "flexkey/preview/images/srgb.h"
#include "preview/pictures.h"
#include "preview_images/test_folder.h"

namespace flexkey {
namespace {

using References = test::TestFolder;

/// A bar that is twisted and bent a little, so that every light shows.
Sitting bent_bar() {
  Sitting bar = sitting(meshes::bar(3, 3, 12));
  for (auto p : bar.mesh.positions.rowwise()) {
    const Vec3 turned = Eigen::AngleAxisd(0.08 * p.z(), Vec3::UnitZ()) * Vec3(p.transpose());
    p = Vec3(turned + Vec3(0, 0.015 * p.z() * p.z(), 0)).transpose();
  }
  bar.options.width = 160;
  bar.options.height = 90;
  bar.options.samples = 16;
  return bar;
}

/// Expects the picture to be the reference of this name, but for what rounding does to a few pixels.
void expect_like_reference(const Picture& drawn, const std::string& name) {
  const std::filesystem::path path =
      std::filesystem::path(FLEXKEY_SOURCE) / "tests/preview_images/references" / name;
  if (std::getenv("FLEXKEY_WRITE_REFERENCES") != nullptr) write_picture(drawn, path);
  const Picture reference = read_picture(path);
  ASSERT_EQ(reference.width, drawn.width);
  ASSERT_EQ(reference.height, drawn.height);
  const std::vector<std::uint8_t> wanted = srgb_bytes(reference), made = srgb_bytes(drawn);
  int far = 0;
  double sum = 0;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const int off = std::abs(wanted[k] - made[k]);
    sum += off;
    if (off > 8) ++far;
  }
  EXPECT_LT(sum / static_cast<double>(wanted.size()), 0.5) << name;
  EXPECT_LT(far, static_cast<int>(wanted.size()) / 100) << name;
}

TEST_F(References, Clay) {
  expect_like_reference(bent_bar().take(), "clay.png");
}

TEST_F(References, WiresAndMarks) {
  Sitting bar = bent_bar();
  bar.options.style = Style::wire;
  Renderer renderer(bar.mesh, bounds_of(bar.mesh.positions), bar.options);
  const int last = bar.mesh.vertex_count() - 1;  // at the near end
  const Marks marks{{last - 3, last - 2, last - 1, last},
                    {last - 8, last - 9},
                    bar.mesh.positions.bottomRows(4).rowwise() + Eigen::RowVector3d(0, 1, 0)};
  expect_like_reference(renderer.render({bar.mesh.positions, {}, true, marks}, bar.camera()), "wire.png");
}

TEST_F(References, NormalsInADraft) {
  Sitting bar = bent_bar();
  bar.options.style = Style::normals;
  bar.options.quality = Quality::draft;
  expect_like_reference(bar.take(), "normals.png");
}

}  // namespace
}  // namespace flexkey
