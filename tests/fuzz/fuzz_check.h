#pragma once

#include <cstdio>
#include <cstdlib>

/// What a fuzz target demands of the code under test: ends the program when it does not hold, in every
/// build, so that whatever drives the target reports the input.
#define FUZZ_CHECK(condition)                                                                                \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            std::fprintf(stderr, "%s:%d: does not hold: %s\n", __FILE__, __LINE__, #condition);              \
            std::abort();                                                                                    \
        }                                                                                                    \
    } while (false)
