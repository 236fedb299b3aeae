// The page on which selections are picked, opened from its file in Chromium.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "browser/browser_test.h"
#include "flexkey/animate/scene.h"
#include "flexkey/html/write_picker.h"
#include "flexkey/timeline/parse.h"
#include "support/meshes.h"

namespace flexkey::testing {
namespace {

using nlohmann::json;

class Pick : public BrowserTest {
 protected:
  /// Writes the page of a mesh, and what a picker's hand gets on it.
  json offers_of(const Mesh& mesh) {
    const std::filesystem::path page = folder_ / "pick.html";
    write_picker(weld(mesh), "</script>mesh.obj", page);
    const Outcome outcome = run_script("proof/pick.mjs", {page.string()});
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    return json::parse(outcome.output, nullptr, false);
  }

  /// The surface vertices that a selection takes in a timeline.
  static std::vector<int> taken(const Mesh& mesh, const std::string& select) {
    const Shot shot =
        parse_shot(fmt::format("mesh: mesh.obj\nhandles:\n  it: {{select: {}}}\n", select), "shot.yaml").shot;
    return bind_shot(shot, mesh).handles.at(0).vertices;
  }

  /// Picks on the mesh, and compares with what a timeline takes.
  void expect_that_offers_hold(const Mesh& mesh) {
    const json offers = offers_of(mesh);
    ASSERT_EQ(offers.size(), 5u) << offers;
    const Weld surface = weld(mesh);
    for (const json& offer : offers) {
      const std::string yaml = offer["yaml"].get<std::string>();
      const bool is_point = offer["tool"] == "point";
      const std::vector<int> vertices = taken(mesh, is_point ? fmt::format("{{nearest: {}}}", yaml) : yaml);
      EXPECT_EQ(vertices, taken(mesh, offer["list"].get<std::string>())) << yaml;
      const auto count = std::count_if(surface.to_surface.begin(), surface.to_surface.end(),
                                       [&](int v) { return std::ranges::binary_search(vertices, v); });
      EXPECT_EQ(count, offer["count"].get<long>()) << yaml;
      EXPECT_GT(count, is_point ? 0 : 5) << yaml;
    }
  }
};

TEST_F(Pick, OffersWhatATimelineTakes) {
  const Mesh mesh = meshes::bumpy(meshes::bar(8, 10, 12), 0.7);
  expect_that_offers_hold(mesh);
}

TEST_F(Pick, CountsTheFilesOwnVerticesOfATriangleMeshWithSeams) {
  Mesh mesh = meshes::sphere(4);
  Mesh split;  // every face has vertices of its own
  split.positions.resize(3 * mesh.face_count(), 3);
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int k = 0; k < 3; ++k)
      split.positions.row(3 * f + k) = mesh.positions.row(mesh.face(f)[static_cast<std::size_t>(k)]);
    split.add_face(std::array<int, 3>{3 * f, 3 * f + 1, 3 * f + 2});
  }
  expect_that_offers_hold(split);
}

}  // namespace
}  // namespace flexkey::testing
