// Drives a fuzz target where libFuzzer is not at hand: every seed as it is, then a bounded number of seeds
// changed by a generator of fixed seed, so that two runs do the same.
//   fuzz_… [--runs N] [--seed N] FILE-OR-FOLDER…      LDS_FUZZ_RUNS replaces N
// An input that ends the program is written to failed-input in the current folder; give that file as the
// only seed, with --runs 0, to see it again.

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
// Sanitizers end the program without a signal; absent without them.
extern "C" __attribute__((weak)) void __sanitizer_set_death_callback(void (*callback)());

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t longestInput = 2048; ///< Beyond what any of the project's datagrams may have.

Bytes g_current; ///< For keepInput.

void keepInput()
{
    if (std::FILE* file = std::fopen("failed-input", "wb")) {
        std::fwrite(g_current.data(), 1, g_current.size(), file);
        std::fclose(file);
        std::fputs("the input is in failed-input\n", stderr);
    }
}

void onSignal(int signal)
{
    keepInput();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

void run(const Bytes& input)
{
    g_current = input;
    // A copy of exactly its size, so that a sanitizer sees the first byte read too far.
    const Bytes exact(input.begin(), input.end());
    LLVMFuzzerTestOneInput(exact.data(), exact.size());
}

Bytes readFile(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return Bytes(std::istreambuf_iterator<char>(file), {});
}

std::vector<Bytes> readSeeds(const std::vector<std::filesystem::path>& paths)
{
    std::vector<std::filesystem::path> files;
    for (const auto& path : paths) {
        if (!std::filesystem::is_directory(path)) {
            files.push_back(path);
            continue;
        }
        for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
            if (entry.is_regular_file())
                files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end()); // folders list in any order
    std::vector<Bytes> seeds;
    for (const auto& file : files)
        seeds.push_back(readFile(file));
    return seeds;
}

class Mutator {
public:
    Mutator(const std::vector<Bytes>& seeds, std::uint64_t seed)
        : m_seeds(seeds)
        , m_random(seed)
    {}

    Bytes next()
    {
        Bytes bytes = anySeed();
        for (std::size_t changes = 1 + below(4); changes > 0; --changes)
            change(bytes);
        bytes.resize(std::min(bytes.size(), longestInput));
        return bytes;
    }

private:
    // A distribution of the library may differ from one library to the next; a remainder does not.
    std::size_t below(std::size_t end) { return std::size_t(m_random() % end); }
    const Bytes& anySeed() { return m_seeds[below(m_seeds.size())]; }

    std::uint8_t anyByte()
    {
        static constexpr std::uint8_t edges[] = {0, 1, 2, 4, 16, 32, 33, 127, 128, 144, 145, 254, 255};
        return below(2) ? edges[below(std::size(edges))] : std::uint8_t(below(256));
    }

    void change(Bytes& bytes)
    {
        const std::size_t at = bytes.empty() ? 0 : below(bytes.size());
        const auto here = bytes.begin() + std::ptrdiff_t(at);
        const std::size_t some = std::min(bytes.size() - at, 1 + below(8));
        switch (bytes.empty() ? 4 : below(9)) {
        case 0:
        case 1:
            *here = std::uint8_t(*here ^ (1U << below(8)));
            break;
        case 2:
            *here = anyByte();
            break;
        case 3:
            *here = std::uint8_t(*here + (below(2) ? 1 : 255));
            break;
        case 4:
            bytes.insert(here, 1 + below(below(16) ? 8 : 1500), anyByte());
            break;
        case 5:
            bytes.erase(here, here + std::ptrdiff_t(some));
            break;
        case 6:
            bytes.resize(at);
            break;
        case 7: {
            const Bytes part(here, here + std::ptrdiff_t(some));
            const auto to = bytes.begin() + std::ptrdiff_t(below(bytes.size()));
            bytes.insert(to, part.begin(), part.end());
            break;
        }
        default: {
            const Bytes& other = anySeed();
            bytes.resize(at);
            const std::size_t from = std::min(other.size(), below(2) ? at : below(other.size() + 1));
            bytes.insert(bytes.end(), other.begin() + std::ptrdiff_t(from), other.end());
        }
        }
    }

    const std::vector<Bytes>& m_seeds;
    std::mt19937_64 m_random;
};

} // namespace

int main(int argc, char** argv)
{
    std::uint64_t runs = 1'000'000;
    std::uint64_t seed = 1;
    std::vector<std::filesystem::path> paths;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument == "--runs" && i + 1 < argc)
            runs = std::strtoull(argv[++i], nullptr, 10);
        else if (argument == "--seed" && i + 1 < argc)
            seed = std::strtoull(argv[++i], nullptr, 10);
        else
            paths.emplace_back(argument);
    }
    if (const char* replaced = std::getenv("LDS_FUZZ_RUNS"))
        runs = std::strtoull(replaced, nullptr, 10);
    const std::vector<Bytes> seeds = readSeeds(paths);
    if (seeds.empty()) {
        std::fputs("no seeds: name files or folders\n", stderr);
        return 2;
    }

    std::signal(SIGABRT, onSignal);
    std::signal(SIGSEGV, onSignal);
    if (__sanitizer_set_death_callback)
        __sanitizer_set_death_callback(keepInput);
    for (const Bytes& each : seeds)
        run(each);
    Mutator mutator(seeds, seed);
    for (std::uint64_t i = 0; i < runs; ++i)
        run(mutator.next());
    std::printf("%zu seeds and %llu changed ones\n", seeds.size(), static_cast<unsigned long long>(runs));
    return 0;
}
