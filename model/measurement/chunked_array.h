#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace lds::measurement {

/// A list that only grows, in chunks that never move: its capacity is at most one chunk over its size,
/// where std::vector's would be up to twice. Elements are plain data.
template <typename T, std::size_t ChunkSize>
class ChunkedArray {
    static_assert(ChunkSize > 0 && (ChunkSize & (ChunkSize - 1)) == 0, "indices are split by shifting");
    static_assert(std::is_trivially_copyable_v<T>);

public:
    std::size_t size() const { return m_size; }
    const T& operator[](std::size_t index) const { return m_chunks[index / ChunkSize][index % ChunkSize]; }
    const T& last() const { return (*this)[m_size - 1]; }

    void append(const T& element)
    {
        if (m_size == m_chunks.size() * ChunkSize)
            m_chunks.push_back(std::make_unique<T[]>(ChunkSize));
        m_chunks[m_size / ChunkSize][m_size % ChunkSize] = element;
        ++m_size;
    }

    /// Capacity included, without this object itself.
    std::size_t bytes() const
    {
        return m_chunks.size() * ChunkSize * sizeof(T) + m_chunks.capacity() * sizeof(std::unique_ptr<T[]>);
    }

private:
    std::vector<std::unique_ptr<T[]>> m_chunks;
    std::size_t m_size = 0;
};

} // namespace lds::measurement
