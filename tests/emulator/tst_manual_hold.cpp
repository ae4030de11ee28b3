// §4.3.4 Hold Mode and §4.6.2 Trigger Mode: their timing charts, step by step, as an external host sees them.
#include "manual_items.h"

#include <optional>

using namespace lds::emulator;
using namespace lds::catalog;
using namespace lds::test;

namespace {

constexpr int lineTakenMs = 3; ///< A level of IN1 is taken after 2 ms (§4.6.2), and a sample follows.
constexpr Value indeterminate = -9'999'999;

enum class TriggerBy { Communication, Line };

/// One step of a timing chart: the workpiece comes to stand somewhere, then the trigger is switched.
struct Step {
    Value place;
    bool trigger;
    Value shown;
    bool holding;
};

} // namespace

class ManualHoldTest : public SensorFixture {
    Q_OBJECT

private Q_SLOTS:
    void init();

    void timingChart_data();
    void timingChart();
    void aTriggerShorterThan2MsIsNotTaken();
    void lineAndCommunicationAreToldApart();

    void aHeldExtremeIsInitializedByWhatTheManualLists_data();
    void aHeldExtremeIsInitializedByWhatTheManualLists();
    void aHeldValueIsReleasedByWhatTheManualLists_data();
    void aHeldValueIsReleasedByWhatTheManualLists();

    void aHoldModeAllowsTriggerModeHoldOnly_data();
    void aHoldModeAllowsTriggerModeHoldOnly();
    void noHoldModeAllowsBothTriggerModes();
    void aHoldModeTurnsOneShotIntoHold_data();
    void aHoldModeTurnsOneShotIntoHold();
    void aChangedTriggerModeClearsTheTriggerAndTheValue_data();
    void aChangedTriggerModeClearsTheTriggerAndTheValue();

private:
    void setTrigger(TriggerBy by, bool on);
};

void ManualHoldTest::init()
{
    setUp();
    QVERIFY(write(ItemId::AverageTimes, 0)); // every sample shows
}

void ManualHoldTest::setTrigger(TriggerBy by, bool on)
{
    if (by == TriggerBy::Communication)
        QVERIFY(write(ItemId::TriggerInputCommunication, on));
    else
        m_sensor->setExternalTrigger(on);
    m_clock->advanceMs(lineTakenMs);
}

void ManualHoldTest::timingChart_data()
{
    QTest::addColumn<int>("holdMode");
    QTest::addColumn<int>("triggerMode");
    QTest::addColumn<int>("by");
    QTest::addColumn<QList<Step>>("steps");

    const QList<Step> hold{{100, false, 100, false}, {200, false, 200, false}, {200, true, 200, true},
                           {700, true, 200, true},   {-300, true, 200, true},  {-300, false, -300, false},
                           {400, false, 400, false}};
    // Updated at each rising edge only, and held between them.
    const QList<Step> oneShot{{100, false, indeterminate, false},
                              {200, true, 200, true},
                              {300, true, 200, true},
                              {300, false, 200, true},
                              {400, false, 200, true},
                              {400, true, 400, true},
                              {500, true, 400, true},
                              {500, false, 400, true}};
    const QList<Step> peak{{100, false, 100, false}, {300, false, 300, false}, {200, false, 300, false},
                           {200, true, 300, true},   {900, true, 300, true},   {150, true, 300, true},
                           {150, false, 150, false}, {180, false, 180, false}, {160, false, 180, false}};
    const QList<Step> bottom{{100, false, 100, false}, {-300, false, -300, false}, {200, false, -300, false},
                             {200, true, -300, true},  {-900, true, -300, true},   {150, true, -300, true},
                             {150, false, 150, false}, {120, false, 120, false},   {160, false, 120, false}};
    const QList<Step> peakToPeak{{100, false, 0, false}, {300, false, 200, false}, {-50, false, 350, false},
                                 {-50, true, 350, true}, {900, true, 350, true},   {150, true, 350, true},
                                 {150, false, 0, false}, {180, false, 30, false},  {160, false, 30, false}};
    for (const TriggerBy by : {TriggerBy::Communication, TriggerBy::Line}) {
        const char* how = by == TriggerBy::Line ? "line" : "communication";
        QTest::addRow("none, hold, by %s", how) << 0 << 0 << int(by) << hold;
        QTest::addRow("none, one shot, by %s", how) << 0 << 1 << int(by) << oneShot;
        QTest::addRow("peak, by %s", how) << 1 << 0 << int(by) << peak;
        QTest::addRow("bottom, by %s", how) << 2 << 0 << int(by) << bottom;
        QTest::addRow("peak to peak, by %s", how) << 3 << 0 << int(by) << peakToPeak;
    }
}

