#include "value_text.h"

#include <QtTest>

#include <random>

using namespace lds::settings;
using namespace lds::catalog;

namespace {

const SettingItem& item(const QString& key)
{
    const SettingItem* found = Catalog::hlG2().findByKey(key);
    if (!found)
        qFatal("no item %s", qPrintable(key));
    return *found;
}

constexpr auto smallest = SensorModel::HlG203; // 0.1 µm
constexpr auto middle = SensorModel::HlG205;   // 1 µm
constexpr auto largest = SensorModel::HlG225;  // 10 µm

} // namespace

class ValueTextTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void valuesAreWrittenAsTheManualWritesThem_data();
    void valuesAreWrittenAsTheManualWritesThem();
    void aTrueMinusSignStandsOnScreensOnly();
    void choicesOfEveryItemGiveTheirCode();
    void errorCodesAreWrittenAsTheSensorShowsThem();
    void measuredLengthsAreCutOffNotRounded_data();
    void measuredLengthsAreCutOffNotRounded();
    void unitsAreSymbols();
    void whatAPersonTypesIsReadExactly_data();
    void whatAPersonTypesIsReadExactly();
    void whatIsNoValueSaysWhy_data();
    void whatIsNoValueSaysWhy();
    void aFailureNamesTheLimits();
    void digitsBelowTheResolutionAreRoundedTowardsZero_data();
    void digitsBelowTheResolutionAreRoundedTowardsZero();
    void everySettingOfEveryModelSurvivesTextAndBack();
    void noTextEverGivesAnIllegalValue();
};

void ValueTextTest::valuesAreWrittenAsTheManualWritesThem_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<SensorModel>("model");
    QTest::addColumn<int>("value");
    QTest::addColumn<QString>("text");

    QTest::newRow("§4.4.1 HIGH, 30 mm") << "highSetValue" << smallest << 50'000 << "+5.0000";
    QTest::newRow("§4.4.1 HIGH, 50 mm") << "highSetValue" << middle << 100'000 << "+10.000";
    QTest::newRow("§4.4.1 HIGH, 250 mm") << "highSetValue" << largest << 1'500'000 << "+150.00";
    QTest::newRow("§4.4.2 LOW") << "lowSetValue" << smallest << -50'000 << "-5.0000";
    QTest::newRow("below one") << "lowSetValue" << smallest << -1 << "-0.0001";
    QTest::newRow("finer than the resolution") << "highSetValue" << largest << 1'500'001 << "+150.0001";
    QTest::newRow("finer, negative") << "lowSetValue" << middle << -5 << "-0.0005";
    QTest::newRow("§4.3.7 Offset at its default") << "offset" << smallest << 0 << "0.0000";
    QTest::newRow("never negative, so no plus") << "hysteresis" << smallest << 100 << "0.0100";
    QTest::newRow("largest tolerance") << "tolerance" << largest << 9'500'000 << "950.00";
    QTest::newRow("§4.3.6 Span") << "span" << smallest << 10'000 << "1.0000";
    QTest::newRow("largest span") << "span" << largest << 99'999 << "9.9999";
    QTest::newRow("count") << "alarmDelayCount" << smallest << 65'535 << "65535";
    QTest::newRow("duration") << "outputDelayTimerSetting" << smallest << 100 << "100";
    QTest::newRow("port") << "portTool" << smallest << 49'152 << "49152";
    QTest::newRow("octet") << "ipAddress1stOctet" << smallest << 192 << "192";
    QTest::newRow("choice") << "holdMode" << smallest << 3 << "3";
    QTest::newRow("most negative number there is")
        << "lowSetValue" << smallest << std::numeric_limits<int>::min() << "-214748.3648";
}

void ValueTextTest::valuesAreWrittenAsTheManualWritesThem()
{
    QFETCH(QString, key);
    QFETCH(SensorModel, model);
    QFETCH(int, value);
    QTEST(valueText(item(key), model, value), "text");
}

