// Holds the catalog against what the manual prints (manual_addresses.h, manual_values.h).

#include "catalog.h"
#include "manual_addresses.h"
#include "manual_values.h"

#include <algorithm>
#include <QMap>
#include <QSet>
#include <QTest>

using namespace lds::catalog;

namespace {

const Catalog& catalog() { return Catalog::hlG2(); }

QString accessText(Access access)
{
    switch (access) {
    case Access::Read:
        return QStringLiteral("R");
    case Access::Write:
        return QStringLiteral("W");
    case Access::ReadWrite:
        return QStringLiteral("RW");
    case Access::None:
        break;
    }
    return {};
}

/// "-9.5000" mm as the wire has it, in 0.1 µm, by moving the point.
Value wireLength(QString millimetres)
{
    const auto point = millimetres.indexOf(u'.');
    const auto decimals = millimetres.size() - point - 1;
    bool ok = false;
    Value value = millimetres.remove(point, 1).toInt(&ok);
    if (point < 0 || !ok)
        qFatal("not a length of the manual");
    for (auto missing = decimals; missing < 4; ++missing)
        value *= 10;
    return value;
}

const SettingItem* find(const char* key) { return catalog().findByKey(QString::fromLatin1(key)); }

SensorModel typeOf(const char* number)
{
    const auto* type = catalog().findModel(QStringLiteral("HL-G%1B-S-MK").arg(QLatin1StringView(number)));
    if (!type)
        qFatal("not a type of the manual");
    return type->model;
}

QString choiceText(const SettingItem& item, ModelMask model)
{
    QStringList parts;
    for (const Choice& choice : item.choices) {
        if (choice.models & model)
            parts += QStringLiteral("%1=%2").arg(choice.code).arg(QString::fromUtf8(choice.name));
    }
    return parts.join(u'|');
}

int numberIn(const QString& protocol, const SettingItem& item)
{
    if (protocol == u"modbus")
        return item.modbus ? item.modbus->number : 0;
    if (protocol == u"slmp")
        return item.slmp ? item.slmp->device : 0;
    return item.eip ? item.eip->attribute : 0;
}

void addAddressRows(const char* protocol, std::span<const manual::Address> rows)
{
    for (const manual::Address& row : rows)
        QTest::addRow("%s %d", protocol, row.number) << QString::fromLatin1(protocol) << &row;
}

} // namespace

Q_DECLARE_METATYPE(const manual::Address*)
Q_DECLARE_METATYPE(const manual::Menu*)
Q_DECLARE_METATYPE(const manual::Length*)
Q_DECLARE_METATYPE(const manual::Number*)
Q_DECLARE_METATYPE(const manual::Choices*)
Q_DECLARE_METATYPE(const manual::DisplayDigits*)

