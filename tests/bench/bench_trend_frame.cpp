// A whole frame of the trend, from the stored samples to painted pixels, at 10 thousand, 1 million and
// 8.64 million samples (a day at 100 a second): at most 10 ms, and no growth with what is stored.

#include "theme.h"
#include "trend_chart.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <QApplication>
#include <QImage>

namespace {

using namespace lds;
using measurement::Measurement;
using measurement::TrendStore;

constexpr qint64 sampleNs = 10'000'000;
constexpr QSize frameSize(1200, 400);

/// A workpiece that rises and falls, noise, a step every seven seconds and an alarm every minute.
Measurement sampleAt(qint64 index)
{
    quint32 noise = quint32(index) * 2654435761U;
    noise ^= noise >> 15;
    Measurement sample;
    sample.monotonicNs = index * sampleNs;
    sample.wallMs = 1'700'000'000'000 + index * 10;
    sample.kind = measurement::ValueKind::Valid;
    const double wave = 4000 * std::sin(double(index) / 900);
    sample.value = qint32(12'000 + wave + (index / 700 % 3 == 0 ? 5000 : 0)) + qint32(noise % 401) - 200;
    sample.state = quint16(sample.value > 17'500  ? measurement::HighBit
                           : sample.value < 7'500 ? measurement::LowBit
                                                  : measurement::GoBit);
    if (index % 6000 < 120) {
        sample.kind = measurement::ValueKind::Alarm;
        sample.value = 9'999'999;
        sample.state = measurement::AlarmBit;
    }
    return sample;
}

const TrendStore& storeOf(qint64 samples)
{
    static std::map<qint64, std::unique_ptr<TrendStore>> stores;
    auto& store = stores[samples];
    if (!store) {
        store = std::make_unique<TrendStore>();
        for (qint64 index = 0; index < samples; ++index)
            store->append(sampleAt(index));
    }
    return *store;
}

std::map<std::pair<int, qint64>, double> results; ///< Milliseconds by window and samples.

enum Window { All, Minute };

void trendFrame(benchmark::State& state)
{
    const TrendStore& store = storeOf(state.range(1));
    ui::TrendView view;
    ui::TrendChart chart;
    chart.resize(frameSize);
    chart.setLimits(
        {{17'500, 18'000, QStringLiteral("HIGH +1.7500"), QStringLiteral("HIGH +1.8000, not applied yet")},
         {7'500, {}, QStringLiteral("LOW +0.7500"), {}},
         false});
    chart.setSource(&store, &view);
    chart.setWindowLength(state.range(0) == All ? 0 : 60'000'000'000);
    chart.show();
    chart.updateFrame(0);
    QImage image(frameSize, QImage::Format_ARGB32_Premultiplied);
    qint64 frame = 0;
    for (auto unused : state) {
        // Every frame differs from the one before, as a live one does.
        if (state.range(0) == Minute)
            view.time.panTo(
                {store.lastNs() - 60'000'000'000 - frame * 25'000'000, store.lastNs() - frame * 25'000'000},
                {store.firstNs(), store.lastNs()});
        chart.updateFrame(++frame * 25'000'000);
        static_cast<QWidget&>(chart).render(&image);
        benchmark::DoNotOptimize(image.bits());
    }
    state.counters["samples"] = double(state.range(1));
}

/// Keeps the medians for the comparison at the end, beside the usual table.
class Reporter final : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override
    {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Aggregate || run.aggregate_name != "median")
                continue;
            const bool all = run.run_name.function_name.find("all") != std::string::npos;
            results[{all ? All : Minute, qint64(run.counters.at("samples").value)}] =
                run.GetAdjustedRealTime();
        }
    }
};

int printRatios()
{
    bool held = !results.empty();
    for (const Window window : {All, Minute}) {
        const double smallest = results[{window, 10'000}];
        std::printf("\ntrend frame, %s, 1200x400:\n", window == All ? "everything stored" : "one minute");
        for (const qint64 samples : {qint64(10'000), qint64(1'000'000), qint64(8'640'000)}) {
            const double ms = results[{window, samples}];
            std::printf("  %9lld samples  %6.2f ms  ratio %.2f\n", static_cast<long long>(samples), ms,
                        ms / smallest);
            held = held && ms > 0 && ms <= 10;
        }
    }
    std::printf("\naim of at most 10 ms a frame: %s\n", held ? "held" : "MISSED");
    return held ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    ui::Theme::instance().apply(application, ui::ThemeMode::Light);
    for (const Window window : {All, Minute}) {
        for (const qint64 samples : {qint64(10'000), qint64(1'000'000), qint64(8'640'000)}) {
            benchmark::RegisterBenchmark(window == All ? "trendFrame/all" : "trendFrame/oneMinute",
                                         trendFrame)
                ->Args({window, samples})
                ->Unit(benchmark::kMillisecond)
                ->MinTime(0.3)
                ->Repetitions(5)
                ->ReportAggregatesOnly();
        }
    }
    benchmark::Initialize(&argc, argv);
    Reporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    return printRatios();
}
