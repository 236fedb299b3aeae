#pragma once

#include <concepts>
#include <type_traits>

namespace flexkey {

/// Type or const Type. A value's `members_of` is written once for both: it gives references to all its
/// members (std::tie), which one archive reads, to save or to hash, and another fills. Of a plain struct they
/// are named by a structured binding, so that a member more does not compile before it is listed.
template <class Type, class Plain>
concept MaybeConst = std::same_as<std::remove_const_t<Type>, Plain>;

}  // namespace flexkey
