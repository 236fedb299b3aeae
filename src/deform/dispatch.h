#pragma once

#include <cstddef>

/// Before a function: compiled once more for each newer x86-64, and the one that the CPU can run is taken
/// when the program starts. Of what the function calls only what is inlined ([[gnu::always_inline]], no
/// lambdas) is compiled along. Needs GCC's names of the levels and glibc's loader; sanitizers run before it
/// has chosen.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && __GNUC__ >= 12 && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define FLEXKEY_CLONES __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define FLEXKEY_CLONES
#endif
