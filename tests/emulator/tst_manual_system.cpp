// §4.8.1, §4.8.6, §4.12 and §4.13 at the sensor: display digit, set value initialization, key lock, range.
#include "manual_items.h"

using namespace lds::emulator;
using namespace lds::catalog;
using namespace lds::test;

class ManualSystemTest : public SensorFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }

    void displayDigitChangesNothingThatIsMeasured();
    void setValueInitializationSparesCommunicationOnly_data() { addRows(settingsChangedAlone()); }
    void setValueInitializationSparesCommunicationOnly();
    void setValueInitializationLeavesTheAddress();
    void setValueInitializationTakesTheInputPolarityBack();
    void keyLockDoesNotStopCommunication();
    void outsideTheRangeIsToldByTheRawValueOfTheType_data();
    void outsideTheRangeIsToldByTheRawValueOfTheType();
};

void ManualSystemTest::displayDigitChangesNothingThatIsMeasured()
{
    QVERIFY(write(ItemId::HighSetValue, 12'344));
    for (const Value digit : {3, 2, 1, 0}) {
        QVERIFY(write(ItemId::DisplayDigit, digit));
        m_sensor->placeWorkpiece(12'345);
        QCOMPARE(value(), 12'345);
        QVERIFY(m_sensor->coil(TimerOffHigh)); // by the digits that are not displayed
        QCOMPARE(readNow(ItemId::HighSetValue), 12'344);
    }
}

void ManualSystemTest::setValueInitializationSparesCommunicationOnly()
{
    QFETCH(int, item);
    const SettingItem& setting = hlG2(ItemId(item));
    const Value standard = readNow(setting.id);
    const Value changed = otherThanDefault(setting, m_sensor->model());
    QVERIFY(write(setting.id, changed));
    QVERIFY(write(ItemId::SetValueSaving, 0));
    m_sensor->initializeSetValues();
    const bool spared = setting.effect == Effect::AfterCommunicationReset;
    QCOMPARE(readNow(setting.id), spared ? changed : standard);
    m_sensor->powerCycle();
    QCOMPARE(readNow(setting.id), spared ? changed : standard);
}

void ManualSystemTest::setValueInitializationLeavesTheAddress()
{
    QVERIFY(!m_sensor->write(anotherNetwork()).refusal);
    QVERIFY(write(ItemId::SetValueSaving, 0));
    m_sensor->initializeSetValues();
    for (const ItemWrite& each : anotherNetwork())
        QCOMPARE(readNow(each.item), each.value);
}

void ManualSystemTest::setValueInitializationTakesTheInputPolarityBack()
{
    const InputPolarity standard = m_sensor->memory().inputPolarity();
    m_sensor->setInputPolarity(InputPolarity::Pnp);
    QVERIFY(m_sensor->memory().inputPolarity() != standard);
    QVERIFY(write(ItemId::SettingsInitialization, 6)); // All Areas spares it
    QCOMPARE(m_sensor->memory().inputPolarity(), InputPolarity::Pnp);
    m_sensor->initializeSetValues();
    QCOMPARE(m_sensor->memory().inputPolarity(), standard);
}

void ManualSystemTest::keyLockDoesNotStopCommunication()
{
    QVERIFY(write(ItemId::KeyLock, 1));
    QVERIFY(m_sensor->isReady());
    QVERIFY(write(ItemId::Offset, 5));
    QCOMPARE(readNow(ItemId::Offset), 5);
    QVERIFY(write(ItemId::ZeroSetting, 1));
    QVERIFY(write(ItemId::KeyLock, 0));
    QCOMPARE(readNow(ItemId::KeyLock), 0);
}

void ManualSystemTest::outsideTheRangeIsToldByTheRawValueOfTheType_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<int>("range");
    // §4.13, in 0.1 µm
    QTest::newRow("30 mm") << int(SensorModel::HlG203) << 50'000;
    QTest::newRow("50 mm") << int(SensorModel::HlG205) << 100'000;
    QTest::newRow("85 mm") << int(SensorModel::HlG208) << 200'000;
    QTest::newRow("120 mm") << int(SensorModel::HlG212) << 300'000;
    QTest::newRow("250 mm") << int(SensorModel::HlG225) << 1'500'000;
}

void ManualSystemTest::outsideTheRangeIsToldByTheRawValueOfTheType()
{
    QFETCH(int, model);
    QFETCH(int, range);
    make(SensorModel(model));
    QVERIFY(write(ItemId::Span, 1'000)); // the measured value stays well inside
    for (const auto& [place, outside] : QList<std::pair<Value, bool>>{
             {range, false}, {range + 1, true}, {-range, false}, {-range - 1, true}}) {
        m_sensor->placeWorkpiece(place);
        m_sensor->catchUp();
        QCOMPARE(m_sensor->coil(OutsideRange), outside);
        QCOMPARE(m_sensor->coil(Notification), outside);
    }
}

QTEST_GUILESS_MAIN(ManualSystemTest)
#include "tst_manual_system.moc"
