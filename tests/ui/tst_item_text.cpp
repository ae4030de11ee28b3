#include "item_text.h"

#include <QTest>

using namespace lds;
using namespace lds::ui;
using namespace Qt::StringLiterals;
using catalog::ItemId;
using catalog::SensorModel;

class ItemTextTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyItemChoiceMenuAndCoilHasAName()
    {
        const auto& all = catalog::Catalog::hlG2();
        for (const auto& item : all.items()) {
            QVERIFY2(!itemName(item).isEmpty(), item.key);
            QVERIFY2(!itemHelp(item).isEmpty(), item.key);
            for (const auto& choice : item.choices)
                QVERIFY2(!choiceName(choice).isEmpty(), item.key);
        }
        for (const auto& entry : all.menu())
            QVERIFY(!menuName(entry).isEmpty());
        for (const auto& coil : all.coils())
            QCOMPARE(coilName(coil).isEmpty(), coil.reserved());
    }

    void lengthsHaveTheTypesDecimalsAndATrueMinusSign()
    {
        const auto& low = catalog::hlG2(ItemId::LowSetValue);
        QCOMPARE(displayValue(low, SensorModel::HlG203, -50'000), u"\u22125.0000"_s);
        QCOMPARE(displayValue(low, SensorModel::HlG208, -50'000), u"\u22125.000"_s);
        QCOMPARE(displayValueWithUnit(low, SensorModel::HlG203, 17'500), u"+1.7500\u00a0mm"_s);
    }

    void aChoiceReadsAsItsNameAndAnUnknownCodeSaysSo()
    {
        const auto& mode = catalog::hlG2(ItemId::HoldMode);
        QCOMPARE(displayValue(mode, SensorModel::HlG203, 1), u"Peak Hold"_s);
        QCOMPARE(displayValue(mode, SensorModel::HlG203, 7), u"7 (unknown)"_s);
        QCOMPARE(displayValueWithUnit(mode, SensorModel::HlG203, 1), u"Peak Hold"_s);
    }

    void sentinelsReadAsOnTheSensorsDisplay() // §2.2, §5.2.4
    {
        const auto& value = catalog::hlG2(ItemId::MeasuredValue);
        const auto text = [&](catalog::Value v) {
            return displayValueWithUnit(value, SensorModel::HlG203, v);
        };
        QCOMPARE(text(catalog::sentinel::over), u"+OVER"_s);
        QCOMPARE(text(catalog::sentinel::under), u"\u2212OVER"_s);
        QCOMPARE(text(catalog::sentinel::indeterminate), u"----"_s);
        QCOMPARE(text(catalog::sentinel::alarm), u"ALARM"_s);
        QCOMPARE(displayValue(catalog::hlG2(ItemId::PeakIntensity), SensorModel::HlG203, 65535), u"----"_s);
    }

    void anErrorCodeReadsAsInTheManual() // §8.2
    {
        const auto& code = catalog::hlG2(ItemId::ErrorCode);
        QCOMPARE(displayValue(code, SensorModel::HlG203, 0x0100), u"E100**"_s);
        QCOMPARE(displayValue(code, SensorModel::HlG203, 0x0131), u"E131**"_s);
        QCOMPARE(displayValue(code, SensorModel::HlG203, 0), u"None"_s);
    }

    void bitsReadAsTheNamesOfThoseThatAreSet() // §5.2.5
    {
        const auto& notification = catalog::hlG2(ItemId::SelfMonitoringNotification);
        const auto& coils = catalog::Catalog::hlG2().coils();
        QCOMPARE(displayValue(notification, SensorModel::HlG203, 0b101),
                 coilName(coils[16]) + u", "_s + coilName(coils[18]));
        QCOMPARE(displayValue(notification, SensorModel::HlG203, 0xff00), u"None"_s); // reserved ones
    }

    void rangesFitTheTypeAndLongChoicesAreShortened()
    {
        QCOMPARE(rangeText(catalog::hlG2(ItemId::HighSetValue), SensorModel::HlG203),
                 u"\u22129.5000 \u2026 +9.5000"_s);
        QCOMPARE(rangeText(catalog::hlG2(ItemId::HighSetValue), SensorModel::HlG225),
                 u"\u2212950.00 \u2026 +950.00"_s);
        QCOMPARE(rangeText(catalog::hlG2(ItemId::SamplingFrequency), SensorModel::HlG203),
                 u"100 µs \u2026 2 ms"_s);
        const QString names = rangeText(catalog::hlG2(ItemId::HoldMode), SensorModel::HlG203);
        QVERIFY2(names.startsWith(u"None (Normal mode), Peak Hold"_s), qPrintable(names));
        QVERIFY2(names.size() <= 48, qPrintable(names));
        QVERIFY(rangeText(catalog::hlG2(ItemId::SetValueSaving), SensorModel::HlG203).isEmpty());
        QVERIFY(rangeText(catalog::hlG2(ItemId::MeasuredValue), SensorModel::HlG203).isEmpty());
    }

    void aTypesMissingChoicesAreNotInItsRange() // §5.2.4, 400111
    {
        const auto& digit = catalog::hlG2(ItemId::DisplayDigit);
        QVERIFY(rangeText(digit, SensorModel::HlG203) != rangeText(digit, SensorModel::HlG225));
    }

    void addressesReadAsWordsAndMissingOnesAreLeftOut()
    {
        QCOMPARE(addressTexts(catalog::hlG2(ItemId::LowSetValue)),
                 (QStringList{u"Modbus 400103, 2 registers"_s, u"EtherNet/IP 2319"_s, u"SLMP D102"_s}));
        QCOMPARE(addressTexts(catalog::hlG2(ItemId::PortModbus)), (QStringList{u"Modbus 400153"_s}));
        QVERIFY(addressTexts(catalog::hlG2(ItemId::MacAddress)).isEmpty());
    }

    void octetsReadAsAnAddress() { QCOMPARE(octetsText({192, 168, 1, 6}), u"192.168.1.6"_s); }
};

QTEST_GUILESS_MAIN(ItemTextTest)
#include "tst_item_text.moc"
