#include "light_receiver.h"

#include <QTest>

using namespace lds::emulator;

namespace {

constexpr qint64 millisecond = 1'000'000;
constexpr double rubber = 0.02;
constexpr double ceramic = 1;
constexpr double steel = 5;

Sight of(double reflectance, double ambientLight = 0) { return {true, 0, reflectance, ambientLight}; }

} // namespace

/// What the project chose for §4.3.1 and §4.3.3, where the manual has no figures: docs/conformance.md.
class LightReceiverTest : public QObject {
    Q_OBJECT

    /// Samples until the light can be measured; 1000 = never.
    static int samplesUntilMeasurable(LightReceiver& receiver, const Sight& sight,
                                      qint64 cycleNs = millisecond)
    {
        for (int samples = 1; samples < 1000; ++samples) {
            if (receiver.receive(sight, cycleNs).light == Light::Measurable)
                return samples;
        }
        return 1000;
    }

private Q_SLOTS:
    void ceramicSuitsEverySamplingCycle();
    void blackRubberNeedsALongCycle();
    void nothingSendsNoLightBack();
    void ambientLightDrownsTheWaveform();
    void automaticAdjustmentTakesSeveralSamples();
    void aTunedRangeAdjustsAtOnce();
    void whatLiesFarFromTheTunedRangeCannotBeMeasured();
    void intensityStaysWithinItsRange();
};

void LightReceiverTest::ceramicSuitsEverySamplingCycle()
{
    for (const qint64 cycle : {100'000, 200'000, 500'000, 1'000'000, 2'000'000}) {
        LightReceiver receiver;
        receiver.settle(of(ceramic), cycle);
        const Reflection reflection = receiver.receive(of(ceramic), cycle);
        QCOMPARE(reflection.light, Light::Measurable);
        QVERIFY(reflection.peakIntensity >= 400 && reflection.peakIntensity <= 800);
        QVERIFY(receiver.isOptimal());
    }
}

void LightReceiverTest::blackRubberNeedsALongCycle() // §4.3.1 note
{
    LightReceiver receiver;
    QCOMPARE(samplesUntilMeasurable(receiver, of(rubber), 100'000), 1000);
    QVERIFY(samplesUntilMeasurable(receiver, of(rubber), 1'000'000) < 1000);
}

void LightReceiverTest::nothingSendsNoLightBack()
{
    LightReceiver receiver;
    const int before = receiver.brightness();
    for (int i = 0; i < 100; ++i)
        QCOMPARE(receiver.receive({false, 0, 1, 0}, millisecond).light, Light::Insufficient);
    QCOMPARE(receiver.brightness(), before); // there was nothing to adjust to
    QCOMPARE(receiver.receive(of(0), millisecond).peakIntensity, quint16(0));
}

void LightReceiverTest::ambientLightDrownsTheWaveform()
{
    LightReceiver receiver;
    receiver.settle(of(ceramic), millisecond);
    QCOMPARE(receiver.receive(of(ceramic, 0.99), millisecond).light, Light::Measurable);
    QCOMPARE(receiver.receive(of(ceramic, 1), millisecond).light, Light::ExtraneousLight);
}

void LightReceiverTest::automaticAdjustmentTakesSeveralSamples()
{
    LightReceiver receiver;
    receiver.settle(of(rubber), millisecond);
    QCOMPARE(receiver.receive(of(steel), millisecond).light, Light::Excessive);
    QVERIFY(samplesUntilMeasurable(receiver, of(steel)) > 8);
}

void LightReceiverTest::aTunedRangeAdjustsAtOnce() // §4.3.3: faster than the automatic mode
{
    LightReceiver receiver;
    receiver.settle(of(steel), millisecond);
    const int lowest = receiver.brightness();
    receiver.settle(of(rubber), millisecond);
    receiver.setRange(BrightnessRange{lowest, receiver.brightness()});
    for (const double reflectance : {steel, rubber, ceramic, rubber, steel})
        QCOMPARE(samplesUntilMeasurable(receiver, of(reflectance)), 1);
}

void LightReceiverTest::whatLiesFarFromTheTunedRangeCannotBeMeasured() // §4.3.3 note
{
    LightReceiver receiver;
    receiver.settle(of(ceramic), millisecond);
    receiver.setRange(BrightnessRange{receiver.brightness(), receiver.brightness()});
    QCOMPARE(samplesUntilMeasurable(receiver, of(rubber)), 1000);
    QCOMPARE(receiver.receive(of(rubber), millisecond).light, Light::Insufficient);
    QCOMPARE(samplesUntilMeasurable(receiver, of(steel)), 1000);
    QCOMPARE(receiver.receive(of(steel), millisecond).light, Light::Excessive);
}

void LightReceiverTest::intensityStaysWithinItsRange() // §5.2.4: 0 to 1,023
{
    LightReceiver receiver;
    for (const double reflectance : {1e-9, 1e-3, 0.1, 1.0, 1e3, 1e9}) {
        const Reflection reflection = receiver.receive(of(reflectance), 2 * millisecond);
        QVERIFY(reflection.peakIntensity <= 1023);
    }
}

QTEST_APPLESS_MAIN(LightReceiverTest)
#include "tst_light_receiver.moc"
