#pragma once

#include <stdexcept>
#include <string>

namespace flexkey {

/// What every exception of flexkey derives from; the message is a whole sentence for the user.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A mesh or another input file cannot be read or used as it is (exit code 3).
class InputError : public Error {
 public:
  using Error::Error;
};

/// An output file could not be written; a later try may succeed (exit code 5).
class OutputError : public Error {
 public:
  using Error::Error;
};

}  // namespace flexkey
