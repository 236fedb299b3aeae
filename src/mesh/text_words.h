#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace flexkey {

/// The words of a text, one after another, and the line on which they stand. Each function throws InputError
/// with that line where the text ends or says something else.
class TextWords {
 public:
  enum class Comments { none, hash };  // hash: "#" begins one, to the end of the line

  /// name: of the file, for messages; line: the number of the text's first.
  TextWords(std::string_view text, std::string name, Comments comments, int line = 1)
      : left_(text), name_(std::move(name)), comments_(comments), line_(line) {}

  bool at_end();
  /// what: "the corners of face 7", which stands there.
  std::string_view next(std::string_view what);
  double coordinate(std::string_view what);
  double number(std::string_view what);
  /// A whole number of low .. high - 1.
  long long whole(std::string_view what, long long low, long long high);
  /// What is left of the line, without blanks around it.
  std::string_view rest_of_line();

  std::size_t bytes_left() const { return left_.size(); }
  int line() const { return line_; }
  [[noreturn]] void fail(std::string_view message) const;

 private:
  void skip_blanks();

  std::string_view left_;
  std::string name_;
  Comments comments_;
  int line_;
};

}  // namespace flexkey
