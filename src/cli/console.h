#pragma once

#include <string_view>

namespace flexkey::cli {

/// For people, on stderr. A terminal that went away or a full disk behind it never fails the job.
void say(std::string_view text);

/// A result, on stdout, for scripts. Throws OutputError if it did not arrive whole.
void print_result(std::string_view text);

}  // namespace flexkey::cli
