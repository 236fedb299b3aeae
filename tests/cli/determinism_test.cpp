// The promise of SECURITY.md that the number of threads changes no byte.
#include <gtest/gtest.h>

#include <map>

#include "cli/work_folder.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey::test {
namespace {

class Determinism : public WorkFolder {
 protected:
  /// All files that the shot gives with so many threads, by name.
  std::map<std::string, std::string> outputs_with(const std::string& threads) const {
    const ProgramResult result = run({"animate", "shot.yaml", "-d", threads, "--threads", threads});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    std::map<std::string, std::string> outputs;
    for (const std::string& name : names_in(threads))
      if (name != ".flexkey") outputs[name] = read_file(folder() / threads / name);
    return outputs;
  }
};

TEST_F(Determinism, OneTwoAndFiveThreadsGiveTheSameBytes) {
  write("large.obj", obj_text(meshes::bumpy(meshes::bar(10, 10, 60), 0.1)));
  write("shot.yaml",
        "mesh: large.obj\nfps: 8\nlambda: {0s: 0.2, 1s: 0.9}\nhandles:\n"
        "  base: {select: {axis: z, below: 3%}}\n"
        "  tip:\n    select: {axis: z, above: 97%}\n    rotate: {axis: [1, 0, 1], keys: {0s: 0deg, 1s: "
        "60deg}}\n"
        "output: {gltf: {path: shot.glb, profile: web}, cache: shot.pc2}\n");
  const auto one = outputs_with("1");
  EXPECT_EQ(one.size(), 2u);
  EXPECT_EQ(outputs_with("2"), one);
  EXPECT_EQ(outputs_with("5"), one);
}

}  // namespace
}  // namespace flexkey::test
