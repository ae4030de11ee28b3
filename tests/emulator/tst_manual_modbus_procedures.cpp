// §4.3.3, §4.9 "using external communication", byte by byte over the registers of §5.2.4.
#include "manual_items.h"
#include "modbus_responder.h"

using namespace lds::emulator;
using namespace lds::catalog;
using namespace lds::test;

namespace {

QByteArray hex(const char* text) { return QByteArray::fromHex(text); }

} // namespace

class ManualModbusProceduresTest : public SensorFixture {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { m_responder.reset(); }

    void teachingByItsRegisters();
    void teachingThatFailsByItsRegisters();
    void teachingIsInterruptedByItsRegister();
    void teachingThatCannotStartIsOtherError();
    void brightnessTuningByItsRegisters();
    void brightnessTuningThatFailsByItsRegisters();
    void brightnessTuningThatCannotStartIsOtherError();
    void neitherRunsAwayFromTheMeasurementDisplay();

private:
    /// What is answered to the request, both as hexadecimal text.
    QByteArray ask(const char* request) { return m_responder->answer(hex(request)).toHex(); }
    bool isEchoed(const char* request) { return ask(request) == hex(request).toHex(); }

    static constexpr auto teachingState = "03 0084 0001"; // 400133
    static constexpr auto tuningState = "03 008f 0001";   // 400144

    std::unique_ptr<ModbusResponder> m_responder;
};

void ManualModbusProceduresTest::init()
{
    setUp();
    m_responder = std::make_unique<ModbusResponder>(*m_sensor);
}

void ManualModbusProceduresTest::teachingByItsRegisters()
{
    QVERIFY(isEchoed("06 0085 0003")); // 400134 teaching mode: 3 points
    QCOMPARE(ask(teachingState), "03020000");
    QVERIFY(isEchoed("06 0087 0001")); // 400136 start
    QCOMPARE(ask(teachingState), "03020001");
    m_sensor->placeWorkpiece(4'000);
    QVERIFY(isEchoed("06 0089 0000")); // 400138 1st point
    QCOMPARE(ask(teachingState), "03020001");
    m_sensor->placeWorkpiece(-2'000);
    QVERIFY(isEchoed("06 008b 0000")); // 400140 2nd point
    QCOMPARE(ask(teachingState), "03020001");
    m_sensor->placeWorkpiece(1'000);
    QVERIFY(isEchoed("06 008d 0000")); // 400142 3rd point
    QCOMPARE(ask(teachingState), "03020002");
    QCOMPARE(ask("03 0064 0004"), "030809c40000fe0cffff"); // HIGH 2,500, LOW −500
}

void ManualModbusProceduresTest::teachingThatFailsByItsRegisters()
{
    QVERIFY(isEchoed("06 0085 0002"));
    QVERIFY(isEchoed("06 0087 0001"));
    m_sensor->placeWorkpiece(4'000);
    QVERIFY(isEchoed("06 0089 0000"));
    QVERIFY(isEchoed("06 008b 0000")); // the same value
    QCOMPARE(ask(teachingState), "03020003");
    QCOMPARE(ask("03 0064 0004"), "0308c35000003cb0ffff"); // HIGH and LOW as they were
    QVERIFY(isEchoed("06 0087 0001"));                     // again
    QCOMPARE(ask(teachingState), "03020001");
}

void ManualModbusProceduresTest::teachingIsInterruptedByItsRegister()
{
    QVERIFY(isEchoed("06 0087 0001"));
    QVERIFY(isEchoed("06 0087 0000"));
    QCOMPARE(ask(teachingState), "03020000");
    QCOMPARE(ask("06 0089 0000"), "8604"); // there is no point to take any more
}

void ManualModbusProceduresTest::teachingThatCannotStartIsOtherError()
{
    QVERIFY(isEchoed("06 0072 0001")); // hold mode: peak
    QCOMPARE(ask("06 0087 0001"), "8604");
    QCOMPARE(ask(teachingState), "03020000");
}

void ManualModbusProceduresTest::brightnessTuningByItsRegisters()
{
    QCOMPARE(ask(tuningState), "03020000");
    QVERIFY(isEchoed("06 007d 0001")); // 400126 ON
    QCOMPARE(ask(tuningState), "03020001");
    QVERIFY(isEchoed("06 0091 0000")); // 400146 1st point
    m_clock->advanceMs(averageFullMs);
    QCOMPARE(ask(tuningState), "03020002");
    QVERIFY(isEchoed("06 0093 0000")); // 400148 2nd point
    m_clock->advanceMs(averageFullMs);
    QCOMPARE(ask(tuningState), "03020003");
    QCOMPARE(ask("03 007d 0001"), "03020001");
}

void ManualModbusProceduresTest::brightnessTuningThatFailsByItsRegisters()
{
    QVERIFY(isEchoed("06 007d 0001"));
    m_sensor->setFault(SensorFault::NoLight, true);
    m_clock->advanceMs(averageFullMs);
    QVERIFY(isEchoed("06 0091 0000"));
    QCOMPARE(ask(tuningState), "03020004");
    m_sensor->setFault(SensorFault::NoLight, false);
    m_clock->advanceMs(averageFullMs);
    QVERIFY(isEchoed("06 007d 0001")); // again
    QCOMPARE(ask(tuningState), "03020001");
}

void ManualModbusProceduresTest::brightnessTuningThatCannotStartIsOtherError()
{
    QVERIFY(isEchoed("06 0072 0003")); // hold mode: peak to peak
    QCOMPARE(ask("06 007d 0001"), "8604");
    QCOMPARE(ask(tuningState), "03020000");
}

void ManualModbusProceduresTest::neitherRunsAwayFromTheMeasurementDisplay()
{
    m_sensor->setInMenu(true);
    for (const char* request : {"06 0087 0001", "06 007d 0001", "06 0089 0000", "06 0091 0000"})
        QCOMPARE(ask(request), "8604");
    m_sensor->setInMenu(false);
    QCOMPARE(ask(teachingState), "03020000");
    QCOMPARE(ask(tuningState), "03020000");
    QCOMPARE(ask("03 007d 0001"), "03020000");
}

QTEST_GUILESS_MAIN(ManualModbusProceduresTest)
#include "tst_manual_modbus_procedures.moc"
