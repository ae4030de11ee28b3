// The catalog as scripts see it: addresses as the manual prints them, codes and English names.

#include "item_json.h"

#include <QTest>

using namespace lds::ctl;
using namespace Qt::StringLiterals;

namespace {

QJsonObject item(const QString& key)
{
    const QJsonArray all = catalogJson(lds::catalog::Catalog::hlG2());
    for (const auto& each : all) {
        if (each.toObject().value(u"key"_s) == key)
            return each.toObject();
    }
    return {};
}

} // namespace

class TestCatalogJson : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void listsEveryItemOnce()
    {
        const QJsonArray all = catalogJson(lds::catalog::Catalog::hlG2());
        QCOMPARE(all.size(), 70);
        int modbus = 0, slmp = 0, eip = 0;
        for (const auto& each : all) {
            modbus += each.toObject().value(u"modbus"_s).isDouble() ? 1 : 0;
            slmp += each.toObject().value(u"slmp"_s).isDouble() ? 1 : 0;
            eip += each.toObject().value(u"eip"_s).isDouble() ? 1 : 0;
        }
        QCOMPARE(modbus, 66);
        QCOMPARE(slmp, 48);
        QCOMPARE(eip, 46);
    }

    void aSettingIsDescribedInFull()
    {
        const QJsonObject high = item(u"highSetValue"_s);
        QCOMPARE(high.value(u"menu"_s), 31);
        QCOMPARE(high.value(u"name"_s), u"HIGH set value"_s);
        QCOMPARE(high.value(u"section"_s), u"4.4.1"_s);
        QCOMPARE(high.value(u"role"_s), u"setting"_s);
        QCOMPARE(high.value(u"kind"_s), u"length"_s);
        QCOMPARE(high.value(u"scope"_s), u"bank"_s);
        QCOMPARE(high.value(u"effect"_s), u"atOnce"_s);
        QCOMPARE(high.value(u"size"_s), 4);
        QCOMPARE(high.value(u"access"_s), u"RW"_s);
        QCOMPARE(high.value(u"modbus"_s), 400101);
        QCOMPARE(high.value(u"slmp"_s), 100);
        QCOMPARE(high.value(u"eip"_s), 2318);
        QCOMPARE(high.value(u"unit"_s), u"mm"_s);
        QCOMPARE(high.value(u"limits"_s).toObject().value(u"HL-G225B-S-MK"_s).toObject(),
                 QJsonObject({{u"minimum"_s, -9'500'000},
                              {u"maximum"_s, 9'500'000},
                              {u"default"_s, 1'500'000},
                              {u"resolution"_s, 100}}));
        QVERIFY(high.value(u"choices"_s).toArray().isEmpty());
    }

    void whatIsNotThereIsNull()
    {
        const QJsonObject intensity = item(u"peakIntensity"_s);
        QVERIFY(intensity.value(u"eip"_s).isNull());
        QVERIFY(intensity.value(u"menu"_s).isNull());
        QVERIFY(intensity.value(u"group"_s).isNull());
        const QJsonObject mac = item(u"macAddress"_s);
        QCOMPARE(mac.value(u"menu"_s), 78);
        for (const QString& name : {u"modbus"_s, u"slmp"_s, u"eip"_s, u"access"_s, u"size"_s})
            QVERIFY2(mac.value(name).isNull(), qPrintable(name));
        QVERIFY(item(u"setValueSaving"_s)
                    .value(u"limits"_s)
                    .toObject()
                    .value(u"HL-G203B-S-MK"_s)
                    .toObject()
                    .value(u"default"_s)
                    .isNull());
    }

    void choicesNameTheirTypes()
    {
        const QJsonArray digits = item(u"displayDigit"_s).value(u"choices"_s).toArray();
        QCOMPARE(digits.size(), 5);
        const QJsonObject four = digits.first().toObject();
        QCOMPARE(four.value(u"code"_s), 0);
        QCOMPARE(four.value(u"name"_s), u"4 digits (0.0001)"_s);
        QCOMPARE(four.value(u"models"_s).toArray(), QJsonArray({u"HL-G203B-S-MK"_s}));
        QCOMPARE(item(u"span"_s).value(u"unit"_s), u"×"_s);
        QCOMPARE(item(u"ipAddress2ndOctet"_s).value(u"group"_s), u"ipAddress"_s);
        QCOMPARE(item(u"portModbus"_s).value(u"effect"_s), u"afterCommunicationReset"_s);
    }
};

QTEST_GUILESS_MAIN(TestCatalogJson)
#include "tst_catalog_json.moc"
