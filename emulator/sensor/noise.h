#pragma once

#include <QtGlobal>

namespace lds::emulator {

/// Noise as a function of time: −1 … 1, always the same for one seed and one moment, new each 100 µs (the
/// shortest sampling cycle). `timeNs` ≥ 0.
inline double noiseShare(quint64 seed, qint64 timeNs)
{
    constexpr qint64 stepNs = 100'000;
    /// SplitMix64: a well mixed number for every step, with no state to keep.
    constexpr auto mixed = [](quint64 number) {
        number += 0x9e3779b97f4a7c15ULL;
        number = (number ^ (number >> 30)) * 0xbf58476d1ce4e5b9ULL;
        number = (number ^ (number >> 27)) * 0x94d049bb133111ebULL;
        return number ^ (number >> 31);
    };
    const quint64 random = mixed(seed ^ mixed(quint64(timeNs / stepNs)));
    return double(random >> 11) * 0x1p-52 - 1.0;
}

} // namespace lds::emulator
