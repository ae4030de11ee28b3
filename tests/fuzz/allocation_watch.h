#pragma once

#include <cstddef>

namespace fuzz {

/// Watches the allocations of this thread while it lives, to hold a decoder to memory in proportion to its
/// input. Only one may live at a time.
class AllocationWatch {
public:
    AllocationWatch();
    ~AllocationWatch();
    AllocationWatch(const AllocationWatch&) = delete;
    AllocationWatch& operator=(const AllocationWatch&) = delete;

    /// Bytes of the largest single allocation so far; always 0 where `works` is false.
    std::size_t largest() const;
    /// With glibc, and under AddressSanitizer.
    static bool works();
};

} // namespace fuzz
