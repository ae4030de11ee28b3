// A whole frame of the trend, from the stored samples to painted pixels, at 10 thousand, 1 million and
// 8.64 million samples (a day at 100 a second): at most 10 ms, and no growth with what is stored.
//
// Pictures that are compared show alike things: a line over everything stored has the same number of
// waves, steps and gaps at every size. A day with a gap in every pixel column stands beside them as the
// worst picture there is.

#include "theme.h"
#include "trend_chart.h"

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
constexpr qint64 minuteNs = 60'000'000'000;
constexpr qint64 fewest = 10'000;

enum Picture {
    Everything, ///< Everything stored, with ten waves.
    Minute,     ///< The last minute or so of a stream.
    Worst,      ///< Everything stored, with a gap every minute.
};

const char* nameOf(Picture picture)
{
    switch (picture) {
    case Everything:
        return "everything stored";
    case Minute:
        return "one minute";
    case Worst:
        return "a gap in every column";
    }
    return "";
}

/// A workpiece that rises and falls, noise, steps and alarms; `period` samples make one wave.
Measurement sampleAt(qint64 index, qint64 period)
{
    quint32 noise = quint32(index) * 2654435761U;
    noise ^= noise >> 15;
    const qint64 phase = index % period;
    Measurement sample;
    sample.monotonicNs = index * sampleNs;
    sample.wallMs = 1'700'000'000'000 + index * 10;
    sample.kind = measurement::ValueKind::Valid;
    const double wave = 4000 * std::sin(double(phase) / double(period) * 2 * M_PI);
    sample.value = qint32(12'000 + wave + (phase * 5 / period == 3 ? 5000 : 0)) + qint32(noise % 401) - 200;
    sample.state = quint16(sample.value > 17'500  ? measurement::HighBit
                           : sample.value < 7'500 ? measurement::LowBit
                                                  : measurement::GoBit);
    if (phase * 50 / period == 49) {
        sample.kind = measurement::ValueKind::Alarm;
        sample.value = 9'999'999;
        sample.state = measurement::AlarmBit;
    }
    return sample;
}

std::unique_ptr<TrendStore> makeStore(Picture picture, qint64 samples)
{
    const qint64 period =
        picture == Everything ? samples / 10 : minuteNs / sampleNs / (picture == Minute ? 10 : 1);
    auto store = std::make_unique<TrendStore>();
    for (qint64 index = 0; index < samples; ++index)
        store->append(sampleAt(index, period));
    return store;
}

void trendFrame(benchmark::State& state)
{
    const auto picture = Picture(state.range(0));
    static std::map<std::pair<int, qint64>, std::unique_ptr<TrendStore>> stores;
    const std::pair<int, qint64> key{picture, state.range(1)};
    if (!stores.contains(key)) {
        stores.clear(); // one at a time: the largest has 150 MB
        stores[key] = makeStore(picture, state.range(1));
    }
    const TrendStore& store = *stores[key];

    ui::TrendView view;
    ui::TrendChart chart;
    chart.resize(frameSize);
    chart.setLimits(
        {{17'500, 18'000, QStringLiteral("HIGH +1.7500"), QStringLiteral("HIGH +1.8000, not applied yet")},
         {7'500, {}, QStringLiteral("LOW +0.7500"), {}},
         false,
         false});
    chart.setSource(&store, &view);
    chart.setWindowLength(0);
    chart.show();
    chart.updateFrame(0);
    QImage image(frameSize, QImage::Format_ARGB32_Premultiplied);
    const ui::TrendSpan stored{store.firstNs(), store.lastNs()};
    qint64 frame = 0;
    for (auto unused : state) {
        ++frame;
        if (picture == Minute) { // every frame differs from the one before, as a live one does
            const qint64 to = stored.toNs - frame % 1000 * 25'000'000;
            view.time.panTo({to - minuteNs, to}, stored);
        }
        chart.updateFrame(frame * 25'000'000);
        static_cast<QWidget&>(chart).render(&image);
        benchmark::DoNotOptimize(image.bits());
    }
    state.counters["samples"] = double(state.range(1));
    state.counters["picture"] = double(picture);
}

std::map<std::pair<int, qint64>, double> results; ///< Milliseconds by picture and samples.

/// Keeps the medians for the comparison at the end, beside the usual table. Processor time: a frame
/// waits for nothing, and what else the machine does is not the frame's.
class Reporter final : public benchmark::ConsoleReporter {
public:
    Reporter()
        : ConsoleReporter(OO_Tabular)
    {}
    void ReportRuns(const std::vector<Run>& runs) override
    {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            if (run.run_type == Run::RT_Aggregate && run.aggregate_name == "median")
                results[{int(run.counters.at("picture").value), qint64(run.counters.at("samples").value)}] =
                    run.GetAdjustedCPUTime();
        }
    }
};

int printRatios()
{
    bool held = !results.empty();
    int picture = -1;
    for (const auto& [key, ms] : results) {
        if (std::exchange(picture, key.first) != key.first)
            std::printf("\ntrend frame 1200x400, %s:\n", nameOf(Picture(key.first)));
        std::printf("  %9lld samples  %6.2f ms", static_cast<long long>(key.second), ms);
        if (const auto smallest = results.find({key.first, fewest}); smallest != results.end())
            std::printf("  %.2f times that of %lld", ms / smallest->second, static_cast<long long>(fewest));
        std::printf("\n");
        held = held && ms <= 10;
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
    const auto add = [](Picture picture, qint64 samples) {
        benchmark::RegisterBenchmark(nameOf(picture), trendFrame)
            ->Args({picture, samples})
            ->Unit(benchmark::kMillisecond)
            ->Iterations(60)
            ->Repetitions(7)
            ->ReportAggregatesOnly();
    };
    for (const Picture picture : {Everything, Minute}) {
        for (const qint64 samples : {fewest, qint64(1'000'000), qint64(8'640'000)})
            add(picture, samples);
    }
    add(Worst, 8'640'000);
    benchmark::Initialize(&argc, argv);
    Reporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    return printRatios();
}
