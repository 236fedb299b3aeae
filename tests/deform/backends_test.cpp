// The promise of SECURITY.md that CHOLMOD and Eigen give the same answers.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>

#include "flexkey/deform/cholesky.h"
#include "support/meshes.h"

namespace flexkey {
namespace {

/// What a program of backend_scenes.cpp writes.
std::vector<double> coordinates_of(const std::string& program, const std::string& name) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / name;
  EXPECT_EQ(std::system(("'" + program + "' '" + path.string() + "'").c_str()), 0);
  std::vector<double> numbers(std::filesystem::file_size(path) / sizeof(double));
  std::ifstream(path, std::ios::binary)
      .read(reinterpret_cast<char*>(numbers.data()),
            static_cast<std::streamsize>(numbers.size() * sizeof(double)));
  std::filesystem::remove(path);
  return numbers;
}

TEST(Backends, AgreeToABillionthOfTheDiagonal) {
  const std::vector<double> built = coordinates_of(FLEXKEY_BACKEND_BUILT, "flexkey_backend_built");
  const std::vector<double> eigen = coordinates_of(FLEXKEY_BACKEND_EIGEN, "flexkey_backend_eigen");
  ASSERT_EQ(built.size(), eigen.size());
  ASSERT_GT(built.size(), 10000u);
  const double diagonal = bounds_of(meshes::bumpy(meshes::bar(4, 4, 16), 0.1).positions).diagonal();
  double farthest = 0;
  for (std::size_t k = 0; k < built.size(); ++k) farthest = std::max(farthest, std::abs(built[k] - eigen[k]));
  EXPECT_LT(farthest, 1e-9 * diagonal);
  if (factoring_library().starts_with("CHOLMOD")) {
    EXPECT_GT(farthest, 0) << "both were of one backend";
  }
}

}  // namespace
}  // namespace flexkey
