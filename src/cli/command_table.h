#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cli/commands.h"

namespace flexkey::cli {

/// What a shell offers for a value.
enum class Offer { nothing, folder, file, timeline, mesh, words };

/// Where a value goes. Its type says what it is: bool a flag (with a null pointer one that the parser itself
/// answers), int a count from 1 to 1024, a vector an option that may be repeated.
using Target = std::variant<bool*, int*, std::string*, std::filesystem::path*, std::vector<std::string>*>;

/// An option, or an argument that is known by its place.
struct Argument {
  std::vector<std::string_view> names;  // "-d", "--out-dir", or "shot" where it is known by its place
  std::string_view value;               // stands for the value in texts, "DIR"; empty for a flag
  std::string_view help;                // a line without a full stop
  Target target;
  Offer offer = Offer::nothing;
  std::vector<std::string_view> words = {};  // all that the value may be, with Offer::words
  bool is_required = false;

  bool has_place() const { return names.front().front() != '-'; }
  bool is_flag() const { return std::holds_alternative<bool*>(target); }
};

struct Command {
  std::string_view name;
  std::string_view help;     // a line without a full stop
  std::string_view example;  // a command line
  std::vector<Argument> arguments;
  std::function<int()> run;
};

/// What a command line may fill in.
struct Request {
  ShotOptions shot;
  std::string chunk;  // "2/4", of the runs or of the frames; empty: all
  InspectOptions inspect;
  InitOptions init;
  PickOptions pick;
  CompletionOptions completion;
};

/// Every command of the program, the only list of them: the parser, `--help`, the shells' completion and the
/// man page are made from it. The request must outlive it.
std::vector<Command> command_table(Request& request);

/// What may stand in a command's place: the help and the version.
std::vector<Argument> program_options();

/// How the files end that are offered, without the dot: none, or those of timelines or meshes.
std::vector<std::string_view> endings_of(Offer offer);

inline constexpr std::string_view program_summary = "flexkey turns a text timeline into an animated mesh.";

struct ExitCodeText {
  std::string_view code;
  std::string_view meaning;
};

/// The exit codes, for `--help` and the man page.
const std::vector<ExitCodeText>& exit_code_texts();

}  // namespace flexkey::cli
