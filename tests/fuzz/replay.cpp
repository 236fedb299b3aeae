// Plays inputs to a target without a fuzzer, for any compiler:
//   fuzz_replay --list                  the targets' names
//   fuzz_replay --seeds NAME FOLDER     writes the target's binary seeds into a folder
//   fuzz_replay NAME [FILES, FOLDERS]   its binary seeds and these files, each whole, cut short and with
//   bytes changed
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "fuzz/targets.h"

namespace flexkey::fuzz {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> inputs_of(const Target& target, const std::vector<std::string>& arguments) {
  std::vector<fs::path> files;
  for (const std::string& argument : arguments) {
    if (fs::is_regular_file(argument)) files.emplace_back(argument);
    if (!fs::is_directory(argument)) continue;
    for (const auto& entry : fs::directory_iterator(argument))
      if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> inputs = target.seeds();
  for (const fs::path& file : files) inputs.push_back(read(file));
  return inputs;
}

/// The same for every run: a sequence of its own, since the standard's distributions differ by library.
std::size_t below(std::size_t bound, std::mt19937& random) {
  return random() % bound;
}

std::string changed(std::string input, std::mt19937& random) {
  constexpr std::string_view telling("0123456789-.eE/{}[]:,\n \"&*\0\xFF\x7F\x80", 29);
  for (std::size_t count = 1 + below(4, random); count > 0 && !input.empty(); --count) {
    const std::size_t place = below(input.size(), random);
    switch (below(4, random)) {
      case 0:
        input.erase(place, 1 + below(8, random));
        break;
      case 1:
        input.insert(place, 1, telling[below(telling.size(), random)]);
        break;
      case 2:
        input[place] = static_cast<char>(input[place] ^ (1 << below(8, random)));
        break;
      default:
        input[place] = telling[below(telling.size(), random)];
    }
  }
  return input;
}

int play(const Target& target, const std::vector<std::string>& inputs) {
  constexpr std::size_t most_bytes = 32768;  // of what is changed; larger ones are played once
  constexpr int changes = 60, cuts = 20;
  std::mt19937 random(1);
  int played = 0;
  for (const std::string& input : inputs) {
    target.run(input);
    ++played;
    if (input.size() > most_bytes) continue;
    for (int k = 0; k < changes; ++k) target.run(changed(input, random));
    for (int k = 0; k < cuts; ++k)
      target.run(std::string_view(input).substr(0, input.size() * static_cast<std::size_t>(k) / cuts));
    played += changes + cuts;
  }
  std::printf("%.*s: %d inputs\n", static_cast<int>(target.name.size()), target.name.data(), played);
  return inputs.empty() ? 1 : 0;
}

int write_seeds(const Target& target, const fs::path& folder) {
  fs::create_directories(folder);
  int number = 0;
  for (const std::string& seed : target.seeds())
    std::ofstream(folder / ("made-" + std::to_string(number++)), std::ios::binary) << seed;
  return 0;
}

int list() {
  for (const Target& target : targets())
    std::printf("%.*s\n", static_cast<int>(target.name.size()), target.name.data());
  return 0;
}

int run(const std::vector<std::string>& arguments) {
  if (arguments.size() == 1 && arguments[0] == "--list") return list();
  const bool makes_seeds = arguments.size() == 3 && arguments[0] == "--seeds";
  const Target* target = arguments.empty() ? nullptr : find_target(arguments[makes_seeds ? 1 : 0]);
  if (target == nullptr) {
    std::fputs("usage: fuzz_replay --list | --seeds NAME FOLDER | NAME [FILES, FOLDERS]\n", stderr);
    return 2;
  }
  if (makes_seeds) return write_seeds(*target, arguments[2]);
  return play(*target, inputs_of(*target, {arguments.begin() + 1, arguments.end()}));
}

}  // namespace
}  // namespace flexkey::fuzz

int main(int count, char** arguments) {
  return flexkey::fuzz::run({arguments + 1, arguments + count});
}