void ManualHoldTest::timingChart()
{
    QFETCH(int, holdMode);
    QFETCH(int, triggerMode);
    QFETCH(int, by);
    QFETCH(QList<Step>, steps);
    m_sensor->placeWorkpiece(steps.first().place);
    QVERIFY(write(ItemId::HoldMode, holdMode));
    QVERIFY(write(ItemId::TriggerMode, triggerMode));
    for (qsizetype i = 0; i < steps.size(); ++i) {
        const Step& step = steps.at(i);
        const QByteArray where = "step " + QByteArray::number(i);
        m_sensor->placeWorkpiece(step.place);
        setTrigger(TriggerBy(by), step.trigger);
        QVERIFY2(value() == step.shown, where + " shows " + QByteArray::number(value()));
        QVERIFY2(m_sensor->coil(Hold) == step.holding, where);
        QVERIFY2(m_sensor->read(ItemId::HoldState) == step.holding, where);
    }
}

void ManualHoldTest::aTriggerShorterThan2MsIsNotTaken()
{
    QVERIFY(write(ItemId::TriggerMode, 1)); // One Shot: a pulse that is taken stays to be seen
    m_sensor->placeWorkpiece(100);
    setTrigger(TriggerBy::Line, true);
    setTrigger(TriggerBy::Line, false);
    m_sensor->placeWorkpiece(200);
    m_sensor->setExternalTrigger(true);
    m_clock->advanceMs(1);
    m_sensor->setExternalTrigger(false);
    m_clock->advanceMs(lineTakenMs);
    QCOMPARE(value(), 100);
    m_sensor->setExternalTrigger(true);
    m_clock->advanceMs(2);
    m_sensor->setExternalTrigger(false);
    m_clock->advanceMs(lineTakenMs);
    QCOMPARE(value(), 200);
}

void ManualHoldTest::lineAndCommunicationAreToldApart()
{
    setTrigger(TriggerBy::Line, true);
    QCOMPARE(readNow(ItemId::TriggerInputExternal), 1);
    QCOMPARE(readNow(ItemId::TriggerInputCommunication), 0);
    setTrigger(TriggerBy::Line, false);
    setTrigger(TriggerBy::Communication, true);
    QCOMPARE(readNow(ItemId::TriggerInputExternal), 0);
    QCOMPARE(readNow(ItemId::TriggerInputCommunication), 1);
}

void ManualHoldTest::aHeldExtremeIsInitializedByWhatTheManualLists_data()
{
    QTest::addColumn<int>("holdMode");
    QTest::addColumn<int>("item");
    QTest::addColumn<int>("written");
    for (int mode = 1; mode <= 3; ++mode) {
        QTest::addRow("mode %d, trigger OFF", mode) << mode << int(ItemId::TriggerInputCommunication) << 0;
        QTest::addRow("mode %d, resetting", mode) << mode << int(ItemId::MeasuredValueResetting) << 0;
        QTest::addRow("mode %d, average times", mode) << mode << int(ItemId::AverageTimes) << 1;
        QTest::addRow("mode %d, all areas", mode) << mode << int(ItemId::SettingsInitialization) << 6;
    }
}

