// KEY=VALUE: which item it means and what goes on the wire for it.

#include "assignment.h"
#include "value_report.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QTest>

using namespace lds::ctl;
using namespace Qt::StringLiterals;
using lds::catalog::ItemId;
using lds::catalog::SensorModel;

namespace {

/// Effective wire values joined by spaces, or the error.
QString valuesOf(const QString& argument, SensorModel model = SensorModel::HlG203)
{
    const auto assignments = parseAssignments({argument});
    if (!assignments)
        return assignments.error();
    const auto values = readValues(assignments->first(), model);
    if (!values)
        return values.error();
    QStringList words;
    for (const WantedValue& value : *values)
        words += QString::number(value.effective);
    return words.join(u' ');
}

Target targetOf(const char* key) { return *findTarget(QString::fromLatin1(key)); }

} // namespace

class TestAssignments : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void textBecomesWireUnits_data()
    {
        QTest::addColumn<QString>("argument");
        QTest::addColumn<QString>("wire");
        QTest::newRow("length") << u"highSetValue=1.75"_s << u"17500"_s;
        QTest::newRow("negative") << u"lowSetValue=-0.0001"_s << u"-1"_s;
        QTest::newRow("with unit") << u"offset=2 mm"_s << u"20000"_s;
        QTest::newRow("factor") << u"span=1.5"_s << u"15000"_s;
        QTest::newRow("count") << u"alarmDelayCount=65535"_s << u"65535"_s;
        QTest::newRow("choice code") << u"samplingFrequency=1"_s << u"1"_s;
        QTest::newRow("choice name") << u"samplingFrequency=200 µs"_s << u"1"_s;
        QTest::newRow("name in any case") << u"holdMode=PEAK HOLD"_s << u"1"_s;
        QTest::newRow("name without brackets") << u"laserStop=on"_s << u"1"_s;
        QTest::newRow("command") << u"setValueSaving=0"_s << u"0"_s;
        QTest::newRow("address") << u"ipAddress=10.1.2.3"_s << u"10 1 2 3"_s;
        QTest::newRow("octet") << u"ipAddress4thOctet=9"_s << u"9"_s;
    }

    void textBecomesWireUnits()
    {
        QFETCH(QString, argument);
        QFETCH(QString, wire);
        QCOMPARE(valuesOf(argument), wire);
    }

    void wrongTextIsNamed_data()
    {
        QTest::addColumn<QString>("argument");
        QTest::addColumn<QString>("named");
        QTest::newRow("no value sign") << u"highSetValue"_s << u"KEY=VALUE"_s;
        QTest::newRow("no key") << u"=1"_s << u"KEY=VALUE"_s;
        QTest::newRow("slip of a letter") << u"higSetValue=1"_s << u"did you mean “highSetValue”"_s;
        QTest::newRow("wrong case") << u"HIGHSETVALUE=1"_s << u"did you mean “highSetValue”"_s;
        QTest::newRow("beginning") << u"hyst=1"_s << u"did you mean “hysteresis”"_s;
        QTest::newRow("group") << u"ipAdress=1.2.3.4"_s << u"did you mean “ipAddress”"_s;
        QTest::newRow("nothing like it")
            << u"qqqqqqqqqq=1"_s << u"unknown key “qqqqqqqqqq”; “ldsctl catalog”"_s;
        QTest::newRow("reported") << u"measuredValue=1"_s << u"the sensor reports it"_s;
        QTest::newRow("keypad only") << u"portSlmp=1"_s << u"menu 76"_s;
        QTest::newRow("no number") << u"span=abc"_s << u"“abc” is not a number"_s;
        QTest::newRow("out of range") << u"highSetValue=9.5001"_s << u"out of range"_s;
        QTest::newRow("no such choice") << u"samplingFrequency=300 µs"_s << u"0 = 100 µs, 1 = 200 µs"_s;
        QTest::newRow("choice of another type") << u"displayDigit=4"_s << u"choose one of 0 = 4 digits"_s;
        QTest::newRow("command takes 0") << u"setValueSaving=1"_s << u"only 0"_s;
        QTest::newRow("three numbers") << u"ipAddress=10.1.2"_s << u"four numbers"_s;
        QTest::newRow("number of an address") << u"ipAddress=10.1.2.256"_s << u"out of range"_s;
        QTest::newRow("empty") << u"span="_s << u"nothing is entered"_s;
    }

    void wrongTextIsNamed()
    {
        QFETCH(QString, argument);
        QFETCH(QString, named);
        const QString error = valuesOf(argument);
        QVERIFY2(error.contains(named), qPrintable(error));
    }

    void limitsAreThoseOfTheType()
    {
        QCOMPARE(valuesOf(u"highSetValue=95"_s, SensorModel::HlG205), u"950000"_s);
        QVERIFY(valuesOf(u"highSetValue=95"_s, SensorModel::HlG203).contains(u"out of range"));
        QCOMPARE(valuesOf(u"displayDigit=0 digits"_s, SensorModel::HlG205), u"4"_s);
    }

    void digitsBelowTheResolutionAreRoundedDown() // §1.4
    {
        const auto assignments = parseAssignments({u"highSetValue=1.2345"_s});
        QVERIFY(assignments);
        const auto values = readValues(assignments->first(), SensorModel::HlG225);
        QVERIFY(values);
        QCOMPARE(values->first().written, 12345);
        QCOMPARE(values->first().effective, 12300);
    }

    void aKeyIsSetOnce()
    {
        QVERIFY(!parseAssignments({u"span=1"_s, u"span=2"_s}));
        QVERIFY(!parseAssignments({u"ipAddress=10.1.2.3"_s, u"ipAddress4thOctet=4"_s}));
        QVERIFY(parseAssignments({u"span=1"_s, u"offset=2"_s}));
    }

    void everyGroupIsAKeyWithTheFirstOctetFirst()
    {
        QCOMPARE(targetOf("ipAddress").items, QList({ItemId::IpAddress1stOctet, ItemId::IpAddress2ndOctet,
                                                     ItemId::IpAddress3rdOctet, ItemId::IpAddress4thOctet}));
        QCOMPARE(targetOf("subnetMask").items.first(), ItemId::SubnetMask1stOctet);
        QCOMPARE(targetOf("defaultGateway").items.last(), ItemId::DefaultGateway4thOctet);
        QCOMPARE(groupKeyOf(ItemId::SubnetMask3rdOctet), u"subnetMask"_s);
        QCOMPARE(groupKeyOf(ItemId::Span), QString());
    }

    void valuesAreWordsAndWireIntegers()
    {
        const lds::settings::Values values{{ItemId::HighSetValue, 17500},
                                           {ItemId::SamplingFrequency, 3},
                                           {ItemId::MeasuredValue, lds::catalog::sentinel::alarm},
                                           {ItemId::SensorState, 0x0448}};
        const auto words = [&values](const char* key) {
            return valueWords(targetOf(key), SensorModel::HlG203, values);
        };
        QCOMPARE(words("highSetValue"), u"+1.7500"_s);
        QCOMPARE(words("samplingFrequency"), u"1 ms"_s);
        QCOMPARE(words("measuredValue"), u"alarm"_s);
        QCOMPARE(words("sensorState"), u"0x0448"_s);
        QCOMPARE(words("span"), QString());
        QCOMPARE(unitOf(targetOf("highSetValue"), values), u"mm"_s);
        QCOMPARE(unitOf(targetOf("measuredValue"), values), QString());
        const QJsonObject json = valueJson(targetOf("highSetValue"), SensorModel::HlG203, values).toObject();
        QCOMPARE(json, QJsonObject({{u"value"_s, 17500}, {u"text"_s, u"+1.7500"_s}, {u"unit"_s, u"mm"_s}}));
        QVERIFY(valueJson(targetOf("ipAddress"), SensorModel::HlG203, values).isNull());
    }

    void measuredValueSentinelsAreWords_data()
    {
        QTest::addColumn<int>("value");
        QTest::addColumn<QString>("word");
        QTest::newRow("over") << 9'600'000 << u"over"_s;
        QTest::newRow("under") << -9'600'000 << u"under"_s;
        QTest::newRow("indeterminate") << -9'999'999 << u"indeterminate"_s;
        QTest::newRow("alarm") << 9'999'999 << u"alarm"_s;
        QTest::newRow("value") << 9'599'999 << QString();
    }

    void measuredValueSentinelsAreWords()
    {
        QFETCH(int, value);
        QFETCH(QString, word);
        QCOMPARE(sentinelWord(value), word);
    }
};

QTEST_GUILESS_MAIN(TestAssignments)
#include "tst_assignments.moc"