void ValueTextTest::aTrueMinusSignStandsOnScreensOnly()
{
    const SettingItem& low = hlG2(ItemId::LowSetValue);
    QCOMPARE(valueText(low, smallest, -7'500, TextStyle::Typographic), QStringLiteral("\u22120.7500"));
    QCOMPARE(valueText(low, smallest, -7'500, TextStyle::Plain), QStringLiteral("-0.7500"));
    QCOMPARE(lengthText(-7'500, 3, TextStyle::Typographic), QStringLiteral("\u22120.750"));
}

void ValueTextTest::choicesOfEveryItemGiveTheirCode()
{
    int seen = 0;
    for (const SettingItem& each : Catalog::hlG2().items()) {
        for (const Choice& choice : each.choices) {
            QCOMPARE(valueText(each, smallest, choice.code), QString::number(choice.code));
            ++seen;
        }
    }
    QVERIFY(seen > 50);
}

void ValueTextTest::errorCodesAreWrittenAsTheSensorShowsThem()
{
    const SettingItem& errorCode = hlG2(ItemId::ErrorCode);
    QCOMPARE(valueText(errorCode, smallest, 0x0100), QStringLiteral("E100")); // §8.2
    QCOMPARE(valueText(errorCode, smallest, 0x0131), QStringLiteral("E131"));
    QCOMPARE(valueText(errorCode, smallest, 0), QStringLiteral("0"));
}

void ValueTextTest::measuredLengthsAreCutOffNotRounded_data()
{
    QTest::addColumn<int>("value");
    QTest::addColumn<int>("decimals");
    QTest::addColumn<QString>("text");

    QTest::newRow("all digits") << 12'345 << 4 << "+1.2345";
    QTest::newRow("§4.8.1 rounded down") << 12'349 << 3 << "+1.234";
    QTest::newRow("towards zero") << -12'349 << 3 << "-1.234";
    QTest::newRow("two") << 12'399 << 2 << "+1.23";
    QTest::newRow("one") << 12'999 << 1 << "+1.2";
    QTest::newRow("none, without a point") << -129'999 << 0 << "-12";
    QTest::newRow("zero is signed as well") << 0 << 4 << "+0.0000";
    QTest::newRow("no negative zero") << -9 << 3 << "+0.000";
    QTest::newRow("no negative zero without decimals") << -9'999 << 0 << "+0";
    QTest::newRow("below one") << 9 << 4 << "+0.0009";
    QTest::newRow("more decimals than there are") << 12'345 << 7 << "+1.2345";
    QTest::newRow("fewer than none") << 12'345 << -1 << "+1";
}

void ValueTextTest::measuredLengthsAreCutOffNotRounded()
{
    QFETCH(int, value);
    QFETCH(int, decimals);
    QTEST(lengthText(value, decimals), "text");
}

void ValueTextTest::unitsAreSymbols()
{
    QCOMPARE(unitText(hlG2(ItemId::HighSetValue)), QStringLiteral("mm"));
    QCOMPARE(unitText(hlG2(ItemId::OutputDelayTimerSetting)), QStringLiteral("ms"));
    QCOMPARE(unitText(hlG2(ItemId::Span)), QStringLiteral("\u00d7"));
    QCOMPARE(unitText(hlG2(ItemId::PortTool)), QString());
    QCOMPARE(unitText(hlG2(ItemId::HoldMode)), QString());
}

void ValueTextTest::whatAPersonTypesIsReadExactly_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("written");

    const auto row = [](const char* name, const char* key, const char* text, int written) {
        QTest::newRow(name) << QString::fromLatin1(key) << QString::fromUtf8(text) << written;
    };
    row("plain", "highSetValue", "1.75", 17'500);
    row("hyphen", "lowSetValue", "-1.75", -17'500);
    row("true minus", "lowSetValue", "\u22121.75", -17'500);
    row("plus", "highSetValue", "+1.75", 17'500);
    row("comma", "highSetValue", "1,75", 17'500);
    row("all decimals", "highSetValue", "9.4999", 94'999);
    row("without a point", "highSetValue", "9", 90'000);
    row("point at the end", "highSetValue", "9.", 90'000);
    row("point at the start", "highSetValue", ".5", 5'000);
    row("leading zeros", "highSetValue", "0001.5", 15'000);
    row("zeros beyond the wire unit say nothing new", "highSetValue", "1.750000", 17'500);
    row("minus zero", "offset", "-0", 0);
    row("space around", "highSetValue", "  1.75 ", 17'500);
    row("unit", "highSetValue", "1.75 mm", 17'500);
    row("unit without space", "highSetValue", "1.75mm", 17'500);
    row("full-width digits, minus and point", "lowSetValue", "－１．７５", -17'500);
    row("full-width plus and comma", "highSetValue", "＋１，７５", 17'500);
    row("full-width unit and space", "highSetValue", "１．７５　ｍｍ", 17'500);
    row("square mm", "highSetValue", "1.75㎜", 17'500);
    row("ideographic full stop", "highSetValue", "１。７５", 17'500);
    row("kana minus", "lowSetValue", "ー１．７５", -17'500);
    row("what valueText writes on screen", "lowSetValue", "\u22125.0000", -50'000);
    row("factor", "span", "1.0001", 10'001);
    row("factor with its sign", "span", "1.5 ×", 15'000);
    row("duration", "outputDelayTimerSetting", "100 ms", 100);
    row("port", "portTool", "49152", 49'152);
    row("whole number with zeros behind the point", "outputDelayTimerSetting", "5.0", 5);
    row("choice", "holdMode", "2", 2);
    row("limits are allowed", "highSetValue", "9.5", 95'000);
    row("both of them", "lowSetValue", "-9.5000", -95'000);
}

void ValueTextTest::whatAPersonTypesIsReadExactly()
{
    QFETCH(QString, key);
    QFETCH(QString, text);
    const auto parsed = parseValue(item(key), smallest, text);
    QVERIFY2(parsed, qPrintable(text));
    QTEST(parsed->written, "written");
    QTEST(parsed->effective, "written"); // nothing is below this type's resolution
}

void ValueTextTest::whatIsNoValueSaysWhy_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("text");
    QTest::addColumn<ParseError>("error");

    const auto row = [](const char* name, const char* key, const char* text, ParseError error) {
        QTest::newRow(name) << QString::fromLatin1(key) << QString::fromUtf8(text) << error;
    };
    row("nothing", "highSetValue", "", ParseError::Empty);
    row("space only", "highSetValue", " \u3000 ", ParseError::Empty);
    row("unit only", "highSetValue", "mm", ParseError::NotANumber);
    row("sign only", "highSetValue", "-", ParseError::NotANumber);
    row("point only", "highSetValue", ".", ParseError::NotANumber);
    row("sign and point", "highSetValue", "-.", ParseError::NotANumber);
    row("letters", "highSetValue", "abc", ParseError::NotANumber);
    row("letters behind", "highSetValue", "1.5x", ParseError::NotANumber);
    row("exponent", "highSetValue", "1e3", ParseError::NotANumber);
    row("hexadecimal", "portTool", "0x10", ParseError::NotANumber);
    row("two points", "highSetValue", "1.2.3", ParseError::NotANumber);
    row("thousands separator", "highSetValue", "1,234.5", ParseError::NotANumber);
    row("space inside", "highSetValue", "1 234", ParseError::NotANumber);
    row("two signs", "highSetValue", "--1", ParseError::NotANumber);
    row("sign behind", "highSetValue", "1-", ParseError::NotANumber);
    row("another unit", "highSetValue", "5 µm", ParseError::NotANumber);
    row("another item's unit", "highSetValue", "5 ms", ParseError::NotANumber);
    row("superscript digits are no digits", "highSetValue", "1²", ParseError::NotANumber);
    row("digits of another script", "highSetValue", "١", ParseError::NotANumber);
    row("not a number", "highSetValue", "nan", ParseError::NotANumber);
    row("infinity", "highSetValue", "inf", ParseError::NotANumber);
    row("five decimals", "highSetValue", "1.23456", ParseError::TooManyDecimals);
    row("a fraction of a millisecond", "outputDelayTimerSetting", "1.5", ParseError::TooManyDecimals);
    row("half a port", "portTool", "80.5", ParseError::TooManyDecimals);
    row("one above", "highSetValue", "9.5001", ParseError::OutOfRange);
    row("one below", "lowSetValue", "-9.5001", ParseError::OutOfRange);
    row("beyond 32 bits", "highSetValue", "99999999999999999999999999", ParseError::OutOfRange);
    row("wraps around to zero in 32 bits", "highSetValue", "429496.7296", ParseError::OutOfRange);
    row("negative hysteresis", "hysteresis", "-0.0001", ParseError::OutOfRange);
    row("port 0", "portTool", "0", ParseError::OutOfRange);
    row("port 65536", "portTool", "65536", ParseError::OutOfRange);
    row("octet 256", "ipAddress1stOctet", "256", ParseError::OutOfRange);
    row("no such choice", "holdMode", "4", ParseError::NotAChoice);
    row("no such choice, huge", "holdMode", "99999999999", ParseError::NotAChoice);
    row("a digit count the type lacks, §4.8.1", "displayDigit", "4", ParseError::NotAChoice);
}

void ValueTextTest::whatIsNoValueSaysWhy()
{
    QFETCH(QString, key);
    QFETCH(QString, text);
    const auto parsed = parseValue(item(key), smallest, text);
    QVERIFY2(!parsed, qPrintable(text));
    QTEST(parsed.error().error, "error");
}

void ValueTextTest::aFailureNamesTheLimits()
{
    const auto parsed = parseValue(hlG2(ItemId::HighSetValue), middle, QStringLiteral("96"));
    QVERIFY(!parsed);
    QCOMPARE(parsed.error().limits.minimum, -950'000);
    QCOMPARE(parsed.error().limits.maximum, 950'000);
    QCOMPARE(parsed.error().limits.resolution, 10);
}

void ValueTextTest::digitsBelowTheResolutionAreRoundedTowardsZero_data()
{
    QTest::addColumn<SensorModel>("model");
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("written");
    QTest::addColumn<int>("effective");

    QTest::newRow("0.1 µm keeps all") << smallest << "1.2349" << 12'349 << 12'349;
    QTest::newRow("1 µm") << middle << "1.2349" << 12'349 << 12'340;
    QTest::newRow("10 µm") << largest << "1.2399" << 12'399 << 12'300;
    QTest::newRow("negative, towards zero") << middle << "-1.2349" << -12'349 << -12'340;
    QTest::newRow("negative, 10 µm") << largest << "-0.0099" << -99 << 0;
    QTest::newRow("on it") << middle << "-1.234" << -12'340 << -12'340;
}

void ValueTextTest::digitsBelowTheResolutionAreRoundedTowardsZero()
{
    QFETCH(SensorModel, model);
    QFETCH(QString, text);
    const SettingItem& low = hlG2(ItemId::LowSetValue);
    const auto parsed = parseValue(low, model, text);
    QVERIFY(parsed);
    QTEST(parsed->written, "written");
    QTEST(parsed->effective, "effective");
    QCOMPARE(effectiveValue(low, model, parsed->written), parsed->effective);
    // A tolerance that the rounding makes zero is none, though the text itself is in range elsewhere.
    QVERIFY(!parseValue(hlG2(ItemId::Tolerance), middle, QStringLiteral("0.0009")));
}

void ValueTextTest::everySettingOfEveryModelSurvivesTextAndBack()
{
    std::mt19937 random(4401);
    int checked = 0;
    for (const ModelDescription& model : Catalog::hlG2().models()) {
        for (const SettingItem& each : Catalog::hlG2().items()) {
            if (each.role != Role::Setting || each.kind == Kind::Choice || each.kind == Kind::MacAddress)
                continue;
            const Limits& limits = each.limitsFor(model.model);
            std::uniform_int_distribution<Value> legal(limits.minimum, limits.maximum);
            QList<Value> values{limits.minimum, limits.maximum, limits.defaultValue};
            for (int i = 0; i < 200; ++i)
                values << legal(random);
            for (const Value value : values) {
                for (const TextStyle style : {TextStyle::Plain, TextStyle::Typographic}) {
                    const QString text = valueText(each, model.model, value, style);
                    const auto parsed = parseValue(each, model.model, text + u' ' + unitText(each));
                    const bool roundsToNothing = effectiveValue(each, model.model, value) < limits.minimum;
                    QVERIFY2(parsed || roundsToNothing, qPrintable(text));
                    if (parsed)
                        QCOMPARE(parsed->written, value);
                    ++checked;
                }
            }
        }
    }
    QVERIFY(checked > 30'000);
}

void ValueTextTest::noTextEverGivesAnIllegalValue()
{
    const QString alphabet = QStringLiteral("0123456789..,,--+ m\u2212\uff11\uff0e\u3002eE\u00b2");
    std::mt19937 random(4402);
    std::uniform_int_distribution<qsizetype> letter(0, alphabet.size() - 1);
    std::uniform_int_distribution<int> length(0, 9);
    int accepted = 0;
    for (int i = 0; i < 50'000; ++i) {
        QString text;
        for (int n = length(random); n > 0; --n)
            text += alphabet[letter(random)];
        for (const ItemId id : {ItemId::LowSetValue, ItemId::Span, ItemId::PortTool, ItemId::DisplayDigit}) {
            const SettingItem& each = hlG2(id);
            const auto parsed = parseValue(each, largest, text);
            if (!parsed)
                continue;
            ++accepted;
            const Limits& limits = each.limitsFor(largest);
            QVERIFY2(parsed->written >= limits.minimum && parsed->written <= limits.maximum,
                     qPrintable(text));
            QCOMPARE(parsed->effective % std::max(1, limits.resolution), 0);
        }
    }
    QVERIFY(accepted > 1000);
}

QTEST_APPLESS_MAIN(ValueTextTest)
#include "tst_value_text.moc"