void ManualHoldTest::aHeldExtremeIsInitializedByWhatTheManualLists()
{
    QFETCH(int, holdMode);
    QFETCH(int, item);
    QFETCH(int, written);
    QVERIFY(write(ItemId::HoldMode, holdMode));
    m_sensor->placeWorkpiece(-800);
    m_sensor->placeWorkpiece(800);
    m_sensor->placeWorkpiece(50);
    setTrigger(TriggerBy::Communication, true);
    const Value held = value();
    QCOMPARE(held, holdMode == 1 ? 800 : holdMode == 2 ? -800 : 1'600);
    QVERIFY(write(ItemId(item), written));
    QVERIFY(write(ItemId::TriggerInputCommunication, 0));
    m_sensor->placeWorkpiece(50);
    // Only what came after counts; "All Areas" has taken the hold mode back as well.
    QCOMPARE(value(), holdMode == 3 && item != int(ItemId::SettingsInitialization) ? 0 : 50);
}

void ManualHoldTest::aHeldValueIsReleasedByWhatTheManualLists_data()
{
    QTest::addColumn<int>("triggerMode");
    QTest::addColumn<int>("item");
    QTest::addColumn<int>("written");
    for (int mode = 0; mode <= 1; ++mode) {
        QTest::addRow("mode %d, average times", mode) << mode << int(ItemId::AverageTimes) << 1;
        QTest::addRow("mode %d, bank", mode) << mode << int(ItemId::BankSwitching) << 2;
        QTest::addRow("mode %d, all areas", mode) << mode << int(ItemId::SettingsInitialization) << 6;
    }
}

void ManualHoldTest::aHeldValueIsReleasedByWhatTheManualLists()
{
    QFETCH(int, triggerMode);
    QFETCH(int, item);
    QFETCH(int, written);
    QVERIFY(write(ItemId::TriggerMode, triggerMode));
    m_sensor->placeWorkpiece(100);
    setTrigger(TriggerBy::Communication, true);
    QCOMPARE(value(), 100);
    QVERIFY(m_sensor->coil(Hold));
    QVERIFY(write(ItemId(item), written));
    QVERIFY(m_sensor->coil(Indeterminate));
    QCOMPARE(value(), indeterminate);
}

void ManualHoldTest::aHoldModeAllowsTriggerModeHoldOnly_data()
{
    QTest::addColumn<int>("holdMode");
    QTest::newRow("peak") << 1;
    QTest::newRow("bottom") << 2;
    QTest::newRow("peak to peak") << 3;
}

void ManualHoldTest::aHoldModeAllowsTriggerModeHoldOnly()
{
    QFETCH(int, holdMode);
    QVERIFY(write(ItemId::HoldMode, holdMode));
    QCOMPARE(m_sensor->write({{ItemId::TriggerMode, 1}}).refusal, Refusal::Data);
    QCOMPARE(readNow(ItemId::TriggerMode), 0);
    QVERIFY(write(ItemId::TriggerMode, 0));
}

void ManualHoldTest::noHoldModeAllowsBothTriggerModes()
{
    for (const Value mode : {1, 0, 1}) {
        QVERIFY(write(ItemId::TriggerMode, mode));
        QCOMPARE(readNow(ItemId::TriggerMode), mode);
    }
}

void ManualHoldTest::aHoldModeTurnsOneShotIntoHold_data() { aHoldModeAllowsTriggerModeHoldOnly_data(); }

void ManualHoldTest::aHoldModeTurnsOneShotIntoHold()
{
    QFETCH(int, holdMode);
    QVERIFY(write(ItemId::TriggerMode, 1));
    QVERIFY(write(ItemId::HoldMode, holdMode));
    QCOMPARE(readNow(ItemId::HoldMode), holdMode);
    QCOMPARE(readNow(ItemId::TriggerMode), 0);
}

void ManualHoldTest::aChangedTriggerModeClearsTheTriggerAndTheValue_data()
{
    QTest::addColumn<int>("from");
    QTest::newRow("Hold to One Shot") << 0;
    QTest::newRow("One Shot to Hold") << 1;
}

void ManualHoldTest::aChangedTriggerModeClearsTheTriggerAndTheValue()
{
    QFETCH(int, from);
    QVERIFY(write(ItemId::TriggerMode, from));
    QVERIFY(write(ItemId::AverageTimes, 2)); // with one sample, the next would be there at once
    m_sensor->placeWorkpiece(100);
    setTrigger(TriggerBy::Communication, true);
    QCOMPARE(value(), 100);
    QVERIFY(write(ItemId::TriggerMode, 1 - from));
    QCOMPARE(m_sensor->read(ItemId::TriggerInputCommunication), 0);
    QVERIFY(m_sensor->coil(Indeterminate));
    QCOMPARE(m_sensor->read(ItemId::MeasuredValue), indeterminate);
}

QTEST_GUILESS_MAIN(ManualHoldTest)
#include "tst_manual_hold.moc"
