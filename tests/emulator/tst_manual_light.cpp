// §4.3: what depends on the light and the movement of what stands under the beam.
#include "manual_items.h"

#include <algorithm>
#include <functional>

using namespace lds::emulator;
using namespace lds::catalog;
using namespace lds::test;

namespace {

constexpr qint64 nsPerMs = 1'000'000;

/// A scenery written as a function of the milliseconds since it began.
class Sketch final : public Scenery {
public:
    explicit Sketch(std::function<Sight(double)> sketch)
        : m_sketch(std::move(sketch))
    {}
    Sight at(qint64 timeNs) const override { return m_sketch(double(timeNs) / nsPerMs); }

private:
    std::function<Sight(double)> m_sketch;
};

Nanometres wire(double value) { return Nanometres(value * nanometresPerWireUnit); }

} // namespace

class ManualLightTest : public SensorFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }

    void closerIsMoreAndReversedIsLess();
    void aLargerCountSuppressesAMomentaryChange();
    void aDarkWorkpieceNeedsALongerCycle();
    void anotherCycleNeedsAnotherTuning();

private:
    void look(std::function<Sight(double)> sketch)
    {
        m_sensor->setScenery(std::make_shared<Sketch>(std::move(sketch)));
    }
    void lookAtStill(double reflectance)
    {
        look([reflectance](double) { return Sight{true, 0, reflectance, 0}; });
        m_clock->advanceMs(averageFullMs);
        m_sensor->catchUp();
    }
    Value largestIn(int milliseconds);
    int tune(double first, double second); ///< Answers with the execution state.
};

Value ManualLightTest::largestIn(int milliseconds)
{
    Value largest = value();
    for (int i = 0; i < milliseconds; ++i) {
        m_clock->advanceMs(1);
        largest = std::max(largest, value());
    }
    return largest;
}

int ManualLightTest::tune(double first, double second)
{
    lookAtStill(first);
    write(ItemId::BrightnessTuning, 1);
    m_clock->advanceMs(averageFullMs);
    write(ItemId::BrightnessTuning1stPoint, 0);
    m_clock->advanceMs(averageFullMs);
    lookAtStill(second);
    write(ItemId::BrightnessTuning2ndPoint, 0);
    m_clock->advanceMs(averageFullMs);
    return readNow(ItemId::BrightnessTuningExecutionState);
}

void ManualLightTest::closerIsMoreAndReversedIsLess()
{
    QVERIFY(write(ItemId::AverageTimes, 0));
    for (const bool reversed : {false, true}) {
        QVERIFY(write(ItemId::InversionOfMeasuredValue, reversed));
        look([](double ms) { return Sight{true, wire(-4'000 + 100 * ms), 1, 0}; }); // it comes closer
        m_clock->advanceMs(2);
        Value before = value();
        for (int i = 0; i < 30; ++i) {
            m_clock->advanceMs(1);
            const Value now = value();
            QCOMPARE(now - before, reversed ? -100 : 100);
            before = now;
        }
    }
}

void ManualLightTest::aLargerCountSuppressesAMomentaryChange()
{
    // For 4 ms something 1 mm high passes by.
    const auto passing = [](double ms) {
        return Sight{true, ms >= 2'000 && ms < 2'004 ? wire(10'000) : 0, 1, 0};
    };
    QVERIFY(write(ItemId::AverageTimes, 0));
    look(passing);
    m_clock->advanceMs(1'900);
    QCOMPARE(largestIn(200), 10'000);
    QVERIFY(write(ItemId::AverageTimes, 6)); // 1024
    look(passing);
    m_clock->advanceMs(1'900);
    QCOMPARE(largestIn(200), 39); // 4 samples of 1024
}

void ManualLightTest::aDarkWorkpieceNeedsALongerCycle()
{
    const double blackRubber = 0.05;
    QVERIFY(write(ItemId::SamplingFrequency, 0)); // 100 µs
    lookAtStill(blackRubber);
    QVERIFY(m_sensor->coil(Alarm) && m_sensor->coil(InsufficientLight));
    QVERIFY(write(ItemId::SamplingFrequency, 4)); // 2 ms
    m_clock->advanceMs(2 * averageFullMs);
    QCOMPARE(value(), 0);
    QVERIFY(!m_sensor->coil(Alarm) && !m_sensor->coil(Indeterminate));
}

void ManualLightTest::anotherCycleNeedsAnotherTuning()
{
    QVERIFY(write(ItemId::SamplingFrequency, 0)); // 100 µs
    QCOMPARE(tune(1, 0.9), 3);
    lookAtStill(1);
    QCOMPARE(value(), 0);
    QVERIFY(write(ItemId::SamplingFrequency, 4)); // 2 ms: twenty times the light
    lookAtStill(1);
    m_clock->advanceMs(averageFullMs);
    m_sensor->catchUp();
    QVERIFY(m_sensor->coil(ExcessiveLight));
    m_clock->advanceMs(averageFullMs);
    QVERIFY(write(ItemId::BrightnessTuning, 0));
    m_clock->advanceMs(2 * averageFullMs);
    QCOMPARE(tune(1, 0.9), 3);
    lookAtStill(1);
    m_clock->advanceMs(averageFullMs);
    QCOMPARE(value(), 0);
    QVERIFY(!m_sensor->coil(ExcessiveLight));
}

QTEST_GUILESS_MAIN(ManualLightTest)
#include "tst_manual_light.moc"
