#include "state_file.h"

#include <functional>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace lds::emulator;
using namespace lds::catalog;
using namespace Qt::StringLiterals;

namespace {

SettingsMemory changedMemory()
{
    SettingsMemory memory(SensorModel::HlG205);
    memory.setValue(ItemId::BankSwitching, 3);
    memory.setValue(ItemId::Offset, -1'230, 2);
    memory.setValue(ItemId::LanguageSetting, 1);
    memory.setZeroCorrection(2, -123'456);
    memory.setTunedBrightness(1, BrightnessRange{3'000, 90'000});
    memory.setInputPolarity(InputPolarity::Pnp);
    return memory;
}

const LifeCounters someLife{7'200, 15};

/// The JSON of changedMemory() with something done to it.
QByteArray spoiled(const std::function<void(QJsonObject&)>& spoil)
{
    QJsonObject root = QJsonDocument::fromJson(toStateJson(changedMemory(), someLife)).object();
    spoil(root);
    return QJsonDocument(root).toJson();
}

void setInBank(QJsonObject& root, int bank, const QString& key, const QJsonValue& value)
{
    QJsonArray banks = root.value("banks"_L1).toArray();
    QJsonObject object = banks.at(bank).toObject();
    if (value.isUndefined())
        object.remove(key);
    else
        object.insert(key, value);
    banks.replace(bank, object);
    root.insert("banks"_L1, banks);
}

void setCommon(QJsonObject& root, const QString& key, const QJsonValue& value)
{
    QJsonObject object = root.value("common"_L1).toObject();
    object.insert(key, value);
    root.insert("common"_L1, object);
}

QString key(ItemId id) { return QString::fromLatin1(hlG2(id).key); }

} // namespace

class StateFileTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatIsSavedIsLoadedAgain();
    void aMissingFileIsNoState();
    void wrongFilesAreRefusedNamingTheField_data();
    void wrongFilesAreRefusedNamingTheField();
    void everyTruncationOfAFileIsRefused();
    void anUnwritablePlaceIsToldByName();
};

void StateFileTest::whatIsSavedIsLoadedAgain()
{
    const QTemporaryDir folder;
    const StateFile file(folder.filePath(u"state.json"_s));
    const SettingsMemory memory = changedMemory();
    QVERIFY(file.save(memory, someLife).has_value());
    const auto loaded = file.load(SensorModel::HlG205);
    QVERIFY2(loaded.has_value(), loaded ? "" : qPrintable(loaded.error()));
    QVERIFY(loaded->has_value());
    QVERIFY((*loaded)->settings == memory);
    QVERIFY((*loaded)->life == someLife);
    QVERIFY((*loaded)->settings != SettingsMemory(SensorModel::HlG205));
}

void StateFileTest::aMissingFileIsNoState()
{
    const QTemporaryDir folder;
    const auto loaded = StateFile(folder.filePath(u"none.json"_s)).load(SensorModel::HlG203);
    QVERIFY(loaded.has_value());
    QVERIFY(!loaded->has_value());
}

void StateFileTest::wrongFilesAreRefusedNamingTheField_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("names");

    QTest::newRow("empty") << QByteArray() << u"is not JSON"_s;
    QTest::newRow("binary") << QByteArray("\x00\xff\x12", 3) << u"is not JSON"_s;
    QTest::newRow("a list") << QByteArray("[]") << u"one JSON object"_s;
    const auto row = [](const char* name, const QString& names,
                        const std::function<void(QJsonObject&)>& spoil) {
        QTest::newRow(name) << spoiled(spoil) << names;
    };
    row("another program", u"format"_s, [](QJsonObject& root) { root.insert("format"_L1, "x"_L1); });
    row("a later version", u"version"_s, [](QJsonObject& root) { root.insert("version"_L1, 3); });
    row("another model", u"HL-G203B-S-MK"_s,
        [](QJsonObject& root) { root.insert("sensor"_L1, "HL-G203B-S-MK"_L1); });
    row("unknown field", u"colour: is not a field"_s, [](QJsonObject& root) { root.insert("colour"_L1, 1); });
    row("no common", u"common: is missing"_s, [](QJsonObject& root) { root.remove("common"_L1); });
    row("three banks", u"banks"_s, [](QJsonObject& root) {
        QJsonArray banks = root.value("banks"_L1).toArray();
        banks.removeLast();
        root.insert("banks"_L1, banks);
    });
    row("unknown item", u"common.frobnication: is not a field"_s,
        [](QJsonObject& root) { setCommon(root, u"frobnication"_s, 1); });
    row("banked item among the common ones", u"common.%1: is not a field"_s.arg(key(ItemId::Offset)),
        [](QJsonObject& root) { setCommon(root, key(ItemId::Offset), 0); });
    row("missing item", u"banks[1].%1: is missing"_s.arg(key(ItemId::Span)),
        [](QJsonObject& root) { setInBank(root, 1, key(ItemId::Span), QJsonValue::Undefined); });
    row("a text", u"banks[0].%1: has to be a whole number"_s.arg(key(ItemId::Span)),
        [](QJsonObject& root) { setInBank(root, 0, key(ItemId::Span), "10000"_L1); });
    row("a fraction", u"banks[0].%1: has to be a whole number"_s.arg(key(ItemId::Span)),
        [](QJsonObject& root) { setInBank(root, 0, key(ItemId::Span), 10'000.5); });
    row("huge", u"banks[0].%1"_s.arg(key(ItemId::Span)),
        [](QJsonObject& root) { setInBank(root, 0, key(ItemId::Span), 1e30); });
    row("out of range", u"banks[3].%1: 950001 is outside"_s.arg(key(ItemId::Offset)),
        [](QJsonObject& root) { setInBank(root, 3, key(ItemId::Offset), 950'001); });
    row("too fine", u"banks[3].%1: 5 is finer"_s.arg(key(ItemId::Offset)),
        [](QJsonObject& root) { setInBank(root, 3, key(ItemId::Offset), 5); });
    row("no such choice", u"common.%1"_s.arg(key(ItemId::LanguageSetting)),
        [](QJsonObject& root) { setCommon(root, key(ItemId::LanguageSetting), 3); });
    row("no such bank", u"common.%1"_s.arg(key(ItemId::BankSwitching)),
        [](QJsonObject& root) { setCommon(root, key(ItemId::BankSwitching), 0); });
    row("HIGH below LOW", u"banks[2].%1"_s.arg(key(ItemId::HighSetValue)),
        [](QJsonObject& root) { setInBank(root, 2, key(ItemId::HighSetValue), -200'000); });
    row("the same port twice", u"common.%1"_s.arg(key(ItemId::PortModbus)),
        [](QJsonObject& root) { setCommon(root, key(ItemId::PortModbus), 49'152); });
    row("an impossible address", u"common.%1"_s.arg(key(ItemId::IpAddress1stOctet)),
        [](QJsonObject& root) { setCommon(root, key(ItemId::IpAddress4thOctet), 255); });
    row("no zero correction", u"banks[0].zeroCorrectionNm: is missing"_s,
        [](QJsonObject& root) { setInBank(root, 0, u"zeroCorrectionNm"_s, QJsonValue::Undefined); });
    row("a brightness that is no range", u"banks[0].tunedBrightness: has to be null or"_s,
        [](QJsonObject& root) { setInBank(root, 0, u"tunedBrightness"_s, 5); });
    row("a brightness upside down", u"banks[0].tunedBrightness[1]: 4 is outside 5"_s, [](QJsonObject& root) {
        setInBank(root, 0, u"tunedBrightness"_s, QJsonArray{5, 4});
    });
    row("a brightness above all", u"banks[0].tunedBrightness[1]"_s, [](QJsonObject& root) {
        setInBank(root, 0, u"tunedBrightness"_s, QJsonArray{5, 1'000'001});
    });
    row("no life", u"life: is missing"_s, [](QJsonObject& root) { root.remove("life"_L1); });
    row("half a life", u"life.memoryWrites: is missing"_s, [](QJsonObject& root) {
        root.insert("life"_L1, QJsonObject{{u"operatingSeconds"_s, 1}});
    });
    row("negative hours", u"life.operatingSeconds"_s, [](QJsonObject& root) {
        root.insert("life"_L1, QJsonObject{{u"operatingSeconds"_s, -1}, {u"memoryWrites"_s, 1}});
    });
    row("no such polarity", u"inputPolarity: has to be"_s,
        [](QJsonObject& root) { root.insert("inputPolarity"_L1, "npn"_L1); });
    row("a bank that is none", u"banks[1]: has to be an object"_s, [](QJsonObject& root) {
        QJsonArray banks = root.value("banks"_L1).toArray();
        banks.replace(1, 5);
        root.insert("banks"_L1, banks);
    });
}

void StateFileTest::wrongFilesAreRefusedNamingTheField()
{
    QFETCH(QByteArray, json);
    QFETCH(QString, names);
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"state.json"_s);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(json);
    file.close();
    const auto loaded = StateFile(path).load(SensorModel::HlG205);
    QVERIFY(!loaded.has_value());
    QVERIFY2(loaded.error().startsWith(path), qPrintable(loaded.error()));
    QVERIFY2(loaded.error().contains(names), qPrintable(loaded.error()));
}

void StateFileTest::everyTruncationOfAFileIsRefused()
{
    const QByteArray json = toStateJson(changedMemory(), someLife).trimmed();
    QVERIFY(fromStateJson(json, SensorModel::HlG205).has_value());
    for (qsizetype length = 0; length < json.size(); length += 7)
        QVERIFY(!fromStateJson(json.left(length), SensorModel::HlG205).has_value());
}

void StateFileTest::anUnwritablePlaceIsToldByName()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"no such folder/state.json"_s);
    const auto saved = StateFile(path).save(changedMemory(), someLife);
    QVERIFY(!saved.has_value());
    QVERIFY2(saved.error().startsWith(path), qPrintable(saved.error()));
}

QTEST_APPLESS_MAIN(StateFileTest)
#include "tst_state_file.moc"
