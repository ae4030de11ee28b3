#include "trend_store.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>

using namespace lds::measurement;

// Drawing must cost the same whatever is stored, and storing must stay cheap: columns() and append() at ten
// thousand, a million and 8.64 million samples (a day at 100 a second), with the ratios printed at the end.

namespace {

constexpr qint64 sampleIntervalNs = 10'000'000; // 100 samples a second
constexpr int columnCount = 1'200;              // a trend 1,200 pixels wide
constexpr std::int64_t sizes[] = {10'000, 1'000'000, 8'640'000};

Measurement sampleAt(std::int64_t index)
{
    Measurement sample;
    sample.monotonicNs = index * sampleIntervalNs;
    sample.wallMs = sample.monotonicNs / 1'000'000;
    sample.value = Value(50'000 * std::sin(double(index) / 5'000)) + Value(index * 7'919 % 101);
    sample.kind = index % 997 == 0 ? ValueKind::Indeterminate : ValueKind::Valid;
    sample.state = GoBit | LaserBit;
    return sample;
}

const TrendStore& storeOf(std::int64_t size)
{
    static std::map<std::int64_t, std::unique_ptr<TrendStore>> stores;
    std::unique_ptr<TrendStore>& store = stores[size];
    if (!store) {
        store = std::make_unique<TrendStore>();
        for (std::int64_t i = 0; i < size; ++i)
            store->append(sampleAt(i));
    }
    return *store;
}

void columnsOfEverything(benchmark::State& state)
{
    const TrendStore& store = storeOf(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(store.columns(store.firstNs(), store.lastNs() + 1, columnCount));
    state.counters["bytes/sample"] = double(store.bytes()) / double(store.size());
}

/// What following a live trend asks for: the newest 60 seconds.
void columnsOfTheLastMinute(benchmark::State& state)
{
    const TrendStore& store = storeOf(state.range(0));
    const qint64 to = store.lastNs() + 1;
    for (auto _ : state)
        benchmark::DoNotOptimize(store.columns(to - 60'000'000'000, to, columnCount));
}

void append(benchmark::State& state)
{
    for (auto _ : state) {
        TrendStore store;
        for (std::int64_t i = 0; i < state.range(0); ++i)
            store.append(sampleAt(i));
        benchmark::DoNotOptimize(store.bytes());
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

void forEachSize(benchmark::internal::Benchmark* bench)
{
    for (const std::int64_t size : sizes)
        bench->Arg(size);
    bench->Unit(benchmark::kMicrosecond);
}

BENCHMARK(columnsOfEverything)->Apply(forEachSize);
BENCHMARK(columnsOfTheLastMinute)->Apply(forEachSize);
BENCHMARK(append)->Arg(10'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

/// The best of several, which is what the code costs when nobody else has the processor.
double bestMicroseconds(const TrendStore& store, qint64 fromNs, qint64 toNs)
{
    double best = 1e9;
    for (int i = 0; i < 200; ++i) {
        const auto start = std::chrono::steady_clock::now();
        benchmark::DoNotOptimize(store.columns(fromNs, toNs, columnCount));
        const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
        best = std::min(best, took.count());
    }
    return best;
}

void printRatios()
{
    std::printf("\ncolumns(), %d of them, against 10,000 samples:\n", columnCount);
    double everythingAtFirst = 0;
    double minuteAtFirst = 0;
    for (const std::int64_t size : sizes) {
        const TrendStore& store = storeOf(size);
        const qint64 to = store.lastNs() + 1;
        const double everything = bestMicroseconds(store, store.firstNs(), to);
        const double minute = bestMicroseconds(store, to - 60'000'000'000, to);
        if (size == sizes[0]) {
            everythingAtFirst = everything;
            minuteAtFirst = minute;
        }
        std::printf(
            "%9lld samples: everything %7.1f us (x%.2f), last minute %7.1f us (x%.2f), %.2f bytes a sample\n",
            static_cast<long long>(size), everything, everything / everythingAtFirst, minute,
            minute / minuteAtFirst, double(store.bytes()) / double(size));
    }
}

} // namespace

int main(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    benchmark::RunSpecifiedBenchmarks();
    printRatios();
    return 0;
}
