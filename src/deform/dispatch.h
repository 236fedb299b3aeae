#pragma once

#include <cstddef>

/// Before a function: it is compiled once more for newer x86-64 CPUs, and what the CPU can run is taken when
/// the program starts. Of the functions that it calls, those that are inlined ([[gnu::always_inline]]; no
/// lambdas) are compiled along. A build that asks for a newer CPU as a whole needs none, and sanitizers
/// cannot have any.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && __GNUC__ >= 12 && \
    !defined(__AVX2__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define FLEXKEY_CLONES __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define FLEXKEY_CLONES
#endif
