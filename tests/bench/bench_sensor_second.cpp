// How long the virtual sensor needs for one second of its life at each sampling cycle, against one second.
// The claim of docs/architecture.md: under 10 ms at the shortest cycle, so that many sensors fit one machine.
#include "manual_clock.h"
#include "scene.h"
#include "virtual_sensor.h"

#include <benchmark/benchmark.h>

using namespace lds;
using namespace lds::emulator;
using catalog::ItemId;

namespace {

void simulateSecond(benchmark::State& state, std::shared_ptr<const Scenery> scenery, int averageTimes)
{
    ManualClock clock;
    VirtualSensor sensor(catalog::SensorModel::HlG203, clock);
    sensor.setScenery(std::move(scenery));
    sensor.write({{ItemId::SamplingFrequency, catalog::Value(state.range(0))}});
    sensor.write({{ItemId::AverageTimes, averageTimes}});
    for ([[maybe_unused]] auto round : state) {
        clock.advanceMs(1000);
        sensor.catchUp();
        benchmark::DoNotOptimize(sensor.read(ItemId::MeasuredValue));
    }
    state.counters["share of real time"] = benchmark::Counter(
        double(state.iterations()), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void gentleWorkpiece(benchmark::State& state) { simulateSecond(state, nullptr, 5); }

void example(benchmark::State& state, const QString& name)
{
    const auto scene = Scene::load(name, catalog::SensorModel::HlG203);
    if (!scene) {
        state.SkipWithError(qPrintable(scene.error()));
        return;
    }
    simulateSecond(state, *scene, 5);
}

} // namespace

int main(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    benchmark::RegisterBenchmark("gently moving workpiece", gentleWorkpiece)
        ->DenseRange(0, 4)
        ->ArgName("cycle");
    for (const QString& name : Scene::examples()) {
        benchmark::RegisterBenchmark(qPrintable(name),
                                     [name](benchmark::State& state) { example(state, name); })
            ->Arg(0)
            ->ArgName("cycle");
    }
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
