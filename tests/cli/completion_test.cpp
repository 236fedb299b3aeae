// What the shells and man are told of the commands, by the shells and man themselves where they are
// installed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "cli/command_table.h"
#include "cli/work_folder.h"
#include "flexkey/mesh/read_file.h"

namespace flexkey::test {
namespace {

using cli::Argument;
using cli::Command;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

bool is_installed(const std::string& program) {
  return std::system(fmt::format("command -v {} >/dev/null", program).c_str()) == 0;
}

class Completion : public WorkFolder {
 protected:
  void SetUp() override {
    WorkFolder::SetUp();
    write("shot.yaml", "");
    write("my other shot.yml", "");
    write("notes.txt", "");
    std::filesystem::create_directories(folder() / "out");
    for (const std::string shell : {"bash", "zsh", "fish"})
      write(shell + "_script", run({"completion", shell}).output);
  }

  /// What a command of a shell prints in the folder, on both streams.
  std::string printed(const std::string& command) const {
    const int status = std::system(
        fmt::format("cd '{}' && {{ {}; }} >printed 2>&1 </dev/null", folder().string(), command).c_str());
    return status == 0 ? read_file(folder() / "printed")
                       : fmt::format("failed: {}", read_file(folder() / "printed"));
  }

  /// What bash offers for the last of these words.
  std::vector<std::string> offered(const std::vector<std::string>& words) const {
    std::string quoted;
    for (const std::string& word : words) quoted += fmt::format(" '{}'", word);
    write("ask", fmt::format("source ./bash_script\n"
                             "COMP_WORDS=({}) COMP_CWORD={}\n"
                             "_flexkey\n"
                             "printf '%s\\n' \"${{COMPREPLY[@]}}\"\n",
                             quoted, words.size() - 1));
    std::vector<std::string> lines;
    std::istringstream text(printed("bash ask"));
    for (std::string line; std::getline(text, line);)
      if (!line.empty()) lines.push_back(line);
    return lines;
  }
};

TEST_F(Completion, BashOffersWhatFits) {
  EXPECT_THAT(offered({"flexkey", "ani"}), ElementsAre("animate"));
  EXPECT_THAT(offered({"flexkey", "--v"}), ElementsAre("--version"));
  EXPECT_THAT(offered({"flexkey", "animate", "--st"}), ElementsAre("--strict"));
  EXPECT_THAT(offered({"flexkey", "check", "--frames"}), IsEmpty());
  EXPECT_THAT(offered({"flexkey", "animate", ""}),
              UnorderedElementsAre("out", "shot.yaml", "my other shot.yml"));
  EXPECT_THAT(offered({"flexkey", "inspect", ""}), UnorderedElementsAre("out", "bar.obj"));
  EXPECT_THAT(offered({"flexkey", "animate", "shot.yaml", "-d", ""}), ElementsAre("out"));
  EXPECT_THAT(offered({"flexkey", "animate", "shot.yaml", "--out-dir", "=", "o"}), ElementsAre("out"));
  EXPECT_THAT(offered({"flexkey", "animate", "shot.yaml", "--set", ""}), IsEmpty());
  EXPECT_THAT(offered({"flexkey", "check", "shot.yaml", "--picture", "n"}), ElementsAre("notes.txt"));
  EXPECT_THAT(offered({"flexkey", "completion", ""}), ElementsAre("bash", "zsh", "fish"));
  EXPECT_THAT(offered({"flexkey", "anmate", ""}), IsEmpty());
}

TEST_F(Completion, ShellsReadTheirScripts) {
  EXPECT_EQ(printed("bash -n bash_script"), "");
  if (is_installed("zsh")) {
    EXPECT_EQ(printed("zsh -n zsh_script"), "");
    EXPECT_EQ(
        printed(
            "zsh -fc 'autoload -U compinit; compinit -D -u; source ./zsh_script; print $_comps[flexkey]'"),
        "_flexkey\n");
  }
  if (is_installed("fish")) {
    EXPECT_EQ(printed("fish --no-execute fish_script"), "");
    const auto asked = [&](const std::string& line) {
      return printed(fmt::format("HOME=. fish -c 'source fish_script; complete -C \"{}\"'", line));
    };
    EXPECT_THAT(asked("flexkey ani"), HasSubstr("animate\tSolve a shot"));
    EXPECT_THAT(asked("flexkey check --pic"), HasSubstr("--picture\tDraw the mesh"));
    EXPECT_THAT(asked("flexkey animate sh"), HasSubstr("shot.yaml"));
    EXPECT_THAT(asked("flexkey pick ba"), HasSubstr("bar.obj"));
    EXPECT_THAT(asked("flexkey solve shot.yaml -d ou"), HasSubstr("out/"));
  }
}

TEST_F(Completion, AnUnknownShellIsRefused) {
  EXPECT_EQ(run({"completion", "csh"}).exit_code, 2);
  EXPECT_EQ(run({"completion"}).exit_code, 2);
}

class ManPage : public Completion {};

TEST_F(ManPage, IsSetWithoutAWarning) {
  write("flexkey.1", run({"man"}).output);
  if (!is_installed("groff")) GTEST_SKIP() << "no groff";
  EXPECT_EQ(printed("groff -man -Tutf8 -ww -rCHECKSTYLE=10 flexkey.1 >text"), "");
  const std::string text = read_file(folder() / "text");
  EXPECT_THAT(text, AllOf(HasSubstr("did not converge"), HasSubstr("SLURM_CPUS_PER_TASK")));
  if (is_installed("man")) {
    EXPECT_EQ(printed("LC_ALL=C.UTF-8 man --warnings -l -Tutf8 ./flexkey.1 >text"), "");
  }
}

/// A name as roff has it.
std::string in_roff(std::string_view name) {
  std::string result;
  for (const char c : name) result += c == '-' ? std::string("\\-") : std::string(1, c);
  return result;
}

TEST_F(ManPage, EveryCommandAndOptionIsInTheHelpTheScriptsAndThePage) {
  const std::string page = run({"man"}).output, bash = read_file(folder() / "bash_script"),
                    zsh = read_file(folder() / "zsh_script"), fish = read_file(folder() / "fish_script");
  cli::Request request;
  const std::vector<Command> table = cli::command_table(request);
  ASSERT_GE(table.size(), 13u);
  for (const Command& command : table) {
    SCOPED_TRACE(command.name);
    const std::string help = run({std::string(command.name), "--help"}).output;
    EXPECT_THAT(help, HasSubstr(fmt::format("Example:\n  {}\n", command.example)));
    const std::size_t begin = page.find(fmt::format(".SS flexkey {}\n", command.name));
    ASSERT_NE(begin, std::string::npos);
    const std::string section = page.substr(begin, page.find(".SS", begin + 1) - begin);
    for (const Argument& argument : command.arguments)
      for (const std::string_view name : argument.names) {
        SCOPED_TRACE(name);
        EXPECT_THAT(help, HasSubstr(std::string(name)));
        if (argument.has_place()) continue;
        EXPECT_THAT(section, HasSubstr(fmt::format("\\fB{}\\fR", in_roff(name))));
        EXPECT_THAT(offered({"flexkey", std::string(command.name), std::string(name)}),
                    Contains(std::string(name)));
        EXPECT_THAT(zsh, HasSubstr(std::string(name)));
        const std::string flag(name[1] == '-' ? name.substr(2) : name.substr(1));
        EXPECT_THAT(fish, testing::ContainsRegex(
                              fmt::format("from {}'( -[sl] [a-z-]+)* -[sl] {}( |\n)", command.name, flag)));
      }
  }
}

TEST_F(ManPage, TheParserTakesNoOptionThatIsNotInTheTable) {
  cli::Request request;
  for (const Command& command : cli::command_table(request)) {
    std::vector<std::string> known;
    for (const Argument& argument : command.arguments)
      known.insert(known.end(), argument.names.begin(), argument.names.end());
    std::istringstream help(run({std::string(command.name), "--help"}).output);
    for (std::string line; std::getline(help, line);) {
      if (!line.starts_with("  -")) continue;
      std::istringstream names(line.substr(2, line.find(' ', 2) - 2));
      for (std::string name; std::getline(names, name, ',');) EXPECT_THAT(known, Contains(name));
    }
  }
}

}  // namespace
}  // namespace flexkey::test