class TestCatalog : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void addressSizeAndAccessAreTheManuals_data()
    {
        QTest::addColumn<QString>("protocol");
        QTest::addColumn<const manual::Address*>("expected");
        addAddressRows("modbus", manual::modbus);
        addAddressRows("slmp", manual::slmp);
        addAddressRows("eip", manual::etherNetIp);
    }

    void addressSizeAndAccessAreTheManuals()
    {
        QFETCH(QString, protocol);
        QFETCH(const manual::Address*, expected);
        const SettingItem* item = find(expected->key);
        QVERIFY2(item, expected->key);
        QCOMPARE(numberIn(protocol, *item), expected->number);
        QCOMPARE(accessText(item->access), QString::fromLatin1(expected->access));
        // SLMP prints two bytes for the communication reset where the other tables have one.
        const bool printedDifferently = protocol == u"slmp" && expected->number == 170;
        QCOMPARE(item->size, printedDifferently ? 1 : expected->size);
        const QString printed = QString::fromUtf8(expected->name);
        if (protocol == u"modbus")
            QCOMPARE(QString::fromUtf8(item->name).toLower(), printed.toLower());
    }

    void noItemHasAnAddressTheManualDoesNotPrint()
    {
        int modbus = 0, slmp = 0, eip = 0;
        for (const SettingItem& item : catalog().items()) {
            modbus += item.modbus ? 1 : 0;
            slmp += item.slmp ? 1 : 0;
            eip += item.eip ? 1 : 0;
            QCOMPARE(item.size != 0, item.modbus.has_value());
            QCOMPARE(item.access == Access::None, !item.modbus.has_value());
        }
        QCOMPARE(modbus, 66);
        QCOMPARE(slmp, 48);
        QCOMPARE(eip, 46);
        QCOMPARE(catalog().items().size(), std::size_t(70));
        QCOMPARE(std::size(manual::modbus), std::size_t(66));
        QCOMPARE(std::size(manual::slmp), std::size_t(48));
        QCOMPARE(std::size(manual::etherNetIp), std::size_t(46));
    }

    void anSlmpDeviceIsTheModbusWireAddress()
    {
        for (const SettingItem& item : catalog().items()) {
            if (item.slmp)
                QCOMPARE(item.slmp->device, int(item.modbus->address()));
        }
    }

    void itemsStandInTheOrderOfTheirIdsAndRegisters()
    {
        int before = 0;
        for (std::size_t place = 0; place < catalog().items().size(); ++place) {
            const SettingItem& item = catalog().items()[place];
            QCOMPARE(std::size_t(item.id), place);
            QCOMPARE(&catalog().item(ItemId(place)), &item);
            if (place >= 66)
                continue;
            QVERIFY2(item.modbus && item.modbus->number > before, item.key);
            before = item.modbus->number;
        }
    }

    void registersDoNotOverlap()
    {
        QSet<int> taken;
        for (const SettingItem& item : catalog().items()) {
            for (int word = 0; item.modbus && word < item.registerCount(); ++word) {
                const int number = item.modbus->number + word;
                QVERIFY2(!taken.contains(number), item.key);
                QVERIFY2(!catalog().isUsageProhibited(quint16(number - 400001)), item.key);
                taken.insert(number);
            }
        }
        QCOMPARE(taken.size(), 66 + 7); // Seven items of four bytes.
    }

    void prohibitedRegistersAreTheManuals()
    {
        QSet<int> found;
        for (int address = 0; address <= 0xffff; ++address) {
            if (catalog().isUsageProhibited(quint16(address)))
                found.insert(address + 400001);
        }
        QCOMPARE(found, QSet<int>(std::begin(manual::usageProhibited), std::end(manual::usageProhibited)));
    }

    void menuIsTheManuals_data()
    {
        QTest::addColumn<const manual::Menu*>("expected");
        for (const manual::Menu& row : manual::menu)
            QTest::addRow("%d", row.number) << &row;
    }

    void menuIsTheManuals()
    {
        QFETCH(const manual::Menu*, expected);
        const MenuEntry* entry = catalog().findMenu(expected->number);
        QVERIFY(entry);
        QCOMPARE(entry->level(), expected->bars);
        QCOMPARE(QString::fromUtf8(entry->name), QString::fromUtf8(expected->name));
        QCOMPARE(QString::fromUtf8(entry->section), QString::fromUtf8(expected->section));
        QStringList keys;
        for (const ItemId id : entry->items) {
            keys += QString::fromLatin1(catalog().item(id).key);
            QCOMPARE(catalog().item(id).menu, expected->number);
        }
        QCOMPARE(keys.join(u' '), QString::fromLatin1(expected->keys));
    }

    void menuIsCompleteAndInTreeOrder()
    {
        QCOMPARE(catalog().menu().size(), std::size_t(46));
        QCOMPARE(std::size(manual::menu), std::size_t(46));
        QSet<ItemId> inMenu;
        QString before;
        for (const MenuEntry& entry : catalog().menu()) {
            // As texts, the numbers sort like the tree: "4" < "42" < "421" < "422" < "5".
            const QString number = QString::number(entry.number);
            QVERIFY2(before < number, qPrintable(number));
            before = number;
            QVERIFY(entry.level() == 1 || catalog().findMenu(entry.parent()));
            for (const ItemId id : entry.items)
                inMenu.insert(id);
        }
        for (const SettingItem& item : catalog().items())
            QVERIFY2((item.menu != 0) == inMenu.contains(item.id), item.key);
        QCOMPARE(catalog().findMenu(0), nullptr);
        QCOMPARE(catalog().findMenu(41), nullptr);
    }

    void coilsAreTheManuals()
    {
        QMap<int, QString> expected;
        for (const manual::Coil& coil : manual::coils)
            expected.insert(coil.number, QString::fromUtf8(coil.name));
        QCOMPARE(catalog().coils().size(), std::size_t(64));
        QSet<QString> keys;
        for (int number = 1; number <= 64; ++number) {
            const Coil& coil = catalog().coils()[std::size_t(number - 1)];
            QCOMPARE(coil.number, number);
            QCOMPARE(QString::fromUtf8(coil.name), expected.value(number));
            QCOMPARE(coil.reserved(), !expected.contains(number));
            if (!coil.reserved())
                keys.insert(QString::fromLatin1(coil.key));
        }
        QCOMPARE(keys.size(), expected.size());
    }

    void lengthsAreTheManuals_data()
    {
        QTest::addColumn<const manual::Length*>("expected");
        for (const manual::Length& row : manual::lengths)
            QTest::addRow("%s %s", row.key, row.type) << &row;
    }

    void lengthsAreTheManuals()
    {
        QFETCH(const manual::Length*, expected);
        const SettingItem* item = find(expected->key);
        QVERIFY(item);
        QVERIFY(item->kind == Kind::Length);
        const SensorModel model = typeOf(expected->type);
        const Limits& limits = item->limitsFor(model);
        QCOMPARE(limits.minimum, wireLength(QString::fromLatin1(expected->minimum)));
        QCOMPARE(limits.maximum, wireLength(QString::fromLatin1(expected->maximum)));
        QCOMPARE(limits.defaultValue, wireLength(QString::fromLatin1(expected->defaultValue)));
        // 0.1 µm for 30 mm, 1 µm for 50 to 120 mm, 10 µm for 250 mm: one in the last printed decimal.
        const QString printed = QString::fromLatin1(expected->maximum);
        const auto decimals = printed.size() - printed.indexOf(u'.') - 1;
        const auto smallest = QStringLiteral("0.").leftJustified(decimals + 1, u'0') + u'1';
        QCOMPARE(limits.resolution, wireLength(smallest));
        QVERIFY(item->hasDefault);
    }

    void numbersAreTheManuals_data()
    {
        QTest::addColumn<const manual::Number*>("expected");
        for (const manual::Number& row : manual::numbers)
            QTest::addRow("%s", row.key) << &row;
    }

    void numbersAreTheManuals()
    {
        QFETCH(const manual::Number*, expected);
        const SettingItem* item = find(expected->key);
        QVERIFY(item);
        QVERIFY(item->hasDefault);
        for (const ModelDescription& model : catalog().models()) {
            const Limits& limits = item->limitsFor(model.model);
            QCOMPARE(limits.minimum, expected->minimum);
            QCOMPARE(limits.maximum, expected->maximum);
            QCOMPARE(limits.defaultValue, expected->defaultValue);
            QCOMPARE(limits.resolution, 1);
        }
    }

    void choicesAreTheManuals_data()
    {
        QTest::addColumn<const manual::Choices*>("expected");
        for (const manual::Choices& row : manual::choices)
            QTest::addRow("%s", row.key) << &row;
    }

    void choicesAreTheManuals()
    {
        QFETCH(const manual::Choices*, expected);
        const SettingItem* item = find(expected->key);
        QVERIFY(item);
        QVERIFY(item->kind == Kind::Choice);
        QCOMPARE(item->hasDefault, expected->defaultCode != manual::noDefault);
        for (const ModelDescription& model : catalog().models()) {
            QCOMPARE(choiceText(*item, maskOf(model.model)), QString::fromUtf8(expected->codes));
            const Limits& limits = item->limitsFor(model.model);
            QCOMPARE(limits.minimum, item->choices.front().code);
            QCOMPARE(limits.maximum, item->choices.back().code);
            if (item->hasDefault)
                QCOMPARE(limits.defaultValue, expected->defaultCode);
        }
    }

    void displayDigitsDifferByType_data()
    {
        QTest::addColumn<const manual::DisplayDigits*>("expected");
        for (const manual::DisplayDigits& row : manual::displayDigits)
            QTest::addRow("%s", row.type) << &row;
    }

    void displayDigitsDifferByType()
    {
        QFETCH(const manual::DisplayDigits*, expected);
        const SettingItem& item = hlG2(ItemId::DisplayDigit);
        const SensorModel model = typeOf(expected->type);
        const QString codes = QString::fromLatin1(expected->codes);
        QCOMPARE(choiceText(item, maskOf(model)), codes);
        QCOMPARE(item.limitsFor(model).minimum, codes.section(u'=', 0, 0).toInt());
        QCOMPARE(item.limitsFor(model).maximum, codes.section(u'|', -1).section(u'=', 0, 0).toInt());
        QCOMPARE(item.limitsFor(model).defaultValue, expected->defaultCode);
    }

    void everyItemsValuesAreHeldAgainstTheManual()
    {
        QSet<QString> held{QStringLiteral("displayDigit")};
        for (const auto& row : manual::lengths)
            held.insert(QString::fromLatin1(row.key));
        for (const auto& row : manual::numbers)
            held.insert(QString::fromLatin1(row.key));
        for (const auto& row : manual::choices)
            held.insert(QString::fromLatin1(row.key));
        for (const SettingItem& item : catalog().items()) {
            const bool reportOnly = item.role == Role::Status && item.kind != Kind::Choice;
            if (item.kind != Kind::Trigger && !reportOnly)
                QVERIFY2(held.contains(QString::fromLatin1(item.key)), item.key);
            QCOMPARE(item.choices.empty(), item.kind != Kind::Choice);
        }
    }

    void bankHeldItemsAreTheManuals()
    {
        QSet<QString> found;
        for (const SettingItem& item : catalog().items()) {
            if (item.scope == Scope::Bank)
                found.insert(QString::fromLatin1(item.key));
        }
        QSet<QString> expected;
        for (const char* key : manual::bankItems)
            expected.insert(QString::fromLatin1(key));
        QCOMPARE(found, expected);
    }

    void communicationSettingsWaitForTheReset() // §5.1.1, §6.2
    {
        for (const SettingItem& item : catalog().items()) {
            const bool waits = (item.menu >= 71 && item.menu <= 77) || (item.menu >= 81 && item.menu <= 84);
            QVERIFY2((item.effect == Effect::AfterCommunicationReset) == waits, item.key);
        }
    }

    void rolesFollowWhatWritingDoes()
    {
        const QMap<QString, Role> special{
            {QStringLiteral("laserStop"), Role::Switch},
            {QStringLiteral("keyLock"), Role::Switch},
            {QStringLiteral("zeroSetting"), Role::Switch},
            {QStringLiteral("triggerInputCommunication"), Role::Switch},
            {QStringLiteral("bankSwitching"), Role::Switch},
            {QStringLiteral("brightnessTuning"), Role::Procedure},
            {QStringLiteral("executionOfTeaching"), Role::Procedure},
            {QStringLiteral("teaching1stPoint"), Role::Procedure},
            {QStringLiteral("teaching2ndPoint"), Role::Procedure},
            {QStringLiteral("teaching3rdPoint"), Role::Procedure},
            {QStringLiteral("brightnessTuning1stPoint"), Role::Procedure},
            {QStringLiteral("brightnessTuning2ndPoint"), Role::Procedure},
            {QStringLiteral("setValueSaving"), Role::Command},
            {QStringLiteral("measuredValueResetting"), Role::Command},
            {QStringLiteral("bankCopy"), Role::Command},
            {QStringLiteral("settingsInitialization"), Role::Command},
            {QStringLiteral("resettingCommunicationSettings"), Role::Command},
            {QStringLiteral("macAddress"), Role::Status},
        };
        for (const SettingItem& item : catalog().items()) {
            const Role expected = special.value(QString::fromLatin1(item.key),
                                                item.access == Access::Read ? Role::Status : Role::Setting);
            QVERIFY2(item.role == expected, item.key);
            QVERIFY2(item.role == Role::Setting || item.effect == Effect::AtOnce, item.key);
        }
    }

    void addressPartsFormThreeGroupsOfFour()
    {
        QMap<WriteGroup, QStringList> groups;
        for (const SettingItem& item : catalog().items()) {
            QCOMPARE(item.group != WriteGroup::None, item.kind == Kind::Octet);
            if (item.group != WriteGroup::None)
                groups[item.group] += QString::fromLatin1(item.key).chopped(8); // "1stOctet"
        }
        QCOMPARE(groups.value(WriteGroup::IpAddress), QStringList(4, QStringLiteral("ipAddress")));
        QCOMPARE(groups.value(WriteGroup::SubnetMask), QStringList(4, QStringLiteral("subnetMask")));
        QCOMPARE(groups.value(WriteGroup::DefaultGateway), QStringList(4, QStringLiteral("defaultGateway")));
    }

    void everyItemIsNamedExplainedAndUnique()
    {
        QSet<QString> keys;
        for (const SettingItem& item : catalog().items()) {
            const QString key = QString::fromLatin1(item.key);
            QVERIFY2(!keys.contains(key), item.key);
            keys.insert(key);
            QVERIFY2(key.front().isLower() &&
                         std::ranges::all_of(key, [](QChar letter) { return letter.isLetterOrNumber(); }),
                     item.key);
            QVERIFY2(*item.name != '\0', item.key);
            QVERIFY2(QString::fromLatin1(item.section).front().isDigit(), item.key);
            const QString help = QString::fromUtf8(item.help);
            QVERIFY2(help.size() > 40 && help.endsWith(u'.'), item.key);
            QVERIFY2(!help.contains(u"  "), item.key);
        }
    }

    void typesAreTheManuals()
    {
        QCOMPARE(catalog().models().size(), std::size(manual::types));
        for (std::size_t place = 0; place < std::size(manual::types); ++place) {
            const manual::Type& expected = manual::types[place];
            const ModelDescription& model = catalog().models()[place];
            QCOMPARE(std::size_t(model.model), place);
            QCOMPARE(&catalog().model(model.model), &model);
            QCOMPARE(QString::fromLatin1(model.typeName), QString::fromLatin1(expected.typeName));
            QCOMPARE(model.centerDistance, expected.centerDistanceMm);
            QCOMPARE(model.measurementRange, expected.measurementRangeMm * 10'000);
            QCOMPARE(model.displayLimit, wireLength(QString::fromLatin1(expected.displayLimitMm)));
            QCOMPARE(model.decimals, expected.decimals);
            QCOMPARE(catalog().findModel(QString::fromLatin1(expected.typeName).toLower()), &model);
        }
        QCOMPARE(catalog().findModel(u"HL-G203"), nullptr);
    }

    void whatIsNotThereIsNotFound()
    {
        QCOMPARE(catalog().findByKey(u"highsetvalue"), nullptr);
        QCOMPARE(catalog().findByKey(u""), nullptr);
        QCOMPARE(catalog().findByModbusAddress(0), nullptr);
        QCOMPARE(catalog().findByModbusAddress(101), nullptr); // The second word of HIGH.
        QCOMPARE(catalog().findByModbusAddress(100), find("highSetValue"));
    }
};

QTEST_APPLESS_MAIN(TestCatalog)
#include "tst_catalog.moc"
