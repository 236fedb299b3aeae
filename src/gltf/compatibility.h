#pragma once

#include <string>
#include <vector>

namespace flexkey {

/// What a well-known client makes of a file.
struct ClientNote {
  std::string client;
  bool plays = true;
  std::string why;  // the limit that the file passes or keeps to, or what the client needs; may be empty
};

/// What is known of clients that matters to a file of so many targets, with and without meshopt.
std::vector<ClientNote> client_notes(int targets, bool has_meshopt);

}  // namespace flexkey
