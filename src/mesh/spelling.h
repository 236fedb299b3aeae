#pragma once

#include <span>
#include <string>
#include <string_view>

namespace flexkey {

/// The candidate nearest to a misspelt word by Damerau-Levenshtein distance or by a shared prefix,
/// or an empty string where none is near enough to be meant.
std::string nearest_word(std::string_view word, std::span<const std::string> candidates);

/// "; did you mean 'rotate'?" or an empty string: the tail of an error about an unknown word.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

/// "no group 'haed' in pig.glb; did you mean 'head'?", or with what there is: "; it has body, head".
std::string no_such_name(std::string_view kind, std::string_view name, std::string_view where,
                         std::span<const std::string> known);

}  // namespace flexkey
